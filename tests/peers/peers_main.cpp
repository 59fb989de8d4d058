// SPDX-License-Identifier: MIT
// nimbus7_peers [--driver llvmpipe|softpipe] [--passes] [--random N] [--mistakes] [FRAME...]
// Draws frames with pipeline::execute and with OpenGL, and compares: the built-in scenes, the frame files given or
// else those of demo/frames, and N random frames, these in two halves (compare_frame.h). Without --driver, with each
// driver in a process of its own.
// --passes prints a line for each pass. --mistakes shows instead that the comparison would see what is wrong
// (mistakes.h): each mistake, in some frame that it changes. Exit status 1 if a frame differs by more than its bounds
// or a known difference is stale, 2 for bad input.
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <charconv>
#include <cstdio>
#include <filesystem>
#include <map>
#include <set>
#include <stdexcept>

#include "demo/embedded_texts.h"
#include "demo/frame_source.h"
#include "tests/peers/compare_frame.h"
#include "tests/peers/expressible.h"
#include "tests/peers/gl_context.h"
#include "tests/peers/known_differences.h"
#include "tests/peers/mistakes.h"
#include "tests/support/random_frame.h"

namespace {

using namespace peers;
namespace fs = std::filesystem;

const std::string kSource = NIMBUS7_SOURCE_DIR;
constexpr demo::Size kSceneSize{640, 360}, kMistakenSceneSize{320, 180};

struct Arguments {
    std::optional<Driver> driver;
    bool prints_passes  = false;
    bool makes_mistakes = false;
    int random_frames   = 0;
    std::vector<std::string> frames;
};

struct UsageError : std::runtime_error {
    using std::runtime_error::runtime_error;
};

Arguments parse(int count, char** words) {
    Arguments arguments;
    const auto value = [&](int& i) -> std::string {
        if (++i == count) throw UsageError(std::string(words[i - 1]) + " needs a value");
        return words[i];
    };
    for (int i = 1; i < count; ++i) {
        const std::string word = words[i];
        if (word == "--driver") {
            const std::string name = value(i);
            arguments.driver       = find_driver(name);
            if (!arguments.driver) throw UsageError("there is no driver '" + name + "'");
        } else if (word == "--passes") {
            arguments.prints_passes = true;
        } else if (word == "--mistakes") {
            arguments.makes_mistakes = true;
        } else if (word == "--random") {
            const std::string number = value(i);
            const char* end          = number.data() + number.size();
            if (std::from_chars(number.data(), end, arguments.random_frames).ptr != end)
                throw UsageError("--random needs a number");
        } else if (word.starts_with("--")) {
            throw UsageError("there is no option '" + word + "'");
        } else {
            arguments.frames.push_back(word);
        }
    }
    return arguments;
}

// In one process there is only one driver.
int run_each_driver(char** words) {
    int worst = 0;
    for (const Driver driver : {Driver::Llvmpipe, Driver::Softpipe}) {
        std::fflush(stdout);
        const pid_t child = fork();
        if (child == 0) {
            std::string option = "--driver", name(driver_name(driver));
            std::vector<char*> arguments{words[0], option.data(), name.data()};
            for (char** word = words + 1; *word != nullptr; ++word) arguments.push_back(*word);
            arguments.push_back(nullptr);
            execv("/proc/self/exe", arguments.data());
            _exit(2);
        }
        int status = 0;
        if (child < 0 || waitpid(child, &status, 0) < 0) throw std::runtime_error("no process for the driver");
        worst = std::max(worst, WIFEXITED(status) ? WEXITSTATUS(status) : 2);
    }
    return worst;
}

class Run {
  public:
    Run(Driver driver, bool prints_passes)
        : driver_(driver_name(driver)), context_(driver), prints_passes_(prints_passes) {
        std::printf("%s\n", context_.description().c_str());
        for (const KnownDifference& known : read_known_differences(kSource + "/tests/known_differences.txt"))
            if (known.driver == driver_) known_[known.frame] = known;
    }

