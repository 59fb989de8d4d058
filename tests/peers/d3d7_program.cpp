// SPDX-License-Identifier: MIT
#include "tests/peers/d3d7_program.h"

#include <unistd.h>

#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <sstream>
#include <stdexcept>

#include "pipeline/emit/emit_dx7.h"

namespace peers {

using namespace pipeline;
namespace fs = std::filesystem;

namespace {

constexpr const char* kCompiler = "x86_64-w64-mingw32-g++";

bool is_in_path(const std::string& program) {
    const char* path = std::getenv("PATH");
    std::istringstream folders(path == nullptr ? "" : path);
    for (std::string folder; std::getline(folders, folder, ':');)
        if (access((fs::path(folder) / program).c_str(), X_OK) == 0) return true;
    return false;
}

std::uint32_t word_at(const std::string& bytes, std::size_t place) {
    std::uint32_t word = 0;
    if (place + 4 > bytes.size()) throw std::runtime_error("a picture is cut short");
    std::memcpy(&word, bytes.data() + place, 4);
    return word;
}

// As the program writes them: 32 bits, rows from the bottom.
ColorImage read_bmp(const std::string& path) {
    const std::string bytes = tests::read_file(path);
    const std::size_t first = word_at(bytes, 10);
    ColorImage image{
        .width = static_cast<int>(word_at(bytes, 18)), .height = static_cast<int>(word_at(bytes, 22)), .pixels = {}};
    for (int y = image.height - 1; y >= 0; --y)
        for (int x = 0; x < image.width; ++x)
            image.pixels.push_back(word_at(bytes, first + static_cast<std::size_t>(4 * (y * image.width + x))));
    return image;
}

}  // namespace

std::vector<std::string> missing_d3d7_tools() {
    std::vector<std::string> missing;
    for (const char* program : {kCompiler, "wine", "xvfb-run"})
        if (!is_in_path(program)) missing.emplace_back(program);
    return missing;
}

D3d7Runner::D3d7Runner() {
    const char* prefix = std::getenv("WINEPREFIX");
    owns_prefix_       = prefix == nullptr;
    prefix_            = owns_prefix_ ? scratch_ / "wine" : prefix;
}

// Wine's server stays for a while, and writes into the prefix when it ends.
D3d7Runner::~D3d7Runner() {
    if (owns_prefix_ && fs::exists(prefix_)) call({"wineserver", "-k"}), call({"wineserver", "-w"});
}

tests::Ended D3d7Runner::call(const std::vector<std::string>& words) const {
    // No .NET and no browser are asked for.
    std::vector<std::string> arguments{"WINEPREFIX=" + prefix_, "WINEDEBUG=-all",
                                       "WINEDLLOVERRIDES=mscoree,mshtml=", "LIBGL_ALWAYS_SOFTWARE=1"};
    arguments.insert(arguments.end(), words.begin(), words.end());
    return tests::run_program("/usr/bin/env", arguments, scratch_.path());
}

bool D3d7Runner::can_run() const {
    return call({"xvfb-run", "-a", "wine", "cmd", "/c", "exit 0"}).status == 0;
}

std::vector<ColorImage> D3d7Runner::run(const LegalFrame& legal) {
    const Emitted emitted = emit_dx7(legal, "frame.bin");
    tests::write_file(scratch_ / "frame.cpp", emitted.text);
    tests::write_file(scratch_ / "frame.bin", std::string(emitted.data.begin(), emitted.data.end()));
    const tests::Ended built = call({kCompiler, "frame.cpp", "-o", "frame.exe", "-lddraw", "-ldxguid", "-static"});
    if (built.status != 0) throw std::runtime_error("the program was not built: " + built.error);
    const tests::Ended ran = call({"xvfb-run", "-a", "wine", "frame.exe", "frame.bmp", "pass"});
    if (ran.status != 0) throw std::runtime_error("the program failed: " + ran.out + ran.error);
    std::vector<ColorImage> pictures;
    for (std::size_t i = 0; i < legal.frame.passes.size(); ++i) {
        const std::string path = scratch_ / ("pass" + std::to_string(i) + ".bmp");
        const bool has_color   = legal.frame.passes[i].color && fs::exists(path);
        pictures.push_back(has_color ? read_bmp(path) : ColorImage{});
        fs::remove(path);
    }
    return pictures;
}

}  // namespace peers
