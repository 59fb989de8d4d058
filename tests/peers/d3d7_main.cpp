// SPDX-License-Identifier: MIT
// nimbus7_d3d7 [--passes] [--size WxH] [SCENE...]
// Draws scenes, or frames that `nimbus7 dump` wrote, rewritten for profile dx7, with pipeline::execute and by their Direct3D 7
// programs under Wine, and compares: pass by pass, each from the same colours (compare.h, pass_limits.h). Without a scene:
// canyon, plume, sunset and inside. --passes prints a line for each pass.
// Wine does not cut corners to 1/16 pixel as the chip does, so that edges move by as much, twice what the frame's own rounding
// moves them by: more pixels may be at edges than with OpenGL.
// Exit status 1 if a scene differs by more than its bounds, 2 for bad input, 77 if a program that is needed is not there, or Wine does not start.
// Not compared: passes to targets of 16 bits, as the API does not say how they round.
#include <algorithm>
#include <cstdio>
#include <stdexcept>

#include "demo/frame_source.h"
#include "tests/peers/d3d7_program.h"
#include "tests/peers/isolate.h"
#include "tests/peers/pass_limits.h"

namespace {

using namespace peers;
using namespace pipeline;

// In pixels: a corner that is cut moves by up to 1/16, and Wine's own centres are 1/256 off.
constexpr float kCutNudges[]          = {-3.0f / 32.0f, -1.0f / 16.0f, -1.0f / 32.0f, 0.0f,
                                         1.0f / 32.0f,  1.0f / 16.0f,  3.0f / 32.0f};
// Hundreds of spheres meet in edges all over a cloud.
constexpr std::uint64_t kEnoughPixels = 10000, kPixelsPerEdge = 100;

struct Arguments {
    bool prints_passes = false;
    demo::Size size{320, 240};
    std::vector<std::string> scenes;
};

struct UsageError : std::runtime_error {
    using std::runtime_error::runtime_error;
};

Arguments parse(int count, char** words) {
    Arguments arguments;
    for (int i = 1; i < count; ++i) {
        const std::string word = words[i];
        if (word == "--passes") {
            arguments.prints_passes = true;
        } else if (word == "--size") {
            int read = 0;
            if (++i == count ||
                std::sscanf(words[i], "%dx%d%n", &arguments.size.width, &arguments.size.height, &read) < 2 ||
                words[i][read] != '\0')
                throw UsageError("--size needs WxH");
        } else if (word.starts_with("--")) {
            throw UsageError("there is no option '" + word + "'");
        } else {
            arguments.scenes.push_back(word);
        }
    }
    if (arguments.scenes.empty()) arguments.scenes = {"canyon", "plume", "sunset", "inside"};
    return arguments;
}

void print(const std::string& name, const Comparison& c, int most_allowed, const std::string& verdict) {
    const auto number = [](std::uint64_t value) { return static_cast<unsigned long long>(value); };
    std::printf("%-48s %7llu pixels, %6llu differ, %llu at edges, %llu beyond", name.c_str(), number(c.pixels),
                number(c.differing), number(c.edge), number(c.failed));
    if (c.worst.units > 0)
        std::printf(", worst %d at (%d, %d) ours %08x Wine %08x", c.worst.units, c.worst.x, c.worst.y, c.worst.ours,
                    c.worst.peers);
    if (most_allowed > 0) std::printf(", allowed up to %d", most_allowed);
    std::printf(", mean %+.4f  %s\n", c.mean(), verdict.c_str());
    std::fflush(stdout);
}

// A rule of the chip that has nothing to do with what its API computes.
bool hinders(const ChipFinding& finding) {
    return finding.rule != "limits" && finding.rule != "memory";
}

class Run {
  public:
    explicit Run(bool prints_passes) : prints_passes_(prints_passes) {}

    bool can_start() const { return runner_.can_run(); }

    void compare(const std::string& name, Frame frame) {
        LegalFrame legal = legalize(std::move(frame), *find_profile("dx7"));
        for (const ChipFinding& finding : legal.left)
            if (hinders(finding)) {
                std::printf("%-48s skipped: %s uses %s\n", name.c_str(), finding.where.c_str(), finding.uses.c_str());
                return;
            }
        legal.left.clear();
        const auto is_not_drawn_to = [](const Target& target) { return target.format == TargetFormat::A1R5G5B5; };
        if (std::any_of(legal.frame.targets.begin(), legal.frame.targets.end(), is_not_drawn_to)) {
            std::printf("%-48s skipped: Wine does not draw to A1R5G5B5\n", name.c_str());
            return;
        }
        const std::vector<TargetPictures> before = pictures_of(legal.frame);
        const SteppedFrame stepped               = step_by_step(legal.frame, before);
        const std::vector<ColorImage> wine       = runner_.run({.frame = stepped.frame, .notes = {}, .left = {}});
        Comparison sum;
        int most_allowed = 0;
        bool ok          = true;
        for (std::size_t i = 0; i < legal.frame.passes.size(); ++i) {
            const Pass& pass = legal.frame.passes[i];
            if (!pass.color || !keeps_bytes(legal.frame.targets[static_cast<std::size_t>(pass.color.index)].format))
                continue;
            PassLimits limits(legal.frame, i, before, {.nudges = kCutNudges});
            const ColorImage& ours = *before[i + 1][static_cast<std::size_t>(pass.color.index)];
            Comparison comparison  = peers::compare(ours, wine[stepped.places[i]], limits.limits());
            if (leans(comparison)) comparison.explained_mean = limits.explained_mean();
            const bool pass_ok = comparison.failed == 0 && !is_too_far(comparison);
            if (prints_passes_ || !pass_ok)
                print("  " + std::to_string(i) + ' ' + pass.label, comparison, limits.most_allowed(),
                      pass_ok ? "" : "FAILED");
            ok           = ok && pass_ok;
            most_allowed = std::max(most_allowed, limits.most_allowed());
            sum.add(comparison);
        }
        if (sum.pixels == 0)
            std::printf("%-48s skipped: its targets have 16 bits\n", name.c_str());
        else
            print(name, sum, most_allowed, ok ? "ok" : "FAILED");
        failed_ = failed_ || !ok;
    }

    bool failed() const { return failed_; }

  private:
    // As is_suspect, with room for corners that are cut.
    static bool is_too_far(const Comparison& comparison) {
        return comparison.pixels >= kEnoughPixels &&
               (leans(comparison) || comparison.edge * kPixelsPerEdge > comparison.pixels);
    }

    D3d7Runner runner_;
    bool prints_passes_, failed_ = false;
};

int run(const Arguments& arguments) {
    if (const std::vector<std::string> missing = missing_d3d7_tools(); !missing.empty()) {
        for (const std::string& program : missing)
            std::fprintf(stderr, "nimbus7_d3d7: %s is not in PATH\n", program.c_str());
        return 77;
    }
    Run run(arguments.prints_passes);
    if (!run.can_start()) {
        std::fprintf(stderr, "nimbus7_d3d7: Wine does not start on this machine\n");
        return 77;
    }
    for (const std::string& scene : arguments.scenes) {
        const demo::FrameSource source(scene);
        run.compare(source.name(),
                    source.frame(source.is_dumped_frame() ? std::nullopt : std::optional(arguments.size), 0));
    }
    return run.failed() ? 1 : 0;
}

}  // namespace

int main(int count, char** words) {
    try {
        return run(parse(count, words));
    } catch (const std::exception& error) {
        std::fprintf(stderr, "nimbus7_d3d7: %s\n", error.what());
        return 2;
    }
}
