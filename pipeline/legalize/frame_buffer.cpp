// SPDX-License-Identifier: MIT
#include "pipeline/legalize/frame_buffer.h"

#include <algorithm>
#include <map>

#include "pipeline/check/chip_findings.h"
#include "pipeline/check/memory_map.h"
#include "pipeline/check/needed_pixels.h"
#include "pipeline/check/target_use.h"
#include "pipeline/legalize/halving_copy.h"
#include "pipeline/legalize/texels_read.h"
#include "pipeline/legalize/wanted_pixels.h"
#include "pipeline/legalize/window_map.h"

namespace pipeline {

namespace {

// Apart: each target has pixels of its own, or shares them in turn as the frame is. Corner: all lie in the top left one.
enum class Sharing : std::uint8_t { Apart, Corner };

// Where a target's pixels are, at one time. not_copied: of those in the buffer, what the copy has not.
struct Held {
    PixelRegion in_buffer, not_copied;
    TargetId copy;
    // How often it is copied, brought back, copied to, and begun in whole tiles.
    int copies = 0, returns = 0, receipts = 0, wider = 0;
};

PixelRect whole_of(const Target& target) {
    return {0, 0, target.width, target.height};
}

// Whole tiles, as far as there are any in the target.
PixelRect in_tiles(const PixelRect& rect, std::int32_t tile, const Target& target) {
    const auto down = [&](std::int32_t pixel) { return pixel / tile * tile; };
    const auto up   = [&](std::int32_t pixel) { return (pixel + tile - 1) / tile * tile; };
    if (!has_pixels(rect)) return {};
    return common_part({down(rect.x0), down(rect.y0), up(rect.x1), up(rect.y1)}, whole_of(target));
}

// The state that limits a pass to a part of its target.
PixelRect scissor_for(const PixelRect& part, const Target& target) {
    return part == whole_of(target) ? PixelRect{} : part;
}

TextureStage show_texel() {
    return {.color_op  = TextureOp::SelectArg1,
            .alpha_op  = TextureOp::SelectArg1,
            .address_u = TextureAddress::Clamp,
            .address_v = TextureAddress::Clamp};
}

class BufferKeeper {
  public:
    BufferKeeper(const Frame& frame, const Profile& profile, Sharing sharing)
        : before_(frame), frame_(frame), profile_(profile), sharing_(sharing), wanted_(wanted_pixels(frame)) {
        held_.resize(frame.targets.size());
        // All are zeros, and so are their copies.
        for (std::size_t i = 0; i < held_.size(); ++i) held_[i].in_buffer.add(whole_of(frame.targets[i]));
        frame_.passes.clear();
    }

    Frame run(RewriteNotes& notes) {
        for (pass_ = 0; pass_ < before_.passes.size(); ++pass_) {
            const Pass& pass = before_.passes[pass_];
            if (std::any_of(pass.draws.begin(), pass.draws.end(), &is_copy))
                copy_pass(pass);
            else if (!halve(pass, notes))
                draw_pass(pass);
        }
        if (is_in_buffer(frame_.output)) hold(frame_.output, PixelRegion(whole_of(target(frame_.output))));
        for (std::size_t i = 0; i < held_.size(); ++i) add_note(i, notes);
        return std::move(frame_);
    }

  private:
    const Target& target(TargetId id) const { return frame_.targets[static_cast<std::size_t>(id.index)]; }
    Held& held(TargetId id) { return held_[static_cast<std::size_t>(id.index)]; }
    const PixelRegion& wanted(TargetId id, std::size_t pass) const {
        return wanted_[static_cast<std::size_t>(id.index)][pass];
    }

    bool is_in_buffer(TargetId id) const { return id && is_among(target(id).format, profile_.formats.draw); }

