// How much of this pixel the rectangle covers, exactly: the overlap across times the overlap down.
precision highp float;

flat in vec4 v_rect;
flat in vec4 v_fill;

uniform vec2 screen;

out vec4 colour;

void main() {
    vec2 pixel = vec2(gl_FragCoord.x, screen.y - gl_FragCoord.y);
    vec2 overlap = min(pixel + 0.5, v_rect.zw) - max(pixel - 0.5, v_rect.xy);
    vec2 covered = clamp(overlap, 0.0, 1.0);
    colour = vec4(v_fill.rgb, 1.0) * (v_fill.a * covered.x * covered.y);
}
