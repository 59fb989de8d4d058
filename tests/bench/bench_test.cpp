// SPDX-License-Identifier: MIT
// The frames that are timed do the work that the figures say, and the reports show the figures.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <filesystem>
#include <regex>

#include "pipeline/execute/execute.h"
#include "pipeline/validate/validate.h"
#include "tests/bench/figures.h"
#include "tests/bench/frames.h"
#include "tests/bench/options.h"
#include "tests/bench/plot.h"
#include "tests/bench/table.h"
#include "tests/support/child_process.h"

namespace {

using namespace bench;

std::string run_text(const std::string& name, double ms, const std::string& more = "") {
    return R"({"name": ")" + name + R"(", "run_name": ")" + name + R"(", "run_type": "iteration", "real_time": )" +
           std::to_string(ms) + R"(, "time_unit": "ms")" + more + "},\n";
}

// Three repetitions out of order, a peer on one thread, a peer that is missing, aggregates, and a growth series.
std::string sample_json() {
    std::string runs = run_text("frame/a/nimbus7/threads:1", 30.0) + run_text("frame/a/nimbus7/threads:1", 10.0) +
                       run_text("frame/a/nimbus7/threads:1", 20.0);
    runs += R"({"run_name": "frame/a/nimbus7/threads:1", "run_type": "aggregate", "aggregate_name": "median",
               "real_time": 99.0, "time_unit": "ms"},
               {"run_name": "frame/a/nimbus7/threads:1", "run_type": "aggregate", "aggregate_name": "mean",
               "real_time": 98.0, "time_unit": "ms"},)";
    runs += run_text("frame/a/llvmpipe/threads:1", 90.0) + run_text("frame/a/llvmpipe/threads:2", 45.0);
    runs += run_text("fill/b/nimbus7", 4.0, R"(, "pixels_per_second": 2.5e9)");
    runs += run_text("fill/b/llvmpipe", 10.0, R"(, "pixels_per_second": 1e9)");
    runs += run_text("fill/b/absent", 0.0, R"(, "error_occurred": true, "error_message": "not built")");
    runs += run_text("blend/c/nimbus7/threads:2", 2.0, R"(, "pixels_per_second": 1.25e8)");
    runs += run_text("blend/c/pixman", 1.0, R"(, "pixels_per_second": 2.5e8)");
    for (const int size : {4, 1, 2})
        runs += run_text("growth/spheres/" + std::to_string(size), 5.0 * size * size,
                         R"(, "size": )" + std::to_string(size));
    runs.erase(runs.rfind(','));
    return R"({"context": {}, "benchmarks": [)" + runs + "]}";
}

std::vector<double> numbers(const std::string& text, const std::string& pattern) {
    std::vector<double> found;
    const std::regex regex(pattern);
    for (std::sregex_iterator at(text.begin(), text.end(), regex), end; at != end; ++at)
        found.push_back(std::stod((*at)[1]));
    return found;
}

}  // namespace

TEST_CASE("each layer of a fill frame writes every pixel", "[bench]") {
    for (const FrameCase& fill : fill_cases()) {
        INFO(fill.name);
        const pipeline::Frame frame = fill.build();
        REQUIRE(pipeline::validate(frame).empty());
        CHECK(frame.passes[0].draws.size() == kFillLayers);
        const pipeline::PassCounts counts = pipeline::execute(frame).counts.at(0);
        CHECK(counts.color_written == std::uint64_t{kFillWidth} * kFillHeight * kFillLayers);
        CHECK(static_cast<double>(counts.color_written) == fill.work);
    }
}

TEST_CASE("the other frames that are timed are valid and have the triangles that are counted", "[bench]") {
    for (const FrameCase& each : frame_cases()) {
        // Scenes give valid frames, which is tested elsewhere; the larger clouds are built as the smaller ones are.
        const bool is_scene = each.name.starts_with("frame/") || each.name.starts_with("growth/canyon/");
        if (is_scene || each.name.starts_with("fill/") || each.size > 100.0) continue;
        INFO(each.name);
        const pipeline::Frame frame = each.build();
        CHECK(pipeline::validate(frame).empty());
        if (each.unit != "triangles") continue;
        const pipeline::PassCounts counts = pipeline::execute(frame).counts.at(0);
        CHECK(static_cast<double>(counts.triangles_in) == each.work);
        CHECK(counts.triangles_drawn > counts.triangles_in / 3);
    }
    CHECK_THROWS_AS(find_frame_case("fill/none"), std::invalid_argument);
}

TEST_CASE("the terrain covers the whole target", "[bench]") {
    const pipeline::Frame frame      = find_frame_case("triangles/terrain_32k").build();
    const pipeline::ColorImage image = pipeline::execute(frame).output;
    CHECK(std::count(image.pixels.begin(), image.pixels.end(), frame.passes[0].clear.color->value) == 0);
}

