// SPDX-License-Identifier: MIT
#include "pipeline/legalize/reversed_depth.h"

#include "pipeline/frame/frame_text.h"
#include "pipeline/validate/validate.h"
#include "tests/support/random.h"
#include "tests/support/small_frame.h"

using namespace pipeline;

namespace {

Frame rewritten(const Frame& frame, std::string_view chip = "ps2") {
    RewriteNotes notes;
    Frame other = rewrite_reversed_depth(frame, *find_profile(chip), notes);
    CHECK(notes.empty() == (other == frame));
    for (const Finding& finding : validate(other)) FAIL_CHECK(finding.where << ": " << finding.what);
    return other;
}
void check_rewrite(const std::string& before, const std::string& after, std::string_view chip = "ps2") {
    INFO(chip);
    CHECK(to_text(rewritten(parse_frame(before), chip)) == to_text(parse_frame(after)));
}

const std::string kTargets =
    "nimbus7 frame 1\noutput \"a\" targets [\"a\" {width 4 height 4} \"d\" {format D24 width 4 height 4}"
    "\"e\" {format D24 width 4 height 4}] ";
// Near 1, far 3: z = (z - 1) * 1.5.
const std::string kCamera   = "\"c\" {projection ((1 0 0 0) (0 1 0 0) (0 0 1.5 -1.5) (0 0 1 0))}";
const std::string kReversed = "\"c\" {projection ((1 0 0 0) (0 1 0 0) (0 0 -0.5 1.5) (0 0 1 0))}";

std::string pass(const std::string& name, const std::string& depth, const std::string& clear, const std::string& func,
                 const std::string& rectangle, const std::string& camera) {
    return '"' + name + "\" {color \"a\" depth \"" + depth + "\" camera " + camera + " clear {" + clear +
           "} state {depth {func " + func + " write true}} draws [rectangle {x1 4 y1 4 depth " + rectangle + "}]}";
}

}  // namespace

TEST_CASE("reversed_depth: functions, clears, rectangles and projections turn around", "[legalize]") {
    check_rewrite(
        kTargets + "cameras [" + kCamera + "] passes [" + pass("p", "d", "depth 0.75", "LESSEQUAL", "0.25", "#0") +
            pass("q", "d", "", "LESS", "1", "#0") + pass("r", "d", "", "ALWAYS", "0", "none") + "]",
        kTargets + "cameras [" + kReversed + "] passes [" + pass("p", "d", "depth 0.25", "GREATEREQUAL", "0.75", "#0") +
            pass("q", "d", "", "GREATER", "0", "#0") + pass("r", "d", "", "ALWAYS", "1", "none") + "]");
}

TEST_CASE("reversed_depth: what the chip compares is left alone", "[legalize]") {
    const std::string growing = kTargets + "cameras [" + kCamera + "] passes [" +
                                pass("p", "d", "depth 0", "GREATEREQUAL", "0.25", "#0") +
                                pass("q", "d", "", "NEVER", "0.5", "#0") + "]";
    check_rewrite(growing, growing);
    const std::string falling =
        kTargets + "cameras [" + kCamera + "] passes [" + pass("p", "d", "depth 1", "LESSEQUAL", "0.25", "#0") + "]";
    for (const char* chip : {"ideal", "dx7", "gamecube", "xbox"}) check_rewrite(falling, falling, chip);
    // Neither way is EQUAL had, and one way is as bad as the other.
    const std::string equal = kTargets + "passes [" + pass("p", "d", "depth 1", "EQUAL", "0.25", "none") + "]";
    check_rewrite(equal, equal);
    const std::string both = kTargets + "passes [" + pass("p", "d", "depth 1", "LESS", "0.25", "none") +
                             pass("q", "d", "", "GREATER", "0.25", "none") + "]";
    check_rewrite(both, both);
}

TEST_CASE("reversed_depth: only targets that need it, with cameras of their own", "[legalize]") {
    check_rewrite(kTargets + "cameras [" + kCamera + "] passes [" +
                      pass("p", "d", "depth 1", "LESSEQUAL", "0.25", "#0") +
                      pass("q", "e", "depth 0", "GREATEREQUAL", "0.25", "#0") + "]",
                  kTargets + "cameras [" + kCamera + kReversed + "] passes [" +
                      pass("p", "d", "depth 0", "GREATEREQUAL", "0.75", "#1") +
                      pass("q", "e", "depth 0", "GREATEREQUAL", "0.25", "#0") + "]");
}

