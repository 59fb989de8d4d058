// SPDX-License-Identifier: MIT
#include "demo/embedded_texts.h"

#include <algorithm>

namespace demo {

std::optional<EmbeddedText> find_text(std::span<const EmbeddedText> texts, std::string_view name) {
    const auto found =
        std::find_if(texts.begin(), texts.end(), [&](const EmbeddedText& text) { return text.name == name; });
    return found == texts.end() ? std::nullopt : std::optional(*found);
}

}  // namespace demo