    void compare(const std::string& name, const pipeline::Frame& frame, Part part = Part::Whole) {
        if (const auto reason = cannot_express(frame)) {
            ++skipped_;
            std::printf("%-28s %-8s skipped: %s\n", name.c_str(), driver_.c_str(), reason->c_str());
            return;
        }
        const std::vector<PassComparison> passes = compare_passes(frame, frame, part);
        if (prints_passes_)
            for (const PassComparison& pass : passes) print("  " + pass.label, pass.comparison, "");
        const Comparison sum         = total(passes);
        const auto found             = known_.find(name);
        const KnownDifference* known = found != known_.end() ? &found->second : nullptr;
        compared_names_.insert(name);
        const Verdict verdict = judge(sum, known);
        if (verdict == Verdict::Failed || verdict == Verdict::Stale) failed_ = true;
        for (const PassComparison& pass : passes)
            if (is_suspect(pass.comparison)) {
                print(pass.label, pass.comparison, "FAILED: differences lean to one side, or too many edges");
                failed_ = true;
            }
        ++compared_;
        print(name, sum, describe(verdict, known));
        std::fflush(stdout);
    }

    // all_frames: nothing was left out, so a known difference that did not come up is of a frame that is no more.
    int finish(bool all_frames) {
        for (const auto& [name, known] : known_)
            if (all_frames && compared_names_.count(name) == 0) {
                std::printf("%s: FAILED: tests/known_differences.txt names it, but it was not compared\n",
                            name.c_str());
                failed_ = true;
            }
        std::printf("%s: %d frames compared, %d skipped: %s\n", driver_.c_str(), compared_, skipped_,
                    failed_ ? "FAILED" : "ok");
        return failed_ ? 1 : 0;
    }

  private:
    void print(const std::string& name, const Comparison& c, const std::string& verdict) const {
        std::printf("%-28s %-8s %7llu pixels, %6llu differ, %4llu edge", name.c_str(), driver_.c_str(),
                    static_cast<unsigned long long>(c.pixels), static_cast<unsigned long long>(c.differing),
                    static_cast<unsigned long long>(c.edge));
        if (c.failed > 0) std::printf(", %llu beyond", static_cast<unsigned long long>(c.failed));
        if (c.worst.units > 0)
            std::printf(", worst %d at (%d, %d) ours %08x GL %08x", c.worst.units, c.worst.x, c.worst.y, c.worst.ours,
                        c.worst.peers);
        std::printf(", mean %+.4f  %s\n", c.mean(), verdict.c_str());
    }

    static std::string describe(Verdict verdict, const KnownDifference* known) {
        switch (verdict) {
            case Verdict::Ok:
                return "ok";
            case Verdict::Known:
                return "ok (" + known->reason + ")";
            case Verdict::Stale:
                return "FAILED: its entry in tests/known_differences.txt is stale";
            case Verdict::Failed:
                return "FAILED";
        }
        return "";
    }

