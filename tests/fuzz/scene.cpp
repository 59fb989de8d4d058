// SPDX-License-Identifier: MIT
// A scene file's text, any bytes: a scene, or one line that begins with the file. Of what is a scene, as much as is soon
// built (soon_built.h) is built, and frames of it are valid, whatever its numbers; small ones are drawn in all ways.
// Inputs are changed as texts, and where they have a number, also by another that is out of the ordinary.
#include "demo/scene_file.h"

#include <algorithm>
#include <cctype>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <iterator>
#include <string>
#include <vector>

#include "demo/scene_build.h"
#include "pipeline/validate/validate.h"
#include "pipeline/validate/work.h"
#include "tests/fuzz/agreement.h"
#include "tests/fuzz/fuzz.h"
#include "tests/fuzz/soon_built.h"
#include "tests/support/random.h"

extern "C" std::size_t LLVMFuzzerMutate(std::uint8_t* data, std::size_t size, std::size_t max_size);

namespace {

// The ends of what keys may be, and of what numbers can be.
constexpr const char* kNumbers[] = {
    "0",    "-0.0", "5e-324", "1e-45", "1.2e-38", "1e-9", "1e-6",  "0.001", "0.01", "0.02", "0.05", "0.25",   "0.5",
    "0.99", "1",    "1.0001", "2",     "3",       "12",   "20",    "64",    "100",  "360",  "1000", "8192",   "1e4",
    "1e5",  "1e6",  "1e9",    "1e18",  "3.4e38",  "1e39", "1e300", "inf",   "nan",  "1024", "2000", "999999", "0.3333",
};

// Of what is drawn: the rectangles around triangles, which are mostly much larger.
constexpr std::uint64_t kMostPixels = 1 << 16;

struct Span {
    std::size_t begin, end;
};

std::vector<Span> numbers_in(std::string_view text) {
    const auto is_digit = [](char c) { return c >= '0' && c <= '9'; };
    const auto goes_on  = [&](char c) {
        return is_digit(c) || std::strchr("+-.e_", c) != nullptr || (c >= 'a' && c <= 'f') || c == 'n' || c == 'i';
    };
    std::vector<Span> spans;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const bool starts = is_digit(text[i]) || (text[i] == '-' && i + 1 < text.size() && is_digit(text[i + 1]));
        const bool in_word =
            i > 0 && (std::isalnum(static_cast<unsigned char>(text[i - 1])) != 0 || text[i - 1] == '_');
        if (!starts || in_word) continue;
        std::size_t end = i + 1;
        while (end < text.size() && text[end] != '\0' && goes_on(text[end])) ++end;
        spans.push_back({i, end});
        i = end;
    }
    return spans;
}

std::string other_number(std::string_view number, test_support::Random& random) {
    if (random.chance(30)) {
        char text[32];
        const double value = std::strtod(std::string(number).c_str(), nullptr);
        std::snprintf(text, sizeof text, "%.9g", value * random.one_of({-1.0, 0.1, 0.5, 1.0001, 2.0, 10.0, 1000.0}));
        return text;
    }
    const std::string chosen = kNumbers[random.below(std::size(kNumbers))];
    return random.chance(30) && chosen[0] != '-' ? "-" + chosen : chosen;
}

// Two frames of the scene, at its own size and at a small one.
void build(const demo::SceneDescription& description, std::uint32_t seed) {
    test_support::Random random(seed);
    const demo::Scene scene = demo::build_scene(description);
    demo::FrameOptions options;
    options.precision                   = random.one_of({demo::Precision::Exact, demo::Precision::Fast});
    options.mega_particles.target_scale = random.one_of({1, 1, 2, 4});
    options.technique                   = random.one_of({demo::Technique::MegaParticles, demo::Technique::MegaParticles,
                                                         demo::Technique::MegaParticles, demo::Technique::Sprites});
    const demo::Size small{random.from(1, 40), random.from(1, 30)};
    for (const int index : {0, random.from(0, description.frames - 1)}) {
        const pipeline::Frame frame = scene_frame(scene, index == 0 ? small : description.size, index, options);
        const std::vector<pipeline::Finding> findings = validate(frame);
        fuzz::require(findings.empty(), findings.empty() ? "" : findings[0].where + " " + findings[0].what);
        if (index == 0 && work_of(frame).pixels <= kMostPixels) fuzz::require_agreement(frame, seed);
    }
}

}  // namespace

extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size, std::size_t max_size,
                                               unsigned int seed) {
    test_support::Random random(seed);
    std::string text(fuzz::as_text(data, size));
    if (!random.chance(70) || numbers_in(text).empty()) return LLVMFuzzerMutate(data, size, max_size);
    for (int i = random.from(1, 3); i > 0; --i) {
        const std::vector<Span> numbers = numbers_in(text);
        if (numbers.empty()) break;
        const Span at = numbers[random.below(numbers.size())];
        text.replace(at.begin, at.end - at.begin, other_number(text.substr(at.begin, at.end - at.begin), random));
    }
    if (text.size() > max_size) return LLVMFuzzerMutate(data, size, max_size);
    std::copy(text.begin(), text.end(), data);
    return text.size();
}

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    try {
        const demo::SceneDescription scene = demo::parse_scene(fuzz::as_text(data, size), "a/b.toml", "a/b.toml");
        fuzz::require(scene.size.width >= 1 && scene.size.width <= demo::kMaxOutputSize, "a width out of range");
        fuzz::require(scene.clouds.size() <= demo::kMaxClouds, "too many clouds");
        build(fuzz::soon_built(scene), static_cast<std::uint32_t>(size));
    } catch (const demo::SceneError& error) {
        fuzz::require(std::string_view(error.what()).starts_with("a/b.toml:"), error.what());
        fuzz::require_complaint(error.what());
    }
    return 0;
}