    // Half of it is in whole tiles too.
    PixelRect in_tiles(const PixelRect& rect, TargetId id) const {
        return pipeline::in_tiles(rect, 2 * profile_.limits.copy_tile, target(id));
    }
    PixelRegion in_tiles(const PixelRegion& region, TargetId id) const {
        PixelRegion tiles;
        for (const PixelRect& part : region.parts()) tiles.add(in_tiles(part, id));
        return tiles;
    }

    TargetId copy_of(TargetId id) {
        TargetId& copy = held(id).copy;
        if (copy) return copy;
        Target made = target(id);
        made.name += ", copy";
        made.format = profile_.formats.copy_targets.front();
        copy        = {static_cast<std::int32_t>(frame_.targets.size())};
        frame_.targets.push_back(std::move(made));
        return copy;
    }

    // What the copy lacks of the region.
    void copy_out(TargetId id, const PixelRegion& region) {
        const PixelRegion lacking = common_part(held(id).not_copied, region);
        if (lacking.empty()) return;
        Pass copy;
        copy.label = target(id).name + ": copied";
        copy.color = copy_of(id);
        for (const PixelRect& part : lacking.parts())
            copy.draws.push_back(CopyRectangle{.source = id, .from = part, .x = part.x0, .y = part.y0});
        frame_.passes.push_back(std::move(copy));
        held(id).not_copied.remove(lacking);
        ++held(id).copies;
    }

    // The others leave these pixels; what is wanted of them is copied.
    void make_room(TargetId id, const PixelRegion& region) {
        if (sharing_ == Sharing::Apart) return;
        for (std::size_t i = 0; i < held_.size(); ++i) {
            const TargetId other{static_cast<std::int32_t>(i)};
            if (other == id || !is_in_buffer(other)) continue;
            const PixelRegion lost = in_tiles(common_part(region, held_[i].in_buffer), other);
            copy_out(other, common_part(lost, in_tiles(wanted(other, pass_), other)));
            held_[i].in_buffer.remove(lost);
            held_[i].not_copied.remove(lost);
        }
    }

    // The buffer gets those pixels of the target that it has not.
    void hold(TargetId id, const PixelRegion& region) {
        const PixelRegion missing = without(region, held(id).in_buffer);
        if (missing.empty()) return;
        make_room(id, missing);
        const TargetId copy = copy_of(id);
        const Target& shown = target(id);
        const float center  = static_cast<float>(frame_.arithmetic.pixel_center - 8) / 16.0f;
        const auto width = static_cast<float>(shown.width), height = static_cast<float>(shown.height);
        Pass pass;
        pass.label           = shown.name + ": brought back";
        pass.color           = id;
        pass.state.stages[0] = show_texel();
        for (const PixelRect& part : missing.parts()) {
            const auto x0 = static_cast<float>(part.x0), y0 = static_cast<float>(part.y0),
                       x1 = static_cast<float>(part.x1), y1 = static_cast<float>(part.y1);
            DrawRectangle draw{.x0 = x0 + center, .y0 = y0 + center, .x1 = x1 + center, .y1 = y1 + center};
            draw.uv[0]              = {x0 / width, y0 / height, x1 / width, y1 / height};
            draw.textures[0].target = copy;
            pass.draws.push_back(draw);
        }
        frame_.passes.push_back(std::move(pass));
        held(id).in_buffer.add(missing);
        ++held(id).returns;
    }

    void bind_copies(Pass& pass) {
        std::map<std::int32_t, PixelRegion> read;
        const PixelRect limit = limit_of(frame_, pass);
        for_each_texture(pass, [&](std::size_t draw, std::size_t stage, const TextureBinding& binding) {
            if (binding.target && is_in_buffer(binding.target))
                read[binding.target.index].add(
                    in_tiles(texels_read(frame_, pass, pass.draws[draw], stage, limit), binding.target));
        });
        for (const auto& [index, region] : read) copy_out({index}, region);
        for (Draw& draw : pass.draws)
            if (TextureBindings* bindings = bindings_of(draw))
                for (TextureBinding& binding : *bindings)
                    if (read.contains(binding.target.index)) binding.target = copy_of(binding.target);
    }

