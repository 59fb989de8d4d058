// SPDX-License-Identifier: MIT
// The words of texture stages on the NV2A, written by hand: the register combiners' from xemu's pgraph/psh_regs.h, the
// textures' from nxdk's lib/pbkit/nv_regs.h.

#include "tests/support/nv2a_written.h"

using namespace pipeline;
using namespace test_support;

TEST_CASE("combiner words of texture ops", "[emit][nv2a]") {
    // a TEXTURE, b DIFFUSE. Registers: V0 4, T0 8, C0 1; 0x10 alpha, 0x20 one minus; 0x20 alone is one, 0x40 minus one.
    struct Row {
        TextureOp op;
        std::uint32_t color_in, alpha_in, out;
    };
    const Row rows[] = {
        {TextureOp::Disable, 0x04200000, 0x14200000, 0x0c00},
        {TextureOp::SelectArg1, 0x08200000, 0x18200000, 0x0c00},
        {TextureOp::SelectArg2, 0x04200000, 0x14200000, 0x0c00},
        {TextureOp::Modulate, 0x08040000, 0x18140000, 0x0c00},
        {TextureOp::Modulate2X, 0x08040000, 0x18140000, 0x10c00},
        {TextureOp::Modulate4X, 0x08040000, 0x18140000, 0x20c00},
        {TextureOp::Add, 0x08200420, 0x18201420, 0x0c00},
        {TextureOp::AddSigned, 0x08200420, 0x18201420, 0x8c00},
        {TextureOp::AddSigned2X, 0x08200420, 0x18201420, 0x18c00},
        {TextureOp::Subtract, 0x08200440, 0x18201440, 0x0c00},
        {TextureOp::BlendDiffuseAlpha, 0x08140434, 0x18141434, 0x0c00},
        {TextureOp::BlendTextureAlpha, 0x08180438, 0x18181438, 0x0c00},
        {TextureOp::BlendFactorAlpha, 0x08110431, 0x18111431, 0x0c00},
        {TextureOp::BlendCurrentAlpha, 0x08140434, 0x18141434, 0x0c00},
        {TextureOp::ModulateColorAddAlpha, 0x08041820, 0x18141820, 0x0c00},
    };
    std::size_t count = 0;
    for (const Row& row : rows) {
        CAPTURE(row.op);
        CHECK(row.op == static_cast<TextureOp>(count++));
        TextureStage stage;
        stage.color_op = stage.alpha_op = row.op;
        stage.color_arg2 = stage.alpha_arg2 = {.source = ArgSource::Diffuse};
        const Written written               = with_stage(stage);
        CHECK(written[0xac0] == row.color_in);
        CHECK(written[0x260] == row.alpha_in);
        CHECK(written[0x1e40] == row.out);
        CHECK(written[0xaa0] == row.out);
        CHECK(written[0x1e60] == 1);
        CHECK(written[0xa60] == 0x80402010);
    }
    CHECK(count == EnumNames<TextureOp>::names.size());
}

TEST_CASE("combiner words of arguments", "[emit][nv2a]") {
    struct Row {
        ArgSource source;
        std::uint32_t color, replicated, alpha;  // input bytes
    };
    // In the second stage, where CURRENT is R0, 12, and TEXTURE T1, 9.
    const Row rows[] = {
        {ArgSource::Diffuse, 0x04, 0x14, 0x14},  {ArgSource::Current, 0x0c, 0x1c, 0x1c},
        {ArgSource::Texture, 0x09, 0x19, 0x19},  {ArgSource::TFactor, 0x01, 0x11, 0x11},
        {ArgSource::Specular, 0x05, 0x20, 0x20},
    };
    check_table(
        rows, [](const Row& row) { return row.source; }, [](const Row& row) { return row.color; });
    for (const Row& row : rows)
        for (const bool complement : {false, true}) {
            TextureStage stage;
            stage.color_op = stage.alpha_op = TextureOp::SelectArg1;
            stage.color_arg1 = stage.alpha_arg1 = {.source = row.source, .complement = complement};
            const std::uint32_t flip            = complement ? 0x20 : 0;
            const Written plain                 = with_stage(stage, TextureFormat::A8R8G8B8, true);
            CHECK(plain[0xac4] == ((row.color ^ flip) << 24 | 0x200000));
            CHECK(plain[0x264] == ((row.alpha ^ flip) << 24 | 0x200000));
            CHECK(plain[0x3b8] == (row.source == ArgSource::Specular));
            CHECK(plain[0x1e60] == 2);
            stage.color_arg1.alpha_replicate = true;
            CHECK(with_stage(stage, TextureFormat::A8R8G8B8, true)[0xac4] ==
                  ((row.replicated ^ flip) << 24 | 0x200000));
        }
    // The first stage's CURRENT is the diffuse colour.
    TextureStage first = kTextureOnly;
    first.color_arg1   = {.source = ArgSource::Current};
    CHECK(with_stage(first)[0xac0] == 0x04200000);
    // A8's colour is 0, its alpha T0's.
    CHECK(with_stage(kTextureOnly, TextureFormat::A8)[0xac0] == 0x00200000);
    CHECK(with_stage(kTextureOnly, TextureFormat::A8)[0x260] == 0x18200000);
    // Nothing bound: white.
    Frame frame                     = quad_frame();
    frame.passes[0].state.stages[0] = kTextureOnly;
    const Written white(frame);
    CHECK(white[0xac0] == 0x20200000);
    CHECK(white[0x260] == 0x20200000);
    CHECK(white[0x1e70] == 0);
    // The second colour is added in a combiner of its own.
    const Written sum = with_state([](PipelineState& state) { state.lighting.specular_enable = true; });
    CHECK(sum[0x1e60] == 2);
    CHECK(sum[0xac4] == 0x0c200520);
    CHECK(sum[0x264] == 0x1c200000);
}

