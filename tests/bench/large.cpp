// More samples than any cache holds: then writing them is the work, and copying the measure.
#include "tests/bench/ours.h"
#include "tests/bench/reference.h"
#include "tests/bench/rows.h"
#include "tests/bench/works.h"

#include <cstring>

namespace splineloft::bench {
namespace {

/// Whatever the machine says of its caches, the samples take between these.
constexpr std::size_t fewestBytes = std::size_t{64} << 20;
constexpr std::size_t mostBytes = std::size_t{512} << 20;
constexpr std::size_t samplesAPiece = 256;
constexpr std::size_t bytesAPiece = samplesAPiece * 2 * sizeof(double);

/// Twice the largest cache of the machine.
std::size_t bytesBeyondCaches() {
    std::size_t largest = 0;
    for (const auto& cache : benchmark::CPUInfo::Get().caches) {
        largest = std::max(largest, static_cast<std::size_t>(cache.size));
    }
    return std::clamp(2 * largest, fewestBytes, mostBytes);
}

UniformCubic makeLargeCubic() {
    UniformCubic work{.pieces = bytesBeyondCaches() / bytesAPiece, .perPiece = samplesAPiece};
    work.points = Dice(2).between((work.pieces + 3) * 2, -4, 4);
    return work;
}

/// Both programs write into the same memory, of which there should not be too much.
std::vector<double>& samples(std::size_t least) {
    static std::vector<double> numbers;
    if (numbers.size() < least) {
        numbers.resize(least);
    }
    return numbers;
}

/// Largest deviation of samples picked from all over.
double deviationOfSome(std::span<const double> found, const UniformCubic& work) {
    constexpr std::size_t step = 997; // prime: every u of a piece has its turn
    std::vector<double> some;
    References right;
    for (std::size_t i = 0; i < work.pieces * work.perPiece; i += step) {
        const auto u =
            static_cast<long double>(i % work.perPiece) / static_cast<long double>(work.perPiece);
        for (std::size_t c = 0; c < 2; ++c) {
            some.push_back(found[2 * i + c]);
            right.push_back(catmullRom(&work.points[i / work.perPiece * 2 + c], 2, u).value);
        }
    }
    return deviation<double>(some, right);
}

Trial ourLarge() {
    const auto& work = largeCubic();
    const auto pieces = ours::catmullRom(work.points, 2);
    const auto size = ours::positionsSize(pieces, work.perPiece);
    return {.pass =
                [pieces, &work, size] {
                    ours::positions(pieces, work.perPiece, std::span(samples(size)).first(size));
                    benchmark::ClobberMemory();
                },
            .error = [&work] { return deviationOfSome(samples(0), work); }};
}

Trial copy() {
    const auto count = largeCubic().pieces * samplesAPiece * 2;
    const auto source = std::make_shared<std::vector<double>>(count, 1.5);
    return {.pass =
                [source, count] {
                    std::memcpy(samples(count).data(), source->data(), count * sizeof(double));
                    benchmark::ClobberMemory();
                },
            .error = [] { return 0.0; }};
}

} // namespace

const UniformCubic& largeCubic() {
    static const auto work = makeLargeCubic();
    return work;
}

void addLarge(Contest& contest) {
    contest.rows.push_back({.id = "large",
                            .work = "same, 2-D, more than the cache holds",
                            .items = largeCubic().pieces * samplesAPiece,
                            .peers = {"memcpy"},
                            .goals = {TimesTheTimeOf{"memcpy", 1.2}}});
    contest.entries.push_back({"large", ourName, ourLarge});
    contest.entries.push_back({"large", "memcpy", copy});
}

} // namespace splineloft::bench
