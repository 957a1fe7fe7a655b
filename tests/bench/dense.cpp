// Many samples of a uniform cubic: what drawing and exporting come down to. The samples fit the
// first cache, as most callers take them piece by piece; one row has more.
#include "tests/bench/ours.h"
#include "tests/bench/reference.h"
#include "tests/bench/rows.h"
#include "tests/bench/works.h"

namespace splineloft::bench {
namespace {

/// What a first cache holds, at least.
constexpr std::size_t firstCache = std::size_t{32} << 10;
/// A second one, with a margin.
constexpr std::size_t secondCache = std::size_t{256} << 10;

/// As many pieces as make samples of so many bytes.
template <class Number> UniformCubic makeUniformCubic(int dimension, std::size_t bytes) {
    const auto d = static_cast<std::size_t>(dimension);
    UniformCubic work{.dimension = dimension};
    work.pieces = bytes / (work.perPiece * d * sizeof(Number));
    for (const double number : Dice(1).between((work.pieces + 3) * d, -4, 4)) {
        work.points.push_back(static_cast<double>(static_cast<Number>(number)));
    }
    work.bezier = bezierOfCatmullRom(work.points, dimension);
    for (std::size_t piece = 0; piece < work.pieces; ++piece) {
        for (std::size_t k = 0; k < work.perPiece; ++k) {
            const auto u = static_cast<long double>(k) / static_cast<long double>(work.perPiece);
            for (std::size_t c = 0; c < d; ++c) {
                work.positions.push_back(catmullRom(&work.points[piece * d + c], d, u).value);
            }
        }
    }
    return work;
}

template <class Number> Trial ourDense(const UniformCubic& work) {
    const auto pieces = ours::catmullRom(work.points, work.dimension);
    const auto more = ours::positionsSize(pieces, work.perPiece) - work.positions.size();
    return filling<Number>(
        work.positions,
        [pieces, &work](std::span<Number> out) { ours::positions(pieces, work.perPiece, out); },
        more);
}

} // namespace

const UniformCubic& smallCubic(int dimension) {
    static const auto plane = makeUniformCubic<double>(2, firstCache);
    static const auto space = makeUniformCubic<double>(3, firstCache);
    return dimension == 2 ? plane : space;
}

const UniformCubic& smallCubicOfFloats() {
    static const auto plane = makeUniformCubic<float>(2, firstCache);
    return plane;
}

const UniformCubic& uniformCubic() {
    static const auto plane = makeUniformCubic<double>(2, secondCache);
    return plane;
}

void addDense(Contest& contest) {
    const auto samples = [](const UniformCubic& work) { return work.pieces * work.perPiece; };
    contest.rows.push_back({.id = "dense-2f",
                            .work = "uniform cubic, 256 a piece, 2-D float",
                            .items = samples(smallCubicOfFloats()),
                            .peers = {"glm"},
                            .goals = {TimesAsFastAs{"glm", 10}}});
    contest.rows.push_back({.id = "dense-2d",
                            .work = "same, 2-D double",
                            .items = samples(smallCubic(2)),
                            .peers = {"glm"},
                            .goals = {TimesAsFastAs{"kurbo", 3}, TimesAsFastAs{"glm", 8}},
                            .kurbo = 1.3});
    contest.rows.push_back({.id = "dense-3d",
                            .work = "same, 3-D double",
                            .items = samples(smallCubic(3)),
                            .peers = {"glm", "Boost"},
                            .goals = {TimesAsFastAs{"glm", 6}}});
    contest.rows.push_back({.id = "dense-2d-second",
                            .work = "same, 2-D, into the second cache",
                            .items = samples(uniformCubic()),
                            .peers = {"glm"}});
    contest.entries.push_back(
        {"dense-2f", ourName, [] { return ourDense<float>(smallCubicOfFloats()); }});
    contest.entries.push_back(
        {"dense-2d", ourName, [] { return ourDense<double>(smallCubic(2)); }});
    contest.entries.push_back(
        {"dense-3d", ourName, [] { return ourDense<double>(smallCubic(3)); }});
    contest.entries.push_back(
        {"dense-2d-second", ourName, [] { return ourDense<double>(uniformCubic()); }});
}

} // namespace splineloft::bench
