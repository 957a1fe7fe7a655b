#include "core/spline/families/tridiagonal.h"

#include <algorithm>
#include <array>
#include <memory>

namespace splineloft::families {
namespace {

// Elimination and back substitution both carry a little state from row to row, and each row waits
// for the arithmetic of the row before. We cut the rows into as many runs as there are lanes and
// go through all runs side by side, so that the waits overlap (and two lanes share a register).
//
// A run cannot know the state that the run before will leave to it. But the state forgets. Where
// the diagonal is at least twice |below| + |above|, |over| <= 1/2 by induction, as then |above| /
// (2 |above| + 2 |below| - |below| / 2) <= 1/2; so back substitution halves an error with every
// row, and usually leaves 0.268 of it. In elimination, a relative error of the pivots falls to a
// third or less with every row where the system is symmetric, and about as fast in ours. So each
// run begins a few rows early, in any state, to come close; and in the end each run is gone through
// again from the state in which it should have begun, until that makes no difference to the last
// bit. That repair needs no bound on anything: whatever the rows are, the result is that of a
// single run, and only the time depends on how soon they forget.
constexpr std::size_t lanes = 6;
constexpr std::size_t warmUp = 24;

/// Fewer rows than these are not worth cutting up.
constexpr std::size_t fewRows = 4 * lanes * warmUp;

// The rows of a block, and what elimination makes of them, are 6 x 16 kB: the second-level cache
// holds them, and allocators keep that much at hand.
constexpr std::size_t mostBlockRows = 2048;

// Back substitution in a block begins this many rows behind its end, knowing nothing. 2^-64 of an
// error is less than the rounding of a double, unless values differ greatly; which is noticed.
constexpr std::size_t rowsAhead = 64;

/// Sets state = step(state, i) and keeps it, for i = 0 .. count-1, from state `before`.
template <class Recurrence>
void run(const Recurrence& recurrence, std::size_t first, std::size_t count,
         typename Recurrence::State state) {
    for (std::size_t i = first; i < count; ++i) {
        state = recurrence.step(state, i);
        recurrence.keep(i, state);
    }
}

/// The same, in lanes.
template <class Recurrence>
void runInLanes(const Recurrence& recurrence, std::size_t count,
                typename Recurrence::State before) {
    if (count < fewRows) {
        run(recurrence, 0, count, before);
        return;
    }
    using State = typename Recurrence::State;
    constexpr auto width = std::tuple_size_v<State>;
    const std::size_t length = count / lanes;
    std::array<std::array<double, lanes>, width> states{}; // lane by lane, to fill registers
    const auto stateOf = [&states](std::size_t lane) {
        State state;
        for (std::size_t v = 0; v < width; ++v) {
            state[v] = states[v][lane];
        }
        return state;
    };
    const auto stepAll = [&](std::size_t firstLane, std::size_t i) {
        for (std::size_t lane = firstLane; lane < lanes; ++lane) {
            const State state = recurrence.step(stateOf(lane), lane * length + i);
            for (std::size_t v = 0; v < width; ++v) {
                states[v][lane] = state[v];
            }
        }
    };
    for (std::size_t i = 0; i < warmUp; ++i) {
        stepAll(1, i - warmUp);
    }
    for (std::size_t v = 0; v < width; ++v) {
        states[v][0] = before[v];
    }
    for (std::size_t i = 0; i < length; ++i) {
        stepAll(0, i);
        for (std::size_t lane = 0; lane < lanes; ++lane) {
            recurrence.keep(lane * length + i, stateOf(lane));
        }
    }
    run(recurrence, lanes * length, count, stateOf(lanes - 1));
    for (std::size_t lane = 1; lane < lanes; ++lane) {
        State state = recurrence.kept(lane * length - 1);
        for (std::size_t i = lane * length; i < count; ++i) {
            state = recurrence.step(state, i);
            if (state == recurrence.kept(i)) {
                break;
            }
            recurrence.keep(i, state);
        }
    }
}

/// Row i becomes z[i] + over[i] z[i+1] = reduced[i].
struct Elimination {
    using State = std::array<double, 2>; // over, reduced
    const double *below, *diagonal, *above, *right;
    double *over, *reduced;

    State step(const State& before, std::size_t i) const {
        const double inverse = 1 / (diagonal[i] - below[i] * before[0]);
        return {above[i] * inverse, inverse * (right[i] - below[i] * before[1])};
    }
    void keep(std::size_t i, const State& state) const {
        over[i] = state[0];
        reduced[i] = state[1];
    }
    State kept(std::size_t i) const { return {over[i], reduced[i]}; }
};

/// z[i] from z[i+1], counted from the last row.
struct BackSubstitution {
    using State = std::array<double, 1>; // z
    const double *over, *reduced;
    double* solution;
    std::size_t last;

    State step(const State& before, std::size_t i) const {
        return {reduced[last - i] - over[last - i] * before[0]};
    }
    void keep(std::size_t i, const State& state) const { solution[last - i] = state[0]; }
    State kept(std::size_t i) const { return {solution[last - i]}; }
};

/// Solves block by block, so that all in between stays in the cache. The last rows of a block need
/// what follows them: its first `rowsAhead` rows have to do. Returns whether they did, to the last
/// bit: whether each block's guess of the next one's first value was its value.
bool solveInBlocks(const Rows<double>& rows, std::span<double> solution, std::size_t block) {
    const std::size_t n = solution.size();
    const std::size_t room = std::min(n, block + rowsAhead);
    const auto over = std::make_unique_for_overwrite<double[]>(room);
    const auto reduced = std::make_unique_for_overwrite<double[]>(room);
    Elimination::State before = {0, 0};
    double guess = 0;
    for (std::size_t first = 0; first < n;) {
        const std::size_t end = n - first <= room ? n : first + block;
        const std::size_t seen = std::min(n, end + rowsAhead);
        runInLanes(Elimination{&rows.below[first], &rows.diagonal[first], &rows.above[first],
                               &rows.right[first], over.get(), reduced.get()},
                   seen - first, before);
        double next = 0;
        for (std::size_t i = seen - first; i-- > end - first;) {
            next = reduced[i] - over[i] * next;
        }
        const std::size_t last = end - first - 1;
        runInLanes(BackSubstitution{over.get(), reduced.get(), &solution[first], last}, last + 1,
                   {next});
        if (first > 0 && solution[first] != guess) {
            return false;
        }
        guess = next;
        before = {over[last], reduced[last]};
        first = end;
    }
    return true;
}

} // namespace

void solveInChains(const Rows<double>& rows, std::span<double> solution) {
    const std::size_t n = solution.size();
    const std::size_t blocks = n / mostBlockRows + 1; // equal ones: a short one gains little
    if (!solveInBlocks(rows, solution, n / blocks + 1)) {
        solveInBlocks(rows, solution, n);
    }
}

} // namespace splineloft::families
