// SPDX-License-Identifier: MIT
#include "demo/scene_file.h"

#include <catch2/catch.hpp>
#include <filesystem>
#include <fstream>
#include <string>

#include "demo/embedded_texts.h"
#include "demo/scene_build.h"
#include "pipeline/validate/validate.h"

namespace demo {
namespace {

std::string complaint(const std::string& text) {
    try {
        parse_scene(text, "dir/x.toml", "x");
    } catch (const SceneError& error) {
        return error.what();
    }
    return "";
}

// A cloud that is right but for `lines`, which start on line 3.
std::string with_cloud(const std::string& lines) {
    return "[[cloud]]\ncores = [[0, 60, 0, 18]]\n" + lines;
}

const char* const kTwoClouds = R"(
summary = "two"
[output]
size = [64, 48]
[light]
to_sun = [0, 3, 4]
[[cloud]]
name = "left"
position = [-30, 10, 0]
scale = 2
cores = [[0, 5, 0, 4], [3, 5, 0, 3.5]]
base_y = 3
blur = 0.5
[[cloud]]
name = "right"
mode = "article"
cores = [[30, 10, 0, 5]]
crown = 5
[cloud.fractal]
octaves = 2
size = 32
noise = "billow"
)";

}  // namespace

TEST_CASE("a scene file that is wrong is refused with one line that says where and why", "[demo][scene_file]") {
    struct Case {
        std::string text, line;
    };
    const Case cases[] = {
        {with_cloud("blur = -3"), "dir/x.toml:3:8: cloud.blur must be >= 0 (got -3)"},
        {with_cloud("blur = nan"), "dir/x.toml:3:8: cloud.blur must be finite (got nan)"},
        {with_cloud("blur = -inf"), "dir/x.toml:3:8: cloud.blur must be finite (got -inf)"},
        {with_cloud("blur = \"soft\""), "dir/x.toml:3:8: cloud.blur must be a number (got \"soft\")"},
        {with_cloud("opacity = 1.5"), "dir/x.toml:3:11: cloud.opacity must be <= 1 (got 1.5)"},
        {with_cloud("crown = 2.5"), "dir/x.toml:3:9: cloud.crown must be an integer (got 2.5)"},
        {with_cloud("crown = -1"), "dir/x.toml:3:9: cloud.crown must be >= 0 (got -1)"},
        {with_cloud("crown = 1999\nrim = 1"),
         "dir/x.toml:2:9: cloud.cores with crown and rim must come to at most 2000 particles (got 2001)"},
        {with_cloud("mode = \"skrit\""),
         "dir/x.toml:3:8: cloud.mode must be one of skirt, article, premultiplied, black (got \"skrit\")"},
        {with_cloud("name = 5"), "dir/x.toml:3:8: cloud.name must be a string (got 5)"},
        {with_cloud("bluur = 1"), "dir/x.toml:3:1: cloud.bluur is not a key of [[cloud]] (did you mean 'blur'?)"},
        {with_cloud("xyzzy = 1"), "dir/x.toml:3:1: cloud.xyzzy is not a key of [[cloud]]"},
        {with_cloud("position = [1, 2]"),
         "dir/x.toml:3:12: cloud.position must be an array of 3 numbers (got an array of 2)"},
        {with_cloud("position = [1, 2, inf]"), "dir/x.toml:3:19: cloud.position must be finite (got inf)"},
        {with_cloud("scale = 0"), "dir/x.toml:3:9: cloud.scale must be >= 0.001 (got 0)"},
        {with_cloud(
             "scale = 1000\nposition = [5e4, 0, 0]\ncrown = 3\n[[cloud]]\nscale = 1000\ncores = [[0, 900, 0, 1]]"),
         "dir/x.toml:8:10: cloud.cores must lie within 500 km of the origin, with a radius of 0.02 to 1e5, once placed "
         "and "
         "scaled"},
        {with_cloud("scale = 0.001"),
         "dir/x.toml:2:10: cloud.cores must lie within 500 km of the origin, with a radius of 0.02 to 1e5, once placed "
         "and "
         "scaled"},
        {with_cloud("fractal = 3"), "dir/x.toml:3:11: cloud.fractal must be a table (got 3)"},
        {with_cloud("fractal.size = 100"), "dir/x.toml:3:16: cloud.fractal.size must be a power of two"},
        {with_cloud("fractal.cycles = 0"), "dir/x.toml:3:18: cloud.fractal.cycles must be > 0 (got 0)"},
        {with_cloud("fractal.octave = 3"),
         "dir/x.toml:3:9: cloud.fractal.octave is not a key of [cloud.fractal] (did you mean 'octaves'?)"},
        {"[[cloud]]\ncores = [[0, 60, 0, -18]]",
         "dir/x.toml:2:10: cloud.cores must have radii >= 0.01, each [x, y, z, radius]"},
        {"[[cloud]]\ncores = [[0, 60, 0]]",
         "dir/x.toml:2:10: cloud.cores must be an array of 4 numbers (got an array of 3)"},
        {"[[cloud]]\ncores = []",
         "dir/x.toml:2:9: cloud.cores must hold one core or more, each [x, y, z, radius]; or cloud.generate, cloud.stream or "
         "cloud.particles stand in its place, one of them"},
        {"[[cloud]]",
         "dir/x.toml:1:1: cloud.cores must hold one core or more, each [x, y, z, radius]; or cloud.generate, cloud.stream or "
         "cloud.particles stand in its place, one of them"},
        {"cloud = 3", "dir/x.toml:1:9: cloud must be an array of tables, each [[cloud]] (got 3)"},
        {"[cloud]", "dir/x.toml:1:1: cloud must be an array of tables, each [[cloud]] (got a table)"},
        {"[output]\nsize = [0, 0]", "dir/x.toml:2:9: output.size must be >= 1 (got 0)"},
        {"[output]\nsize = [640, 9000]", "dir/x.toml:2:14: output.size must be <= 8192 (got 9000)"},
        {"[output]\nsize = 640", "dir/x.toml:2:8: output.size must be an array of 2 integers (got 640)"},
        {"output = true", "dir/x.toml:1:10: output must be a table (got true)"},
        {"[camera]\nvfov_deg = 180", "dir/x.toml:2:12: camera.vfov_deg must be <= 170 (got 180)"},
        {"[camera]\nnear = 5\nfar = 4", "dir/x.toml:3:7: camera.far must be > camera.near"},
        {"[camera]\nposition = [1, 2, 3]\ntarget = [1, 2, 3]",
         "dir/x.toml:2:12: camera.position must differ from camera.target, and not lie straight above or below it"},
        {"[camera]\nposition = [0, 50, 0]\ntarget = [0, 2, 0]",
         "dir/x.toml:2:12: camera.position must differ from camera.target, and not lie straight above or below it"},
        {"[camera.orbit]\nframes = 0", "dir/x.toml:2:10: camera.orbit.frames must be >= 1 (got 0)"},
        {"[light]\nto_sun = [0, 0, 0]", "dir/x.toml:2:10: light.to_sun must not be zero"},
        {"[sky]\nzenith = [0, 0, 2]", "dir/x.toml:2:17: sky.zenith must be <= 1 (got 2)"},
        {"[fog]\nstart = 10\nend = 10", "dir/x.toml:3:7: fog.end must be > fog.start"},
        {"[terrain]\nseed = 1", "dir/x.toml:1:1: terrain.height_map or terrain.generate must be there, and not both"},
        {"[terrain]\ngenerate = \"moon\"", "dir/x.toml:2:12: terrain.generate must be one of canyon (got \"moon\")"},
        {"[terrain]\nheight_map = \"none.png\"", "dir/x.toml:2:14: terrain.height_map names no file: \"dir/none.png\""},
        {"[terrain]\ngenerate = \"canyon\"\nwalls = \"brick.png\"",
         "dir/x.toml:3:9: terrain.walls names no file: \"dir/brick.png\""},
        {"[[solid]]\nkind = \"box\"\nfrom = [0, 0, 0]\nto = [1, 0, 1]",
         "dir/x.toml:4:6: solid.to must lie 0.001 or more from solid.from in x, y and z"},
        {"[[solid]]\nkind = \"spire\"\nfrom = [0, 0, 0]\nto = [1, 1, 9e-4]",
         "dir/x.toml:4:6: solid.to must lie 0.001 or more from solid.from in x, y and z"},
        {"[[solid]]\nkind = \"cylinder\"\nfrom = [0, 0, 0]\nto = [0, 1e-30, 0]\nradius = 1",
         "dir/x.toml:4:6: solid.to must lie 0.001 or more from solid.from in x, y or z"},
        {"[camera]\npath = [[0, 0, 9, 9, 0, 9, 0], [1e-4, 0, 9, 8, 0, 9, 0]]",
         "dir/x.toml:2:32: camera.path must have rising times, from 0 seconds on, at least 0.001 apart"},
        {"[[solid]]\nkind = \"cylinder\"\nfrom = [0, 0, 0]\nto = [0, 9, 0]\nradius = -1",
         "dir/x.toml:5:10: solid.radius must be > 0 (got -1)"},
        {"[[solid]]\nkind = \"cylinder\"\nfrom = [0, 0, 0]\nto = [0, 9, 0]", "dir/x.toml:1:1: solid.radius is missing"},
        {"[[solid]]\nkind = \"box\"\nfrom = [0, 0, 0]\nto = [1, 1, 1]\nradius = 1",
         "dir/x.toml:5:1: solid.radius is not a key of a box"},
        {"[[solid]]\nfrom = [0, 0, 0]", "dir/x.toml:1:1: solid.kind is missing: box, cylinder or spire"},
        {"[[solid]]\nkind = \"box\"\nto = [1, 1, 1]", "dir/x.toml:1:1: solid.from is missing: [x, y, z]"},
        {"[[solid]]\nkind = \"box\"\nfront = 1\nfrom = [0, 0, 0]\nto = [1, 1, 1]",
         "dir/x.toml:3:9: solid.front must be true or false (got 1)"},
        {"colour = 1\n[[clouds]]", "dir/x.toml:1:1: colour is not a key of a scene file (did you mean 'cloud'?)"},
    };
    for (const Case& wrong : cases) {
        INFO(wrong.text);
        CHECK(complaint(wrong.text) == wrong.line);
    }
}

