// SPDX-License-Identifier: MIT
// Formats and sizes of targets and textures, what stands together, what is read and copied.
#include <set>

#include "pipeline/check/chip_findings.h"
#include "pipeline/check/target_use.h"

namespace pipeline {

namespace {

std::string size_text(std::int32_t width, std::int32_t height) {
    return "width " + std::to_string(width) + " height " + std::to_string(height);
}

// limit 0: none.
std::string limit_text(std::int32_t width, std::int32_t height) {
    return "up to " + size_text(width, height);
}
bool exceeds(std::int32_t size, std::int32_t limit) {
    return limit != 0 && size > limit;
}

// A texture, or a target that is read as one.
void check_texture_size(std::int32_t width, std::int32_t height, std::string_view what, const Place& place,
                        ChipFindings& findings) {
    const ChipLimits& limits = findings.profile().limits;
    if (exceeds(width, limits.texture_width) || exceeds(height, limits.texture_height))
        findings.add(place, "limits", size_text(width, height) + std::string(what),
                     limit_text(limits.texture_width, limits.texture_height));
}

void check_target_format(TargetFormat format, const TargetUse& use, const Place& place, ChipFindings& findings) {
    const ChipFormats& formats = findings.profile().formats;
    const Place at             = place.field("format");
    if (is_depth(format)) {
        if (use.drawn && !is_among(format, formats.depth))
            findings.add(at, "depth", text_of(format), names_of(formats.depth));
        return;
    }
    if (use.drawn && !is_among(format, formats.draw))
        findings.add(at, "targets", text_of(format) + ", drawn to", names_of(formats.draw));
    if (use.copied_to && !is_among(format, formats.copy_targets))
        findings.add(at, "targets", text_of(format) + ", copied to", names_of(formats.copy_targets));
}

void check_target(const Target& target, const TargetUse& use, const Place& place, ChipFindings& findings) {
    const ChipLimits& limits = findings.profile().limits;
    check_target_format(target.format, use, place, findings);
    if (use.drawn && (exceeds(target.width, limits.target_width) || exceeds(target.height, limits.target_height)))
        findings.add(place, "limits", size_text(target.width, target.height) + ", drawn to",
                     limit_text(limits.target_width, limits.target_height));
    if (use.read) check_texture_size(target.width, target.height, ", read as a texture", place, findings);
}

void check_texture_of(const Texture& texture, const Place& place, ChipFindings& findings) {
    const ChipLimits& limits = findings.profile().limits;
    if (!is_among(texture.format, limits.texture_formats))
        findings.add(place.field("format"), "limits", text_of(texture.format), names_of(limits.texture_formats));
    check_texture_size(texture.width, texture.height, "", place, findings);
}

void check_pair(const Frame& frame, const Pass& pass, const Place& place, ChipFindings& findings) {
    const Target* color = find_target(frame, pass.color);
    const Target* depth = find_target(frame, pass.depth);
    if (color == nullptr || depth == nullptr || !uses_depth(pass)) return;
    const ChipFormats& formats = findings.profile().formats;
    if (go_together(formats, color->format, depth->format)) return;
    std::vector<TargetFormat> partners;
    for (const TargetFormat format : formats.depth)
        if (go_together(formats, color->format, format)) partners.push_back(format);
    findings.add(place.field("depth"), "targets", text_of(depth->format) + " beside " + text_of(color->format),
                 names_of(partners));
}

// What lies in a frame buffer that no texture is read from must have been copied out of it. Once for each stage and
// target of a pass.
void check_reading(const Frame& frame, const Pass& pass, const Place& place, ChipFindings& findings) {
    const ChipFormats& formats = findings.profile().formats;
    if (formats.reads_targets) return;
    std::set<std::pair<std::size_t, std::int32_t>> seen;
    for_each_texture(pass, [&](std::size_t draw, std::size_t stage, const TextureBinding& binding) {
        const Target* target = find_target(frame, binding.target);
        if (target == nullptr || is_among(target->format, formats.copy_targets)) return;
        if (!seen.insert({stage, binding.target.index}).second) return;
        findings.add(place.entry("draws", draw).entry("textures", stage).field("target"), "targets",
                     text_of(target->format), "copies of it, " + names_of(formats.copy_targets));
    });
}

void check_copied_formats(const CopyRectangle& copy, TargetFormat from, TargetFormat to, const Place& place,
                          ChipFindings& findings) {
    const ChipFormats& formats = findings.profile().formats;
    const std::string uses     = text_of(from) + " to " + text_of(to);
    if (!copy.halve && !formats.copies) findings.add(place, "copy", uses, "none");
    if (copy.halve && !formats.copies_halve)
        findings.add(place.field("halve"), "copy", "true", formats.copies ? "false" : "none");
    if (from != to && !formats.copies_convert) findings.add(place, "copy", uses, "one format");
    if (findings.profile().limits.frame_buffer_width != 0 && !is_among(from, formats.draw))
        findings.add(place.field("source"), "copy", text_of(from), names_of(formats.draw));
}

void check_copied_parts(const CopyRectangle& copy, const Target& to, const Place& place, ChipFindings& findings) {
    const ChipLimits& limits = findings.profile().limits;
    const PixelRect& from    = copy.from;
    const auto is_off        = [](std::int32_t pixel, std::int32_t step) { return pixel % step != 0; };
    const std::int32_t step  = limits.copy_from_step;
    if (is_off(from.x0, step) || is_off(from.y0, step) || is_off(from.x1, step) || is_off(from.y1, step))
        findings.add(place.field("from"), "limits", differing_fields(from, {}), "multiples of " + std::to_string(step));
    // A tile may go beyond the target, which is padded to whole tiles.
    const std::int32_t tile = limits.copy_tile, scale = copy.halve ? 2 : 1;
    const std::int32_t x1 = copy.x + (from.x1 - from.x0) / scale, y1 = copy.y + (from.y1 - from.y0) / scale;
    if (is_off(copy.x, tile) || is_off(copy.y, tile) || (is_off(x1, tile) && x1 != to.width) ||
        (is_off(y1, tile) && y1 != to.height)) {
        findings.add(place, "limits",
                     "x " + std::to_string(copy.x) + " y " + std::to_string(copy.y) + " to x " + std::to_string(x1) +
                         " y " + std::to_string(y1),
                     "tiles of " + std::to_string(tile) + 'x' + std::to_string(tile));
    }
}

void check_copies(const Frame& frame, const Pass& pass, const Place& place, ChipFindings& findings) {
    const Target* to = find_target(frame, pass.color);
    for (std::size_t i = 0; i < pass.draws.size(); ++i) {
        const auto* copy = std::get_if<CopyRectangle>(&pass.draws[i]);
        if (copy == nullptr) continue;
        const Target* from = find_target(frame, copy->source);
        if (from == nullptr || to == nullptr) continue;
        const Place here = place.entry("draws", i);
        check_copied_formats(*copy, from->format, to->format, here, findings);
        check_copied_parts(*copy, *to, here, findings);
    }
}

}  // namespace

void check_targets_and_textures(const Frame& frame, ChipFindings& findings) {
    const std::vector<TargetUse> uses = target_uses(frame);
    for (std::size_t i = 0; i < frame.targets.size(); ++i)
        check_target(frame.targets[i], uses[i], Place("target", i, frame.targets[i].name), findings);
    for (std::size_t i = 0; i < frame.textures.size(); ++i)
        check_texture_of(frame.textures[i], Place("texture", i, frame.textures[i].name), findings);
}

void check_pass_formats(const Frame& frame, const Pass& pass, const Place& place, ChipFindings& findings) {
    check_pair(frame, pass, place, findings);
    check_reading(frame, pass, place, findings);
    check_copies(frame, pass, place, findings);
}

}  // namespace pipeline
