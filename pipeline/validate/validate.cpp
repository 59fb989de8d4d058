// SPDX-License-Identifier: MIT
#include "pipeline/validate/validate.h"

#include <algorithm>
#include <bit>
#include <cmath>

#include "pipeline/validate/check_pass.h"
#include "pipeline/validate/check_values.h"

namespace pipeline {

namespace {

void check_size(std::string_view name, std::int32_t size, std::int32_t limit, const Place& place, Findings& findings) {
    if (size >= 1 && size <= limit) return;
    report(findings, place.field(name), "must lie within 1.." + std::to_string(limit) + got(size));
}

void check_output(const Frame& frame, const Place& place, Findings& findings) {
    if (!frame.output) {
        if (frame.output.index == -1) report(findings, place.field("output"), "must refer to a colour target");
        return;
    }
    const Target* output = find_target(frame, frame.output);
    if (output != nullptr && is_depth(output->format)) {
        report(findings, place.field("output"), "must be a colour target" + got(output->format));
    }
}

void check_texture(const Texture& texture, const Place& place, Findings& findings) {
    const std::size_t findings_before = findings.size();
    check_size("width", texture.width, kMaxTextureSize, place, findings);
    check_size("height", texture.height, kMaxTextureSize, place, findings);
    if (findings.size() > findings_before) return;

    const auto longest = static_cast<std::uint32_t>(std::max(texture.width, texture.height));
    const int possible = std::bit_width(longest);  // levels down to 1x1
    if (texture.levels < 1 || texture.levels > possible) {
        report(findings, place.field("levels"),
               "must lie within 1.." + std::to_string(possible) + " for a texture of " + std::to_string(texture.width) +
                   'x' + std::to_string(texture.height) + got(texture.levels));
        return;
    }
    if (texture.levels > 1 && !(is_power_of_two(texture.width) && is_power_of_two(texture.height))) {
        report(findings, place.field("levels"),
               "must be 1 unless width and height are powers of two" + got(texture.levels));
    }
    std::uint64_t bytes = 0;
    for (int level = 0; level < texture.levels; ++level) {
        bytes += static_cast<std::uint64_t>(std::max(1, texture.width >> level)) *
                 static_cast<std::uint64_t>(std::max(1, texture.height >> level)) *
                 static_cast<std::uint64_t>(bytes_per_texel(texture.format));
    }
    if (texture.texels.size() != bytes) {
        report(findings, place.field("texels"),
               "must hold " + std::to_string(bytes) + " bytes" + got(texture.texels.size()));
    }
}

// The first vertex that is not finite stands for all of them.
template <class AnyVertex>
void check_finite(const Frame& frame, const std::vector<AnyVertex>& vertices, std::string_view name,
                  Findings& findings) {
    std::size_t bad = 0, first = 0;
    for (std::size_t i = 0; i < vertices.size(); ++i) {
        bool finite = true;
        visit_fields(vertices[i], [&](std::string_view, const auto& field) {
            using Field = std::remove_cvref_t<decltype(field)>;
            if constexpr (kIsVec<Field> || std::same_as<Field, float>) finite &= is_finite(field);
        });
        if (!finite && bad++ == 0) first = i;
    }
    if (bad == 0) return;
    check_values(frame, vertices[first], Place(name, first, {}), findings);
    if (bad > 1) findings.back().what += "; " + std::to_string(bad - 1) + " more vertices are not finite";
}

bool has_coords_in_range(const WindowVertex& vertex) {
    const auto in_range = [&](const Vec3& uv) {
        for (glm::length_t i = 0; i < 3; ++i)
            if (!(std::abs(uv[i] * vertex.rhw) < 0x1p40f)) return false;
        return true;
    };
    return in_range(vertex.uv0) && in_range(vertex.uv1);
}

// Likewise the first vertex that is out of range. What is not finite has been reported.
void check_window_vertices(const Frame& frame, Findings& findings) {
    constexpr auto kMost = static_cast<float>(kMaxWindowCoordinate);
    for (std::size_t i = 0; i < frame.window_vertices.size(); ++i) {
        const WindowVertex& vertex        = frame.window_vertices[i];
        const std::size_t findings_before = findings.size();
        const Place place("window vertex", i, {});
        const auto refuse = [&](std::string_view name, bool refused, const std::string& what, float value) {
            if (refused) report(findings, place.field(name), what + got(value));
        };
        const std::string near_zero = "must lie within " + std::to_string(kMaxWindowCoordinate) + " pixels of 0";
        refuse("x", std::abs(vertex.x) > kMost, near_zero, vertex.x);
        refuse("y", std::abs(vertex.y) > kMost, near_zero, vertex.y);
        refuse("z", vertex.z < 0.0f || vertex.z > 1.0f, "must lie within 0..1", vertex.z);
        refuse("rhw", vertex.rhw <= 0.0f, "must be greater than 0", vertex.rhw);
        if (findings.size() == findings_before && !has_coords_in_range(vertex))
            report(findings, place, "must have texture coordinates that times rhw are below 2^40");
        if (findings.size() > findings_before) return;
    }
}

// What an index may name: one that no draw uses, a vertex of either kind.
enum Use : std::uint8_t { kUnused, kVertices = 1, kWindowVertices = 2 };
std::vector<std::uint8_t> uses_of_indices(const Frame& frame) {
    std::vector<std::uint8_t> uses(frame.indices.size(), kUnused);
    const auto mark = [&](const auto& draw, Use use) {
        const std::uint64_t end =
            std::min<std::uint64_t>(std::uint64_t{draw.first_index} + draw.index_count, uses.size());
        for (std::uint64_t i = draw.first_index; i < end; ++i) uses[i] |= use;
    };
    for (const Pass& pass : frame.passes)
        for (const Draw& draw : pass.draws) {
            if (const auto* triangles = std::get_if<DrawTriangles>(&draw)) mark(*triangles, kVertices);
            if (const auto* triangles = std::get_if<DrawWindowTriangles>(&draw)) mark(*triangles, kWindowVertices);
        }
    return uses;
}

// The first one out of range stands for all.
template <class IsUsed>
void check_indices(const Frame& frame, std::size_t limit, std::string_view what, IsUsed&& is_used, const Place& place,
                   Findings& findings) {
    std::size_t bad = 0, first = 0;
    for (std::size_t i = 0; i < frame.indices.size(); ++i) {
        if (frame.indices[i] >= limit && is_used(i) && bad++ == 0) first = i;
    }
    if (bad == 0) return;
    std::string text = "must be less than the number of " + std::string(what) + ", " + std::to_string(limit) +
                       got(frame.indices[first]);
    if (bad > 1) text += "; " + std::to_string(bad - 1) + " more are not";
    report(findings, place.entry("indices", first), std::move(text));
}

bool draws_window_triangles(const Frame& frame) {
    return std::any_of(frame.passes.begin(), frame.passes.end(), [](const Pass& pass) {
        return std::any_of(pass.draws.begin(), pass.draws.end(),
                           [](const Draw& draw) { return std::holds_alternative<DrawWindowTriangles>(draw); });
    });
}

void check_indices(const Frame& frame, const Place& place, Findings& findings) {
    // Mostly there is nothing to find, and a look at them all says so.
    std::uint32_t greatest = 0;
    for (const std::uint32_t index : frame.indices) greatest = std::max(greatest, index);
    if (greatest < frame.vertices.size() && !draws_window_triangles(frame)) return;
    const std::vector<std::uint8_t> uses = uses_of_indices(frame);
    const auto names_vertex              = [&](std::size_t i) {
        return (uses[i] & kVertices) != 0 || (uses[i] == kUnused && frame.indices[i] >= frame.window_vertices.size());
    };
    check_indices(frame, frame.vertices.size(), "vertices", names_vertex, place, findings);
    check_indices(
        frame, frame.window_vertices.size(), "window vertices",
        [&](std::size_t i) { return (uses[i] & kWindowVertices) != 0; }, place, findings);
}

}  // namespace

std::vector<Finding> validate(const Frame& frame) {
    Findings findings;
    const Place whole("frame");
    check_id(frame, frame.output, whole.field("output"), findings);
    check_output(frame, whole, findings);
    const Place arithmetic("arithmetic");
    check_values(frame, frame.arithmetic, arithmetic, findings);
    if (frame.arithmetic.pixel_center < 0 || frame.arithmetic.pixel_center > 15) {
        report(findings, arithmetic.field("pixel_center"),
               "must lie within 0..15" + got(frame.arithmetic.pixel_center));
    }
    for (std::size_t i = 0; i < frame.targets.size(); ++i) {
        const Target& target = frame.targets[i];
        const Place place("target", i, target.name);
        check_values(frame, target, place, findings);
        check_size("width", target.width, kMaxTargetSize, place, findings);
        check_size("height", target.height, kMaxTargetSize, place, findings);
    }
    for (std::size_t i = 0; i < frame.textures.size(); ++i) {
        const Place place("texture", i, frame.textures[i].name);
        check_values(frame, frame.textures[i], place, findings);
        check_texture(frame.textures[i], place, findings);
    }
    for (std::size_t i = 0; i < frame.cameras.size(); ++i) {
        check_values(frame, frame.cameras[i], Place("camera", i, frame.cameras[i].name), findings);
    }
    check_finite(frame, frame.vertices, "vertex", findings);
    const std::size_t findings_before = findings.size();
    check_finite(frame, frame.window_vertices, "window vertex", findings);
    if (findings.size() == findings_before) check_window_vertices(frame, findings);
    check_indices(frame, whole, findings);
    for (std::size_t i = 0; i < frame.passes.size(); ++i) {
        const Place place("pass", i, frame.passes[i].label);
        check_values(frame, frame.passes[i], place, findings);
        check_pass_state(frame, frame.passes[i], place, findings);
        check_draws(frame, frame.passes[i], place, findings);
    }
    return findings;
}

}  // namespace pipeline
