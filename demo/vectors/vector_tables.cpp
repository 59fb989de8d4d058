// SPDX-License-Identifier: MIT
#include "demo/vectors/vector_tables.h"

#include <algorithm>

namespace demo {

std::size_t axis_size(const Axis& axis) {
    if (const auto* range = std::get_if<AxisRange>(&axis.values))
        return static_cast<std::size_t>(range->last - range->first + 1);
    return std::visit(
        [](const auto& values) -> std::size_t {
            if constexpr (requires { values.size(); }) {
                return values.size();
            } else {
                return 0;
            }
        },
        axis.values);
}

std::vector<VectorTable> vector_tables(const pipeline::Profile& profile, Prober& prober) {
    std::vector<VectorTable> tables;
    if (profile.arithmetic.blend == pipeline::BlendRule::GsShift7) {
        add_gs_blend_tables(profile, prober, tables);
    } else {
        add_blend_tables(profile, prober, tables);
    }
    add_store_tables(profile, prober, tables);
    add_texture_tables(profile, prober, tables);
    add_fog_tables(profile, prober, tables);
    add_test_tables(profile, prober, tables);
    return tables;
}

bool has_topic(const pipeline::Profile& profile, std::string_view topic) {
    return std::any_of(profile.evidence.begin(), profile.evidence.end(),
                       [&](const pipeline::Evidence& evidence) { return evidence.topic == topic; });
}

std::string lower_case(std::string_view text) {
    std::string lower(text);
    for (char& c : lower)
        if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
    return lower;
}

}  // namespace demo
