#include "core/spline/fast/natural_slopes.h"

#include <algorithm>
#include <array>
#include <iterator>

namespace splineloft {
namespace {

// What a block has of each kind is 33 kB, up to twice that in the last one: the second-level cache
// holds it all. Chains 264 rows apart begin in different lines of the first-level cache; 256 rows
// apart many would share one.
constexpr std::size_t blockRows = 16 * 264;

} // namespace

NaturalSlopes::NaturalSlopes(std::span<const double> x, std::span<const double> y,
                             std::span<double> slopes)
    : x_(x), y_(y), slopes_(slopes), chains_(lanes::slopeChains()) {
    const std::size_t rows = x.size() - 2;
    const bool few = rows < chains_ * lanes::leastChain;
    cut(few ? 0 : std::max<std::size_t>(1, rows / blockRows));
}

/// All blocks are equal but the last, which takes what is left over, short of a row a chain.
void NaturalSlopes::cut(std::size_t blocks) {
    blocks_ = blocks;
    if (blocks > 0) {
        length_ = blocks > 1 ? blockRows / chains_ : 0;
        lastLength_ = (x_.size() - 1 - firstOf(blocks - 1)) / chains_;
        room_ = std::max(length_, lastLength_) * chains_ / std::size(Line{}.numbers) + 1;
        columns_ = std::make_unique_for_overwrite<Line[]>((blocks > 1 ? 5 : 3) * room_);
    }
}

std::size_t NaturalSlopes::blocks() const {
    return std::max<std::size_t>(1, blocks_);
}

std::size_t NaturalSlopes::pointsFor(std::size_t block) const {
    return block + 1 < blocks_ ? firstOf(block + 1) + 1 : x_.size();
}

lanes::SlopeBlock NaturalSlopes::columnsOf(std::size_t block) const {
    Line* const over = columns_.get() + (block % 2 == 0 ? 1 : 3) * room_;
    Line* const reduced = over + room_;
    return {firstOf(block), block + 1 < blocks_ ? length_ : lastLength_, over->numbers,
            reduced->numbers};
}

double NaturalSlopes::firstChord() const {
    return 3 * ((y_[1] - y_[0]) / (x_[1] - x_[0]));
}

void NaturalSlopes::solve(std::size_t block, const lanes::Upcoming& upcoming) {
    if (block == 0) { // 2 m[0] + m[1] = chord
        state_ = {firstChord(), 0.5, firstChord() / 2};
    }
    if (block < blocks_) {
        const auto columns = columnsOf(block);
        state_ = lanes::eliminate(x_.data(), y_.data(), columns, state_, upcoming);
        if (block > 0) {
            substitute(block - 1, lanes::foreseenSlope(columns));
        }
    }
    if (block + 1 >= blocks_) {
        solveRest();
    }
}

void NaturalSlopes::substitute(std::size_t block, double next) {
    const auto columns = columnsOf(block);
    // Written in as many places as there are chains, they stay in the cache until they leave it in
    // one go, which memory likes better.
    double* const found = columns_[0].numbers;
    lanes::substitute(columns, next, found);
    std::copy_n(found, columns.length * chains_, &slopes_[columns.first]);
    if (block > 0 && slopes_[columns.first] != foreseen_) {
        wasForeseen_ = false;
    }
    foreseen_ = next;
}

/// The rows behind the last block, m[n-2] + 2 m[n-1] = chord, and backwards from there.
void NaturalSlopes::solveRest() {
    const std::size_t last = x_.size() - 1;
    const std::size_t first = blocks_ > 0 ? firstOf(blocks_ - 1) + lastLength_ * chains_ : 1;
    std::array<double, lanes::mostSlopeChains * lanes::leastChain> over;
    state_ = lanes::eliminateOneByOne(x_.data(), y_.data(), first, last - first, state_,
                                      over.data(), &slopes_[first]);
    slopes_[last] = (state_.chord - state_.reduced) / (2 - state_.over);
    for (std::size_t i = last; i-- > first;) {
        slopes_[i] -= over[i - first] * slopes_[i + 1];
    }
    if (blocks_ > 0) {
        substitute(blocks_ - 1, slopes_[first]);
    }
    slopes_[0] = (firstChord() - slopes_[1]) / 2;
    if (!wasForeseen_) { // values so different that even 2^-64 of one is felt
        wasForeseen_ = true;
        cut(1);
        solve(0);
    }
}

} // namespace splineloft
