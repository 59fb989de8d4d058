// SPDX-License-Identifier: MIT
#include "demo/command_render.h"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <filesystem>
#include <future>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <vector>

#include "demo/chip_frame.h"
#include "demo/image_file.h"
#include "demo/pass_pictures.h"
#include "demo/pass_statistics.h"
#include "demo/progress_bar.h"
#include "demo/standard_output.h"
#include "pipeline/execute/execute.h"

namespace demo {
namespace {

namespace fs = std::filesystem;
using Clock  = std::chrono::steady_clock;

double milliseconds_since(Clock::time_point start) {
    return std::chrono::duration<double, std::milli>(Clock::now() - start).count();
}

void choose_simd_target(const std::string& name) {
    if (name.empty()) return;
    const std::vector<std::string> targets = pipeline::simd_targets();
    if (std::find(targets.begin(), targets.end(), name) == targets.end()) {
        std::string known;
        for (const std::string& target : targets) known += (known.empty() ? "" : ", ") + target;
        throw std::runtime_error("--simd " + name + ": this machine has " + known);
    }
    pipeline::force_simd_target(name);
}

struct DrawnFrame {
    int index;
    std::string path;
    int width = 0, height = 0;
    std::vector<PassStatistics> passes;
    double building_ms = 0.0, drawing_ms = 0.0;  // scene to frame; frame to picture, writing files not counted
};

// Gives frame after frame, for the chip if there is one.
class Frames {
  public:
    Frames(const FrameSource& source, const RenderOptions& options)
        : source_(source),
          chip_{.scene   = options.scene,
                .profile = options.profile,
                .size    = options.size,
                .changes = options.changes,
                .reduce  = options.reduce} {}

    pipeline::Frame at(int index) {
        if (chip_.profile == nullptr) return source_.frame(chip_.size, index, chip_.changes);
        chip_.frame = index;
        return drawable_chip_frame(source_, chip_).frame;
    }

  private:
    const FrameSource& source_;
    ChipFrameOptions chip_;
};

DrawnFrame draw(Frames& frames, const RenderOptions& options, int index, const std::string& path,
                pipeline::Executor& executor, pipeline::Execution& execution) {
    DrawnFrame drawn{.index = index, .path = path, .passes = {}};
    const Clock::time_point start = Clock::now();
    const pipeline::Frame frame   = frames.at(index);
    drawn.building_ms             = milliseconds_since(start);

    std::optional<PassPictures> pictures;
    if (options.passes_directory) {
        pictures.emplace(numbered_path(*options.passes_directory, index), frame.passes.size());
    }
    const Clock::time_point draw_start = Clock::now();
    Clock::time_point pass_start       = draw_start;
    const auto observe                 = [&](const pipeline::FinishedPass& pass) {
        drawn.passes.push_back({pass.pass.label, pass.counts, pass.kernels, milliseconds_since(pass_start)});
        if (pictures) pictures->add(pass);
        pass_start = Clock::now();
    };
    // Observed, passes are drawn one by one, which takes longer; and so does counting.
    const bool is_counted  = options.statistics != StatisticsFormat::None;
    const bool is_observed = pictures || is_counted;
    executor.execute(frame, execution, {.threads = options.threads, .counts_fragments = is_counted},
                     is_observed ? pipeline::PassObserver(observe) : pipeline::PassObserver());
    if (is_observed) {
        for (const PassStatistics& pass : drawn.passes) drawn.drawing_ms += pass.milliseconds;
        drawn.drawing_ms += milliseconds_since(pass_start);
    } else {
        drawn.drawing_ms = milliseconds_since(draw_start);
    }
    drawn.width  = execution.output.width;
    drawn.height = execution.output.height;
    if (pictures) pictures->finish();
    return drawn;
}

void print_text(const DrawnFrame& frame, bool with_table) {
    char times[80];
    std::snprintf(times, sizeof times, "drawn in %.2f ms, frame built in %.2f ms", frame.drawing_ms, frame.building_ms);
    print(frame.path + "  " + std::to_string(frame.width) + "x" + std::to_string(frame.height) + "  " + times + "\n");
    if (with_table) print(to_table(frame.passes));
}

nlohmann::ordered_json to_json(const DrawnFrame& frame) {
    nlohmann::ordered_json object;
    object["frame"]                 = frame.index;
    object["path"]                  = frame.path;
    object["width"]                 = frame.width;
    object["height"]                = frame.height;
    object["building_milliseconds"] = frame.building_ms;
    object["drawing_milliseconds"]  = frame.drawing_ms;
    object["passes"]                = nlohmann::ordered_json::array();
    for (const PassStatistics& pass : frame.passes) object["passes"].push_back(to_json(pass));
    return object;
}

// All that can be wrong with where files go is found before the first frame is drawn.
void check_paths(const RenderOptions& options, const std::string& output, const FrameRange& frames) {
    const bool is_sequence = frames.first != frames.last;
    if (is_sequence && !has_frame_number(output)) {
        throw std::runtime_error("-o " + output + ": needs #### for the number, since --frames asks for several");
    }
    check_image_output(numbered_path(output, frames.first));
    if (!options.passes_directory) return;
    if (is_sequence && !has_frame_number(*options.passes_directory)) {
        throw std::runtime_error("--passes " + *options.passes_directory +
                                 ": needs #### for the number, since --frames asks for several");
    }
}

}  // namespace

void render(const RenderOptions& options) {
    choose_simd_target(options.simd_target);
    const std::future<void> loading = preload_image_module();  // while the scene is built
    const FrameSource source(options.scene, options.limit);
    const FrameRange frames    = options.frames.value_or(FrameRange{});
    const bool is_sequence     = frames.first != frames.last;
    const std::string output   = options.output.value_or(source.name() + (is_sequence ? ".####.png" : ".png"));
    const bool reports_in_json = options.statistics == StatisticsFormat::Json;
    check_paths(options, output, frames);

    nlohmann::ordered_json report{{"scene", options.scene},
                                  {"profile", options.profile != nullptr ? options.profile->name : "ideal"}};
    report["frames"] = nlohmann::ordered_json::array();
    ProgressBar progress(frames.last - frames.first + 1);
    pipeline::Executor executor;
    pipeline::Execution execution;
    Frames chip_frames(source, options);
    double drawing_ms = 0.0;
    for (int index = frames.first; index <= frames.last; ++index) {
        const DrawnFrame frame = draw(chip_frames, options, index, numbered_path(output, index), executor, execution);
        write_image(frame.path, execution.output, Channels::Rgb);
        drawing_ms += frame.drawing_ms;
        progress.hide();
        if (reports_in_json) {
            report["frames"].push_back(to_json(frame));
        } else {
            print_text(frame, options.statistics == StatisticsFormat::Text);
        }
        progress.advance();
    }
    progress.hide();
    if (reports_in_json) {
        // A label may be any bytes; JSON is UTF-8.
        print(report.dump(2, ' ', false, nlohmann::json::error_handler_t::replace) + "\n");
    } else if (is_sequence) {
        char line[80];
        const int count = frames.last - frames.first + 1;
        std::snprintf(line, sizeof line, "%d frames, drawn in %.2f ms each\n", count, drawing_ms / count);
        print(line);
    }
}

}  // namespace demo
