#!/usr/bin/env bash
# Every C++ file is as clang-format 19 writes it.
#
#   format.sh          names each line that differs
#   format.sh --fix    rewrites the files
#
# Versions format differently, so one is fixed, which Debian 12, Debian 13 and Ubuntu 24.04 all have.
# Where it is missing the check says so and is skipped (exit 77), but with CI=true it fails.
set -euo pipefail

readonly major=19
readonly skipped=77
cd "$(dirname "${BASH_SOURCE[0]}")/../.."

formatter() {
    local candidate
    for candidate in "clang-format-$major" clang-format; do
        if [[ "$("$candidate" --version 2>/dev/null)" == *" version $major."* ]]; then
            printf '%s' "$candidate"
            return
        fi
    done
    return 1
}

if ! tool="$(formatter)"; then
    printf 'THE FORMATTING WAS NOT CHECKED: clang-format %s is not installed\n' "$major" >&2
    if [[ ${CI:-} == true ]]; then
        exit 1
    fi
    exit "$skipped"
fi

mapfile -d '' files < <(find core ui app tests \( -name '*.h' -o -name '*.cpp' \) -type f -print0)
if [[ ${#files[@]} -eq 0 ]]; then
    printf 'there is no C++ file to check\n' >&2
    exit 1
fi

if [[ ${1:-} == --fix ]]; then
    how=(-i)
else
    how=(--dry-run -Werror)
fi
if ! printf '%s\0' "${files[@]}" | xargs -0 -n 8 -P "$(nproc)" "$tool" --style=file "${how[@]}"; then
    printf 'to format them: tests/checks/format.sh --fix\n' >&2
    exit 1
fi
printf '%d files are formatted\n' "${#files[@]}"
