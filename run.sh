#!/usr/bin/env bash
# Opens Splineloft: ./run.sh [FILE...]
#
# Installs what is missing, builds what has changed, and opens the editor on FILE or, with none,
# on an example. Where there is no display it draws the document into a picture instead.
set -euo pipefail

# shellcheck source=tools/setup.sh
source "$(dirname "${BASH_SOURCE[0]}")/tools/setup.sh"

readonly example="$root/assets/examples/ship-lines.json"
readonly preview="$root/build/splineloft-preview.png"

build_the_editor() {
    set_up_for_running
    if ! is_configured release; then
        say "Configuring and building Splineloft; the first time takes a few minutes."
        configure release -DSPLINELOFT_TESTS=OFF
    fi
    build release splineloft
}

editor() { printf '%s/app/splineloft' "$(build_folder release)"; }

has_display() {
    [[ -n ${DISPLAY:-} || -n ${WAYLAND_DISPLAY:-} || $(uname) == Darwin ]]
}

# --help or `families`, unlike a file, need no display.
is_for_the_command_line() { [[ $1 == -* || ($1 != *[./]* && ! -e $1) ]]; }

draw_a_preview() {
    rm -f "$preview"
    "$(editor)" screenshot "$1" -o "$preview" || fail "the preview of $1 could not be drawn"
    say "There is no display here (neither DISPLAY nor WAYLAND_DISPLAY is set), so the editor was"
    say "not opened. A picture of it with $1:"
    say "$preview"
}

build_the_editor >&2 # what goes to stdout is the program's own
if [[ $# -eq 0 ]]; then
    set -- "$example"
fi
if has_display || is_for_the_command_line "$1"; then
    exec "$(editor)" "$@"
fi
draw_a_preview "$1"
