// SPDX-License-Identifier: MIT
// Valid frames, drawn in all ways. Inputs are frames' texts; they are changed as frames, one field here and there, so that
// most stay valid, and sometimes as bytes, which changes numbers in ways of its own.
#include <algorithm>

#include "pipeline/frame/frame_text.h"
#include "pipeline/validate/validate.h"
#include "tests/fuzz/agreement.h"
#include "tests/fuzz/fuzz.h"
#include "tests/support/random.h"
#include "tests/support/random_frame.h"

using namespace pipeline;

extern "C" std::size_t LLVMFuzzerMutate(std::uint8_t* data, std::size_t size, std::size_t max_size);

namespace {

std::optional<Frame> read(std::string_view text) {
    try {
        return parse_frame(text);
    } catch (const ParseError&) {
        return {};
    }
}

// The text's length, or 0 if there is no room for it.
std::size_t put(const std::string& text, std::uint8_t* data, std::size_t max_size) {
    if (text.size() > max_size) return 0;
    std::copy(text.begin(), text.end(), data);
    return text.size();
}

// A frame that is valid and not this one, if a few attempts find one.
std::optional<Frame> changed(const Frame& frame, test_support::Random& random) {
    for (int attempt = 0; attempt < 16; ++attempt) {
        Frame other = frame;
        for (int i = random.from(1, 4); i > 0; --i) test_support::mutate_field(other, random.bits());
        if (validate(other).empty()) return other;
    }
    return {};
}

}  // namespace

extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size, std::size_t max_size,
                                               unsigned int seed) {
    test_support::Random random(seed);
    const std::optional<Frame> frame = read(fuzz::as_text(data, size));
    if (!frame || random.chance(5)) {
        const std::size_t made = put(to_text(test_support::random_frame(random.bits())), data, max_size);
        if (made > 0) return made;
    }
    if (frame && random.chance(80)) {
        const std::optional<Frame> other = changed(*frame, random);
        const std::size_t made           = other ? put(to_text(*other), data, max_size) : 0;
        if (made > 0) return made;
    }
    return LLVMFuzzerMutate(data, size, max_size);
}

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::optional<Frame> frame = read(fuzz::as_text(data, size));
    // Only frames are kept; the other fuzzer keeps texts that are none.
    return frame && fuzz::require_agreement(*frame, static_cast<std::uint32_t>(size)) ? 0 : -1;
}
