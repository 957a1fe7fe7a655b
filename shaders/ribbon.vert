// A stroke whose points were laid out before: one segment an instance. segment.vert stands before.
layout(location = 0) in vec2 before;
layout(location = 1) in vec4 start;      // x, y, distance along the stroke, half the width: pixels
layout(location = 2) in vec2 startDash;  // dash and gap, pixels
layout(location = 3) in vec4 startColour;
layout(location = 4) in vec4 end;
layout(location = 5) in vec4 endColour;
layout(location = 6) in vec2 after;

void main() {
    layOut(before, SegmentEnd(start, startColour), SegmentEnd(end, endColour), after, startDash);
}
