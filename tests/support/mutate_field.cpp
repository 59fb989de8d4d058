// SPDX-License-Identifier: MIT
#include <limits>

#include "pipeline/frame/field_traits.h"
#include "tests/support/random.h"
#include "tests/support/random_frame.h"

namespace test_support {

using namespace pipeline;

namespace {

template <class T>
T other_value(const T& value, std::initializer_list<T> choices, Random& random) {
    T other = value;
    while (other == value) other = random.one_of(choices);
    return other;
}

// The alternative after this one, the first after the last.
template <class... Alternatives>
std::variant<Alternatives...> another_alternative(const std::variant<Alternatives...>& value) {
    const std::array<std::variant<Alternatives...>, sizeof...(Alternatives)> all{Alternatives{}...};
    return all[(value.index() + 1) % all.size()];
}

// One choice at each level, so that a rare field is as likely as one of thousands of vertices.
template <class T>
void mutate(T& value, Random& random) {
    if constexpr (FieldStruct<T>) {
        std::size_t count = 0, i = 0;
        visit_fields(value, [&](std::string_view, auto&) { ++count; });
        const std::size_t chosen = random.below(count);
        visit_fields(value, [&](std::string_view, auto& field) {
            if (i++ == chosen) mutate(field, random);
        });
    } else if constexpr (kIsList<T>) {
        if (value.empty() || random.chance(15)) {
            value.emplace_back();
        } else if (random.chance(10)) {
            value.pop_back();
        } else {
            mutate(value[random.below(value.size())], random);
        }
    } else if constexpr (kIsArray<T>) {
        mutate(value[random.below(value.size())], random);
    } else if constexpr (kIsOptional<T>) {
        if (!value) {
            value.emplace();
        } else if (random.chance(50)) {
            value.reset();
        } else {
            mutate(*value, random);
        }
    } else if constexpr (kIsVariant<T>) {
        if (random.chance(20)) {
            value = another_alternative(value);
        } else {
            std::visit([&](auto& alternative) { mutate(alternative, random); }, value);
        }
    } else if constexpr (NamedEnum<T>) {
        value = static_cast<T>((static_cast<std::size_t>(value) + 1) % EnumNames<T>::names.size());
    } else if constexpr (kIsId<T>) {
        value.index = other_value(value.index, {-5, -1, 0, 1, 2, 1000}, random);
    } else if constexpr (std::same_as<T, Argb>) {
        value.value ^= 1u << random.from(0, 31);
    } else if constexpr (std::same_as<T, std::string>) {
        value += static_cast<char>(random.bits());
    } else if constexpr (kIsVec<T> || std::same_as<T, Mat4>) {
        mutate(value[random.from(0, value.length() - 1)], random);
    } else if constexpr (std::same_as<T, bool>) {
        value = !value;
    } else if constexpr (std::same_as<T, float>) {
        using Limits = std::numeric_limits<float>;
        value        = other_value(value,
                                   {-0.0f, 1.0f / 3.0f, Limits::denorm_min(), Limits::max(), -Limits::infinity(), 16777216.0f,
                                    static_cast<float>(random.bits())},
                                   random);
    } else {
        value = other_value(value,
                            {std::numeric_limits<T>::min(), std::numeric_limits<T>::max(), T{1},
                             static_cast<T>(static_cast<std::uint64_t>(value) + 1)},
                            random);
    }
}

}  // namespace

void mutate_field(Frame& frame, std::uint32_t seed) {
    Random random(seed);
    mutate(frame, random);
}

}  // namespace test_support
