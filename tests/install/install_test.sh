#!/usr/bin/env bash
# Installs the library and builds somebody else's program against it: with find_package, and with
# pkg-config. install_test.sh BUILD_FOLDER
set -euo pipefail

readonly build="$1"
here="$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd -P)"
work="$(mktemp -d)"
trap 'rm -rf "$work"' EXIT
readonly here work prefix="$work/a prefix"

say() { printf '%s\n' "$*"; }

cmake --install "$build" --prefix "$prefix" >"$work/install.log" || {
    cat "$work/install.log" >&2
    exit 1
}

say "no type of Dear ImGui, OpenGL or the JSON library in what was installed:"
if grep -rnE 'nlohmann|imgui|GLFW|glad|GL/|hwy/' "$prefix/include"; then
    exit 1
fi

say "every header stands by itself:"
while IFS= read -r header; do
    printf '#include "%s"\n' "${header#"$prefix/include/"}"
done < <(find "$prefix/include" -name '*.h' | sort) >"$work/headers.txt"
count=0
while IFS= read -r line; do
    printf '%s\n' "$line" >"$work/one.cpp"
    "${CXX:-c++}" -std=c++20 -fsyntax-only -Wall -Wextra -Werror \
        -I "$prefix/include" -I "$prefix/include/splineloft" "$work/one.cpp"
    count=$((count + 1))
done <"$work/headers.txt"
say "$count headers"
[[ $count -gt 10 ]]

say "with find_package:"
cmake -S "$here/consumer" -B "$work/consumer" -DCMAKE_PREFIX_PATH="$prefix" \
    -DCMAKE_BUILD_TYPE=Release >"$work/configure.log" || {
    cat "$work/configure.log" >&2
    exit 1
}
cmake --build "$work/consumer" >"$work/build.log" || {
    cat "$work/build.log" >&2
    exit 1
}
"$work/consumer/consumer"

say "with pkg-config:"
PKG_CONFIG_PATH="$(dirname "$(find "$prefix" -name splineloft.pc)")"
export PKG_CONFIG_PATH
eval "flags=($(pkg-config --cflags --libs splineloft))"
# shellcheck disable=SC2154 # eval sets them
"${CXX:-c++}" -std=c++20 "$here/consumer/main.cpp" "${flags[@]}" -o "$work/with-pkg-config"
"$work/with-pkg-config"
