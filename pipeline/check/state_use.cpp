// SPDX-License-Identifier: MIT
#include "pipeline/check/state_use.h"

#include <algorithm>
#include <map>

#include "pipeline/check/idle_state.h"
#include "pipeline/check/target_use.h"
#include "pipeline/frame/field_traits.h"

namespace pipeline {
namespace {

template <class T>
constexpr bool kIsChoice = std::same_as<T, bool> || NamedEnum<T>;

// A list or an array of structs.
template <class T>
constexpr bool kHoldsChoices = false;
template <FieldStruct T>
constexpr bool kHoldsChoices<std::vector<T>> = true;
template <FieldStruct T, std::size_t count>
constexpr bool kHoldsChoices<std::array<T, count>> = true;

template <class T>
std::vector<std::string_view> values_of() {
    if constexpr (std::same_as<T, bool>)
        return {"false", "true"};
    else
        return {EnumNames<T>::names.begin(), EnumNames<T>::names.end()};
}

std::string joined(const std::string& path, std::string_view name) {
    return path.empty() ? std::string(name) : path + '.' + std::string(name);
}

// A pass's own fields are on the top: "state.cull", not "passes.state.cull".
template <class T>
constexpr bool kIsOnTop = std::same_as<T, Pass>;

class FieldLister {
  public:
    template <class T>
    void add(const std::string& path, const T& value) {
        if constexpr (kIsChoice<T>) {
            fields.push_back({path, values_of<T>(), static_cast<std::size_t>(value)});
        } else if constexpr (FieldStruct<T>) {
            visit_fields(value, [&](std::string_view name, const auto& field) {
                add(joined(kIsOnTop<T> ? std::string() : path, name), field);
            });
        } else if constexpr (kIsVariant<T>) {
            add_alternatives(path, value);
        } else if constexpr (kIsArray<T>) {
            add(path, value[0]);
        } else if constexpr (kIsOptional<T> || kIsList<T>) {
            add(path, typename T::value_type{});
        }
    }
    std::vector<StateField> fields;

  private:
    template <class... Alternatives>
    void add_alternatives(const std::string& path, const std::variant<Alternatives...>&) {
        (add(joined(path, kAlternativeName<Alternatives>), Alternatives{}), ...);
    }
};

class UseCounter {
  public:
    explicit UseCounter(StateUses& uses) : uses_(uses) {
        const std::vector<StateField>& fields = state_fields();
        uses_.resize(fields.size());
        for (std::size_t i = 0; i < fields.size(); ++i) uses_[i].resize(fields[i].values.size());
    }

    template <class T>
    void add(const std::string& path, const T& value) {
        add(path, value, value);
    }

    // Where the two are the same.
    template <class T>
    void add(const std::string& path, const T& a, const T& b) {
        if constexpr (kIsChoice<T>) {
            if (a == b) ++uses_[index_of(path)][static_cast<std::size_t>(a)];
        } else if constexpr (FieldStruct<T>) {
            visit_pairs(a, b, [&](std::string_view name, const auto& x, const auto& y) {
                using Field = std::remove_cvref_t<decltype(x)>;
                if constexpr (kIsChoice<Field> || FieldStruct<Field> || kHoldsChoices<Field>)
                    add(joined(path, name), x, y);
            });
        } else if constexpr (kHoldsChoices<T>) {
            if (a.size() != b.size()) return;
            for (std::size_t i = 0; i < a.size(); ++i) add(path, a[i], b[i]);
        }
    }

  private:
    static std::size_t index_of(const std::string& path) {
        static const std::map<std::string, std::size_t> indices = [] {
            std::map<std::string, std::size_t> of_path;
            const std::vector<StateField>& fields = state_fields();
            for (std::size_t i = 0; i < fields.size(); ++i) of_path[fields[i].path] = i;
            return of_path;
        }();
        return indices.at(path);
    }

    StateUses& uses_;
};

// Every choice in a struct, at its first value or at its second: between them the two differ in all of it.
template <FieldStruct Struct>
void set_choices(Struct& state, bool second) {
    visit_fields(state, [&](std::string_view, auto& field) {
        using Field = std::remove_cvref_t<decltype(field)>;
        if constexpr (kIsChoice<Field>)
            field = static_cast<Field>(second);
        else if constexpr (FieldStruct<Field>)
            set_choices(field, second);
        else if constexpr (kHoldsChoices<Field>)
            for (auto& entry : field) set_choices(entry, second);
    });
}
template <FieldStruct Struct>
const Struct& choices(bool second) {
    static const std::array<Struct, 2> both = [] {
        std::array<Struct, 2> set;
        set_choices(set[0], false);
        set_choices(set[1], true);
        return set;
    }();
    return both[second];
}

}  // namespace

const std::vector<StateField>& state_fields() {
    static const std::vector<StateField> fields = [] {
        FieldLister lister;
        lister.add("", Frame{});
        return lister.fields;
    }();
    return fields;
}

void add_state_uses(const Frame& frame, StateUses& uses) {
    UseCounter counter(uses);
    counter.add("arithmetic", with_idle_rules_of(frame, choices<Arithmetic>(false)),
                with_idle_rules_of(frame, choices<Arithmetic>(true)));
    const std::vector<bool> targets = targets_in_use(frame), textures = textures_in_use(frame);
    for (std::size_t i = 0; i < targets.size(); ++i)
        if (targets[i]) counter.add("targets", frame.targets[i]);
    for (std::size_t i = 0; i < textures.size(); ++i)
        if (textures[i]) counter.add("textures", frame.textures[i]);
    for (std::size_t i = 0; i < frame.passes.size(); ++i) {
        counter.add("state", with_idle_state_of(frame, frame.passes[i], choices<PipelineState>(false)),
                    with_idle_state_of(frame, frame.passes[i], choices<PipelineState>(true)));
        for (const Draw& draw : frame.passes[i].draws)
            std::visit(
                [&](const auto& alternative) {
                    using Alternative = std::remove_cvref_t<decltype(alternative)>;
                    counter.add(joined("draws", kAlternativeName<Alternative>), alternative);
                },
                draw);
    }
}

std::vector<bool> targets_in_use(const Frame& frame) {
    std::vector<bool> used;
    for (const TargetUse& use : target_uses(frame)) used.push_back(use.drawn || use.copied_to || use.read);
    for (const Pass& pass : frame.passes)
        for (const Draw& draw : pass.draws)
            if (const auto* copy = std::get_if<CopyRectangle>(&draw); copy != nullptr && copy->source)
                used[static_cast<std::size_t>(copy->source.index)] = true;
    return used;
}

std::vector<bool> textures_in_use(const Frame& frame) {
    std::vector<bool> uses(frame.textures.size());
    for (const Pass& pass : frame.passes)
        for_each_texture(pass, [&](std::size_t, std::size_t, const TextureBinding& binding) {
            if (find_texture(frame, binding.texture) != nullptr)
                uses[static_cast<std::size_t>(binding.texture.index)] = true;
        });
    return uses;
}

}  // namespace pipeline
