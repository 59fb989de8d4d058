// SPDX-License-Identifier: MIT
// Text files that are compiled in by demo/embed_texts.cmake, in alphabetical order.
#pragma once

#include <optional>
#include <span>
#include <string_view>

namespace demo {

// name: the file's, without its extension.
struct EmbeddedText {
    std::string_view name, text;
};

// Defined in generated files: the scenes of demo/scenes, the frames of demo/frames, the page of demo/tradeoff.
std::span<const EmbeddedText> embedded_scenes();
std::span<const EmbeddedText> embedded_frames();
std::span<const EmbeddedText> embedded_tradeoff();

std::optional<EmbeddedText> find_text(std::span<const EmbeddedText> texts, std::string_view name);

}  // namespace demo
