// What all strokes share: one segment a-b, with the points before and after it, becomes a rectangle
// just long enough to hold the segment and its share of the round joins at both ends.
precision highp float;

uniform vec2 screen;

flat out vec4 v_segment;    // a, b
flat out vec4 v_neighbours; // before, after
flat out vec4 v_directions; // of the segment before a and of the one after b; 0 where there is none
flat out vec3 v_direction;  // of a-b; its length
flat out vec4 v_laid;       // along at a and b; dash; gap
flat out vec2 v_widths;     // half the width at a and b
flat out vec4 v_startColour;
flat out vec4 v_endColour;

const float softEdge = 1.0;      // pixels beyond half the width that can still be touched
const float shortest = 1e-6;     // pixels: a shorter segment has no direction
const float farthest = 1e7;      // pixels: beyond it floats cannot tell one pixel from the next
const vec4 nowhere = vec4(2.0, 2.0, 2.0, 1.0);

vec2 directionFrom(vec2 p, vec2 q) {
    vec2 way = q - p;
    float size = length(way);
    return size > shortest && size < farthest ? way / size : vec2(0.0);
}

// How far a stroke of half width `reach` can stick out beyond a joint. The wedge of a turn by an
// angle below 90 degrees ends at reach * sin(angle); a sharper turn, and a free end (direction 0,
// so cosine 0), needs the whole half disc.
float overhang(vec2 incoming, vec2 outgoing, float reach) {
    float sine = incoming.x * outgoing.y - incoming.y * outgoing.x;
    return dot(incoming, outgoing) > 0.0 ? reach * min(abs(sine) + 0.001, 1.0) : reach;
}

// One end of a segment: x, y, distance along the stroke, half the width; all in pixels.
struct SegmentEnd {
    vec4 place;
    vec4 colour;
};

// Puts this vertex where it belongs. `dash` is the length of a dash and of the gap after it.
void layOut(vec2 before, SegmentEnd start, SegmentEnd end, vec2 after, vec2 dash) {
    vec2 a = start.place.xy;
    vec2 b = end.place.xy;
    vec2 direction = directionFrom(a, b);
    bool visible = start.place.w > 0.0 && end.place.w > 0.0 && direction != vec2(0.0);
    float reach = max(max(start.place.w, end.place.w), 0.5) + softEdge;
    v_segment = vec4(a, b);
    v_neighbours = vec4(before, after);
    v_directions = vec4(directionFrom(before, a), directionFrom(b, after));
    v_direction = vec3(direction, distance(a, b));
    v_laid = vec4(start.place.z, end.place.z, dash);
    v_widths = vec2(start.place.w, end.place.w);
    v_startColour = start.colour;
    v_endColour = end.colour;

    bool atEnd = (gl_VertexID & 1) == 1;
    vec2 across = vec2(-direction.y, direction.x) * (gl_VertexID < 2 ? -reach : reach);
    vec2 place = across + (atEnd ? b + direction * overhang(direction, v_directions.zw, reach)
                                 : a - direction * overhang(v_directions.xy, direction, reach));
    vec2 ndc = (place / screen * 2.0 - 1.0) * vec2(1.0, -1.0);
    gl_Position = visible ? vec4(ndc, 0.0, 1.0) : nowhere;
}

