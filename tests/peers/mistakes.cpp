// SPDX-License-Identifier: MIT
#include "tests/peers/mistakes.h"

#include <algorithm>

namespace peers {

using namespace pipeline;

namespace {

template <class Change>
void for_each_state(Frame& frame, Change&& change) {
    for (Pass& pass : frame.passes) change(pass.state);
}

template <class Change>
void for_each_stage(Frame& frame, Change&& change) {
    for_each_state(frame, [&](PipelineState& state) {
        for (TextureStage& stage : state.stages) change(stage);
    });
}

template <class Change>
void for_each_rectangle(Frame& frame, Change&& change) {
    for (Pass& pass : frame.passes)
        for (Draw& draw : pass.draws)
            if (auto* rectangle = std::get_if<DrawRectangle>(&draw)) change(*rectangle);
}

// A byte, `steps` brighter or, where it is too bright for that, darker.
std::uint32_t changed_red(std::uint32_t color, std::uint32_t steps) {
    const std::uint32_t red = color >> 16 & 255;
    return red + steps <= 255 ? color + (steps << 16) : color - (steps << 16);
}

constexpr Mistake kMistakes[] = {
    {"source alpha taken for one",
     [](Frame& frame) {
         for_each_state(frame, [](PipelineState& s) {
             if (s.blend.source == BlendFactor::SourceAlpha) s.blend.source = BlendFactor::One;
         });
     }},
    {"no blend", [](Frame& frame) { for_each_state(frame, [](PipelineState& s) { s.blend = {}; }); }},
    {"alpha written where masked or kept where not",
     [](Frame& frame) { for_each_state(frame, [](PipelineState& s) { s.color_mask.alpha = !s.color_mask.alpha; }); }},
    {"no alpha test", [](Frame& frame) { for_each_state(frame, [](PipelineState& s) { s.alpha_test = {}; }); }},
    {"alpha test's reference off by eight",
     [](Frame& frame) {
         for_each_state(frame, [](PipelineState& s) {
             if (s.alpha_test.func != CompareFunc::Always)
                 s.alpha_test.reference = static_cast<std::uint8_t>(s.alpha_test.reference ^ 8);
         });
     }},
    {"depth test reversed",
     [](Frame& frame) {
         for_each_state(frame, [](PipelineState& s) {
             if (s.depth.func == CompareFunc::LessEqual) s.depth.func = CompareFunc::GreaterEqual;
         });
     }},
    {"no depth written", [](Frame& frame) { for_each_state(frame, [](PipelineState& s) { s.depth.write = false; }); }},
    {"the other faces culled",
     [](Frame& frame) {
         for_each_state(frame, [](PipelineState& s) {
             if (s.cull != CullMode::None)
                 s.cull = s.cull == CullMode::Clockwise ? CullMode::CounterClockwise : CullMode::Clockwise;
         });
     }},
    {"flat shading", [](Frame& frame) { for_each_state(frame, [](PipelineState& s) { s.shade = ShadeMode::Flat; }); }},
    {"fog ends 5 % too early",
     [](Frame& frame) {
         for_each_state(frame, [](PipelineState& s) { s.fog.end = s.fog.start + 0.95f * (s.fog.end - s.fog.start); });
     }},
    {"fog by depth, not range",
     [](Frame& frame) { for_each_state(frame, [](PipelineState& s) { s.fog.range = false; }); }},
    {"fog's red off by 16",
     [](Frame& frame) {
         for_each_state(frame, [](PipelineState& s) {
             if (s.fog.mode != FogMode::None) s.fog.color.value = changed_red(s.fog.color.value, 16);
         });
     }},
    {"no filter",
     [](Frame& frame) { for_each_stage(frame, [](TextureStage& s) { s.filter = TextureFilter::Point; }); }},
    {"no mip levels",
     [](Frame& frame) { for_each_stage(frame, [](TextureStage& s) { s.mip_filter = MipFilter::None; }); }},
    {"nearest mip level",
     [](Frame& frame) {
         for_each_stage(frame, [](TextureStage& s) { s.mip_filter = std::min(s.mip_filter, MipFilter::Point); });
     }},
    {"clamp taken for wrap",
     [](Frame& frame) {
         for_each_stage(frame, [](TextureStage& s) { s.address_u = s.address_v = TextureAddress::Wrap; });
     }},
    {"modulate for modulate4x and add-signed",
     [](Frame& frame) {
         for_each_stage(frame, [](TextureStage& s) {
             for (TextureOp* op : {&s.color_op, &s.alpha_op})
                 if (*op == TextureOp::Modulate4X || *op == TextureOp::AddSigned2X) *op = TextureOp::Modulate;
         });
     }},
    {"rectangles half a texel to the right",
     [](Frame& frame) {
         for_each_rectangle(frame, [](DrawRectangle& r) {
             for (UvRect& uv : r.uv) {
                 uv.u0 += 0.5f / std::max(1.0f, r.x1 - r.x0);
                 uv.u1 += 0.5f / std::max(1.0f, r.x1 - r.x0);
             }
         });
     }},
    {"rectangles a pixel to the right",
     [](Frame& frame) {
         for_each_rectangle(frame, [](DrawRectangle& r) {
             r.x0 += 1.0f;
             r.x1 += 1.0f;
         });
     }},
    {"clear's red off by one",
     [](Frame& frame) {
         for (Pass& pass : frame.passes)
             if (pass.clear.color) pass.clear.color->value = changed_red(pass.clear.color->value, 1);
     }},
    {"vertices' red off by 16",
     [](Frame& frame) {
         for (Vertex& vertex : frame.vertices) vertex.diffuse.value = changed_red(vertex.diffuse.value, 16);
     }},
    {"cameras a fifth of a pixel of 640 to the left",
     [](Frame& frame) {
         for (Camera& camera : frame.cameras)
             for (int column = 0; column < 4; ++column)
                 camera.projection[column][0] -= 0.4f / 640.0f * camera.projection[column][3];
     }},
    {"blends truncated", [](Frame& frame) { frame.arithmetic.blend = BlendRule::FlipperTrunc256; }, true},
    {"filters floored once", [](Frame& frame) { frame.arithmetic.filter = FilterRule::FlipperFloor7; }, true},
    {"filters floored in cascade", [](Frame& frame) { frame.arithmetic.filter = FilterRule::GsFloor4; }, true},
    {"colours floored", [](Frame& frame) { frame.arithmetic.gouraud = GouraudRule::Floor; }, true},
    {"pixels sampled at their corners", [](Frame& frame) { frame.arithmetic.pixel_center = 0; }, true},
};

}  // namespace

std::span<const Mistake> mistakes() {
    return kMistakes;
}

}  // namespace peers
