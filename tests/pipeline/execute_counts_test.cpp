// SPDX-License-Identifier: MIT
// What a pass says it did, counted by hand: whole PassCounts, for passes that differ from a known one in one thing.
#include "tests/support/count_rows.h"

using namespace pipeline;
using namespace test_support;

namespace {

PipelineState& state(Frame& frame) {
    return frame.passes[0].state;
}
DrawRectangle& first(Frame& frame) {
    return std::get<DrawRectangle>(frame.passes[0].draws[0]);
}

// 16 fragments at depth 0.5 on 64 pixels of colour and depth.
Frame rectangle_frame(TargetFormat depth) {
    Frame frame           = small_frame(8, 8, depth);
    frame.passes[0].draws = {rectangle({2, 2, 6, 6}, 0x80808080, 0.5f)};
    return frame;
}

void bind_texture(Frame& frame, TextureFormat format, int stage) {
    const std::vector<std::uint8_t> texels(static_cast<std::size_t>(21 * bytes_per_texel(format)), 0x80);
    first(frame).textures[static_cast<std::size_t>(stage)] = bound(add_texture(frame, format, 4, 4, texels, 3));
    state(frame).stages[static_cast<std::size_t>(stage)]   = kTextureOnly;
}

}  // namespace

TEST_CASE("counts: a pass without draws", "[execute][counts]") {
    check_rows(small_frame(8, 8),
               {{"nothing", [](Frame&) {}, {}},
                {"colour", [](Frame& f) { f.passes[0].clear.color = Argb{0}; }, {.cleared = 64, .bytes = 256}}});
    const auto clear_both  = [](Frame& f) { f.passes[0].clear = {.color = Argb{0}, .depth = 1.0f}; };
    const auto clear_depth = [](Frame& f) { f.passes[0].clear.depth = 1.0f; };
    const auto clear_part  = [](Frame& f) {
        f.passes[0].clear            = {.color = Argb{0}, .depth = 1.0f};
        f.passes[0].state.viewport   = {1, 1, 6, 5};
        f.passes[0].state.scissor    = {3, 0, 8, 4};
        f.passes[0].state.color_mask = {false, false, false, false};
    };
    const auto clear_nothing = [](Frame& f) {
        f.passes[0].clear          = {.color = Argb{0}, .depth = 1.0f};
        f.passes[0].state.viewport = {0, 0, 3, 8};
        f.passes[0].state.scissor  = {4, 0, 8, 8};
    };
    for (const auto& [format, depth_bytes] :
         {std::pair{TargetFormat::D16, 2u}, {TargetFormat::D24, 4u}, {TargetFormat::D32, 4u}}) {
        INFO(enum_name(format));
        check_rows(small_frame(8, 8, format),
                   {{"colour and depth", clear_both, {.cleared = 128, .bytes = 64 * (4 + depth_bytes)}},
                    {"depth", clear_depth, {.cleared = 64, .bytes = 64 * depth_bytes}},
                    {"a part", clear_part, {.cleared = 18, .bytes = 9 * (4 + depth_bytes)}},
                    {"viewport and scissor apart", clear_nothing, {}}});
    }
}

TEST_CASE("counts: depth and alpha tests", "[execute][counts]") {
    for (const auto& [format, depth_bytes] :
         {std::pair{TargetFormat::D16, 2u}, {TargetFormat::D24, 4u}, {TargetFormat::D32, 4u}}) {
        INFO(enum_name(format));
        const std::uint64_t access = 16 * depth_bytes;  // one reading or writing of the fragments' depth
        check_rows(rectangle_frame(format),
                   {{"tests off",
                     [](Frame&) {},
                     {.rectangles = 1, .covered = 16, .depth_passed = 16, .color_written = 16, .bytes = 64}},
                    {"written without a test",
                     [](Frame& f) {
                         state(f).depth = {CompareFunc::Always, true};
                     },
                     {.rectangles    = 1,
                      .covered       = 16,
                      .depth_passed  = 16,
                      .depth_written = 16,
                      .color_written = 16,
                      .bytes         = 64 + access}},
                    {"tested",
                     [](Frame& f) {
                         state(f).depth = {CompareFunc::Greater, false};
                     },
                     {.rectangles    = 1,
                      .covered       = 16,
                      .depth_tested  = 16,
                      .depth_passed  = 16,
                      .color_written = 16,
                      .bytes         = 64 + access}},
                    {"tested and written",
                     [](Frame& f) {
                         state(f).depth = {CompareFunc::Greater, true};
                     },
                     {.rectangles    = 1,
                      .covered       = 16,
                      .depth_tested  = 16,
                      .depth_passed  = 16,
                      .depth_written = 16,
                      .color_written = 16,
                      .bytes         = 64 + 2 * access}},
                    {"depth fails",
                     [](Frame& f) {
                         state(f).depth = {CompareFunc::Less, true};
                     },
                     {.rectangles = 1, .covered = 16, .depth_tested = 16, .bytes = access}},
                    {"alpha fails",
                     [](Frame& f) {
                         state(f).depth      = {CompareFunc::Greater, true};
                         state(f).alpha_test = {CompareFunc::Greater, 0x80};
                     },
                     {.rectangles = 1, .covered = 16}},
                    {"alpha fails for one of two, depth for the part that is behind",
                     [](Frame& f) {
                         state(f).depth      = {CompareFunc::Greater, true};
                         state(f).alpha_test = {CompareFunc::GreaterEqual, 0x80};
                         f.passes[0].draws.emplace_back(rectangle({0, 0, 8, 8}, 0x7fffffff, 0.75f));
                         f.passes[0].draws.emplace_back(rectangle({4, 4, 8, 8}, 0xffffffff, 0.25f));
                     },
                     {.rectangles    = 3,
                      .covered       = 16 + 64 + 16,
                      .depth_tested  = 16 + 16,
                      .depth_passed  = 16 + 12,
                      .depth_written = 16 + 12,
                      .color_written = 16 + 12,
                      .bytes         = 4 * 28 + depth_bytes * (32 + 28)}},
                    {"depth alone",
                     [](Frame& f) {
                         f.passes[0].color = {};
                         state(f).depth    = {CompareFunc::Greater, true};
                     },
                     {.rectangles    = 1,
                      .covered       = 16,
                      .depth_tested  = 16,
                      .depth_passed  = 16,
                      .depth_written = 16,
                      .bytes         = 2 * access}}});
    }
}