TEST_CASE("text that is not TOML is refused with the parser's place and one line", "[demo][scene_file]") {
    for (const char* text : {"[output\nsize = [1, 2]", "a = = 1", "\xff\xfe", "blur = 1\nblur = 2", "x = \"open"}) {
        const std::string line = complaint(text);
        INFO(line);
        CHECK(line.rfind("dir/x.toml:", 0) == 0);
        CHECK(line.find('\n') == std::string::npos);
        CHECK(line.size() > std::string("dir/x.toml:1:1: ").size());
    }
}

TEST_CASE("counts have limits", "[demo][scene_file]") {
    std::string clouds;
    for (int i = 0; i <= kMaxClouds; ++i) clouds += "[[cloud]]\ncores = [[0, 0, 0, 1]]\n";
    CHECK(complaint(clouds) == "dir/x.toml:129:1: cloud may be there at most 64 times");
}

TEST_CASE("an empty file is a scene with a sky alone", "[demo][scene_file]") {
    const SceneDescription scene = parse_scene("", "x.toml", "x");
    CHECK(scene.name == "x");
    CHECK(scene.size.width == 1280);
    CHECK(scene.size.height == 720);
    CHECK_FALSE(scene.terrain);
    CHECK(scene.clouds.empty());
    const pipeline::Frame frame = scene_frame(build_scene(scene), {16, 9}, 0);
    CHECK(pipeline::validate(frame).empty());
    CHECK(frame.passes.size() == 1);
}

