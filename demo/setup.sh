# SPDX-License-Identifier: MIT
# Sourced by demo/run and tests/run: installs what the build needs and is not there, and builds. Says nothing when there is
# nothing to do.
set -euo pipefail

root=$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")/.." && pwd)
build_directory=$root/build/release

# Debian package, name of the project, header.
libraries=(
    "libglm-dev           GLM            glm/glm.hpp"
    "libopenimageio-dev   OpenImageIO    OpenImageIO/imageio.h"
    "catch2               Catch2         catch2/catch.hpp"
    "libhwy-dev           Highway        hwy/highway.h"
    "libtbb-dev           oneTBB         tbb/parallel_for.h"
    "libcli11-dev         CLI11          CLI/CLI.hpp"
    "libtomlplusplus-dev  toml++         toml++/toml.h"
    "libtinygltf-dev      tinygltf       tiny_gltf.h"
    "nlohmann-json3-dev   nlohmann-json  nlohmann/json.hpp"
    "nettle-dev           Nettle         nettle/sha2.h"
)
# Debian package, name of the project, command.
tools=(
    "g++          GCC         ${CXX:-c++}"
    "cmake        CMake       cmake"
    "ninja-build  Ninja       ninja"
    "pkg-config   pkg-config  pkg-config"
)

say() { printf '%s\n' "$*" >&2; }

# Prints "package project" for each thing that is missing.
list_missing() {
    local package project what
    for line in "${tools[@]}"; do
        read -r package project what <<<"$line"
        command -v "$what" >/dev/null || printf '%s %s\n' "$package" "$project"
    done
    for line in "${libraries[@]}"; do
        read -r package project what <<<"$line"
        if command -v "${CXX:-c++}" >/dev/null; then
            printf '#if !__has_include(<%s>)\n#error\n#endif\n' "$what" |
                "${CXX:-c++}" -std=c++20 -E -x c++ - >/dev/null 2>&1 && continue
        fi
        printf '%s %s\n' "$package" "$project"
    done
}

# Whether apt may be used; sets `as_root`.
can_install() {
    as_root=()
    command -v apt-get >/dev/null || return 1
    [[ $(id -u) == 0 ]] && return 0
    command -v sudo >/dev/null || return 1
    as_root=(sudo)
}

install_missing() {
    local missing package project log
    missing=$(list_missing)
    [[ -z $missing ]] && return
    if ! can_install; then
        # Ninja is only the faster way.
        command -v make >/dev/null && missing=$(grep -v '^ninja-build ' <<<"$missing" || true)
        [[ -z $missing ]] && return
        say "nimbus7 needs these, and they cannot be installed from here (no apt-get, or neither root nor sudo):"
        while read -r package project; do say "  $project (Debian package $package)"; done <<<"$missing"
        exit 1
    fi
    local packages=()
    while read -r package project; do packages+=("$package"); done <<<"$missing"
    say "Installing ${packages[*]}"
    local install=("${as_root[@]}" env DEBIAN_FRONTEND=noninteractive
        apt-get install -y -qq --no-install-recommends "${packages[@]}")
    log=$(mktemp)
    if ! "${install[@]}" >"$log" 2>&1; then
        # The list of packages may be missing or old.
        if ! { "${as_root[@]}" apt-get update -qq && "${install[@]}"; } >"$log" 2>&1; then
            cat "$log" >&2
            rm -f "$log"
            say "The packages could not be installed."
            exit 1
        fi
    fi
    rm -f "$log"
}

# Builds the targets named, or all.
build() {
    local log=$build_directory/build.log targets=()
    (($# > 0)) && targets=(--target "$@")
    mkdir -p "$build_directory"
    [[ -x $build_directory/bin/nimbus7 ]] || say "Building in $build_directory (the first time takes minutes)"
    {
        # Without a cache the generator may be chosen; without a build file an earlier attempt has failed.
        if [[ ! -f $build_directory/build.ninja && ! -f $build_directory/Makefile ]]; then
            local generator=()
            [[ -f $build_directory/CMakeCache.txt ]] || ! command -v ninja >/dev/null || generator=(-G Ninja)
            cmake -S "$root" -B "$build_directory" "${generator[@]}" -DCMAKE_BUILD_TYPE=Release
        fi && cmake --build "$build_directory" --parallel "$(nproc)" "${targets[@]}"
    } >"$log" 2>&1 || {
        cat "$log" >&2
        exit 1
    }
}