    // What overwrites all of the area, and is the pass where anybody can see it; nothing if there is no such.
    std::vector<Pass> begun(const Pass& pass, const PixelRegion& area) const {
        const PixelRegion beside = without(area, drawn_to(frame_, pass));
        if (meet(beside, wanted(pass.color, pass_ + 1))) return {};
        Pass wide            = pass;
        wide.state.viewport  = {};
        wide.state.scissor   = scissor_for(area.bounds(), target(pass.color));
        const bool can_widen = !beside.empty() && area.parts().size() == 1;
        if (can_widen && pass.clear.color) {
            Pass clear;
            clear.label         = pass.label;
            clear.color         = pass.color;
            clear.clear.color   = pass.clear.color;
            clear.state.scissor = wide.state.scissor;
            Pass rest           = pass;
            rest.clear.color    = {};
            if (rest.clear == Clear{} && rest.draws.empty()) return {clear};
            return {clear, rest};
        }
        const bool is_plain = !draws_triangles(pass) && pass.clear == Clear{} && !uses_depth(pass);
        const Pass& one     = can_widen && is_plain ? wide : pass;
        if (without(area, overwritten(frame_, one)).empty()) return {one};
        return {};
    }

    void draw_pass(Pass pass) {
        bind_copies(pass);
        PixelRegion area;
        if (is_in_buffer(pass.color)) area = in_tiles(drawn_to(frame_, pass), pass.color);
        if (area.empty()) {
            frame_.passes.push_back(std::move(pass));
            return;
        }
        std::vector<Pass> passes;
        if (sharing_ == Sharing::Corner) passes = begun(pass, area);
        make_room(pass.color, area);
        const bool is_as_it_was = passes.empty() || (passes.size() == 1 && passes[0] == pass);
        held(pass.color).wider += !is_as_it_was;
        if (passes.empty()) {
            hold(pass.color, without(area, overwritten(frame_, pass)));
            passes = {pass};
        }
        held(pass.color).in_buffer.add(area);
        held(pass.color).not_copied.add(area);
        std::move(passes.begin(), passes.end(), std::back_inserter(frame_.passes));
    }

    // If it is no more trouble to have all of the source in the buffer than to draw the half.
    bool halve(const Pass& pass, RewriteNotes& notes) {
        if (!is_in_buffer(pass.color)) return false;
        const PixelRect limit = limit_of(frame_, pass);
        const PixelRegion to(pipeline::in_tiles(limit, profile_.limits.copy_tile, target(pass.color)));
        const std::optional<CopyRectangle> copy = halving_copy(frame_, pass, to.bounds());
        if (!copy || !is_in_buffer(copy->source)) return false;
        const PixelRegion from(copy->from);
        const bool is_seen_beside = meet(without(to, PixelRegion(limit)), wanted(pass.color, pass_ + 1));
        if (is_seen_beside || without(from, held(copy->source).in_buffer).pixels() > to.pixels()) return false;
        hold(copy->source, from);
        copied_to(pass.color, to);
        Pass halving;
        halving.label = pass.label;
        halving.color = copy_of(pass.color);
        halving.draws = {*copy};
        frame_.passes.push_back(std::move(halving));
        notes.push_back({"frame_buffer", place_of(before_, pass_),
                         "the chip reads no target, but halves what it copies", "a copy that halves"});
        return true;
    }

    // From now on the copy alone has them.
    void copied_to(TargetId id, const PixelRegion& region) {
        held(id).in_buffer.remove(region);
        held(id).not_copied.remove(region);
    }

