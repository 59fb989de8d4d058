// SPDX-License-Identifier: MIT
// A strict look at a glTF file (2.0) before tinygltf takes it apart, which ignores properties of the wrong type, cuts
// integers to 32 bits, trusts the lengths in a GLB's headers and does not compare views with buffers. After this: the
// GLB's parts lie within the file; every integer and number that we use has its type; indices are 0 to 2^31 - 1; each
// buffer view lies within its buffer. What indices point at, and what accessors hold, gltf_file.h checks where they
// are used.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace demo {

// Of the file, of each file it names, and of all its buffers together.
inline constexpr std::int64_t kMaxGltfBytes = std::int64_t{256} << 20;

// A name or text out of a file, for a complaint: one line, not too long.
std::string in_quotes(std::string_view text);

bool is_glb(std::string_view bytes);

// Throws std::runtime_error with the reason, one line: "nodes[3].translation must be 3 numbers".
void check_gltf(std::string_view bytes);

}  // namespace demo
