# SPDX-License-Identifier: MIT
# cmake -DIN=demo/scenes -DOUT=embedded_scenes.cpp -P embed_scenes.cmake
# Writes a C++ file that holds every .toml file of the folder IN as a raw string, for demo/builtin_scenes.h. Some
# compilers stop at literals of 16 KiB: longer files are split into adjacent ones.
cmake_minimum_required(VERSION 3.20)

file(GLOB files "${IN}/*.toml")
list(SORT files)
set(scenes "")
foreach(file IN LISTS files)
    get_filename_component(name "${file}" NAME_WE)
    file(READ "${file}" text)
    if(text MATCHES "\\)scene\"")
        message(FATAL_ERROR "${file}: holds the characters that end a raw string here: )scene\"")
    endif()
    string(APPEND scenes "    {\"${name}\",\n")
    string(LENGTH "${text}" length)
    set(position 0)
    while(position LESS length)
        string(SUBSTRING "${text}" ${position} 8000 part)
        string(APPEND scenes "     R\"scene(${part})scene\"\n")
        math(EXPR position "${position} + 8000")
    endwhile()
    string(APPEND scenes "     \"\"},\n")
endforeach()

file(WRITE "${OUT}.new" "// Generated from demo/scenes by demo/embed_scenes.cmake.
#include \"demo/builtin_scenes.h\"

#include <array>

namespace demo {

std::span<const EmbeddedScene> embedded_scenes() {
    static constexpr auto kScenes = std::to_array<EmbeddedScene>({
${scenes}    });
    return kScenes;
}

}  // namespace demo
")
file(RENAME "${OUT}.new" "${OUT}")
