// SPDX-License-Identifier: MIT
#include "pipeline/legalize/reversed_depth.h"

#include <map>

#include "pipeline/check/chip_findings.h"
#include "pipeline/check/target_use.h"
#include "pipeline/legalize/vertex_changes.h"

namespace pipeline {

namespace {

CompareFunc reversed(CompareFunc func) {
    switch (func) {
        case CompareFunc::LessEqual:
            return CompareFunc::GreaterEqual;
        case CompareFunc::Less:
            return CompareFunc::Greater;
        case CompareFunc::GreaterEqual:
            return CompareFunc::LessEqual;
        case CompareFunc::Greater:
            return CompareFunc::Less;
        case CompareFunc::Always:
        case CompareFunc::Equal:
        case CompareFunc::NotEqual:
        case CompareFunc::Never:
            break;
    }
    return func;
}

// z' = w - z
Mat4 reversed(Mat4 projection) {
    for (int column = 0; column < 4; ++column) projection[column][2] = projection[column][3] - projection[column][2];
    return projection;
}

std::size_t index_of(TargetId id) {
    return static_cast<std::size_t>(id.index);
}

// For each target whether its depth is to be reversed.
std::vector<bool> targets_to_reverse(const Frame& frame, const std::vector<CompareFunc>& funcs) {
    std::vector<int> gained(frame.targets.size());
    for (const Pass& pass : frame.passes) {
        if (!pass.depth || !draws(pass)) continue;
        const CompareFunc func = pass.state.depth.func;
        gained[index_of(pass.depth)] += is_among(reversed(func), funcs) - is_among(func, funcs);
    }
    std::vector<bool> reverse(frame.targets.size());
    std::transform(gained.begin(), gained.end(), reverse.begin(), [](int passes) { return passes > 0; });
    return reverse;
}

bool clears_all_depth(const Frame& frame, const Pass& pass) {
    const Target& target  = frame.targets[index_of(pass.depth)];
    const auto is_limited = [&](const PixelRect& limit) {
        return limit != PixelRect{} && limit != PixelRect{0, 0, target.width, target.height};
    };
    return pass.clear.depth && !is_limited(pass.state.viewport) && !is_limited(pass.state.scissor);
}

class Reversal {
  public:
    Reversal(Frame& frame, std::vector<bool> targets) : frame_(frame), targets_(std::move(targets)) {
        for (const Pass& pass : frame_.passes)
            if (pass.depth && !is_reversed(pass)) kept_cameras_.push_back(pass.camera);
    }

    bool is_reversed(const Pass& pass) const { return pass.depth && targets_[index_of(pass.depth)]; }

    void reverse_vertices() {
        const VertexChange keep, change{{}, [](WindowVertex&vertex) { vertex.z = 1.0f - vertex.z; }};
        std::vector<ChangedDraw> draws;
        for (Pass& pass : frame_.passes)
            for (Draw& draw : pass.draws) draws.push_back({&draw, is_reversed(pass) ? std::size_t{1} : std::size_t{0}});
        change_vertices(frame_, draws, std::array{keep, change});
    }

    void reverse(Pass& pass) {
        pass.state.depth.func = reversed(pass.state.depth.func);
        if (pass.clear.depth) pass.clear.depth = 1.0f - *pass.clear.depth;
        for (Draw& draw : pass.draws)
            if (auto* rectangle = std::get_if<DrawRectangle>(&draw)) rectangle->depth = 1.0f - rectangle->depth;
        if (pass.camera) pass.camera = reversed_camera(pass.camera);
    }

    // Passes to come before those that meet a target in its first state, zeros.
    std::vector<std::pair<std::size_t, Pass>> starts() const {
        std::vector<std::pair<std::size_t, Pass>> passes;
        std::vector<bool> seen(targets_.size());
        for (std::size_t i = 0; i < frame_.passes.size(); ++i) {
            const Pass& pass = frame_.passes[i];
            if (!is_reversed(pass) || seen[index_of(pass.depth)] || !(uses_depth(pass) || pass.clear.depth)) continue;
            seen[index_of(pass.depth)] = true;
            if (clears_all_depth(frame_, pass)) continue;
            Pass& start       = passes.emplace_back(i, Pass{}).second;
            start.label       = "zeros of '" + frame_.targets[index_of(pass.depth)].name + "', reversed";
            start.depth       = pass.depth;
            start.clear.depth = 1.0f;
        }
        return passes;
    }

  private:
    CameraId reversed_camera(CameraId camera) {
        const auto [found, is_new] = reversed_cameras_.insert({camera.index, camera});
        if (!is_new) return found->second;
        if (is_among(camera, kept_cameras_)) {
            frame_.cameras.push_back(frame_.cameras[static_cast<std::size_t>(camera.index)]);
            found->second = {static_cast<std::int32_t>(frame_.cameras.size()) - 1};
        }
        Camera& changed    = frame_.cameras[static_cast<std::size_t>(found->second.index)];
        changed.projection = reversed(changed.projection);
        return found->second;
    }

    Frame& frame_;
    std::vector<bool> targets_;
    std::vector<CameraId> kept_cameras_;
    std::map<std::int32_t, CameraId> reversed_cameras_;
};

void insert(std::vector<std::pair<std::size_t, Pass>> starts, Frame& frame) {
    for (auto start = starts.rbegin(); start != starts.rend(); ++start)
        frame.passes.insert(frame.passes.begin() + static_cast<std::ptrdiff_t>(start->first), std::move(start->second));
}

}  // namespace

Frame rewrite_reversed_depth(Frame frame, const Profile& profile, RewriteNotes& notes) {
    const std::vector<CompareFunc>& funcs = profile.states.depth_funcs;
    if (is_among(CompareFunc::LessEqual, funcs) || !is_among(CompareFunc::GreaterEqual, funcs)) return frame;
    const std::vector<bool> targets = targets_to_reverse(frame, funcs);
    for (std::size_t i = 0; i < targets.size(); ++i)
        if (targets[i])
            notes.push_back({"reversed_depth", Place("target", i, frame.targets[i].name).text(),
                             "the chip compares depth with " + names_of(funcs), "depth 1 - d, compared the other way"});
    Reversal reversal(frame, targets);
    reversal.reverse_vertices();
    for (Pass& pass : frame.passes)
        if (reversal.is_reversed(pass)) reversal.reverse(pass);
    auto starts = reversal.starts();
    for (const auto& [index, start] : starts)
        notes.push_back({"reversed_depth", Place("pass", index, frame.passes[index].label).text(),
                         "its depth target held zeros, once nearest", "a pass that clears it to 1 comes first"});
    insert(std::move(starts), frame);
    return frame;
}

}  // namespace pipeline
