#!/usr/bin/env bash
# Runs every test: ./test.sh [quick], or the benchmark: ./test.sh bench
#
# First the release build with all tests, then the tests that open no window once more under
# AddressSanitizer, LeakSanitizer and UndefinedBehaviorSanitizer. `quick` leaves the second out.
# The last line counts both together. With CI=true a check that lacks its tool fails, not skips.
#
# `bench` instead measures the library beside its peers, then frames of the window and, where there
# is a display, its start: about four minutes. What it prints is for reading: a goal that is missed
# on a busy machine is no failed test.
set -euo pipefail

# shellcheck source=tools/setup.sh
source "$(dirname "${BASH_SOURCE[0]}")/tools/setup.sh"

passed=0
failed=0
skipped=0

# Adds what one run of ctest counted, read from the head of its JUnit report.
add_up() {
    local head
    head="$(tr '\n\t' '  ' <"$1" | grep -o '<testsuite [^>]*>' | head -n 1)"
    attribute() { sed -n "s/.* $1=\"\([0-9]*\)\".*/\1/p" <<<"$head"; }
    local bad skips
    bad="$(attribute failures)"
    skips=$(($(attribute skipped) + $(attribute disabled)))
    passed=$((passed + $(attribute tests) - bad - skips))
    failed=$((failed + bad))
    skipped=$((skipped + skips))
}

# run_tests PRESET: builds it and runs its tests; failures are counted, not fatal.
run_tests() {
    local preset="$1" folder report all_good=true
    folder="$(build_folder "$preset")"
    report="$folder/tests.xml"
    say "== $preset: building"
    configure "$preset" -DSPLINELOFT_TESTS=ON
    build "$preset"
    say "== $preset: testing"
    rm -f "$report"
    # One test more than there are processors: those of the window mostly wait. (ctest finds its
    # preset in the current directory only.)
    (cd "$root" &&
        ctest --preset "$preset" --parallel $(($(nproc) + 1)) --output-junit "$report") ||
        all_good=false
    [[ -s $report ]] || fail "ctest ran no test of the preset '$preset' (see above)"
    add_up "$report"
    if ! $all_good && [[ $failed -eq 0 ]]; then
        fail "ctest failed with the preset '$preset' although no test did (see above)"
    fi
}

# Builds the benchmarks and runs them; prints their tables, and what CMake did not find for them.
run_bench() {
    local folder
    folder="$(build_folder bench)"
    say "== bench: building"
    configure bench
    sed -n '/^CMake Warning/,/^$/p' "$folder/configure.log"
    build bench bench
    build bench window_bench
    build bench startup_bench
    "$folder/tests/bench/bench"
    say ""
    say "== frames of the window, on curves of 10^3 to 10^6 points; goal: 2000 us, and 1 us a changed piece"
    "$folder/tests/bench/window_bench"
    if [[ -n ${DISPLAY:-} ]]; then
        "$folder/tests/bench/startup_bench"
    else
        say "no display: the start of the window was not measured"
    fi
}

case "$*" in
'') presets=(release sanitize) ;;
quick) presets=(release) ;;
bench)
    set_up_for_bench
    run_bench
    exit
    ;;
*)
    printf 'usage: test.sh [quick|bench]\n' >&2
    exit 2
    ;;
esac

set_up_for_tests
for preset in "${presets[@]}"; do
    run_tests "$preset"
done

say ""
say "$passed passed, $failed failed, $skipped skipped"
[[ $failed -eq 0 && $passed -gt 0 ]]