TEST_CASE("counts: colour is written, and read if blend or mask need it", "[execute][counts]") {
    constexpr PassCounts kReplaced{
        .rectangles = 1, .covered = 16, .depth_passed = 16, .color_written = 16, .bytes = 64};
    constexpr PassCounts kMasked{.rectangles = 1, .covered = 16, .depth_passed = 16, .color_written = 16, .bytes = 128};
    constexpr PassCounts kBlended{
        .rectangles = 1, .covered = 16, .depth_passed = 16, .color_written = 16, .blended = 16, .bytes = 128};
    using enum BlendFactor;
    const struct {
        BlendFactor factor;
        PassCounts as_source, as_dest;  // the other being ZERO
    } rows[] = {
        {Zero, kReplaced, kReplaced},       {One, kReplaced, kBlended},
        {SourceColor, kReplaced, kBlended}, {InvSourceColor, kReplaced, kBlended},
        {DestColor, kBlended, kBlended},    {InvDestColor, kBlended, kBlended},
        {SourceAlpha, kReplaced, kBlended}, {InvSourceAlpha, kReplaced, kBlended},
        {DestAlpha, kBlended, kBlended},    {InvDestAlpha, kBlended, kBlended},
    };
    CHECK(std::size(rows) == EnumNames<BlendFactor>::names.size());
    for (const auto& row : rows) {
        INFO(enum_name(row.factor));
        Frame frame        = rectangle_frame(TargetFormat::D24);
        state(frame).blend = {row.factor, Zero};
        CHECK(text_of(draw_on_both(frame).execution.counts[0]) == text_of(row.as_source));
        state(frame).blend = {Zero, row.factor};
        CHECK(text_of(draw_on_both(frame).execution.counts[0]) == text_of(row.as_dest));
    }
    check_rows(rectangle_frame(TargetFormat::D24),
               {{"no red", [](Frame& f) { state(f).color_mask.red = false; }, kMasked},
                {"no green", [](Frame& f) { state(f).color_mask.green = false; }, kMasked},
                {"no blue", [](Frame& f) { state(f).color_mask.blue = false; }, kMasked},
                {"no alpha", [](Frame& f) { state(f).color_mask.alpha = false; }, kMasked},
                {"red alone",
                 [](Frame& f) {
                     state(f).color_mask = {true, false, false, false};
                 },
                 kMasked},
                {"alpha alone",
                 [](Frame& f) {
                     state(f).color_mask = {false, false, false, true};
                 },
                 kMasked},
                {"masked and blended",
                 [](Frame& f) {
                     state(f).blend            = kAlphaOver;
                     state(f).color_mask.alpha = false;
                 },
                 kBlended},
                {"nothing",
                 [](Frame& f) {
                     state(f).blend      = kAlphaOver;
                     state(f).color_mask = {false, false, false, false};
                 },
                 {.rectangles = 1, .covered = 16, .depth_passed = 16}}});
}

TEST_CASE("counts: fragments, not pixels, within the target", "[execute][counts]") {
    check_rows(rectangle_frame(TargetFormat::D24),
               {{"twice the same",
                 [](Frame& f) { f.passes[0].draws.push_back(f.passes[0].draws[0]); },
                 {.rectangles = 2, .covered = 32, .depth_passed = 32, .color_written = 32, .bytes = 128}},
                {"partly outside",
                 [](Frame& f) {
                     f.passes[0].draws = {rectangle({-5, 6, 3, 20}, 0)};
                 },
                 {.rectangles = 1, .covered = 6, .depth_passed = 6, .color_written = 6, .bytes = 24}},
                {"outside",
                 [](Frame& f) {
                     f.passes[0].draws = {rectangle({8, 0, 20, 8}, 0)};
                 },
                 {.rectangles = 1}},
                {"of no size",
                 [](Frame& f) {
                     f.passes[0].draws = {rectangle({3, 0, 3, 8}, 0)};
                 },
                 {.rectangles = 1}},
                {"scissor",
                 [](Frame& f) {
                     state(f).scissor = {3, 3, 8, 5};
                 },
                 {.rectangles = 1, .covered = 6, .depth_passed = 6, .color_written = 6, .bytes = 24}},
                {"viewport",
                 [](Frame& f) {
                     state(f).viewport = {0, 0, 3, 8};
                 },
                 {.rectangles = 1, .covered = 4, .depth_passed = 4, .color_written = 4, .bytes = 16}}});
}

