// A stroke is all points nearer to its middle line than half its width, so joins are round. Each
// pixel is drawn by the one segment it is nearest to: neighbouring segments abut without a gap and
// without overlap, and a translucent stroke is as even at its joints as between them.
precision highp float;

flat in vec4 v_segment;
flat in vec4 v_neighbours;
flat in vec4 v_directions;
flat in vec3 v_direction;
flat in vec4 v_laid;
flat in vec2 v_widths;
flat in vec4 v_startColour;
flat in vec4 v_endColour;

uniform vec2 screen;

out vec4 colour;

float cross2(vec2 p, vec2 q) { return p.x * q.y - p.y * q.x; }

// Both segments at a joint ask the same question in the same arithmetic, so that exactly one of
// them says yes. Seen from the joint: is the pixel nearer to the segment that leaves along
// `outgoing` to `last` than to the one that arrived along `incoming` from `first`? In the wedge
// where the joint itself is nearest to both, the pixel belongs to the one that arrived.
bool belongsToOutgoing(vec2 fromJoint, vec2 incoming, vec2 outgoing, vec2 pixel, vec2 first,
                       vec2 last, vec2 joint) {
    float ahead = dot(fromJoint, outgoing);
    float behind = dot(fromJoint, incoming);
    if (ahead <= 0.0) {
        return false;
    }
    if (behind >= 0.0) {
        return true;
    }
    float toOutgoing = ahead <= dot(last - joint, outgoing) ? abs(cross2(fromJoint, outgoing))
                                                            : distance(pixel, last);
    float toIncoming = behind >= dot(first - joint, incoming) ? abs(cross2(fromJoint, incoming))
                                                              : distance(pixel, first);
    return toOutgoing < toIncoming;
}

float dashCover(float along) {
    float dash = v_laid.z;
    float period = dash + v_laid.w;
    if (dash <= 0.0 || v_laid.w <= 0.0) {
        return 1.0;
    }
    float fromMiddle = abs(mod(along - 0.5 * dash + 0.5 * period, period) - 0.5 * period);
    return clamp(0.5 * dash + 0.5 - fromMiddle, 0.0, 1.0);
}

void main() {
    vec2 pixel = vec2(gl_FragCoord.x, screen.y - gl_FragCoord.y);
    vec2 a = v_segment.xy;
    vec2 b = v_segment.zw;
    vec2 direction = v_direction.xy;
    vec2 incoming = v_directions.xy;
    vec2 outgoing = v_directions.zw;
    vec2 fromA = pixel - a;
    vec2 fromB = pixel - b;
    if (incoming != vec2(0.0) &&
        !belongsToOutgoing(fromA, incoming, direction, pixel, v_neighbours.xy, b, a)) {
        discard;
    }
    if (outgoing != vec2(0.0) &&
        belongsToOutgoing(fromB, direction, outgoing, pixel, a, v_neighbours.zw, b)) {
        discard;
    }
    float ahead = dot(fromA, direction);
    float t = clamp(ahead / v_direction.z, 0.0, 1.0);
    float away = ahead < 0.0 ? length(fromA)
               : dot(fromB, direction) > 0.0 ? length(fromB) : abs(cross2(fromA, direction));
    // A line thinner than a pixel keeps a pixel's width and fades instead.
    float halfWidth = mix(v_widths.x, v_widths.y, t);
    float cover = clamp(max(halfWidth, 0.5) + 0.5 - away, 0.0, 1.0) * min(2.0 * halfWidth, 1.0);
    cover *= dashCover(mix(v_laid.x, v_laid.y, t));
    vec4 paint = mix(v_startColour, v_endColour, t);
    colour = vec4(paint.rgb, 1.0) * (paint.a * cover);
}