TEST_CASE("figures are the medians of what ran", "[bench]") {
    const std::vector<Figure> figures = read_figures(sample_json());
    REQUIRE(figures.size() == 10);
    CHECK(figures[0].name == "frame/a/nimbus7/threads:1");
    CHECK(figures[0].seconds == Approx(0.020));
    CHECK(figures[3].unit == "pixels");
    CHECK(figures[3].rate == 2.5e9);
    CHECK_THROWS_AS(read_figures("{}"), std::runtime_error);
    CHECK_THROWS_AS(read_figures("no JSON"), std::runtime_error);
}

TEST_CASE("of aggregates alone the median is taken", "[bench]") {
    const std::vector<Figure> figures = read_figures(R"({"benchmarks": [
        {"run_name": "a", "run_type": "aggregate", "aggregate_name": "mean", "real_time": 3, "time_unit": "us"},
        {"run_name": "a", "run_type": "aggregate", "aggregate_name": "median", "real_time": 2, "time_unit": "us"}]})");
    REQUIRE(figures.size() == 1);
    CHECK(figures[0].seconds == Approx(2e-6));
}

TEST_CASE("the table sets ours beside each peer's", "[bench]") {
    CHECK(to_table(read_figures(sample_json())) == R"(| case | nimbus7 | peer | times as fast |
| --- | ---: | ---: | ---: |
| frame/a, 1 thread | 20.0 ms | llvmpipe 90.0 ms | 4.50 |
| fill/b | 2.5 Gpixel/s | llvmpipe 1 Gpixel/s | 2.50 |
| blend/c, 2 threads | 125 Mpixel/s | pixman 250 Mpixel/s | 0.50 |

| case | time | rate |
| --- | ---: | ---: |
| frame/a/llvmpipe/threads:2 | 45.0 ms |  |
| growth/spheres/4 | 80.0 ms |  |
| growth/spheres/1 | 5.00 ms |  |
| growth/spheres/2 | 20.0 ms |  |
)");
    CHECK(format_time(0.9999) == "1.00 s");
    CHECK(format_time(123e-6) == "123 µs");
}

TEST_CASE("the plot is logarithmic on both axes", "[bench]") {
    const std::string svg       = to_plot(read_figures(sample_json()));
    // Sizes 1, 2, 4 at 5, 20, 80 ms: equal steps to the right, and up.
    const std::vector<double> x = numbers(svg, "cx=\"([0-9.]+)\""), y = numbers(svg, "cy=\"([0-9.]+)\"");
    REQUIRE(x.size() == 3);
    REQUIRE(y.size() == 3);
    CHECK(x[1] - x[0] == Approx(x[2] - x[1]).margin(0.11));
    CHECK(y[1] - y[0] == Approx(y[2] - y[1]).margin(0.11));
    CHECK(x[0] < x[1]);
    CHECK(y[0] > y[1]);
    for (const char* text : {">5.00 ms<", ">20.0 ms<", ">80.0 ms<", ">one cloud: spheres<", "</svg>"})
        CHECK_THAT(svg, Catch::Contains(text));
    CHECK_THROWS_AS(to_plot({}), std::runtime_error);
}

TEST_CASE("the bench's own options are taken out of Google Benchmark's", "[bench]") {
    const Options options =
        parse_options({"--threads", "2", "--json", "a.json", "--benchmark_filter=fill", "--simd", "AVX2"});
    CHECK(options.threads == 2);
    CHECK(options.json == "a.json");
    CHECK(options.simd == "AVX2");
    CHECK(options.benchmark_arguments == std::vector<std::string>{"--benchmark_filter=fill"});
    CHECK_FALSE(options.prints_table);
    CHECK(parse_options({"--from", "a.json"}).prints_table);
    CHECK_THROWS_AS(parse_options({"--json"}), std::runtime_error);
    CHECK_THROWS_AS(parse_options({"--threads", "0"}), std::runtime_error);
    CHECK_THROWS_AS(parse_options({"fill"}), std::runtime_error);
}

TEST_CASE("nimbus7 bench says so if the bench was not built", "[bench][cli]") {
    const tests::ScratchDirectory directory;
    std::filesystem::copy_file(NIMBUS7_PROGRAM, directory / "nimbus7");
    const tests::Ended ended = tests::run_program(directory / "nimbus7", {"bench", "--help"}, directory.path());
    CHECK(ended.status == 2);
    CHECK(ended.out == "");
    CHECK_THAT(ended.error, Catch::StartsWith("nimbus7: bench: there is no "));
    CHECK(std::count(ended.error.begin(), ended.error.end(), '\n') == 1);
}
