// SPDX-License-Identifier: MIT
#include "tests/support/gs_frames.h"

#include <algorithm>
#include <cmath>
#include <sstream>

#include "pipeline/check/check.h"
#include "pipeline/emit/gs_dump.h"
#include "pipeline/emit/gs_memory.h"
#include "pipeline/execute/execute.h"
#include "pipeline/validate/validate.h"
#include "tests/support/gs_replay.h"

namespace test_support {

using namespace pipeline;

namespace {

bool has_16_bits(TargetFormat format) {
    return bytes_per_pixel(format) == 2;
}

std::uint32_t random_color(Random& random) {
    // Alphas near one and the ends are where the rules bend.
    const std::uint32_t alpha = random.one_of<std::uint32_t>({0, 0x7f, 0x80, 0x81, 0xff, random.bits() & 255});
    return (random.bits() & 0x00ffffff) | alpha << 24;
}

TextureStage random_stage(Random& random) {
    using enum TextureOp;
    TextureStage stage;
    const TextureArg vertex{.source = random.one_of({ArgSource::Diffuse, ArgSource::Current})},
        texel{.source = ArgSource::Texture};
    stage.color_arg1 = stage.alpha_arg1 = vertex;
    stage.color_arg2 = stage.alpha_arg2 = texel;
    const bool has_alpha                = random.chance(60);
    switch (random.from(0, 4)) {
        case 0:
            stage.color_op = Modulate;
            stage.alpha_op = has_alpha ? Modulate : SelectArg1;
            break;
        case 1:
            stage.color_op = SelectArg2;
            stage.alpha_op = has_alpha ? SelectArg2 : SelectArg1;
            break;
        case 2:
            stage.color_op = ModulateColorAddAlpha;
            stage.alpha_op = has_alpha ? Add : SelectArg1;
            break;
        case 3:
            stage.color_op = ModulateColorAddAlpha;
            stage.alpha_op = SelectArg2;
            break;
        default:
            break;
    }
    stage.filter    = random.any<TextureFilter>();
    stage.address_u = random.one_of({TextureAddress::Wrap, TextureAddress::Clamp});
    stage.address_v = random.one_of({TextureAddress::Wrap, TextureAddress::Clamp});
    return stage;
}

PixelRect random_part(int width, int height, Random& random) {
    if (random.chance(75)) return {};
    const int x0 = random.from(0, width - 1), y0 = random.from(0, height - 1);
    return {x0, y0, random.from(x0 + 1, width), random.from(y0 + 1, height)};
}

PipelineState random_gs_state(const Target& color, bool has_depth, Random& random) {
    PipelineState state;
    if (random.chance(70)) {
        state.gs_blend.a = random.any<GsColor>();
        state.gs_blend.b = random.any<GsColor>();
        state.gs_blend.c = random.any<GsAlpha>();
        state.gs_blend.d = random.any<GsColor>();
    }
    state.gs_blend.fix      = static_cast<std::uint8_t>(random.bits());
    state.gs_blend.pabe     = random.chance(25);
    state.gs_blend.colclamp = random.chance(75);
    state.gs_blend.fba      = random.chance(25);
    if (has_16_bits(color.format) && random.chance(50)) {
        state.dither.mode = DitherMode::GsDimx;
        for (std::int32_t& offset : state.dither.matrix) offset = random.from(-4, 3);
    }
    state.color_mask = {random.chance(85), random.chance(85), random.chance(85), random.chance(80)};
    if (has_depth) {
        state.depth.func = random.one_of(
            {CompareFunc::Always, CompareFunc::GreaterEqual, CompareFunc::Greater, CompareFunc::GreaterEqual});
        if (random.chance(5)) state.depth.func = CompareFunc::Never;
        state.depth.write = random.chance(60);
    }
    if (random.chance(25))
        state.alpha_test = {random.any<CompareFunc>(), static_cast<std::uint8_t>(random.bits()),
                            random.any<AlphaFail>()};
    if (random.chance(12)) state.dest_alpha_test = random.any<DestAlphaTest>();
    if (random.chance(25)) {
        state.fog.mode  = FogMode::Linear;
        state.fog.color = {random.bits()};
    }
    state.stages[0] = random_stage(random);
    state.viewport  = random_part(color.width, color.height, random);
    state.scissor   = random_part(color.width, color.height, random);
    return state;
}

bool is_power(int size) {
    return (size & (size - 1)) == 0;
}

// Something that is not drawn to, of sizes that the stage's addressing takes; for triangles a power of two.
TextureBinding random_binding(const Frame& frame, const Pass& pass, bool powers_only, Random& random) {
    for (int tries = 0; tries < 8; ++tries) {
        TextureBinding binding;
        int width = 1, height = 1;
        if (random.chance(10)) return binding;
        if (random.chance(50)) {
            binding.texture = {static_cast<std::int32_t>(random.below(frame.textures.size()))};
            width           = frame.textures[static_cast<std::size_t>(binding.texture.index)].width;
            height          = frame.textures[static_cast<std::size_t>(binding.texture.index)].height;
        } else {
            binding.target       = {static_cast<std::int32_t>(random.below(frame.targets.size()))};
            const Target& target = frame.targets[static_cast<std::size_t>(binding.target.index)];
            if (is_depth(target.format) || binding.target == pass.color) continue;
            width  = target.width;
            height = target.height;
        }
        const TextureStage& stage = pass.state.stages[0];
        const bool u_fits         = is_power(width) || (!powers_only && stage.address_u == TextureAddress::Clamp),
                   v_fits         = is_power(height) || (!powers_only && stage.address_v == TextureAddress::Clamp);
        if (u_fits && v_fits) return binding;
    }
    return {};
}

WindowVertex random_corner(int width, int height, Random& random) {
    WindowVertex vertex;
    const auto coordinate = [&](int size) {
        const float at = random.real(-0.3f, 1.3f) * static_cast<float>(size);
        return random.chance(30) ? std::floor(at) : at;
    };
    vertex.x        = coordinate(width);
    vertex.y        = coordinate(height);
    vertex.z        = random.chance(10) ? 1.0f : random.real(0.0f, 1.0f);
    vertex.rhw      = random.real(0.1f, 4.0f);
    vertex.diffuse  = {random_color(random)};
    vertex.specular = {random.bits()};
    vertex.uv0      = {random.real(-2.0f, 2.0f), random.real(-2.0f, 2.0f), random.real(0.5f, 2.0f)};
    return vertex;
}

DrawRectangle random_rectangle(const Frame& frame, const Pass& pass, const Target& color, Random& random) {
    DrawRectangle draw;
    const auto ends = [&](int size, float& low, float& high) {
        low  = random.real(-0.3f, 1.0f) * static_cast<float>(size);
        high = low + random.real(0.0f, 1.3f) * static_cast<float>(size);
        if (random.chance(60)) low = std::floor(low), high = std::floor(high);
    };
    ends(color.width, draw.x0, draw.x1);
    ends(color.height, draw.y0, draw.y1);
    draw.depth       = random.real(0.0f, 1.0f);
    draw.color       = {random_color(random)};
    draw.textures[0] = random_binding(frame, pass, false, random);
    const int choice = random.from(0, 2);
    if (choice == 1) draw.uv[0] = {0.25f, 0.5f, 0.75f, -0.5f};
    if (choice == 2)
        draw.uv[0] = {random.real(-2.0f, 2.0f), random.real(-2.0f, 2.0f), random.real(-2.0f, 2.0f),
                      random.real(-2.0f, 2.0f)};
    return draw;
}

CopyRectangle random_copy(const Frame& frame, const Pass& pass, std::int32_t source, Random& random) {
    const Target& from = frame.targets[static_cast<std::size_t>(source)];
    const Target& to   = frame.targets[static_cast<std::size_t>(pass.color.index)];
    CopyRectangle copy;
    copy.source      = {source};
    const int width  = random.from(1, std::min(from.width, to.width)),
              height = random.from(1, std::min(from.height, to.height));
    const bool whole = random.chance(30);
    copy.from.x0     = whole ? 0 : random.from(0, from.width - width);
    copy.from.y0     = whole ? 0 : random.from(0, from.height - height);
    copy.from.x1     = copy.from.x0 + width;
    copy.from.y1     = copy.from.y0 + height;
    copy.x           = whole ? 0 : random.from(0, to.width - width);
    copy.y           = whole ? 0 : random.from(0, to.height - height);
    if (from.format == TargetFormat::Psmct32) copy.channels = random.any<CopyChannels>();
    return copy;
}

// Another colour target of the pass's format; -1 if there is none.
std::int32_t another_of_format(const Frame& frame, const Pass& pass) {
    const TargetFormat format = frame.targets[static_cast<std::size_t>(pass.color.index)].format;
    for (std::size_t i = 0; i < frame.targets.size(); ++i)
        if (frame.targets[i].format == format && static_cast<std::int32_t>(i) != pass.color.index)
            return static_cast<std::int32_t>(i);
    return -1;
}

// So that what is read and blended with is not one colour.
void fill_targets(Frame& frame, std::size_t colors, TextureId texture) {
    for (std::size_t i = 0; i < colors; ++i) {
        Pass& pass           = frame.passes.emplace_back();
        pass.color           = {static_cast<std::int32_t>(i)};
        pass.state.stages[0] = {.color_op = TextureOp::SelectArg1, .alpha_op = TextureOp::SelectArg1};
        DrawRectangle draw;
        draw.x1          = static_cast<float>(frame.targets[i].width);
        draw.y1          = static_cast<float>(frame.targets[i].height);
        draw.textures[0] = {.texture = texture, .target = {}};
        pass.draws.push_back(draw);
    }
}

void add_random_pass(Frame& frame, std::size_t colors, Random& random) {
    Pass& pass          = frame.passes.emplace_back();
    pass.color          = {static_cast<std::int32_t>(random.below(colors))};
    const Target& color = frame.targets[static_cast<std::size_t>(pass.color.index)];
    // Depth targets come after the colours, one of each family for each size.
    for (std::size_t i = colors; i < frame.targets.size(); ++i) {
        const Target& depth = frame.targets[i];
        if (depth.width == color.width && depth.height == color.height &&
            has_16_bits(depth.format) == has_16_bits(color.format) && random.chance(60))
            pass.depth = {static_cast<std::int32_t>(i)};
    }
    if (random.chance(15)) pass.clear.color = Argb{random_color(random)};
    if (pass.depth && random.chance(60)) pass.clear.depth = random.real(0.0f, 0.6f);
    const std::int32_t source = another_of_format(frame, pass);
    if (source >= 0 && random.chance(25)) {
        for (int i = random.from(1, 2); i > 0; --i) pass.draws.push_back(random_copy(frame, pass, source, random));
        return;
    }
    pass.state = random_gs_state(color, static_cast<bool>(pass.depth), random);
    for (int i = random.from(1, 4); i > 0; --i) {
        if (random.chance(50)) {
            pass.draws.push_back(random_rectangle(frame, pass, color, random));
        } else {
            std::array<WindowVertex, 3> corners;
            for (WindowVertex& corner : corners) corner = random_corner(color.width, color.height, random);
            add_triangle(frame, pass, corners, random_binding(frame, pass, true, random));
        }
    }
}

}  // namespace

Frame gs_frame(int width, int height, TargetFormat color, std::optional<TargetFormat> depth) {
    Frame frame;
    frame.arithmetic = find_profile("ps2")->arithmetic;
    frame.output     = {0};
    frame.targets.push_back({.name = "color", .format = color, .width = width, .height = height});
    if (depth) frame.targets.push_back({.name = "depth", .format = *depth, .width = width, .height = height});
    Pass& pass = frame.passes.emplace_back();
    pass.color = {0};
    if (depth) pass.depth = {1};
    return frame;
}

void add_triangle(Frame& frame, Pass& pass, const std::array<WindowVertex, 3>& corners, const TextureBinding& binding) {
    DrawWindowTriangles draw{
        .first_index = static_cast<std::uint32_t>(frame.indices.size()), .index_count = 3, .textures = {}};
    draw.textures[0] = binding;
    for (const WindowVertex& corner : corners) {
        frame.indices.push_back(static_cast<std::uint32_t>(frame.window_vertices.size()));
        frame.window_vertices.push_back(corner);
    }
    pass.draws.push_back(draw);
}

TextureId add_random_texture(Frame& frame, TextureFormat format, int width, int height, Random& random) {
    Texture& texture = frame.textures.emplace_back();
    texture.format   = format;
    texture.width    = width;
    texture.height   = height;
    texture.texels.resize(static_cast<std::size_t>(width * height * bytes_per_texel(format)));
    for (std::uint8_t& texel : texture.texels) texel = static_cast<std::uint8_t>(random.bits());
    return {static_cast<std::int32_t>(frame.textures.size()) - 1};
}

Frame random_gs_frame(std::uint32_t seed) {
    Random random(seed);
    Frame frame;
    frame.arithmetic = find_profile("ps2")->arithmetic;
    const int width  = random.one_of({random.from(1, 150), 64, 128}),
              height = random.one_of({random.from(1, 150), 64, 32});
    const auto add   = [&](TargetFormat format, int w, int h) {
        frame.targets.push_back({.name = {}, .format = format, .width = w, .height = h});
    };
    using enum TargetFormat;
    add(Psmct32, width, height);
    add(Psmct32, 64, 64);
    add(random.one_of({Psmct24, Psmct16}), width, height);
    add(random.one_of({Psmct24, Psmct16}), 32, 128);
    const std::size_t colors = frame.targets.size();
    add(D16, width, height);
    add(random.one_of({D24, D32}), width, height);
    add(random.one_of({D24, D32}), 64, 64);
    frame.output = {static_cast<std::int32_t>(random.below(colors))};
    for (const TextureFormat format : all_of<TextureFormat>()) {
        add_random_texture(frame, format, 1 << random.from(0, 7), 1 << random.from(0, 7), random);
        add_random_texture(frame, format, random.from(1, 150), random.from(1, 70), random);
    }
    fill_targets(frame, colors, add_random_texture(frame, TextureFormat::A8R8G8B8, 64, 32, random));
    for (int i = random.from(2, 6); i > 0; --i) add_random_pass(frame, colors, random);
    return frame;
}

LegalFrame legal_gs_frame(const Frame& frame) {
    for (const Finding& finding : validate(frame)) FAIL(finding.where << ": " << finding.what);
    LegalFrame legal{.frame = frame, .notes = {}, .left = check(frame, *find_profile("ps2"))};
    for (const ChipFinding& finding : legal.left) FAIL(finding.where << " uses " << finding.uses);
    return legal;
}

std::vector<std::uint32_t> replayed(const Frame& frame, const GsStream& stream) {
    const GsReplay replay(gs_dump(stream));
    const Target& output = frame.targets[static_cast<std::size_t>(frame.output.index)];
    return replay.shown(output.width, output.height);
}
std::vector<std::uint32_t> replayed(const Frame& frame) {
    return replayed(frame, emit_gs(legal_gs_frame(frame)));
}

namespace {

std::string difference_between(const ColorImage& want, const std::vector<std::uint32_t>& got) {
    if (got.size() != want.pixels.size()) return "another size";
    for (std::size_t i = 0; i < got.size(); ++i) {
        if (got[i] == want.pixels[i]) continue;
        std::ostringstream text;
        text << '(' << i % static_cast<std::size_t>(want.width) << ", " << i / static_cast<std::size_t>(want.width)
             << "): got " << std::hex << got[i] << ", want " << want.pixels[i];
        return text.str();
    }
    return {};
}

}  // namespace

std::string difference_of(const Frame& frame, const std::vector<std::uint32_t>& got) {
    return difference_between(execute(frame).output, got);
}

std::string difference_in_targets(const Frame& frame) {
    const GsReplay replay(gs_dump(emit_gs(legal_gs_frame(frame))));
    const GsMemory memory = place_in_gs_memory(frame);
    Frame shown           = frame;
    for (std::size_t i = 0; i < frame.targets.size(); ++i) {
        const Target& target = frame.targets[i];
        if (is_depth(target.format)) continue;
        shown.output             = {static_cast<std::int32_t>(i)};
        const GsSurface& surface = memory.targets[i];
        const std::string text   = difference_of(
              shown, replay.pixels({static_cast<std::uint32_t>(surface.psm), surface.block, surface.width64},
                                   target.width, target.height));
        if (!text.empty()) return "target " + std::to_string(i) + ' ' + text;
    }
    return {};
}

}  // namespace test_support