TEST_CASE("what a file says arrives, and the rest has its default", "[demo][scene_file]") {
    const SceneDescription about = parse_scene(kTwoClouds, "x.toml", "x");
    CHECK(about.summary == "two");
    CHECK(about.light.to_sun.y == Approx(0.6f));
    CHECK(about.light.to_sun.z == Approx(0.8f));
    CHECK(about.camera.vfov_deg == 45.0);
    REQUIRE(about.clouds.size() == 2);
    CHECK(about.clouds[0].settings.mode == cloud::Mode::Skirt);
    CHECK(about.clouds[0].cores.size() == 2);
    CHECK(about.clouds[1].settings.mode == cloud::Mode::Article);
    CHECK(about.clouds[1].settings.fractal.octaves == 2);
    CHECK(about.clouds[1].settings.fractal.face_size == 32);
    CHECK(about.clouds[1].settings.fractal.noise == cloud::Noise::Billow);
    CHECK(about.clouds[1].settings.blur_m == cloud::Cloud{}.blur_m);
}

TEST_CASE("position and scale place a cloud's particles, base and blur", "[demo][scene_file]") {
    const Scene scene = build_scene(parse_scene(kTwoClouds, "x.toml", "x"));
    REQUIRE(scene.clouds.size() == 2);
    const cloud::Cloud& left = scene.clouds[0].baked.cloud;
    REQUIRE(left.particles.size() == 2);
    CHECK(left.particles[0].center == Vec3(-30.0f, 20.0f, 0.0f));
    CHECK(left.particles[0].radius == 8.0f);
    CHECK(left.base_y == 16.0f);
    CHECK(left.blur_m == 1.0f);
    CHECK(scene.clouds[1].baked.cloud.particles.size() > 1);
    CHECK(pipeline::validate(scene_frame(scene, {64, 48}, 0)).empty());
}

