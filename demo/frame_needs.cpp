// SPDX-License-Identifier: MIT
#include "demo/frame_needs.h"

#include <algorithm>
#include <set>

#include "pipeline/check/idle_state.h"
#include "pipeline/check/target_use.h"
#include "pipeline/execute/fill_kernel_list.h"
#include "pipeline/frame/field_traits.h"

namespace demo {

using namespace pipeline;

namespace {

// "SRCALPHA INVSRCALPHA": the enumerators of a struct.
template <FieldStruct Struct>
std::string enumerators_of(const Struct& state) {
    std::string text;
    visit_fields(state, [&](std::string_view, const auto& field) {
        if constexpr (NamedEnum<std::remove_cvref_t<decltype(field)>>)
            text += (text.empty() ? "" : " ") + std::string(enum_name(field));
    });
    return text;
}

std::string sampling_of(const TextureStage& stage) {
    std::string text(enum_name(stage.filter));
    for (const std::string_view name :
         {enum_name(stage.mip_filter), enum_name(stage.address_u), enum_name(stage.address_v)})
        text += ' ' + std::string(name);
    return text;
}

std::size_t bytes_of_attribute(std::string_view attribute) {
    std::size_t bytes = 0;
    const Vertex vertex{};
    visit_fields(vertex, [&](std::string_view name, const auto& field) {
        if (name == attribute) bytes = sizeof field;
    });
    return bytes;
}

std::size_t vertex_count(const Frame& frame, const DrawTriangles& draw) {
    const auto first = frame.indices.begin() + static_cast<std::ptrdiff_t>(draw.first_index);
    return std::set<std::uint32_t>(first, first + static_cast<std::ptrdiff_t>(draw.index_count)).size();
}

MemoryNeeds memory_of(const Frame& frame) {
    MemoryNeeds memory;
    for (const Pass& pass : frame.passes) {
        std::size_t bytes_per_vertex = 0;
        for (const std::string_view name : vertex_attributes(frame, pass)) bytes_per_vertex += bytes_of_attribute(name);
        for (const Draw& draw : pass.draws) {
            if (const auto* triangles = std::get_if<DrawTriangles>(&draw)) {
                memory.vertices += bytes_per_vertex * vertex_count(frame, *triangles);
                memory.indices += sizeof(std::uint32_t) * triangles->index_count;
            } else if (const auto* window = std::get_if<DrawWindowTriangles>(&draw)) {
                memory.indices += sizeof(std::uint32_t) * window->index_count;
            }
        }
    }
    memory.vertices += sizeof(WindowVertex) * frame.window_vertices.size();
    return memory;
}

}  // namespace

void FrameNeeds::add(const Frame& frame) {
    ++frames;
    passes += frame.passes.size();
    add_state_uses(frame, states);
    MemoryNeeds own = memory_of(frame);

    const std::vector<bool> used = targets_in_use(frame);
    for (std::size_t i = 0; i < used.size(); ++i) {
        const pipeline::Target& target = frame.targets[i];
        if (!used[i]) continue;
        const auto bytes = static_cast<std::uint64_t>(target.width) * static_cast<std::uint64_t>(target.height) *
                           static_cast<std::uint64_t>(bytes_per_pixel(target.format));
        own.targets += bytes;
        ++targets[{target.name, std::string(enum_name(target.format)), target.width, target.height, bytes}];
    }

    std::set<Texture> read;
    std::vector<bool> is_counted(frame.textures.size());
    for (const Pass& pass : frame.passes) {
        for (const Draw& draw : pass.draws)
            std::visit([&](const auto& of) { ++draws[kAlternativeName<std::remove_cvref_t<decltype(of)>>]; }, draw);
        for (const std::string_view name : vertex_attributes(frame, pass)) ++attributes[std::string(name)];
        if (writes_color(frame, pass))
            ++blends[frame.arithmetic.blend == BlendRule::GsShift7 ? enumerators_of(pass.state.gs_blend)
                                                                   : enumerators_of(pass.state.blend)];
        for_each_texture(pass, [&](std::size_t, std::size_t stage, const TextureBinding& binding) {
            if (!binding.texture) return;
            const auto index                 = static_cast<std::size_t>(binding.texture.index);
            const pipeline::Texture& texture = frame.textures[index];
            read.insert({texture.name, std::string(enum_name(texture.format)), texture.width, texture.height,
                         texture.levels, texture.texels.size(), sampling_of(pass.state.stages[stage])});
            if (!is_counted[index]) own.textures += texture.texels.size();
            is_counted[index] = true;
        });
    }
    for (const Texture& texture : read) ++textures[texture];
    for (const FillKernelName& kernel : fill_kernels_of(frame))
        ++kernels[{kernel.primitive, kernel.name, kernel.is_special}];

    memory.targets  = std::max(memory.targets, own.targets);
    memory.textures = std::max(memory.textures, own.textures);
    memory.vertices = std::max(memory.vertices, own.vertices);
    memory.indices  = std::max(memory.indices, own.indices);
}

void FrameNeeds::add(const RewriteNotes& notes) {
    for (const RewriteNote& note : notes) ++rewrites[std::string(note.rewrite)];
}

}  // namespace demo
