// SPDX-License-Identifier: MIT
#include "demo/command_tradeoff.h"

#include <filesystem>
#include <future>
#include <stdexcept>

#include "demo/image_file.h"
#include "demo/new_directory.h"
#include "demo/standard_output.h"
#include "demo/tradeoff/page.h"
#include "demo/tradeoff/report.h"
#include "demo/tradeoff/truth_picture.h"

namespace demo {
namespace {

// Smaller ones have no place for a window of SSIM, nor for a cloud's rim.
constexpr int kLeastSize           = 64;
// 1920x1080 fits; the truth holds half a kilobyte for each pixel of each target.
constexpr std::int64_t kMostPixels = std::int64_t{1} << 21;
constexpr int kChartScale          = 2;

const std::vector<std::string> kFiles{"tradeoff.csv", "tradeoff.svg", "tradeoff.png", "index.html"};

std::string scene_name(const TradeoffOptions& options) {
    return std::filesystem::path(options.scene).stem().string();
}

std::string heading(const TradeoffOptions& options) {
    const SweepOptions& sweep = options.sweep;
    return scene_name(options) + ", frame " + std::to_string(sweep.frame) + ", " + std::to_string(sweep.size.width) +
           "x" + std::to_string(sweep.size.height);
}

}  // namespace

void report_tradeoff(const TradeoffOptions& options) {
    const SweepOptions& wanted = options.sweep;
    if (!options.directory && !options.prints_table) throw std::runtime_error("tradeoff: needs -o DIR or --table");
    const auto pixels = static_cast<std::int64_t>(wanted.size.width) * wanted.size.height;
    if (wanted.size.width < kLeastSize || wanted.size.height < kLeastSize || pixels > kMostPixels)
        throw std::runtime_error("--size: a trade-off needs at least " + std::to_string(kLeastSize) +
                                 " pixels each way, and at most " + std::to_string(kMostPixels) + " in all");
    const std::future<void> loading = preload_image_module();
    if (options.directory) check_new_directory(*options.directory, kFiles);
    const ScenePtr scene = load_scene(options.scene);
    const Sweep result   = sweep(*scene, wanted, knobs(), &truth_picture);
    if (options.prints_table) print(to_markdown(result, scene_name(options)));
    if (!options.directory) return;
    const Drawing chart = to_chart(result, heading(options));
    write_directory(*options.directory,
                    {{kFiles[0], to_csv(result)},
                     {kFiles[1], to_svg(chart)},
                     {kFiles[2], encode_image(kFiles[2], to_image(chart, kChartScale), Channels::Rgb)},
                     {kFiles[3], to_page(result, heading(options))}});
    if (!options.prints_table) print(*options.directory + "\n");
}

}  // namespace demo