    std::string driver_;
    GlContext context_;
    bool prints_passes_;
    std::map<std::string, KnownDifference> known_;
    std::set<std::string> compared_names_;
    int compared_ = 0, skipped_ = 0;
    bool failed_ = false;
};

std::vector<std::string> frame_files() {
    std::vector<std::string> files;
    const fs::path folder = fs::path(kSource) / "demo/frames";
    if (!fs::exists(folder)) return files;
    for (const fs::directory_entry& entry : fs::directory_iterator(folder))
        if (entry.path().extension() == ".frame") files.push_back(entry.path());
    std::sort(files.begin(), files.end());
    return files;
}

// Every alpha from the left to the right over one colour: large enough to tell how a blend rounds.
pipeline::Frame blend_ramp() {
    using namespace pipeline;
    Frame frame;
    frame.output  = {0};
    frame.targets = {{.name = "picture", .width = 256, .height = 256}};
    frame.cameras.resize(1);
    Pass& pass       = frame.passes.emplace_back();
    pass.label       = "over";
    pass.color       = {0};
    pass.camera      = {0};
    pass.clear.color = Argb{0xff40c080};
    pass.state.blend = kAlphaOver;
    for (const float y : {1.0f, -1.0f})
        for (const float x : {-1.0f, 1.0f}) {
            Vertex& vertex  = frame.vertices.emplace_back();
            vertex.position = {x, y, 0.0f};
            vertex.diffuse  = {(x > 0.0f ? 0xff000000 : 0) | (y > 0.0f ? 0xd02010u : 0x1080f0u)};
        }
    frame.indices = {0, 1, 2, 2, 1, 3};
    pass.draws    = {DrawTriangles{.index_count = 6}};
    return frame;
}

struct NamedFrame {
    std::string name;
    pipeline::Frame frame;
    bool is_random = false;
};

std::vector<NamedFrame> frames_of(const Arguments& arguments, const demo::Size& scene_size) {
    std::vector<NamedFrame> frames;
    if (arguments.frames.empty()) {
        frames.push_back({"blend_ramp", blend_ramp()});
        for (const demo::EmbeddedText& scene : demo::embedded_scenes()) {
            const std::string name(scene.name);
            frames.push_back({name, demo::FrameSource(name).frame(scene_size, 0)});
        }
    }
    for (const std::string& file : arguments.frames.empty() ? frame_files() : arguments.frames) {
        const demo::FrameSource source(file);
        frames.push_back(
            {source.name(), source.frame(source.is_dumped_frame() ? std::nullopt : std::optional(scene_size), 0)});
    }
    for (int seed = 0; seed < arguments.random_frames; ++seed) {
        NamedFrame random{"random-" + std::to_string(seed),
                          test_support::random_frame(static_cast<std::uint32_t>(seed)), true};
        make_expressible(random.frame);
        frames.push_back(std::move(random));
    }
    return frames;
}

int run(const Arguments& arguments) {
    Run run(*arguments.driver, arguments.prints_passes);
    for (const NamedFrame& named : frames_of(arguments, kSceneSize)) {
        if (named.is_random) {
            run.compare(named.name + "-raster", named.frame, Part::Raster);
            run.compare(named.name + "-vertices", named.frame, Part::Vertices);
        } else {
            run.compare(named.name, named.frame);
        }
    }
    return run.finish(arguments.frames.empty());
}

int run_mistakes(const Arguments& arguments) {
    const GlContext context(*arguments.driver);
    std::vector<NamedFrame> frames = frames_of(arguments, kMistakenSceneSize);
    std::erase_if(frames, [](const NamedFrame& named) { return cannot_express(named.frame).has_value(); });
    // A frame with a known difference shows a mistake by differing more than that.
    std::map<std::string, KnownDifference> known;
    for (const KnownDifference& each : read_known_differences(kSource + "/tests/known_differences.txt"))
        if (each.driver == driver_name(*arguments.driver)) known[each.frame] = each;
    // What shows that a frame is not the peer's, if anything does.
    const auto shown_by = [&](const std::string& name, const pipeline::Frame& ours, const pipeline::Frame& peers) {
        const std::vector<PassComparison> passes = compare_passes(ours, peers);
        const Comparison sum                     = total(passes);
        const auto found                         = known.find(name);
        if (judge(sum, found != known.end() ? &found->second : nullptr) == Verdict::Failed)
            return name + ": " + std::to_string(sum.failed) + " pixels";
        for (const PassComparison& pass : passes)
            if (is_suspect(pass.comparison))
                return name + ": mean " + std::to_string(pass.comparison.mean()) + " in " + pass.label;
        return std::string();
    };
    // Frames that show something without a mistake show nothing.
    std::map<std::string, bool> is_sound;
    const auto shows_nothing = [&](const NamedFrame& named) {
        const auto [found, is_new] = is_sound.insert({named.name, false});
        if (is_new) found->second = shown_by(named.name, named.frame, named.frame).empty();
        return found->second;
    };
    int missed = 0;
    for (const Mistake& mistake : mistakes()) {
        // The smaller frames first: the first that shows it is enough.
        std::string seen;
        for (auto named = frames.rbegin(); named != frames.rend() && seen.empty(); ++named) {
            pipeline::Frame wrong = named->frame;
            mistake.make(wrong);
            if (wrong == named->frame) continue;
            seen = mistake.is_ours ? shown_by(named->name, wrong, named->frame)
                                   : shown_by(named->name, named->frame, wrong);
            if (!seen.empty() && !shows_nothing(*named)) seen.clear();
        }
        missed += seen.empty();
        std::printf("%-48s %s\n", std::string(mistake.name).c_str(),
                    seen.empty() ? "MISSED" : ("seen in " + seen).c_str());
    }
    return missed > 0 ? 1 : 0;
}

}  // namespace

int main(int count, char** words) {
    try {
        const Arguments arguments = parse(count, words);
        if (!arguments.driver) return run_each_driver(words);
        return arguments.makes_mistakes ? run_mistakes(arguments) : run(arguments);
    } catch (const std::exception& error) {
        std::fprintf(stderr, "nimbus7_peers: %s\n", error.what());
        return 2;
    }
}
