// SPDX-License-Identifier: MIT
#include "cloud/mega_particles/share_passes.h"

#include <algorithm>
#include <cstddef>
#include <glm/common.hpp>
#include <iterator>
#include <utility>
#include <variant>

namespace cloud {

using namespace pipeline;

namespace {

constexpr double kHalfStep    = 0.5 / 256.0;  // of the texels that coordinates are floored to
constexpr float kNearestW     = 1e-3f;        // nearer corners have no place in the window
constexpr const char* kClear  = "clear, each in its own colour";
constexpr int kMostNames      = 3;
constexpr float kSnapMarginPx = 1.0f;  // far more than corners are moved by snapping and rounding

bool meet(const PixelRect& a, const PixelRect& b) {
    return a.x0 < b.x1 && b.x0 < a.x1 && a.y0 < b.y1 && b.y0 < a.y1;
}

const Target& target_of(const Frame& frame, TargetId id) {
    return frame.targets[static_cast<std::size_t>(id.index)];
}

// A pass on its way: of one cloud, or of several.
struct Step {
    std::vector<std::string> names;
    std::string what;
    Pass pass;
    bool may_be_shared = true;
};

// One axis of a rectangle, and of the coordinates of one stage.
struct Axis {
    double x0, x1, u0, u1;
};

double texel_at(const Axis& axis, double x, int size) {
    return (axis.u0 + (x - axis.x0) / (axis.x1 - axis.x0) * (axis.u1 - axis.u0)) * size;
}

// Whether all corners, and all between the first and the last of them, fall into the pass's scissor, or out of the
// target.
bool falls_into_scissor(const Frame& frame, const Pass& pass, const DrawTriangles& draw) {
    if (!pass.camera) return false;
    const Camera& camera = frame.cameras[static_cast<std::size_t>(pass.camera.index)];
    const Mat4 to_clip   = camera.projection * camera.view * draw.world;
    const Target& target = target_of(frame, pass.color);
    const Vec2 half      = Vec2(static_cast<float>(target.width), static_cast<float>(target.height)) * 0.5f;
    Vec2 low(1e30f), high(-1e30f);
    const auto indices       = frame.indices.begin() + static_cast<std::ptrdiff_t>(draw.first_index);
    const auto [first, last] = std::minmax_element(indices, indices + static_cast<std::ptrdiff_t>(draw.index_count));
    if (draw.index_count == 0) return true;
    for (std::size_t i = *first; i <= *last; ++i) {
        const Vec4 clip = to_clip * Vec4(frame.vertices[i].position, 1.0f);
        if (!(clip.w > kNearestW)) return false;
        const Vec2 place = Vec2(1.0f + clip.x / clip.w, 1.0f - clip.y / clip.w) * half;
        low = glm::min(low, place), high = glm::max(high, place);
    }
    const PixelRect& scissor = pass.state.scissor;
    const auto is_held       = [](float lowest, float highest, int from, int to, int size) {
        return (from <= 0 || lowest - kSnapMarginPx >= static_cast<float>(from)) &&
               (to >= size || highest + kSnapMarginPx <= static_cast<float>(to));
    };
    return is_held(low.x, high.x, scissor.x0, scissor.x1, target.width) &&
           is_held(low.y, high.y, scissor.y0, scissor.y1, target.height);
}

bool needs_no_scissor(const Frame& frame, const Pass& pass) {
    if (!pass.color || pass.clear.depth || pass.state.viewport != PixelRect{}) return false;
    return std::ranges::all_of(pass.draws, [&](const Draw& draw) {
        if (const auto* triangles = std::get_if<DrawTriangles>(&draw))
            return falls_into_scissor(frame, pass, *triangles);
        return std::holds_alternative<DrawRectangle>(draw);
    });
}

// What a clear does, drawn.
Pass drawn_clear(const Pass& pass) {
    Pass clear;
    clear.label         = pass.label;
    clear.color         = pass.color;
    clear.state.scissor = pass.state.scissor;
    DrawRectangle all;
    all.x0    = static_cast<float>(pass.state.scissor.x0);
    all.y0    = static_cast<float>(pass.state.scissor.y0);
    all.x1    = static_cast<float>(pass.state.scissor.x1);
    all.y1    = static_cast<float>(pass.state.scissor.y1);
    all.color = *pass.clear.color;
    clear.draws.push_back(all);
    return clear;
}

std::vector<Step> steps_of(const Frame& frame, CloudPasses& cloud) {
    std::vector<Step> steps;
    for (Pass& pass : cloud.passes) {
        const std::string what = pass.label.substr(cloud.name.size() + 2);
        if (!needs_no_scissor(frame, pass)) {
            steps.push_back({{cloud.name}, what, std::move(pass), false});
            continue;
        }
        if (pass.clear.color) steps.push_back({{cloud.name}, kClear, drawn_clear(pass)});
        pass.clear.color.reset();
        if (pass.draws.empty()) continue;
        for (Draw& draw : pass.draws)
            if (auto* rectangle = std::get_if<DrawRectangle>(&draw))
                *rectangle = cut_rectangle(frame, *rectangle, pass.state.scissor);
        steps.push_back({{cloud.name}, what, std::move(pass)});
    }
    return steps;
}

// Equal but for draws and scissor.
bool can_be_one(const Step& a, const Step& b) {
    if (!a.may_be_shared || !b.may_be_shared || a.what != b.what) return false;
    PipelineState state = b.pass.state;
    state.scissor       = a.pass.state.scissor;
    return a.pass.color == b.pass.color && a.pass.depth == b.pass.depth && a.pass.camera == b.pass.camera &&
           a.pass.state == state;
}

void join(Step& to, Step&& from) {
    std::ranges::move(from.names, std::back_inserter(to.names));
    std::ranges::move(from.pass.draws, std::back_inserter(to.pass.draws));
    to.pass.state.scissor = hull(to.pass.state.scissor, from.pass.state.scissor);
}

// Both in their order, with as many steps in common as can be.
std::vector<Step> interleave(std::vector<Step> a, std::vector<Step> b) {
    // common[i][j]: of a from i and b from j.
    std::vector<std::vector<int>> common(a.size() + 1, std::vector<int>(b.size() + 1, 0));
    for (std::size_t i = a.size(); i-- > 0;)
        for (std::size_t j = b.size(); j-- > 0;)
            common[i][j] =
                can_be_one(a[i], b[j]) ? 1 + common[i + 1][j + 1] : std::max(common[i + 1][j], common[i][j + 1]);
    std::vector<Step> both;
    std::size_t i = 0, j = 0;
    while (i < a.size() && j < b.size()) {
        if (can_be_one(a[i], b[j])) {
            join(a[i], std::move(b[j++]));
            both.push_back(std::move(a[i++]));
        } else if (common[i + 1][j] >= common[i][j + 1]) {
            both.push_back(std::move(a[i++]));
        } else {
            both.push_back(std::move(b[j++]));
        }
    }
    std::move(a.begin() + static_cast<std::ptrdiff_t>(i), a.end(), std::back_inserter(both));
    std::move(b.begin() + static_cast<std::ptrdiff_t>(j), b.end(), std::back_inserter(both));
    return both;
}

std::string listed(const std::vector<std::string>& names) {
    const std::size_t shown = names.size() <= kMostNames ? names.size() : kMostNames - 1;
    std::string list        = names[0];
    for (std::size_t i = 1; i < shown; ++i) list += ", " + names[i];
    if (shown < names.size()) list += " and " + std::to_string(names.size() - shown) + " more";
    return list;
}

// A clear that none shares goes back to the pass that comes after it, if that is its cloud's alone as well.
void undo_single_clears(std::vector<Step>& steps) {
    std::vector<Step> left;
    for (Step& step : steps) {
        const bool follows = !left.empty() && left.back().what == kClear && left.back().names.size() == 1 &&
                             step.names == left.back().names && step.pass.color == left.back().pass.color;
        if (!follows) {
            left.push_back(std::move(step));
            continue;
        }
        step.pass.clear.color = std::get<DrawRectangle>(left.back().pass.draws[0]).color;
        left.back()           = std::move(step);
    }
    steps = std::move(left);
}

using Group = std::vector<CloudPasses*>;

std::vector<Group> group_apart(std::vector<CloudPasses>& clouds) {
    std::vector<Group> groups;
    for (CloudPasses& cloud : clouds) {
        std::size_t place = groups.size();
        while (place > 0 && std::ranges::none_of(groups[place - 1], [&](const CloudPasses* other) {
                   return meet(other->reach, cloud.reach);
               }))
            --place;
        if (place == groups.size()) groups.emplace_back();
        groups[place].push_back(&cloud);
    }
    return groups;
}

}  // namespace

DrawRectangle cut_rectangle(const Frame& frame, const DrawRectangle& rectangle, const PixelRect& area) {
    DrawRectangle cut = rectangle;
    cut.x0            = std::max(rectangle.x0, static_cast<float>(area.x0));
    cut.y0            = std::max(rectangle.y0, static_cast<float>(area.y0));
    cut.x1            = std::max(cut.x0, std::min(rectangle.x1, static_cast<float>(area.x1)));
    cut.y1            = std::max(cut.y0, std::min(rectangle.y1, static_cast<float>(area.y1)));
    for (std::size_t stage = 0; stage < rectangle.uv.size(); ++stage) {
        const TargetId source = rectangle.textures[stage].target;
        if (!source || cut.x0 >= cut.x1 || cut.y0 >= cut.y1) continue;
        const Target& target = target_of(frame, source);
        const UvRect& uv     = rectangle.uv[stage];
        const Axis across{rectangle.x0, rectangle.x1, uv.u0, uv.u1}, down{rectangle.y0, rectangle.y1, uv.v0, uv.v1};
        const auto moved = [](const Axis& axis, float x, int size) {
            return static_cast<float>((texel_at(axis, x, size) + kHalfStep) / size);
        };
        cut.uv[stage] = {.u0 = moved(across, cut.x0, target.width),
                         .v0 = moved(down, cut.y0, target.height),
                         .u1 = moved(across, cut.x1, target.width),
                         .v1 = moved(down, cut.y1, target.height)};
    }
    return cut;
}

std::vector<Pass> share_passes(const Frame& frame, std::vector<CloudPasses> clouds) {
    std::vector<Pass> passes;
    for (const Group& group : group_apart(clouds)) {
        if (group.size() == 1) {
            std::ranges::move(group[0]->passes, std::back_inserter(passes));
            continue;
        }
        std::vector<Step> steps;
        for (CloudPasses* cloud : group) steps = interleave(std::move(steps), steps_of(frame, *cloud));
        undo_single_clears(steps);
        for (Step& step : steps) {
            step.pass.label = listed(step.names) + ": " + step.what;
            passes.push_back(std::move(step.pass));
        }
    }
    return passes;
}

}  // namespace cloud
