// SPDX-License-Identifier: MIT
#include "demo/vectors/vector_tables.h"

#include <type_traits>

namespace demo {

std::size_t axis_size(const Axis& axis) {
    return std::visit(
        [](const auto& values) -> std::size_t {
            if constexpr (std::is_same_v<std::remove_cvref_t<decltype(values)>, AxisRange>)
                return static_cast<std::size_t>(values.last - values.first + 1);
            else
                return values.size();
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

std::string lower_case(std::string_view text) {
    std::string lower(text);
    for (char& c : lower)
        if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
    return lower;
}

}  // namespace demo
