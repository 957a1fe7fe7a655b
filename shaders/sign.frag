// The shape as a distance to its edge, negative inside; one pixel of it is the soft edge. The
// outline lies within the shape: the fill begins where the distance is one outline width inside.
precision highp float;

flat in vec4 v_body;
flat in vec2 v_turn;
flat in float v_shape;
flat in vec4 v_fill;
flat in vec4 v_outline;

uniform vec2 screen;

out vec4 colour;

// The order of ui::SignShape; anything else is a disc.
const int diamond = 1;
const int square = 2;
const int ring = 3;
const int triangle = 4;

const float halfRoot2 = 0.70710678;
const float halfRoot3 = 0.86602540;
const float third3 = 0.57735027; // inner radius of the triangle over half its side

float distanceToEdge(int shape, vec2 p, float radius) {
    vec2 q = abs(p);
    if (shape == diamond) {
        return (q.x + q.y - radius) * halfRoot2;
    }
    if (shape == square) {
        return max(q.x, q.y) - radius;
    }
    if (shape == triangle) { // point up, its sides 2 radii long, its middle on the place
        return max(p.y, q.x * halfRoot3 - p.y * 0.5) - radius * third3;
    }
    return length(p) - radius;
}

void main() {
    vec2 offset = vec2(gl_FragCoord.x, screen.y - gl_FragCoord.y) - v_body.xy;
    // Back from the turned shape to the upright one (clockwise on the screen, y down).
    vec2 p = vec2(dot(offset, v_turn), dot(offset, vec2(-v_turn.y, v_turn.x)));
    int shape = int(v_shape + 0.5);
    float edge = distanceToEdge(shape, p, v_body.z);
    float whole = clamp(0.5 - edge, 0.0, 1.0);
    float inner = clamp(0.5 - edge - v_body.w, 0.0, 1.0);
    vec4 outlined = vec4(v_outline.rgb, 1.0) * (v_outline.a * (whole - inner));
    vec4 filled = vec4(v_fill.rgb, 1.0) * (v_fill.a * inner);
    colour = shape == ring ? outlined : outlined + filled;
}
