// SPDX-License-Identifier: MIT
#include "pipeline/legalize/formats.h"

#include <optional>

#include "pipeline/check/chip_findings.h"
#include "pipeline/check/target_use.h"
#include "pipeline/legalize/alpha_use.h"

namespace pipeline {

namespace {

bool is_gs_format(TargetFormat format) {
    return format == TargetFormat::Psmct32 || format == TargetFormat::Psmct24 || format == TargetFormat::Psmct16;
}

bool is_legal(TargetFormat format, const TargetUse& use, const ChipFormats& formats) {
    if (is_depth(format)) return !use.drawn || is_among(format, formats.depth);
    return (!use.drawn || is_among(format, formats.draw)) && (!use.copied_to || is_among(format, formats.copy_targets));
}

TargetFormat color_format_for(TargetFormat format, bool reads_alpha, const ChipFormats& formats) {
    if (format == TargetFormat::A1R5G5B5 && !reads_alpha && is_among(TargetFormat::Psmct16, formats.draw))
        return TargetFormat::Psmct16;
    const bool needs_alpha = keeps_alpha(format) && (reads_alpha || keeps_bytes(formats.with_alpha));
    return needs_alpha ? formats.with_alpha : formats.opaque;
}

int bits_of(TargetFormat depth) {
    return depth == TargetFormat::D16 ? 16 : depth == TargetFormat::D24 ? 24 : 32;
}

// The colour formats that a depth target is used beside.
std::vector<TargetFormat> partners_of(const Frame& frame, TargetId depth) {
    std::vector<TargetFormat> partners;
    for (const Pass& pass : frame.passes) {
        const Target* color = find_target(frame, pass.color);
        if (color != nullptr && pass.depth == depth && uses_depth(pass)) partners.push_back(color->format);
    }
    return partners;
}

std::optional<TargetFormat> depth_format_for(TargetFormat format, const std::vector<TargetFormat>& partners,
                                             const ChipFormats& formats) {
    std::optional<TargetFormat> best;
    const auto is_better = [&](TargetFormat other) {
        if (!best) return true;
        const int want = bits_of(format), has = bits_of(*best), would = bits_of(other);
        return has < want ? would > has : would >= want && would < has;
    };
    for (const TargetFormat candidate : formats.depth) {
        const bool goes = std::all_of(partners.begin(), partners.end(),
                                      [&](TargetFormat color) { return go_together(formats, color, candidate); });
        if (goes && is_better(candidate)) best = candidate;
    }
    return best;
}

void set_format(Frame& frame, std::size_t index, TargetFormat format, std::string why, RewriteNotes& notes) {
    Target& target = frame.targets[index];
    if (target.format == format) return;
    notes.push_back({"formats", Place("target", index, target.name).text(), std::move(why),
                     text_of(target.format) + " became " + text_of(format)});
    target.format = format;
}

// Whole bytes are not dithered.
void drop_dithers(Frame& frame, TargetId target) {
    for (Pass& pass : frame.passes)
        if (pass.color == target) pass.state.dither = {};
}

void rewrite_colors(Frame& frame, const std::vector<TargetUse>& uses, const ChipFormats& formats, RewriteNotes& notes) {
    for (std::size_t i = 0; i < frame.targets.size(); ++i) {
        const TargetFormat format = frame.targets[i].format;
        if (is_depth(format) || is_gs_format(format) || is_legal(format, uses[i], formats)) continue;
        const bool reads_alpha   = is_alpha_read(frame, {static_cast<std::int32_t>(i)});
        const TargetFormat other = color_format_for(format, reads_alpha, formats);
        if (!is_legal(other, uses[i], formats)) continue;
        set_format(frame, i, other, "the chip's colours are " + names_of(formats.draw), notes);
        if (keeps_bytes(other)) drop_dithers(frame, {static_cast<std::int32_t>(i)});
    }
}

void rewrite_depths(Frame& frame, const std::vector<TargetUse>& uses, const ChipFormats& formats, RewriteNotes& notes) {
    for (std::size_t i = 0; i < frame.targets.size(); ++i) {
        const TargetFormat format = frame.targets[i].format;
        if (!is_depth(format) || !uses[i].drawn) continue;
        const std::vector<TargetFormat> partners = partners_of(frame, {static_cast<std::int32_t>(i)});
        const std::optional<TargetFormat> other  = depth_format_for(format, partners, formats);
        if (other) set_format(frame, i, *other, "the depths beside its colours are " + names_of(formats.depth), notes);
    }
}

}  // namespace

Frame rewrite_formats(Frame frame, const Profile& profile, RewriteNotes& notes) {
    const std::vector<TargetUse> uses = target_uses(frame);
    rewrite_colors(frame, uses, profile.formats, notes);
    rewrite_depths(frame, uses, profile.formats, notes);
    return frame;
}

}  // namespace pipeline
