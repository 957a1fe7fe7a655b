// A curve through points of one's own type, in ten lines.
#include <splineloft/splineloft.h>

#include <iostream>
#include <vector>

struct Buoy {
    const char* name;
    float x, y;
};

int main() {
    const std::vector<Buoy> course = {
        {"red", 0, 0}, {"green", 3, 1}, {"north", 4, 4}, {"south", 7, 2}};
    const splineloft::Spline spline{.family = "catmull-rom", .parameters = {{"alpha", 0.5}}};
    const auto buoys = splineloft::PointsView::of(course, &Buoy::x, &Buoy::y);
    const auto pieces = splineloft::piecesOf(spline, buoys);
    const splineloft::ArcLength length(pieces);
    const auto half = pieces.position(length.spotAt(length.total() / 2));
    std::cout << "length " << length.total() << ", half way at " << half[0] << ' ' << half[1]
              << '\n';
    return pieces.size() == 3 && pieces.position({1, 0}) == splineloft::Point({3, 1}) ? 0 : 1;
}
