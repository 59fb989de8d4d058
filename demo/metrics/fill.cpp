// SPDX-License-Identifier: MIT
#include "demo/metrics/fill.h"

#include <algorithm>
#include <utility>
#include <variant>
#include <vector>

#include "cloud/baselines/slice_volume.h"
#include "cloud/baselines/sprite_cloud.h"
#include "demo/metrics/measures.h"
#include "demo/metrics/statistics.h"

namespace demo {
namespace {

using pipeline::PassCounts;

PassCounts counts_of(Studio& studio, const pipeline::Frame& frame) {
    return cloud_counts(frame, studio.run(frame));
}

// As many spheres again, each within another one of the cloud, so that the picture should cost the same to blend.
void double_spheres(SceneCloud& cloud) {
    std::vector<cloud::Particle>& particles = cloud.baked.cloud.particles;
    std::vector<cloud::LitVertex>& vertices = cloud.baked.lit.vertices.edit();
    const std::size_t count = particles.size(), per_particle = count > 0 ? vertices.size() / count : 0;
    for (std::size_t i = 0; i < count; ++i) {
        cloud::Particle inner = particles[i];
        inner.radius *= 0.9f;
        particles.push_back(inner);
        for (std::size_t v = 0; v < per_particle; ++v) {
            cloud::LitVertex vertex = vertices[i * per_particle + v];
            vertex.position         = inner.center + 0.9f * (vertex.position - inner.center);
            vertices.push_back(vertex);
        }
    }
}

// From where the camera stands into the greatest particle.
std::vector<PassCounts> approach(Studio& studio) {
    const Vec3 end = studio.greatest_particle().center, eye = studio.eye(), target = studio.target();
    std::vector<PassCounts> counts;
    for (const float share : {0.0f, 0.3f, 0.6f, 0.75f, 0.85f, 0.95f}) {
        const Vec3 at = eye + (end - eye) * share;
        studio.look_from(at, at + (end - eye));
        counts.push_back(counts_of(studio, studio.frame()));
    }
    studio.look_from(eye, target);
    return counts;
}

double things_moved(const Studio& studio) {
    double particles = 0.0;
    for (const SceneCloud& cloud : studio.clouds())
        particles += static_cast<double>(cloud.baked.cloud.particles.size());
    const auto clouds = static_cast<double>(studio.clouds().size());
    const double size = cloud::SliceOptions().size;
    switch (studio.options().technique) {
        case Technique::MegaParticles:
            return particles;
        case Technique::Sprites:
            return clouds * cloud::SpriteOptions().count;
        case Technique::Slices:
            return clouds * 3.0 * size * size * size;
    }
    return 0.0;
}

}  // namespace

PassCounts cloud_counts(const pipeline::Frame& frame, const pipeline::Execution& execution) {
    PassCounts sum;
    for (std::size_t i = 0; i < frame.passes.size(); ++i) {
        if (!is_cloud_pass(frame.passes[i])) continue;
        PassCounts counts = execution.counts[i];
        if (counts.depth_tested == 0) counts.depth_passed = 0;  // by a test that lets all pass
        for (std::uint64_t PassCounts::*count :
             {&PassCounts::depth_tested, &PassCounts::depth_passed, &PassCounts::color_written, &PassCounts::blended,
              &PassCounts::texels, &PassCounts::bytes, &PassCounts::vertices, &PassCounts::triangles_in})
            sum.*count += counts.*count;
    }
    return sum;
}

void reverse_triangles(pipeline::Frame& frame, const pipeline::Pass& pass) {
    for (const pipeline::Draw& draw : pass.draws) {
        const auto* triangles = std::get_if<pipeline::DrawTriangles>(&draw);
        if (triangles == nullptr) continue;
        const auto first = frame.indices.begin() + triangles->first_index;
        std::reverse(first, first + triangles->index_count);
        // Each triangle turns as before.
        for (auto at = first; at != first + triangles->index_count; at += 3) std::swap(at[0], at[2]);
    }
}

Metrics measure_fill(Studio& studio) {
    Metric layers{"M8.layers", "blended pixels over those of the picture", ""};
    Metric layers_full{"M8.layers_full", "the same from as near as costs most, up to full cover", "", {}, at_most(2.0)};
    Metric spread{"M8.cost_variation", "how much the memory traffic varies on the way into the cloud", "%"};
    Metric bytes{"M8.megabytes", "memory read and written for the clouds of a picture", "MB"};
    Metric texels{"M8.texels", "texels read, over the pixels of the picture", ""};
    Metric slope{"M8.sphere_slope", "blended pixels more, for twice the spheres", "%", {}, Target{0.0, 0.0}};
    Metric depth_ratio{
        "M8.front_to_back", "spheres' pixels that pass the depth test, over those back to front", "", {}, at_most(1.0)};
    Metric hidden{"M8.early_z", "depth-tested pixels that are rejected before any colour is computed", "%"};
    Metric scissored{
        "M8.blur_scissored", "texels that the blur reads, over those without scissor", "", {}, at_most(1.0)};
    Metric moved{"M8.moved", "things that an animation has to move", ""};
    if (studio.has_cloud()) {
        pipeline::Frame frame   = studio.frame();
        const PassCounts counts = counts_of(studio, frame);
        const double pixels     = double{1} * studio.options().size.width * studio.options().size.height;
        const auto over_picture = [&](std::uint64_t count) { return static_cast<double>(count) / pixels; };
        layers.value            = over_picture(counts.blended);
        texels.value            = over_picture(counts.texels);
        bytes.value             = static_cast<double>(counts.bytes) / 1e6;
        if (counts.depth_tested > 0)
            hidden.value =
                100.0 * (1.0 - static_cast<double>(counts.depth_passed) / static_cast<double>(counts.depth_tested));
        moved.value = things_moved(studio);

        std::vector<double> costs;
        double most = 0.0;
        for (const PassCounts& near : approach(studio)) {
            costs.push_back(static_cast<double>(near.bytes));
            most = std::max(most, over_picture(near.blended));
        }
        layers_full.value = most;
        spread.value      = 100.0 * variation(costs);

        if (const std::optional<FoundBlur> blur = find_blur(frame)) {
            const auto texels_of = [&](const pipeline::Frame& drawn) {
                const pipeline::Execution execution = studio.run(drawn);
                std::uint64_t sum                   = 0;
                for (std::size_t i = blur->first; i < blur->end; ++i) sum += execution.counts[i].texels;
                return static_cast<double>(sum);
            };
            const auto passed = [&](const pipeline::Frame& drawn) {
                return static_cast<double>(studio.run(drawn).counts[blur->first - 1].depth_passed);
            };
            const double narrow = texels_of(frame), front_to_back = passed(frame);
            pipeline::Frame whole = frame;
            for (std::size_t i = blur->first; i < blur->end; ++i) whole.passes[i].state.scissor = {};
            scissored.value = narrow / texels_of(whole);
            reverse_triangles(frame, frame.passes[blur->first - 1]);
            if (const double back_to_front = passed(frame); back_to_front > 0.0)
                depth_ratio.value = front_to_back / back_to_front;

            for (SceneCloud& cloud : studio.edit().clouds) double_spheres(cloud);
            const PassCounts doubled = counts_of(studio, studio.frame());
            studio.restore();
            if (counts.blended > 0)
                slope.value =
                    100.0 * (static_cast<double>(doubled.blended) / static_cast<double>(counts.blended) - 1.0);
        }
    }
    return {layers, layers_full, spread, bytes, texels, slope, depth_ratio, hidden, scissored, moved};
}

}  // namespace demo
