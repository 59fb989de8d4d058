// SPDX-License-Identifier: MIT
#include "demo/arguments.h"

#include <charconv>
#include <optional>
#include <stdexcept>
#include <string_view>

#include "pipeline/frame/frame.h"

namespace demo {
namespace {

// Digits alone: no sign, no space, no fraction.
std::optional<int> whole_number(std::string_view text, int low, int high) {
    int value                = 0;
    const auto [end, status] = std::from_chars(text.data(), text.data() + text.size(), value);
    const bool is_number     = status == std::errc() && end == text.data() + text.size() && text.front() != '-';
    return is_number && value >= low && value <= high ? std::optional(value) : std::nullopt;
}

[[noreturn]] void fail(const std::string& option, const std::string& text, const std::string& reason) {
    throw std::runtime_error(option + " " + text + ": " + reason);
}

struct Run {
    std::size_t first, length;
};
Run last_run_of_hashes(const std::string& path) {
    const std::size_t slash = path.rfind('/');
    const std::size_t name  = slash == std::string::npos ? 0 : slash + 1;
    const std::size_t last  = path.rfind('#');
    if (last == std::string::npos || last < name) return {path.size(), 0};
    std::size_t first = last;
    while (first > name && path[first - 1] == '#') --first;
    return {first, last - first + 1};
}

}  // namespace

Size parse_size(const std::string& text) {
    const std::size_t x = text.find('x');
    if (x != std::string::npos) {
        const auto width  = whole_number(std::string_view(text).substr(0, x), 1, pipeline::kMaxTargetSize);
        const auto height = whole_number(std::string_view(text).substr(x + 1), 1, pipeline::kMaxTargetSize);
        if (width && height) return {*width, *height};
    }
    fail("--size", text,
         "expected WIDTHxHEIGHT, each a whole number from 1 to " + std::to_string(pipeline::kMaxTargetSize));
}

FrameRange parse_frames(const std::string& text) {
    const std::size_t dash = text.find('-');
    const auto first       = whole_number(std::string_view(text).substr(0, dash), 0, kMaxFrameNumber);
    const auto last =
        dash == std::string::npos ? first : whole_number(std::string_view(text).substr(dash + 1), 0, kMaxFrameNumber);
    if (!first || !last) {
        fail("--frames", text, "expected FIRST-LAST, each a whole number from 0 to " + std::to_string(kMaxFrameNumber));
    }
    if (*first > *last) fail("--frames", text, "the first frame comes after the last");
    return {*first, *last};
}

int parse_number(const std::string& option, const std::string& text, int low, int high) {
    if (const auto number = whole_number(text, low, high)) return *number;
    fail(option, text, "expected a whole number from " + std::to_string(low) + " to " + std::to_string(high));
}

bool has_frame_number(const std::string& pattern) {
    return last_run_of_hashes(pattern).length > 0;
}

std::string numbered_path(const std::string& pattern, int number) {
    const Run run = last_run_of_hashes(pattern);
    if (run.length == 0) return pattern;
    std::string digits = std::to_string(number);
    if (digits.size() < run.length) digits.insert(0, run.length - digits.size(), '0');
    return std::string(pattern).replace(run.first, run.length, digits);
}

}  // namespace demo
