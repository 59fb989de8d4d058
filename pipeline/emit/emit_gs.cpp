// SPDX-License-Identifier: MIT
#include "pipeline/emit/emit_gs.h"

#include <algorithm>
#include <stdexcept>

#include "pipeline/check/target_use.h"
#include "pipeline/emit/gs_copies.h"
#include "pipeline/emit/gs_sprites.h"
#include "pipeline/emit/gs_triangles.h"
#include "pipeline/legalize/window_map.h"

namespace pipeline {

namespace {

constexpr std::uint64_t kSprite = 6;

bool is_empty(const PixelRect& rect) {
    return rect.x0 >= rect.x1 || rect.y0 >= rect.y1;
}

// One sprite for what is there of both.
void emit_clear(const GsSurface& color, std::optional<Argb> value, const std::optional<GsSurface>& depth,
                std::uint32_t units, const PixelRect& part, GsBuilder& out) {
    set_plain_state(out);
    set_targets(
        {.color = color, .keep_bits = value ? 0u : 0xffffffffu, .depth = depth, .writes_depth = depth.has_value()},
        part, out);
    out.write(GsReg::Prim, {{"PRIM", kSprite}});
    emit_sprites(part, units, value.value_or(Argb{0}), out);
}

// Of a depth target alone, with a masked colour buffer at its place.
GsSurface masked_buffer(const GsSurface& depth) {
    GsSurface surface = depth;
    surface.psm       = depth.has_16_bits() ? GsPsm::Ct16 : GsPsm::Ct32;
    return surface;
}

void emit_pass_clear(const Frame& frame, const GsMemory& memory, const Pass& pass, GsBuilder& out) {
    const PixelRect part = limit_of(frame, pass);
    if (pass.clear == Clear{} || is_empty(part)) return;
    out.step("clear");
    std::optional<GsSurface> depth;
    std::uint32_t units = 0;
    if (pass.clear.depth) {
        depth = memory.targets[static_cast<std::size_t>(pass.depth.index)];
        units = depth_units(frame, pass, *pass.clear.depth);
    }
    const GsSurface color = frame_surface(memory, pass);
    // 16 bit depth goes with 16 bit colours alone.
    if (!depth || color.has_16_bits() == depth->has_16_bits())
        return emit_clear(color, pass.clear.color, depth, units, part, out);
    if (pass.clear.color) emit_clear(color, pass.clear.color, {}, 0, part, out);
    emit_clear(masked_buffer(*depth), {}, depth, units, part, out);
}

// Targets that no pass clears whole before it uses them.
std::vector<std::size_t> targets_from_zero(const Frame& frame) {
    std::vector<std::size_t> found;
    for (std::size_t i = 0; i < frame.targets.size(); ++i) {
        const TargetId id{static_cast<std::int32_t>(i)};
        const PixelRect all{0, 0, frame.targets[i].width, frame.targets[i].height};
        const auto uses = [&](const Pass& pass) {
            bool used = pass.color == id || pass.depth == id;
            for (const Draw& draw : pass.draws) {
                const auto* copy = std::get_if<CopyRectangle>(&draw);
                used             = used || textures_of(draw)[0].target == id || (copy != nullptr && copy->source == id);
            }
            return used;
        };
        const auto first = std::find_if(frame.passes.begin(), frame.passes.end(), uses);
        if (first == frame.passes.end() && frame.output != id) continue;
        const bool is_cleared =
            first != frame.passes.end() && limit_of(frame, *first) == all &&
            ((first->color == id && first->clear.color) || (first->depth == id && first->clear.depth));
        if (!is_cleared) found.push_back(i);
    }
    return found;
}

void emit_zeros(const Frame& frame, const GsMemory& memory, GsBuilder& out) {
    const std::vector<std::size_t> targets = targets_from_zero(frame);
    if (targets.empty()) return;
    out.group("targets that start at zero");
    for (const std::size_t i : targets) {
        const Target& target     = frame.targets[i];
        const GsSurface& surface = memory.targets[i];
        const PixelRect all{0, 0, target.width, target.height};
        out.step(quoted_name("target", i, target.name));
        if (is_depth(target.format))
            emit_clear(masked_buffer(surface), {}, surface, 0, all, out);
        else
            emit_clear(surface, Argb{0}, {}, 0, all, out);
    }
}

void emit_draw(const Frame& frame, const GsMemory& memory, const Pass& pass, std::size_t index, GsBuilder& out) {
    const Draw& draw      = pass.draws[index];
    const auto with_place = [&](std::string_view kind) { return std::string(kind) + ' ' + std::to_string(index); };
    if (const auto* copy = std::get_if<CopyRectangle>(&draw)) {
        out.step(with_place("copy") + ' ' + std::string(enum_name(copy->channels)));
        return emit_copy(frame, memory, pass, *copy, out);
    }
    if (is_empty(limit_of(frame, pass))) return;
    if (const auto* rectangle = std::get_if<DrawRectangle>(&draw)) {
        out.step(with_place("rectangle"));
        return emit_rectangle(frame, memory, pass, *rectangle, out);
    }
    if (const auto* triangles = std::get_if<DrawWindowTriangles>(&draw)) {
        out.step(with_place("triangles"));
        return emit_triangles(frame, memory, pass, *triangles, out);
    }
    throw std::invalid_argument("the Graphics Synthesizer does not transform: " + with_place("draw") + " of pass '" +
                                pass.label + "' has vertices in object space");
}

void emit_pass(const Frame& frame, const GsMemory& memory, std::size_t index, GsBuilder& out) {
    const Pass& pass = frame.passes[index];
    out.group(quoted_name("pass", index, pass.label));
    emit_pass_clear(frame, memory, pass, out);
    if (pass.draws.empty()) return;
    // What the passes before have drawn may lie in the cache.
    out.step("texture cache");
    out.write(GsReg::TexFlush, std::uint64_t{0});
    if (draws(pass) && !is_empty(limit_of(frame, pass))) {
        out.step("state");
        set_pass_state(frame, memory, pass, out);
    }
    for (std::size_t i = 0; i < pass.draws.size(); ++i) emit_draw(frame, memory, pass, i, out);
}

void emit_start(GsBuilder& out) {
    out.group("registers that stay");
    out.step("drawing by PRIM, in context 1, all rows, palettes by CSM1");
    out.write(GsReg::PrModeCont, {{"AC", 1}});
    out.write(GsReg::ScanMsk, {{"MSK", 0}});
    out.write(GsReg::TexClut, std::uint64_t{0});
}

// NTSC's timing as the console's own program sets it; a picture wider than 640 or higher than 448 pixels does not show whole.
std::vector<GsWrite> display_of(const GsSurface& output) {
    const auto width = static_cast<std::uint64_t>(output.width), height = static_cast<std::uint64_t>(output.height);
    const std::uint64_t magnification = std::clamp<std::uint64_t>(2560 / width, 1, 16);
    return {{GsReg::Pmode, encode(GsReg::Pmode, {{"EN1", 1}, {"CRTMD", 1}, {"MMOD", 1}, {"ALP", 0xff}})},
            {GsReg::Smode1, 0x0000000740834504},
            {GsReg::Smode2, encode(GsReg::Smode2, {{"INT", height > 256}, {"FFMD", 0}})},
            {GsReg::Srfsh, 8},
            {GsReg::Synch1, 0x0007f5b61f06f040},
            {GsReg::Synch2, 0x000000000033a4d8},
            {GsReg::SyncV, 0x00c7800601a01801},
            {GsReg::DispFb1,
             encode(GsReg::DispFb1, {{"FBP", output.page()}, {"FBW", output.width64}, {"PSM", code(output.psm)}})},
            {GsReg::Display1, encode(GsReg::Display1, {{"DX", 636},
                                                       {"DY", height > 256 ? 50u : 25u},
                                                       {"MAGH", magnification - 1},
                                                       {"DW", std::min<std::uint64_t>(width * magnification, 4096) - 1},
                                                       {"DH", height - 1}})},
            {GsReg::BgColor, 0}};
}

}  // namespace

GsStream emit_gs(const LegalFrame& legal) {
    if (!legal.left.empty())
        throw std::invalid_argument("the Graphics Synthesizer cannot draw this frame: " + legal.left[0].where +
                                    " uses " + legal.left[0].uses + ", the chip has " + legal.left[0].has);
    const Frame& frame    = legal.frame;
    const GsMemory memory = place_in_gs_memory(frame);
    GsBuilder out;
    emit_start(out);
    emit_uploads(frame, memory, out);
    emit_zeros(frame, memory, out);
    for (std::size_t i = 0; i < frame.passes.size(); ++i) emit_pass(frame, memory, i, out);
    GsStream stream = out.take();
    if (frame.output) stream.display = display_of(memory.targets[static_cast<std::size_t>(frame.output.index)]);
    return stream;
}

}  // namespace pipeline
