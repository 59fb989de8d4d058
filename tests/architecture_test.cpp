// SPDX-License-Identifier: MIT
// The layers hold: read from the sources themselves. The made-up sources show that each rule does find what it is for.
#include <catch2/catch.hpp>

#include "tests/support/include_rules.h"

namespace {

using tests::include_faults;
using tests::Sources;
using Faults = std::vector<std::string>;

std::string quoted(const std::string& path) {
    return "#include \"" + path + "\"\n";
}
std::string angled(const std::string& path) {
    return "#include <" + path + ">\n";
}

}  // namespace

TEST_CASE("the sources keep to their layers", "[architecture]") {
    const Sources sources = tests::read_sources(NIMBUS7_SOURCE_DIR);
    // Were the reader to find nothing, everything would pass.
    CHECK(sources.size() > 50);
    for (const char* file : {"raster/tile.h", "pipeline/frame/frame.h", "cloud/cloud.h", "demo/scene.h"}) {
        CHECK(sources.count(file) == 1);
    }
    CHECK(include_faults(sources) == Faults{});
}

TEST_CASE("allowed includes are no faults", "[architecture]") {
    const Sources sources = {
        {"raster/tile.h", "#pragma once\n" + angled("algorithm")},
        {"raster/lanes-inl.h", quoted("hwy/highway.h")},
        {"raster/fill.cpp", quoted("raster/tile.h") + angled("hwy/highway.h") + quoted("raster/lanes-inl.h")},
        {"pipeline/frame/frame.h", angled("glm/vec3.hpp")},
        {"pipeline/execute/execute.h", quoted("pipeline/frame/frame.h")},
        {"pipeline/execute/execute.cpp", quoted("pipeline/execute/execute.h") + "  # include \"raster/tile.h\"\n"},
        {"pipeline/validate/validate.cpp", quoted("pipeline/frame/frame.h")},
        {"cloud/cloud.h", quoted("pipeline/frame/frame.h") + angled("glm/vec3.hpp") + angled("vector")},
        {"demo/image_module.cpp", angled("OpenImageIO/imageio.h")},
        {"demo/main.cpp", quoted("cloud/cloud.h") + quoted("pipeline/execute/execute.h") + angled("CLI/CLI.hpp")},
        {"tests/raster/tile_test.cpp", quoted("raster/tile.h") + "// #include \"nowhere.h\"\n"},
    };
    CHECK(include_faults(sources) == Faults{});
}

TEST_CASE("each forbidden include is found", "[architecture]") {
    struct Case {
        std::string from, text, to;
    };
    const Case forbidden = GENERATE(
        // A layer includes what stands above it.
        Case{"raster/a.cpp", quoted("pipeline/frame/frame.h"), "pipeline/frame/frame.h"},
        Case{"raster/a.h", quoted("demo/scene.h"), "demo/scene.h"},
        Case{"pipeline/execute/a.cpp", quoted("cloud/cloud.h"), "cloud/cloud.h"},
        Case{"pipeline/validate/a.cpp", quoted("demo/scene.h"), "demo/scene.h"},
        Case{"cloud/a.cpp", quoted("demo/scene.h"), "demo/scene.h"},
        // It is below, but not open to this layer.
        Case{"pipeline/frame/a.cpp", quoted("pipeline/execute/execute.h"), "pipeline/execute/execute.h"},
        Case{"pipeline/frame/a.cpp", quoted("raster/tile.h"), "raster/tile.h"},
        Case{"pipeline/validate/a.cpp", quoted("raster/tile.h"), "raster/tile.h"},
        Case{"pipeline/truth/a.cpp", quoted("raster/tile.h"), "raster/tile.h"},
        Case{"pipeline/truth/a.cpp", quoted("pipeline/execute/execute.h"), "pipeline/execute/execute.h"},
        Case{"cloud/a.cpp", quoted("pipeline/execute/execute.h"), "pipeline/execute/execute.h"},
        Case{"cloud/deep/er/a.cpp", quoted("raster/tile.h"), "raster/tile.h"},
        Case{"demo/a.cpp", quoted("raster/tile.h"), "raster/tile.h"},
        // The product includes its tests.
        Case{"demo/a.cpp", quoted("tests/support/help.h"), "tests/support/help.h"},
        // Libraries where they do not belong.
        Case{"demo/image_file.cpp", angled("OpenImageIO/imageio.h"), "OpenImageIO/imageio.h"},
        Case{"tests/demo/a.cpp", angled("OpenImageIO/imageio.h"), "OpenImageIO/imageio.h"},
        Case{"raster/a.h", angled("hwy/highway.h"), "hwy/highway.h"},
        Case{"raster/a.h", quoted("hwy/highway.h"), "hwy/highway.h"},
        Case{"cloud/a.cpp", angled("tbb/parallel_for.h"), "tbb/parallel_for.h"},
        Case{"cloud/a.cpp", quoted("hwy/highway.h"), "hwy/highway.h"},
        // Not there, or not by its path from the top, or in angles.
        Case{"raster/a.cpp", quoted("raster/none.h"), "raster/none.h"},
        Case{"raster/a.cpp", quoted("tile.h"), "tile.h"},
        Case{"demo/a.cpp", quoted("../cloud/cloud.h"), "../cloud/cloud.h"},
        Case{"raster/a.cpp", angled("raster/tile.h"), "raster/tile.h"});
    INFO(forbidden.from << " includes " << forbidden.to);
    Sources sources = {{"raster/tile.h", ""}, {"pipeline/frame/frame.h", ""}, {"pipeline/execute/execute.h", ""},
                       {"cloud/cloud.h", ""}, {"demo/scene.h", ""},           {"tests/support/help.h", ""}};
    REQUIRE(include_faults(sources) == Faults{});
    sources[forbidden.from] = "#pragma once\n\n" + forbidden.text;
    const Faults faults     = include_faults(sources);
    REQUIRE(faults.size() == 1);
    CHECK_THAT(faults[0], Catch::StartsWith(forbidden.from + " includes " + forbidden.to + ": "));
}

TEST_CASE("include cycles are found", "[architecture]") {
    CHECK(include_faults({{"raster/a.h", quoted("raster/a.h")}}) == Faults{"include cycle: raster/a.h -> raster/a.h"});
    // The way into the cycle is no part of it; a file that two others share makes none.
    const Sources sources = {{"raster/a.h", quoted("raster/b.h") + quoted("raster/d.h")},
                             {"raster/b.h", quoted("raster/c.h") + quoted("raster/d.h")},
                             {"raster/c.h", quoted("raster/b.h")},
                             {"raster/d.h", ""}};
    CHECK(include_faults(sources) == Faults{"include cycle: raster/b.h -> raster/c.h -> raster/b.h"});
}
