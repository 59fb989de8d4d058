// SPDX-License-Identifier: MIT
// What frames ask of whoever draws them: states, formats, textures, kernels, attributes of vertices, memory. Only what has a
// part in the picture counts (pipeline/check/idle_state.h).
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "pipeline/check/state_use.h"
#include "pipeline/frame/frame.h"
#include "pipeline/legalize/legalize.h"

namespace demo {

// Bytes as the formats have them; triangles' vertices with the attributes that their passes need, each once for a pass.
struct MemoryNeeds {
    std::uint64_t targets = 0, textures = 0, vertices = 0, indices = 0;
};

// Of one frame or several: counts are sums, memory is that of the frame that needs most of each.
struct FrameNeeds {
    struct Target {
        std::string name, format;
        int width = 0, height = 0;
        std::uint64_t bytes                   = 0;
        auto operator<=>(const Target&) const = default;
    };
    // sampling: how passes read it, "LINEAR LINEAR WRAP WRAP": filter, mip_filter, address_u, address_v.
    struct Texture {
        std::string name, format;
        int width = 0, height = 0, levels = 0;
        std::uint64_t bytes = 0;
        std::string sampling;
        auto operator<=>(const Texture&) const = default;
    };
    struct Kernel {
        std::string_view primitive, name;
        bool is_special                       = false;
        auto operator<=>(const Kernel&) const = default;
    };
    using Uses = std::map<std::string, std::size_t>;  // passes

    std::size_t frames = 0, passes = 0;
    std::map<std::string_view, std::size_t> draws;  // by what they are called in a frame's text
    pipeline::StateUses states;
    Uses blends;  // by the enumerators of the blend, in the order of its fields
    Uses attributes;
    std::map<Target, std::size_t> targets;    // frames
    std::map<Texture, std::size_t> textures;  // frames
    std::map<Kernel, std::size_t> kernels;    // draws
    MemoryNeeds memory;
    Uses rewrites;  // notes

    // The frame must be valid.
    void add(const pipeline::Frame& frame);
    void add(const pipeline::RewriteNotes& notes);
};

}  // namespace demo
