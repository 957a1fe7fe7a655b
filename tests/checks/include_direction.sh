#!/usr/bin/env bash
# The rooms' arrows run one way, core <- ui <- app, and OpenGL stays in the app.
#
#   include_direction.sh [TREE]         checks the source tree (default: this one)
#   include_direction.sh --self-test    plants every forbidden line and sees that it is caught
#
# A rule is one line: where, what may not be included there, why.
set -euo pipefail

readonly opengl='GL/|GLES|EGL/|KHR/|glad|OpenGL/|epoxy/|imgui_impl_'
readonly glfw='GLFW/'
readonly imgui='imgui|ui/imgui_compat'

list_rules() {
    cat <<RULES
core|ui/|core knows no interface
core|app/|core knows no application
core|$imgui|core draws nothing
core|$opengl|core draws nothing
core|$glfw|core opens no window
core/spline|core/document|splines know no document
core/spline|core/formats|splines know no format
core/document|core/formats|documents know no format
ui|app/|the interface knows no application
ui|$opengl|only app sees OpenGL
ui|$glfw|only app sees GLFW
ui/canvas|$imgui|canvas logic is pure functions
ui/canvas|ui/panels|panels use the canvas, not the other way
RULES
}

source_lines() { # TREE FOLDER PATTERN -> file:line:text, paths relative to the tree
    (cd "$1" && grep -rnE --include='*.h' --include='*.hpp' --include='*.cpp' --include='*.c' \
        --include='*.inl' --include='*.in' -- "$3" "$2") || true
}

includes_of() { source_lines "$1" "$2" "^[[:space:]]*#[[:space:]]*include[[:space:]]*[<\"]($3)"; }

# The last field of a rule is its reason, the first its folder; between them a pattern with bars.
check_rules() {
    local tree="$1" rule folder reason pattern
    while IFS= read -r rule; do
        folder="${rule%%|*}"
        reason="${rule##*|}"
        pattern="${rule#*|}"
        pattern="${pattern%|*}"
        includes_of "$tree" "$folder" "$pattern" | sed "s/\$/    <- $reason/"
    done < <(list_rules)
}

# A path with .. would walk past the rules above.
check_that_paths_start_at_the_root() {
    local folder
    for folder in core ui app; do
        includes_of "$1" "$folder" '[^">]*\.\./' | sed 's/$/    <- write the path from the root/'
    done
}

check_draw_calls() {
    local folder
    for folder in core ui app; do
        source_lines "$1" "$folder" '^([^/]|/[^/])*\<gl(Multi)?Draw[A-Z][A-Za-z]*[[:space:]]*\(' |
            grep -v '^app/renderer\.cpp:' | sed 's/$/    <- only app\/renderer.cpp draws/' || true
    done
}

check() {
    local tree="$1" folder findings
    for folder in core/spline core/document core/formats ui/canvas app; do
        if [[ -z "$(find "$tree/$folder" -name '*.cpp' -print -quit 2>/dev/null)" ]]; then
            printf 'there is no source file in %s: nothing was checked\n' "$folder" >&2
            return 1
        fi
    done
    findings="$(
        check_rules "$tree"
        check_that_paths_start_at_the_root "$tree"
        check_draw_calls "$tree"
    )"
    if [[ -n $findings ]]; then
        printf '%s\n' "$findings" >&2
        return 1
    fi
}

plant_a_good_tree() {
    local tree="$1"
    mkdir -p "$tree"/{core/{spline,document,formats},ui/{canvas,panels},app}
    printf '#include <vector>\n#include <glm/vec2.hpp>\n' >"$tree/core/spline/good.cpp"
    printf '#include "core/spline/good.h"\n' >"$tree/core/document/good.cpp"
    printf '#include "core/document/good.h"\n' >"$tree/core/formats/good.cpp"
    printf '#include "core/document/good.h"\n' >"$tree/ui/canvas/good.cpp"
    printf '#include <imgui.h>\n#include "ui/canvas/good.h"\n' >"$tree/ui/panels/good.cpp"
    printf '#include <glad/gl.h>\n    glDrawArrays(GL_TRIANGLES, 0, 3);\n' >"$tree/app/renderer.cpp"
    printf '#include <GLFW/glfw3.h>\n// renderer calls glDrawArrays(...)\n' >"$tree/app/window.cpp"
}

# expect_refusal FILE LINE: the good tree with this one line added must be refused by file name.
expect_refusal() {
    local tree="$scratch/tree" output
    rm -rf "$tree"
    plant_a_good_tree "$tree"
    mkdir -p "$(dirname "$tree/$1")"
    printf '%s\n' "$2" >>"$tree/$1"
    tried=$((tried + 1))
    if output="$(check "$tree" 2>&1)"; then
        printf 'not caught: %s in %s\n' "$2" "$1" >&2
        missed=$((missed + 1))
    elif [[ $output != *"$1:"* ]]; then
        printf 'refused without naming %s: %s\n' "$1" "$output" >&2
        missed=$((missed + 1))
    fi
}

self_test() {
    scratch="$(mktemp -d)"
    trap 'rm -rf "$scratch"' EXIT
    tried=0
    missed=0

    plant_a_good_tree "$scratch/good"
    check "$scratch/good" || { printf 'the good tree was refused\n' >&2; return 1; }
    mkdir "$scratch/empty"
    if check "$scratch/empty" 2>/dev/null; then
        printf 'an empty tree passed\n' >&2
        return 1
    fi

    expect_refusal core/new.h '#include "ui/session.h"'
    expect_refusal core/new.h '  #  include "app/window.h"'
    expect_refusal core/formats/good.cpp '#include <imgui.h>'
    expect_refusal core/formats/good.cpp '#include "imgui/imgui.h"'
    expect_refusal core/spline/good.cpp '#include <GL/gl.h>'
    expect_refusal core/spline/good.cpp '#include <glad/gl.h>'
    expect_refusal core/spline/good.cpp '#include <GLFW/glfw3.h>'
    expect_refusal core/spline/families/new.cpp.in '#include "core/document/document.h"'
    expect_refusal core/spline/good.cpp '#include "core/document/document.h"'
    expect_refusal core/spline/good.cpp '#include "core/formats/json.h"'
    expect_refusal core/spline/good.cpp '#include "../document/document.h"'
    expect_refusal core/document/good.cpp '#include "core/formats/json.h"'
    expect_refusal ui/panels/good.cpp '#include "app/window.h"'
    expect_refusal ui/panels/good.cpp '#include <EGL/egl.h>'
    expect_refusal ui/panels/good.cpp '#include <imgui_impl_opengl3.h>'
    expect_refusal ui/panels/good.cpp '#include <GLFW/glfw3.h>'
    expect_refusal ui/canvas/good.cpp '#include <imgui.h>'
    expect_refusal ui/canvas/good.cpp '#include "ui/imgui_compat.h"'
    expect_refusal ui/canvas/good.cpp '#include "ui/panels/status.h"'
    expect_refusal app/window.cpp '    glDrawElements(GL_TRIANGLES, 3, type, nullptr);'
    expect_refusal ui/panels/good.cpp 'glDrawArraysInstanced (mode, 0, 4, n);'

    printf '%d planted lines, %d not caught\n' "$tried" "$missed"
    [[ $missed -eq 0 ]]
}

if [[ ${1:-} == --self-test ]]; then
    self_test
else
    check "${1:-"$(dirname "${BASH_SOURCE[0]}")/../.."}"
fi