TEST_CASE("every built-in scene parses, has a summary, and no two share a name", "[demo][scene_file]") {
    REQUIRE_FALSE(embedded_scenes().empty());
    for (const EmbeddedText& scene : embedded_scenes()) {
        INFO(scene.name);
        const SceneDescription about = parse_scene(scene.text, std::string(scene.name), std::string(scene.name));
        CHECK_FALSE(about.summary.empty());
    }
    const auto infos = built_in_scenes();
    for (std::size_t i = 1; i < infos.size(); ++i) CHECK(infos[i - 1].name < infos[i].name);
}

TEST_CASE("a scene that is neither built in nor a file is named", "[demo][scene_file]") {
    CHECK_THROWS_WITH(load_scene("no/such.toml"),
                      Catch::StartsWith("no/such.toml: no such file, and no built-in scene (there is blast, canyon"));
    CHECK_THROWS_WITH(load_scene("/"), "/: is not a file");
}

TEST_CASE("files are found beside the scene file", "[demo][scene_file]") {
    namespace fs       = std::filesystem;
    const fs::path dir = fs::temp_directory_path() / "nimbus7_scene_file_test";
    fs::create_directories(dir / "maps");
    std::ofstream(dir / "maps" / "height.png") << "not read here";
    std::ofstream(dir / "x.toml") << "[terrain]\nheight_map = \"maps/height.png\"\n";
    const SceneDescription about = read_scene_file((dir / "x.toml").string());
    REQUIRE(about.terrain);
    REQUIRE(about.terrain->height_map);
    CHECK(fs::path(about.terrain->height_map->path) == dir / "maps" / "height.png");
    CHECK(about.terrain->height_map->named_at == (dir / "x.toml").string() + ":2:14: terrain.height_map");
    fs::remove_all(dir);
}

}  // namespace demo
