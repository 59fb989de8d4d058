// SPDX-License-Identifier: MIT
#include "pipeline/validate/validate.h"

#include <algorithm>
#include <bit>

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
void check_vertices(const Frame& frame, Findings& findings) {
    std::size_t bad = 0, first = 0;
    for (std::size_t i = 0; i < frame.vertices.size(); ++i) {
        bool finite = true;
        visit_fields(frame.vertices[i], [&](std::string_view, const auto& field) {
            if constexpr (kIsVec<std::remove_cvref_t<decltype(field)>>) finite = finite && is_finite(field);
        });
        if (!finite && bad++ == 0) first = i;
    }
    if (bad == 0) return;
    check_values(frame, frame.vertices[first], Place("vertex", first, {}), findings);
    if (bad > 1) findings.back().what += "; " + std::to_string(bad - 1) + " more vertices are not finite";
}

void check_indices(const Frame& frame, const Place& place, Findings& findings) {
    std::size_t bad = 0, first = 0;
    for (std::size_t i = 0; i < frame.indices.size(); ++i) {
        if (frame.indices[i] >= frame.vertices.size() && bad++ == 0) first = i;
    }
    if (bad == 0) return;
    std::string what = "must be less than the number of vertices, " + std::to_string(frame.vertices.size()) +
                       got(frame.indices[first]);
    if (bad > 1) what += "; " + std::to_string(bad - 1) + " more are not";
    report(findings, place.entry("indices", first), std::move(what));
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
    check_vertices(frame, findings);
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
