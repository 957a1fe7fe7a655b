#!/usr/bin/env bash
# Lets each fuzz target run for so many seconds, under the sanitizers: fuzz.sh [SECONDS] [TARGET...]
#
# Starts from the corpus in tests/fuzz/corpus, which it also feeds: inputs that reach something new
# are added, as few and short as they can be. Ten minutes each is what a release gets.
set -euo pipefail

# shellcheck source=tools/setup.sh
source "$(dirname "${BASH_SOURCE[0]}")/../../tools/setup.sh"

readonly seconds="${1:-600}"
shift || true
targets=("$@")
if [[ ${#targets[@]} -eq 0 ]]; then
    targets=(conversions documents evaluation lengths nearest_spots pastes)
fi

set_up_for_fuzzing
configure fuzz
build fuzz
for target in "${targets[@]}"; do
    program="$(build_folder fuzz)/tests/fuzz/fuzz_$target"
    corpus="$root/tests/fuzz/corpus/$target"
    found="$(build_folder fuzz)/found/$target"
    mkdir -p "$corpus" "$found"
    say "== $target: $seconds s"
    (cd "$(build_folder fuzz)" && "$program" -max_total_time="$seconds" -timeout=20 -max_len=1024 -len_control=0 \
        -rss_limit_mb=4096 -print_final_stats=1 "$found" "$corpus" 2>&1 | tail -n 12) ||
        fail "$target found something (see above)"
    "$program" -merge=1 "$corpus" "$found" >/dev/null 2>&1
done