TEST_CASE("counts: texels of each filter and format", "[execute][counts]") {
    const struct {
        TextureFilter filter;
        MipFilter mip;
        std::uint64_t texels;  // of one fragment
    } filters[] = {
        {TextureFilter::Point, MipFilter::None, 1},   {TextureFilter::Linear, MipFilter::None, 4},
        {TextureFilter::Point, MipFilter::Point, 1},  {TextureFilter::Linear, MipFilter::Point, 4},
        {TextureFilter::Point, MipFilter::Linear, 2}, {TextureFilter::Linear, MipFilter::Linear, 8},
    };
    for (const auto& [filter, mip, texels] : filters)
        for (const auto& [format, texel_bytes] :
             {std::pair{TextureFormat::A8, 1u}, {TextureFormat::L8, 1u}, {TextureFormat::A8R8G8B8, 4u}}) {
            INFO(enum_name(filter) << ", " << enum_name(mip) << ", " << enum_name(format));
            Frame frame = rectangle_frame(TargetFormat::D24);
            bind_texture(frame, format, 0);
            state(frame).stages[0].filter     = filter;
            state(frame).stages[0].mip_filter = mip;
            const PassCounts expected{.rectangles    = 1,
                                      .covered       = 16,
                                      .depth_passed  = 16,
                                      .color_written = 16,
                                      .texels        = 16 * texels,
                                      .bytes         = 64 + 16 * texels * texel_bytes};
            CHECK(text_of(draw_on_both(frame).execution.counts[0]) == text_of(expected));
        }
}

TEST_CASE("counts: texels of what is bound and read, for each covered fragment", "[execute][counts]") {
    const auto with_texels = [](std::uint64_t texels, std::uint64_t texel_bytes) {
        return PassCounts{.rectangles    = 1,
                          .covered       = 16,
                          .depth_passed  = 16,
                          .color_written = 16,
                          .texels        = texels,
                          .bytes         = 64 + texel_bytes};
    };
    check_rows(rectangle_frame(TargetFormat::D24),
               {{"two textures",
                 [](Frame& f) {
                     bind_texture(f, TextureFormat::A8, 0);
                     bind_texture(f, TextureFormat::A8R8G8B8, 1);
                     state(f).stages[1].filter = TextureFilter::Linear;
                 },
                 with_texels(16 + 64, 16 + 4 * 64)},
                {"nothing bound", [](Frame& f) { state(f).stages[0] = kTextureOnly; }, with_texels(0, 0)},
                {"bound to the other stage",
                 [](Frame& f) {
                     bind_texture(f, TextureFormat::A8, 1);
                     state(f).stages[0] = kTextureOnly;
                     state(f).stages[1] = {};
                 },
                 with_texels(0, 0)},
                {"bound, not read",
                 [](Frame& f) {
                     bind_texture(f, TextureFormat::A8, 0);
                     state(f).stages[0].color_op = state(f).stages[0].alpha_op = TextureOp::SelectArg2;
                 },
                 with_texels(0, 0)},
                {"read for alpha alone",
                 [](Frame& f) {
                     bind_texture(f, TextureFormat::L8, 0);
                     state(f).stages[0].color_op = TextureOp::SelectArg2;
                 },
                 with_texels(16, 16)},
                {"read in four arguments",
                 [](Frame& f) {
                     bind_texture(f, TextureFormat::L8, 0);
                     TextureStage& stage = state(f).stages[0];
                     stage.color_op = stage.alpha_op = TextureOp::Modulate;
                     stage.color_arg2 = stage.alpha_arg2 = {.source = ArgSource::Texture};
                 },
                 with_texels(16, 16)},
                {"a target",
                 [](Frame& f) {
                     f.targets.push_back({.name = "other", .width = 4, .height = 4});
                     first(f).textures[0].target = {2};
                     state(f).stages[0]          = kTextureOnly;
                 },
                 with_texels(16, 64)},
                {"depth fails afterwards",
                 [](Frame& f) {
                     bind_texture(f, TextureFormat::A8, 0);
                     state(f).depth.func = CompareFunc::Less;
                 },
                 {.rectangles = 1, .covered = 16, .depth_tested = 16, .texels = 16, .bytes = 64 + 16}},
                {"alpha fails",
                 [](Frame& f) {
                     bind_texture(f, TextureFormat::A8, 0);
                     state(f).alpha_test = {CompareFunc::Greater, 0x80};
                 },
                 {.rectangles = 1, .covered = 16, .texels = 16, .bytes = 16}}});
}
