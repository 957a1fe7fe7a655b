// A stroke along Bézier pieces, from their points in a table: one straight segment an instance.
// segment.vert stands before.
precision highp sampler2D;

uniform sampler2D table;    // a Bézier point a texel: x, y, and what floats leave out of them
uniform ivec4 table_shape;  // degree; points from piece to piece; points; whether it is closed
uniform ivec4 run;          // first piece, the one after the last; segments a piece; pieces a segment
uniform vec4 centre;        // of the view, like a texel
uniform vec4 placing;       // where the centre is on the screen; pixels a unit; which line
uniform vec4 style;         // half the width, dash, gap: pixels
uniform vec4 paint;

// The order of ui::PieceLine.
const int firstLeg = 1;
const int lastLeg = 2;

int pieceCount() {
    int stride = table_shape.y;
    bool isOpenPolygon = stride == 1 && table_shape.w == 0;
    return table_shape.z / stride - (isOpenPolygon ? 1 : 0);
}

// The differences are small where the view is small, so that nothing of them is lost.
vec2 bezierPoint(int index) {
    int width = textureSize(table, 0).x;
    int at = index < table_shape.z ? index : index - table_shape.z; // around a closed polygon
    vec4 place = texelFetch(table, ivec2(at % width, at / width), 0);
    vec2 fromCentre = (place.xy - centre.xy) + (place.zw - centre.zw);
    return placing.xy + vec2(fromCentre.x, -fromCentre.y) * placing.z;
}

// de Casteljau's ladder, of degree 3 at most.
vec2 onPiece(int piece, float u) {
    int degree = table_shape.x;
    int line = int(placing.w);
    int first = piece * table_shape.y + (line == lastLeg ? degree - 1 : 0);
    vec2 a = bezierPoint(first);
    vec2 b = bezierPoint(first + 1);
    if (degree == 1 || line == firstLeg || line == lastLeg) {
        return mix(a, b, u);
    }
    vec2 c = bezierPoint(first + 2);
    if (degree == 2) {
        return mix(mix(a, b, u), mix(b, c, u), u);
    }
    vec2 d = bezierPoint(first + 3);
    vec2 ab = mix(a, b, u);
    vec2 bc = mix(b, c, u);
    vec2 cd = mix(c, d, u);
    return mix(mix(ab, bc, u), mix(bc, cd, u), u);
}

// A spot of a piece, or where the curve goes on beyond its end; an open one stays there.
vec2 spot(int piece, float u) {
    int count = pieceCount();
    if (table_shape.w != 0) {
        return onPiece((piece + count) % count, u);
    }
    return piece < 0 ? onPiece(0, 0.0) : piece >= count ? onPiece(count - 1, 1.0)
                                                        : onPiece(piece, u);
}

// End number k of the run's segments; the one before the first is -1.
vec2 endOfSegment(int k) {
    int segments = run.z;
    int step = run.w;
    if (step > 1) {
        int piece = run.x + k * step;
        return spot(piece <= run.y ? piece : piece < run.y + step ? run.y : run.y + 1, 0.0);
    }
    int piece = (k + segments) / segments - 1; // also of k = -1
    return spot(run.x + piece, float(k - piece * segments) / float(segments));
}

void main() {
    vec2 a = endOfSegment(gl_InstanceID);
    vec2 b = endOfSegment(gl_InstanceID + 1);
    bool standsAlone = int(placing.w) != 0;
    vec2 before = standsAlone ? a : endOfSegment(gl_InstanceID - 1);
    vec2 after = standsAlone ? b : endOfSegment(gl_InstanceID + 2);
    // Dashes begin anew on every leg. What is too short for one is as faint as dashes are from afar.
    float size = distance(a, b);
    float period = style.y + style.z;
    bool isDashed = period > 0.0 && size > period;
    float cover = period > 0.0 && !isDashed ? style.y / period : 1.0;
    vec4 colour = vec4(paint.rgb, paint.a * cover);
    layOut(before, SegmentEnd(vec4(a, 0.0, style.x), colour),
           SegmentEnd(vec4(b, size, style.x), colour), after, isDashed ? style.yz : vec2(0.0));
}
