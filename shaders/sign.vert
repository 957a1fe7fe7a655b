// A marker, one instance each: a square that holds the shape however it is turned.
precision highp float;

layout(location = 0) in vec4 body; // x, y, radius, outline width: pixels
layout(location = 1) in float angle;
layout(location = 2) in float shape;
layout(location = 3) in vec4 fill;
layout(location = 4) in vec4 outline;

uniform vec2 screen;

flat out vec4 v_body;
flat out vec2 v_turn; // cosine and sine of the angle
flat out float v_shape;
flat out vec4 v_fill;
flat out vec4 v_outline;

const float farthestCorner = 1.42; // of a square, the widest shape, in radii: the root of 2
const float softEdge = 1.0;        // pixels

void main() {
    vec2 corner = vec2(gl_VertexID & 1, gl_VertexID >> 1) * 2.0 - 1.0;
    vec2 place = body.xy + corner * (body.z * farthestCorner + softEdge);
    v_body = body;
    v_turn = vec2(cos(angle), sin(angle));
    v_shape = shape;
    v_fill = fill;
    v_outline = outline;
    gl_Position = vec4((place / screen * 2.0 - 1.0) * vec2(1.0, -1.0), 0.0, 1.0);
}
