// SPDX-License-Identifier: MIT
#include "demo/gltf_animation.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <glm/geometric.hpp>
#include <iterator>
#include <string>
#include <utility>

#include "demo/gltf_check.h"

namespace demo {
namespace {

// `otherwise`, where the length is none.
glm::dvec4 unit_or(const glm::dvec4& quaternion, const glm::dvec4& otherwise) {
    const double squared = glm::dot(quaternion, quaternion);
    return squared > 1e-12 ? quaternion / std::sqrt(squared) : otherwise;
}

Interpolation interpolation_of(const GltfFile& file, const std::string& name, const std::string& what) {
    if (name == "LINEAR") return Interpolation::Linear;
    if (name == "STEP") return Interpolation::Step;
    if (name == "CUBICSPLINE") return Interpolation::CubicSpline;
    file.fail(what + ": there is no interpolation " + in_quotes(name));
}

std::vector<double> read_times(GltfFile& file, int accessor, const std::string& what) {
    const GltfNumbers input = file.read_numbers(accessor, {.what = "the times of " + what});
    std::vector<double> times(input.values.begin(), input.values.end());
    const auto is_late = [](double time, double next) { return time >= next; };
    if (times.front() < 0.0 || std::adjacent_find(times.begin(), times.end(), is_late) != times.end()) {
        file.fail("the times of " + what + ": must start at 0 or later and ascend");
    }
    return times;
}

Curve read_curve(GltfFile& file, const tinygltf::AnimationSampler& sampler, bool is_rotation, const std::string& what) {
    Curve curve{.interpolation = interpolation_of(file, sampler.interpolation, what),
                .is_rotation   = is_rotation,
                .times         = read_times(file, sampler.input, what),
                .values        = {}};
    const int components     = is_rotation ? 4 : 3;
    const GltfNumbers output = file.read_numbers(sampler.output, {.what             = "the keys of " + what,
                                                                  .least_components = components,
                                                                  .most_components  = components,
                                                                  .or_normalized    = is_rotation});
    const bool is_cubic      = curve.interpolation == Interpolation::CubicSpline;
    if (output.count != curve.times.size() * (is_cubic ? 3 : 1)) {
        file.fail("the keys of " + what + ": are not as many as their times");
    }
    for (std::size_t i = 0; i < output.count; ++i) {
        glm::dvec4 value(output.at(i, 0), output.at(i, 1), output.at(i, 2), is_rotation ? output.at(i, 3) : 0.0f);
        if (is_rotation && (!is_cubic || i % 3 == 1)) {
            value = unit_or(value, glm::dvec4(0.0));
            if (value == glm::dvec4(0.0)) file.fail("the keys of " + what + ": hold a rotation that is no quaternion");
        }
        curve.values.push_back(value);
    }
    return curve;
}

}  // namespace

glm::dvec4 Curve::at(double seconds) const {
    const std::size_t per_key = interpolation == Interpolation::CubicSpline ? 3 : 1;
    const auto value          = [&](std::size_t key) { return values[key * per_key + per_key / 2]; };
    const auto after          = std::upper_bound(times.begin(), times.end(), seconds);
    if (after == times.begin()) return value(0);
    const auto key = static_cast<std::size_t>(std::distance(times.begin(), after)) - 1;
    if (after == times.end() || interpolation == Interpolation::Step) return value(key);

    const double step = times[key + 1] - times[key];
    const double t    = (seconds - times[key]) / step;
    if (interpolation == Interpolation::Linear) {
        const glm::dvec4 from = value(key);
        // q and -q are one rotation: the nearer one is meant.
        const glm::dvec4 to   = is_rotation && glm::dot(from, value(key + 1)) < 0.0 ? -value(key + 1) : value(key + 1);
        const glm::dvec4 between = from * (1.0 - t) + to * t;
        return is_rotation ? unit_or(between, from) : between;
    }
    // glTF 2.0, appendix C.5: Hermite's polynomials.
    const double t2 = t * t, t3 = t2 * t;
    const glm::dvec4& leaving  = values[key * 3 + 2];
    const glm::dvec4& arriving = values[(key + 1) * 3];
    const glm::dvec4 between   = value(key) * (2.0 * t3 - 3.0 * t2 + 1.0) + leaving * (step * (t3 - 2.0 * t2 + t)) +
                               value(key + 1) * (3.0 * t2 - 2.0 * t3) + arriving * (step * (t3 - t2));
    return is_rotation ? unit_or(between, value(key)) : between;
}

void NodeCurves::apply(LocalTransform& transform, double seconds) const {
    if (translation) transform.translation = glm::dvec3(translation->at(seconds));
    if (rotation) transform.rotation = rotation->at(seconds);
    if (scale) transform.scale = glm::dvec3(scale->at(seconds));
}

double NodeCurves::duration() const {
    double last = 0.0;
    for (const std::optional<Curve>* curve : {&translation, &rotation, &scale})
        if (*curve) last = std::max(last, (*curve)->times.back());
    return last;
}

std::map<int, NodeCurves> read_curves(GltfFile& file) {
    std::map<int, NodeCurves> curves;
    for (std::size_t i = 0; i < file.model().animations.size(); ++i) {
        const tinygltf::Animation& animation = file.model().animations[i];
        for (std::size_t k = 0; k < animation.channels.size(); ++k) {
            const tinygltf::AnimationChannel& channel = animation.channels[k];
            const std::string& path                   = channel.target_path;
            const bool is_known                       = path == "translation" || path == "rotation" || path == "scale";
            if (channel.target_node < 0 || !is_known) continue;
            const std::string what = "animations[" + std::to_string(i) + "].channels[" + std::to_string(k) + "]";
            const tinygltf::Node& node =
                file.find(file.model().nodes, channel.target_node, what + " moves a node that is not there");
            if (!node.matrix.empty())
                file.fail(node_name(file, channel.target_node) + ": has a matrix and is animated");
            const tinygltf::AnimationSampler& sampler =
                file.find(animation.samplers, channel.sampler, what + " has a sampler that is not there");

            NodeCurves& moved          = curves[channel.target_node];
            std::optional<Curve>& goal = path == "translation" ? moved.translation
                                         : path == "rotation"  ? moved.rotation
                                                               : moved.scale;
            if (!goal) goal = read_curve(file, sampler, path == "rotation", what);
        }
    }
    return curves;
}

}  // namespace demo
