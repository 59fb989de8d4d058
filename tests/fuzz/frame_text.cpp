// SPDX-License-Identifier: MIT
// A frame's text, any bytes: read, or refused with a place within it. What was read has a text that reads as the same, and
// is valid or has findings.
#include "pipeline/frame/frame_text.h"

#include <algorithm>

#include "pipeline/validate/work.h"
#include "tests/fuzz/fuzz.h"

using namespace pipeline;

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string_view text = fuzz::as_text(data, size);
    Frame frame;
    try {
        frame = parse_frame(text);
    } catch (const ParseError& error) {
        fuzz::require_complaint(error.what());
        fuzz::require(error.line >= 1 && error.line <= 1 + std::count(text.begin(), text.end(), '\n'), "no such line");
        fuzz::require(error.column >= 1 && static_cast<std::size_t>(error.column) <= size + 1, "no such column");
        return 0;
    }
    const std::string written = to_text(frame);
    const Frame read          = parse_frame(written);
    // Not-a-number is not equal to itself; its text is.
    fuzz::require(to_text(read) == written, "the text's text is another");
    fuzz::require(diff(frame, read).empty(), "the text reads as another frame");
    for (const Finding& finding : validate(frame)) fuzz::require_complaint(finding.what);
    if (validate(frame).empty()) check_work(work_of(frame));
    return 0;
}