TEST_CASE("texture formats, filters and addresses", "[emit][nv2a]") {
    struct Row {
        TextureFormat format;
        std::uint32_t swizzled, linear;
    };
    const Row rows[] = {
        {TextureFormat::A8, 0x19, 0x1f}, {TextureFormat::L8, 0x00, 0x13}, {TextureFormat::A8R8G8B8, 0x06, 0x12}};
    check_table(
        rows, [](const Row& row) { return row.format; }, [](const Row& row) { return row.linear; });
    for (const Row& row : rows)
        for (const bool is_swizzled : {true, false}) {
            Frame frame                     = quad_frame({});
            frame.passes[0].state.stages[0] = kTextureOnly;
            const int width                 = is_swizzled ? 8 : 6;
            const auto bytes                = static_cast<std::size_t>(width * 2 * bytes_per_texel(row.format));
            std::vector<std::uint8_t> texels(bytes);
            for (std::size_t i = 0; i < bytes; ++i) texels[i] = static_cast<std::uint8_t>(37 * i);
            quad_of(frame).textures[0] = bound(add_texture(frame, row.format, width, 2, texels));
            const Written written(frame);
            // DMA A, border colour, two dimensions, one level; sizes as logarithms 3 and 1.
            CHECK(written[0x1b04] ==
                  (0x10029u | (is_swizzled ? row.swizzled << 8 | 3u << 20 | 1u << 24 : row.linear << 8)));
            CHECK(written[0x420] == !is_swizzled);
            CHECK(written[0x1e70] == 1);
            if (!is_swizzled) {
                CHECK(written[0x1b10] == 64u << 16);
                CHECK(written[0x1b1c] == (6u << 16 | 2u));
                CHECK(written.real(0x6c0) == 6.0f);
                CHECK(written.real(0x6d4) == 2.0f);
                CHECK(written.real(0x6fc) == 1.0f);
            }
        }
    const auto filter = [](TextureFilter of, MipFilter mip) {
        TextureStage stage = kTextureOnly;
        stage.filter       = of;
        stage.mip_filter   = mip;
        return with_stage(stage)[0x1b14];
    };
    CHECK(filter(TextureFilter::Point, MipFilter::None) == 0x01012000);
    CHECK(filter(TextureFilter::Linear, MipFilter::None) == 0x02022000);
    CHECK(filter(TextureFilter::Point, MipFilter::Point) == 0x01032000);
    CHECK(filter(TextureFilter::Linear, MipFilter::Point) == 0x02042000);
    CHECK(filter(TextureFilter::Point, MipFilter::Linear) == 0x01052000);
    CHECK(filter(TextureFilter::Linear, MipFilter::Linear) == 0x02062000);
    const auto address = [](TextureAddress u, TextureAddress v) {
        TextureStage stage = kTextureOnly;
        stage.address_u    = u;
        stage.address_v    = v;
        return with_stage(stage)[0x1b08];
    };
    CHECK(address(TextureAddress::Wrap, TextureAddress::Clamp) == 0x30301);
    CHECK(address(TextureAddress::Mirror, TextureAddress::Wrap) == 0x30102);
    CHECK(address(TextureAddress::Clamp, TextureAddress::Mirror) == 0x30203);
    CHECK(with_stage(kTextureOnly)[0x1b0c] == 0x4003ffc0);
}
