// SPDX-License-Identifier: MIT
#include "pipeline/legalize/unused.h"

#include "tests/support/rewritten.h"

using namespace pipeline;
using namespace test_support;

namespace {

std::string texture(const std::string& name, const std::string& texel) {
    return '"' + name + "\" { format A8 width 1 height 1 texels [" + texel + "] } ";
}
// Three draws of a pass with one stage: the first's second texture is not read.
std::string text(const std::string& textures, const std::string& second, const std::string& stage = "SELECTARG1") {
    return "targets [ \"a\" { width 4 height 4 } ] passes [ \"p\" { color \"a\" state { stages [ { color_op " + stage +
           " alpha_op " + stage + " } ] } draws [ rectangle { x1 4 y1 4 textures [ { texture \"c\" } " + second +
           " ] } rectangle { x1 4 y1 4 } window_triangles { index_count 3 textures [ { texture \"a\" } ] } ] } ] textures [ " +
           textures + "] window_vertices [ {} {} {} ] indices [ 0 1 2 ]";
}

}  // namespace

TEST_CASE("unused: textures that nothing reads go, and the others keep their order", "[legalize]") {
    const std::string before =
        text(texture("a", "11") + texture("b", "22") + texture("c", "33") + texture("d", "44"), "{ texture \"b\" }");
    const std::string after = text(texture("a", "11") + texture("c", "33"), "");
    for (const char* chip : {"ps2", "dx7", "gamecube", "xbox"}) check_rewrite(&drop_unused, chip, before, after);
    check_left_alone(&drop_unused, "ideal", before);
    check_left_alone(&drop_unused, "ps2", after);
    const RewriteNotes notes = notes_of(parsed(before), &drop_unused, "ps2");
    REQUIRE(notes.size() == 2);
    CHECK(notes[0].where == "texture 1 'b'");
    CHECK(notes[1].where == "texture 3 'd'");
    CHECK(pixels_of(parsed(after)) == pixels_of(parsed(before)));
}

TEST_CASE("unused: what is bound to a stage that selects something else is not read", "[legalize]") {
    Frame frame = parsed(text(texture("a", "11") + texture("c", "33"), "", "SELECTARG2"));
    frame       = rewritten(frame, &drop_unused, "ps2");
    CHECK(frame.textures.empty());
    for (const Draw& draw : frame.passes[0].draws) CHECK(textures_of(draw) == TextureBindings{});
}
