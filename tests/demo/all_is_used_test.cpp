// SPDX-License-Identifier: MIT
// Nothing is in the product that nothing needs: each value of each state, each fill kernel and each rewrite serves a frame of
// a built-in scene, one rewritten for a chip, or one of the golden vectors; a kernel, or what the bench says the speed of.
#include <algorithm>
#include <catch2/catch.hpp>
#include <map>
#include <set>

#include "demo/embedded_texts.h"
#include "demo/scene.h"
#include "demo/vectors/vector_frames.h"
#include "demo/vectors/vector_probe.h"
#include "pipeline/check/idle_state.h"
#include "pipeline/check/state_use.h"
#include "pipeline/execute/fill_kernel_list.h"
#include "pipeline/legalize/rewrites.h"
#include "tests/bench/frames.h"
#include "tests/support/small_frame.h"

using namespace pipeline;

namespace {

class Uses {
  public:
    void add(const Frame& frame) {
        add_state_uses(frame, states_);
        add_kernels(frame);
    }
    void add_kernels(const Frame& frame) {
        for (const FillKernelName& kernel : fill_kernels_of(frame)) kernels_.insert(text_of(kernel));
    }

    // And as each chip draws it.
    void add_rewritten(const Frame& frame) {
        add(frame);
        for (const Profile& profile : profiles()) {
            if (profile.arithmetic == Arithmetic{} && profile.limits.memory == 0) continue;  // no chip
            Frame legal = frame;
            for (const NamedRewrite& next : rewrites()) {
                RewriteNotes notes;
                legal = next.rewrite(std::move(legal), profile, notes);
                if (!notes.empty()) rewrites_.insert(next.name);
            }
            add(legal);
        }
    }

    // An enumerator that several fields can have is used if one of them has it; so is a value of yes-or-no fields of one
    // name, such as the arguments' `complement`. Defaults are what no frame need say.
    std::set<std::string> unused_states() const {
        std::set<std::string> all, used;
        for (std::size_t i = 0; i < states_.size(); ++i) {
            const StateField& field = state_fields()[i];
            const bool is_bool      = field.values[0] == "false";
            std::string kind        = is_bool ? field.path.substr(field.path.rfind('.') + 1) : std::string();
            if (!is_bool)
                for (const std::string_view value : field.values) kind += std::string(value) + '|';
            for (std::size_t value = 0; value < states_[i].size(); ++value) {
                const std::string name = kind + ": " + std::string(field.values[value]);
                all.insert(name);
                if (states_[i][value] > 0 || value == field.default_value) used.insert(name);
            }
        }
        std::set<std::string> unused;
        std::set_difference(all.begin(), all.end(), used.begin(), used.end(), std::inserter(unused, unused.end()));
        return unused;
    }
    std::vector<std::string> unused_kernels() const {
        std::vector<std::string> unused;
        for (const FillKernelName& kernel : fill_kernel_names())
            if (kernels_.count(text_of(kernel)) == 0) unused.push_back(text_of(kernel));
        return unused;
    }
    std::vector<std::string_view> unused_rewrites() const {
        std::vector<std::string_view> unused;
        for (const NamedRewrite& rewrite : rewrites())
            if (rewrites_.count(rewrite.name) == 0) unused.push_back(rewrite.name);
        return unused;
    }

  private:
    static std::string text_of(const FillKernelName& kernel) {
        return std::string(kernel.primitive) + ": " + std::string(kernel.name);
    }

    StateUses states_;
    std::set<std::string> kernels_;
    std::set<std::string_view> rewrites_;
};

// As `render` can draw them.
std::vector<demo::FrameOptions> ways_to_draw() {
    std::vector<demo::FrameOptions> ways(1);
    for (const cloud::Mode mode :
         {cloud::Mode::Skirt, cloud::Mode::Article, cloud::Mode::Premultiplied, cloud::Mode::Black})
        ways.emplace_back().mode = mode;
    ways.emplace_back().order = cloud::Order::OrderFree;
    for (const demo::Technique technique : {demo::Technique::Sprites, demo::Technique::Slices})
        ways.emplace_back().technique = technique;
    return ways;
}

// Targets and textures that a frame has for nothing.
void add_idle(const std::string& scene, const Frame& frame, std::set<std::string>& idle) {
    const std::vector<bool> targets = targets_in_use(frame), textures = textures_in_use(frame);
    for (std::size_t i = 0; i < targets.size(); ++i)
        if (!targets[i]) idle.insert(scene + ": target " + frame.targets[i].name);
    for (std::size_t i = 0; i < textures.size(); ++i)
        if (!textures[i]) idle.insert(scene + ": texture " + frame.textures[i].name);
}

void add_scenes(Uses& uses, std::set<std::string>& idle) {
    constexpr demo::Size kSize{48, 27};
    for (const demo::SceneInfo& info : demo::built_in_scenes()) {
        const demo::ScenePtr scene = demo::load_scene(info.name);
        const int frames           = demo::frame_count(*scene);
        for (const int index : {0, frames / 2}) {
            const Frame frame = demo::scene_frame(*scene, kSize, index);
            add_idle(std::string(info.name), frame, idle);
            uses.add_rewritten(frame);
        }
    }
    const demo::ScenePtr canyon = demo::load_scene("canyon");
    for (const demo::FrameOptions& way : ways_to_draw()) uses.add(demo::scene_frame(*canyon, kSize, 0, way));
}

void add_golden_vectors(Uses& uses) {
    for (const Profile& profile : profiles()) {
        for (const demo::VectorFrame& frame : demo::vector_frames(profile, demo::embedded_frames())) {
            if (frame.why_not.empty()) uses.add(frame.frame);
            if (profile.arithmetic == Arithmetic{}) uses.add_rewritten(frame.frame);
        }
        demo::Prober prober(profile.arithmetic, [&](const Frame& frame) { uses.add(frame); });
        for (const demo::VectorTable& table : demo::vector_tables(profile, prober)) table.draw();
    }
}

}  // namespace

TEST_CASE("every state, kernel and rewrite serves a scene, a chip or a golden vector", "[requires]") {
    Uses uses;
    std::set<std::string> idle;
    add_scenes(uses, idle);
    CHECK(idle == std::set<std::string>{});
    add_golden_vectors(uses);
    for (const bench::FrameCase& fill : bench::fill_cases()) uses.add_kernels(fill.build());
    // Kernels' blends are swept over all bytes by plain rectangles; that of thrown light has no other.
    Frame plain                 = test_support::small_frame(8, 8);
    plain.passes[0].state.blend = {BlendFactor::DestColor, BlendFactor::One};
    plain.passes[0].draws       = {test_support::rectangle({0, 0, 8, 8}, 0xff102030)};
    uses.add_kernels(plain);
    CHECK(uses.unused_states() == std::set<std::string>{});
    CHECK(uses.unused_kernels() == std::vector<std::string>{});
    CHECK(uses.unused_rewrites() == std::vector<std::string_view>{});
}
