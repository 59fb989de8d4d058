// SPDX-License-Identifier: MIT
// A scene's cloud at a moment.
#pragma once

#include "demo/scene_data.h"

namespace demo {

// As the plan says, before anything moves. Particles that stream or come from a file are not in it.
cloud::Cloud grow_cloud(const CloudPlan& plan);

// The cloud at `seconds`; without particles if there is nothing to see.
cloud::Cloud cloud_at(const SceneCloud& scene_cloud, double seconds);

// What its lights throw on the scene around. color: at most 1.
struct ThrownLight {
    Vec3 center, color;
    float range;
};
std::vector<ThrownLight> thrown_lights(const CloudPlan& plan, double seconds);

// Does it need new light as it moves? If not, only what is drawn with each frame anyway changes.
bool reshapes(const CloudPlan& plan);

// A box around a cloud that reshapes, at 121 moments from 0 to `last_s` or to where its motion ends or repeats; relative
// to the offset of its keys.
cloud::Box box_over_time(const SceneCloud& scene_cloud, double last_s);

// Does it move in any way?
bool moves(const CloudPlan& plan);

}  // namespace demo
