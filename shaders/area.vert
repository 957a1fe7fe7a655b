// A filled rectangle, one instance each, grown by a pixel so that its edges can be softened.
precision highp float;

layout(location = 0) in vec4 rect; // left, top, right, bottom: pixels from the top left corner
layout(location = 1) in vec4 fill;

uniform vec2 screen; // size of the window, pixels

flat out vec4 v_rect;
flat out vec4 v_fill;

void main() {
    vec2 corner = vec2(gl_VertexID & 1, gl_VertexID >> 1);
    vec2 place = mix(rect.xy - 1.0, rect.zw + 1.0, corner);
    v_rect = rect;
    v_fill = fill;
    gl_Position = vec4((place / screen * 2.0 - 1.0) * vec2(1.0, -1.0), 0.0, 1.0);
}
