// SPDX-License-Identifier: MIT
// The names of special programs stand in a list of their own: what their words say holds for the program of that place.
#include "raster/special_names.h"

#include <catch2/catch.hpp>
#include <string_view>

using namespace raster;

namespace {

void check_words(std::string_view name, const FillProgram& program) {
    CAPTURE(name);
    const auto says     = [&](std::string_view word) { return name.find(word) != std::string_view::npos; };
    const auto& texture = program.textures[0];
    if (says("landscape")) CHECK((program.fog && program.depth_bits == 24));
    if (says("and detail")) CHECK(program.textures[1].has_texels);
    if (says("no texture")) CHECK_FALSE(program.is_textured());
    if (says("mega-particles")) CHECK((program.depth_write && program.fog));
    if (says("skirt")) CHECK((!program.depth_write && program.fog && program.is_replace()));
    if (says("sky")) CHECK((!program.depth_write && !program.fog && program.depth_bits == 24));
    if (says("vertex colour")) CHECK((program.depth_write && !program.fog && !program.is_textured()));
    if (says("thrown light")) CHECK((program.source == special::kDest && program.dest == kOne));
    if (says("box")) CHECK((texture.alpha_quads || program.textures[1].alpha_quads));
    if (says("over the scene") || says("laid over")) CHECK(program.source == special::kSourceAlpha);
    if (says("dissolve")) CHECK(program.is_replace());
    if (says("multipl")) CHECK(program.dest == special::kSourceColor);
    if (says("one level")) CHECK_FALSE(texture.has_mips);
    if (says("sprites")) CHECK((texture.alpha_quads && program.alpha_func == Compare::Greater));
    if (says("slices")) CHECK((!texture.alpha_quads && program.alpha_func == Compare::Greater));
    if (says("blit")) CHECK((program.is_textured() && program.is_replace()));
    if (says("linear")) CHECK(texture.linear);
    if (says("point")) CHECK_FALSE(texture.linear);
    if (says("constant alpha")) CHECK(program.stages[0].alpha.a == special::kConstant);
    if (says("composite")) CHECK(program.source == special::kSourceAlpha);
    if (says("faded")) CHECK(program.stages[0].alpha.op == CombineOp::Modulate);
    if (says("masked")) CHECK(program.dest_alpha_test == DestAlphaTest::One);
    if (says("into alpha") || says("rim mask")) CHECK(program.writes == Writes::Alpha);
    if (says("alpha kept")) CHECK(program.writes == Writes::Some);
    if (says("colour, depth")) CHECK(program.depth_write);
    if (says("colour, over")) CHECK(program.source == special::kSourceAlpha);
    if (says("times one more")) CHECK((program.source == special::kDest && program.dest == kOne));
}

}  // namespace

TEST_CASE("what a special program's name says holds for it", "[raster]") {
    for (std::size_t i = 0; i < kTrianglePrograms.size(); ++i) check_words(kTriangleNames[i], kTrianglePrograms[i]);
    for (std::size_t i = 0; i < kRectanglePrograms.size(); ++i) check_words(kRectangleNames[i], kRectanglePrograms[i]);
}