TEST_CASE("reversed_depth: the zeros that a target starts with stay nearest", "[legalize]") {
    const std::string start = "\"zeros of 'd', reversed\" {depth \"d\" clear {depth 1}}";
    check_rewrite(kTargets + "passes [" + pass("p", "d", "", "LESSEQUAL", "0.25", "none") + "]",
                  kTargets + "passes [" + start + pass("p", "d", "", "GREATEREQUAL", "0.75", "none") + "]");
    // A clear of a part leaves zeros.
    const auto part = [](const char* clear, const char* func, const char* depth) {
        return std::string("\"p\" {color \"a\" depth \"d\" clear {depth ") + clear + "} state {depth {func " + func +
               "} scissor {x1 2 y1 4}} draws [rectangle {x1 4 y1 4 depth " + depth + "}]}";
    };
    check_rewrite(kTargets + "passes [" + part("1", "LESS", "0.5") + "]",
                  kTargets + "passes [" + start + part("0", "GREATER", "0.5") + "]");

    Frame frame                 = test_support::small_frame(1, 1, TargetFormat::D24);
    frame.passes[0].state.depth = {.func = CompareFunc::Less, .write = true};
    frame.passes[0].draws       = {test_support::rectangle({0, 0, 1, 1}, 0xffffffff, 0.5f)};
    CHECK(test_support::color_on_both(frame) == 0);
    CHECK(test_support::color_on_both(rewritten(frame)) == 0);
}

TEST_CASE("reversed_depth: every pair of 256 depths compares as before", "[legalize]") {
    const CompareFunc func    = GENERATE(CompareFunc::Less, CompareFunc::LessEqual);
    const TargetFormat format = GENERATE(TargetFormat::D16, TargetFormat::D24, TargetFormat::D32);
    Frame frame               = test_support::small_frame(256, 256, format);
    Pass& pass                = frame.passes[0];
    pass.clear.depth          = 1.0f;
    pass.state.depth          = {.func = CompareFunc::LessEqual, .write = true};
    for (int x = 0; x < 256; ++x)
        pass.draws.push_back(test_support::rectangle({x, 0, x + 1, 256}, 0xff0000ff, static_cast<float>(x) / 255.0f));
    Pass second        = pass;
    second.clear       = {};
    second.state.depth = {.func = func, .write = false};
    second.draws.clear();
    for (int y = 0; y < 256; ++y)
        second.draws.push_back(test_support::rectangle({0, y, 256, y + 1}, 0xffff0000, static_cast<float>(y) / 255.0f));
    frame.passes.push_back(second);
    const auto want = execute(frame).output.pixels;
    CHECK(std::count(want.begin(), want.end(), 0xffff0000) == 256 * (func == CompareFunc::Less ? 255 : 257) / 2);
    CHECK(execute(rewritten(frame)).output.pixels == want);
}

TEST_CASE("reversed_depth: triangles in perspective meet where they met", "[legalize]") {
    // Two quads that cross along a diagonal, from z 1 to 3: at most the pixels on the line where they meet may differ.
    Frame frame                 = test_support::small_frame(64, 64, TargetFormat::D24);
    frame.cameras[0].projection = Mat4(1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1.5f, 1, 0, 0, -1.5f, 0);
    Pass& pass                  = frame.passes[0];
    pass.clear                  = {.color = Argb{0xff000000}, .depth = 1.0f};
    pass.state.depth            = {.func = CompareFunc::LessEqual, .write = true};
    for (const std::uint32_t color : {0xffff0000u, 0xff00ff00u}) {
        DrawTriangles draw      = test_support::add_quad(frame, color);
        const std::size_t first = frame.vertices.size() - 4;
        for (std::size_t i = 0; i < 4; ++i) {
            Vec3& position   = frame.vertices[first + i].position;
            const bool right = position.x > 0.0f, is_near = right == (color == 0xffff0000u);
            position = Vec3(position.x, position.y, 1.0f) * (is_near ? 1.25f : 2.75f);
        }
        pass.draws.push_back(draw);
    }
    const auto want = execute(frame).output.pixels, got = execute(rewritten(frame)).output.pixels;
    const auto reds = std::count(want.begin(), want.end(), 0xffff0000u);
    CHECK(reds > 64 * 16);
    CHECK(reds < 64 * 48);
    int differing = 0;
    for (std::size_t i = 0; i < want.size(); ++i) differing += got[i] != want[i];
    CHECK(differing <= 64);
}
