// SPDX-License-Identifier: MIT
#include "pipeline/frame/text_reader.h"

namespace pipeline {

void TextReader::read_first_line() {
    constexpr int kVersion  = 1;
    const std::size_t start = scan_.position();
    if (scan_.word() != "nimbus7" || scan_.word() != "frame") {
        scan_.fail_at(start, "a frame's text starts with 'nimbus7 frame 1'");
    }
    const std::size_t number = scan_.position();
    const int version        = scan_.integer(0, std::numeric_limits<int>::max());
    if (version != kVersion) {
        scan_.fail_at(number, "unknown version " + std::to_string(version) +
                                  " of the text; this program reads version " + std::to_string(kVersion));
    }
}

void TextReader::read_top_level(Frame& frame) {
    std::uint32_t given = 0;
    while (!scan_.at_end()) read_field(frame, given);
    const FrameNames names(frame);
    resolve(frame, names);
}

void TextReader::read_value(Mat4& value) {
    scan_.expect('(', "'(' before four rows");
    for (int row = 0; row < 4; ++row) {
        Vec4 numbers;
        read_value(numbers);
        for (int column = 0; column < 4; ++column) value[column][row] = numbers[column];
    }
    scan_.expect(')', "')' after four rows");
}

void TextReader::read_reference() {
    Reference reference{.position = scan_.position(), .name = {}, .index = 0};
    if (scan_.take('#')) {
        reference.index =
            scan_.integer(std::numeric_limits<std::int32_t>::min(), std::numeric_limits<std::int32_t>::max());
    } else if (scan_.peek() == '"') {
        reference.name = scan_.quoted();
        if (reference.name.empty()) scan_.fail_at(reference.position, "an empty name refers to nothing; write none");
    } else {
        scan_.fail("expected \"a name\", #number or none, got " + scan_.what_follows());
    }
    references_.push_back(std::move(reference));
}

std::int32_t TextReader::index_by_name(const Reference& reference, const NamedList& list) const {
    const auto found        = list.indices.find(reference.name);
    const std::string field = std::string(list.field);
    if (found == list.indices.end()) {
        std::string reason               = "nothing in " + field + " is named \"" + shorten(reference.name) + "\"";
        constexpr std::size_t kMostShown = 8;
        if (list.indices.size() <= kMostShown) {
            bool first = true;
            for (const std::string_view name : list.names) {
                if (name.empty()) continue;
                reason += first ? "; there are \"" : ", \"";
                reason += shorten(name) + "\"";
                first = false;
            }
        }
        scan_.fail_at(reference.position, reason);
    }
    if (found->second.size() > 1) {
        scan_.fail_at(reference.position, std::to_string(found->second.size()) + " of " + field + " are named \"" +
                                              shorten(reference.name) + "\"; write #" +
                                              std::to_string(found->second.front()) + " for the first");
    }
    return found->second.front();
}

bool TextReader::read_bool() {
    const std::size_t start     = scan_.position();
    const std::string_view word = scan_.word();
    if (word != "true" && word != "false") {
        scan_.fail_at(start, word.empty() ? "expected true or false, got " + scan_.what_follows()
                                          : "expected true or false, got '" + shorten(word) + "'");
    }
    return word == "true";
}

bool TextReader::end_of_list(std::size_t opened) {
    if (scan_.take(']')) return true;
    if (scan_.at_end()) {
        path_.back().index = -1;
        scan_.fail("missing ']': " + path() + " is still open, since line " + std::to_string(scan_.line_of(opened)));
    }
    return false;
}

std::string TextReader::path() const {
    if (path_.empty()) return "the frame";
    std::string text;
    for (const Step& step : path_) {
        if (!text.empty()) text += '.';
        text += step.name;
        if (step.index >= 0) text += '[' + std::to_string(step.index) + ']';
    }
    return text;
}

std::string TextReader::shorten(std::string_view word) {
    constexpr std::size_t kLongest = 40;
    return word.size() <= kLongest ? std::string(word) : std::string(word.substr(0, kLongest)) + "...";
}

}  // namespace pipeline
