#!/usr/bin/env bash
# run.sh where there is no display: it draws the document into a PNG, names it and succeeds,
# from any working directory, with relative paths, spaces in them, and no argument at all.
#
# Uses the build in build/release as it stands, so it belongs after a release build.
set -euo pipefail

root="$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd -P)"
readonly root
unset DISPLAY WAYLAND_DISPLAY
scratch="$(mktemp -d)"
trap 'rm -rf "$scratch"' EXIT

complain() {
    printf '%s\n' "$*" >&2
    exit 1
}

# A picture in which something is drawn: a PNG of some size that is not one colour all over.
expect_a_picture() {
    local facts kind width height deviation
    [[ -s $1 ]] || complain "no file $1"
    facts="$(identify -format '%m %w %h %[fx:standard_deviation]' "$1")"
    read -r kind width height deviation <<<"$facts"
    [[ $kind == PNG && $width -ge 640 && $height -ge 400 ]] || complain "$1 is $facts"
    awk -v d="$deviation" 'BEGIN { exit !(d > 0.01) }' || complain "$1 is one colour: $facts"
}

# expect_preview FOLDER [ARGUMENT...]: runs run.sh in FOLDER and looks at the picture it names.
expect_preview() {
    local output picture
    output="$(cd "$1" && "$root/run.sh" "${@:2}" </dev/null 2>&1)" ||
        complain "run.sh ${*:2} failed: $output"
    [[ $output == *'no display'* ]] || complain "run.sh did not say that there is no display: $output"
    picture="$(tail -n 1 <<<"$output")"
    [[ $picture == /* ]] || complain "the last line is no absolute path: $output"
    expect_a_picture "$picture"
    printf 'drawn: run.sh %s\n' "${*:2}"
}

# expect_failure ARGUMENT...: run.sh must fail and say which file it could not show.
expect_failure() {
    local output
    if output="$("$root/run.sh" "$@" </dev/null 2>&1)"; then
        complain "run.sh $* succeeded: $output"
    fi
    [[ $output == *"$1"* ]] || complain "run.sh $* does not name the file: $output"
    printf 'refused: run.sh %s\n' "$*"
}

mkdir "$scratch/some folder"
cp "$root/assets/examples/ship-lines.json" "$scratch/some folder/a curve.json"

expect_preview "$scratch"
expect_preview "$scratch" 'some folder/a curve.json'
expect_preview "$scratch/some folder" 'a curve.json'
expect_preview / "$scratch/some folder/a curve.json"
expect_failure "$scratch/not there.json"
