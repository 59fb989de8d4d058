// SPDX-License-Identifier: MIT
// For the thread sanitizer: frames' texts, and scene files, whose frames have enough tiles and vertices for several
// threads. They are drawn by one thread and by some, which must not differ.
#include "demo/scene_build.h"
#include "demo/scene_file.h"
#include "pipeline/frame/frame_text.h"
#include "pipeline/validate/validate.h"
#include "pipeline/validate/work.h"
#include "tests/fuzz/fuzz.h"
#include "tests/fuzz/soon_built.h"
#include "tests/support/frame_agreement.h"

using namespace pipeline;

namespace {

// The sanitizer makes all of it some ten times slower.
constexpr std::uint64_t kMostPixels = 1 << 20, kMostTriangles = 1 << 14, kMostBytes = 1 << 24;

std::optional<Frame> read(std::string_view text) {
    try {
        if (text.starts_with("nimbus7 frame ")) return parse_frame(text);
        const demo::SceneDescription scene = demo::parse_scene(text, "a/b.toml", "b");
        const int index                    = static_cast<int>(text.size()) % scene.frames;
        return scene_frame(demo::build_scene(fuzz::soon_built(scene)), {192, 108}, index);
    } catch (const ParseError&) {
        return {};
    } catch (const demo::SceneError&) {
        return {};
    }
}

}  // namespace

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::optional<Frame> frame = read(fuzz::as_text(data, size));
    if (!frame || !validate(*frame).empty()) return -1;
    const Work work = work_of(*frame);
    if (work.pixels > kMostPixels || work.triangles > kMostTriangles || work.bytes > kMostBytes) return -1;

    const auto seed                = static_cast<std::uint32_t>(size);
    const test_support::Drawn want = test_support::draw(*frame, {.threads = 1});
    ExecuteOptions options{.threads = 4, .tile_order_seed = seed};
    fuzz::require(difference(test_support::draw(*frame, options), want).empty(), "4 threads, pass by pass, differ");
    options.threads = 3;
    fuzz::require(execute(*frame, options).output == want.execution.output, "3 threads differ");
    options.counts_fragments = false;
    fuzz::require(execute(*frame, options).output == want.execution.output, "3 threads differ without counts");
    return 0;
}