    void copy_pass(Pass pass) {
        if (pass.clear != Clear{} && is_in_buffer(pass.color)) {
            Pass clear = pass;
            clear.draws.clear();
            draw_pass(clear);
            pass.clear = {};
            // The clear is done, so what the picture depends on afterwards is wanted now too.
            wanted_[static_cast<std::size_t>(pass.color.index)][pass_].add(
                without(wanted(pass.color, pass_ + 1), overwritten(frame_, pass)));
        }
        const std::vector<Draw> draws = std::move(pass.draws);
        pass.draws.clear();
        bool is_open = false;  // can the last pass take another copy?
        for (const Draw& draw : draws) {
            const auto& copy          = std::get<CopyRectangle>(draw);
            const std::size_t present = frame_.passes.size();
            if (is_in_buffer(copy.source)) hold(copy.source, PixelRegion(copy.from));
            if (is_in_buffer(pass.color)) {
                const PixelRegion to(in_tiles(written_by(copy), pass.color));
                copy_out(pass.color, to);
                copied_to(pass.color, to);
                ++held(pass.color).receipts;
            }
            if (!is_open || frame_.passes.size() > present) {
                frame_.passes.push_back(pass);
                if (is_in_buffer(pass.color)) frame_.passes.back().color = copy_of(pass.color);
                pass.clear = {};
            }
            frame_.passes.back().draws.push_back(draw);
            is_open = true;
        }
    }

    void add_note(std::size_t index, RewriteNotes& notes) const {
        const Held& one = held_[index];
        std::string how;
        for (const auto& [what, count] : {std::pair{"copied ", one.copies},
                                          {"brought back ", one.returns},
                                          {"its copy written ", one.receipts},
                                          {"begun in whole tiles ", one.wider}})
            if (count > 0)
                how += (how.empty() ? "" : ", ") + std::string(what) + std::to_string(count) +
                       (count == 1 ? " time" : " times");
        if (how.empty() && !one.copy) return;
        if (how.empty()) how = "read from its copy";
        notes.push_back({"frame_buffer", Place("target", index, before_.targets[index].name).text(),
                         "the chip draws to one frame buffer and reads copies of it", std::move(how)});
    }

    const Frame& before_;
    Frame frame_;
    const Profile& profile_;
    Sharing sharing_;
    std::vector<std::vector<PixelRegion>> wanted_;
    std::vector<Held> held_;
    std::size_t pass_ = 0;
};

bool has_room(const Frame& frame, const Profile& profile) {
    const MemoryMap map = lay_out(frame, profile);
    return map.clashes.empty() && map.regions[0].over == 0;
}

bool fits_by_itself(const Target& target, const Profile& profile) {
    const bool is_elsewhere = !is_depth(target.format) && !is_among(target.format, profile.formats.draw);
    return is_elsewhere ||
           (target.width <= profile.limits.frame_buffer_width && target.height <= profile.limits.frame_buffer_height);
}

bool reads_buffer(const Frame& frame, const Profile& profile) {
    bool reads = false;
    for (const Pass& pass : frame.passes)
        for_each_texture(pass, [&](std::size_t, std::size_t, const TextureBinding& binding) {
            const Target* target = find_target(frame, binding.target);
            reads                = reads || (target != nullptr && is_among(target->format, profile.formats.draw));
        });
    return reads;
}

}  // namespace

Frame share_frame_buffer(Frame frame, const Profile& profile, RewriteNotes& notes) {
    if (profile.limits.frame_buffer_width == 0 || profile.formats.reads_targets) return frame;
    const bool all_fit = std::all_of(frame.targets.begin(), frame.targets.end(),
                                     [&](const Target& target) { return fits_by_itself(target, profile); });
    if (!all_fit) return frame;
    if (has_room(frame, profile)) {
        if (!reads_buffer(frame, profile)) return frame;
        RewriteNotes of_copies;
        Frame apart = BufferKeeper(frame, profile, Sharing::Apart).run(of_copies);
        if (has_room(apart, profile)) {
            notes.insert(notes.end(), of_copies.begin(), of_copies.end());
            return apart;
        }
    }
    return BufferKeeper(frame, profile, Sharing::Corner).run(notes);
}

}  // namespace pipeline
