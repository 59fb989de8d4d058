// SPDX-License-Identifier: MIT
// What the SCENE argument of a command names: a built-in scene, a scene file, or a frame that `nimbus7 dump` wrote
// (known by its first line). All give valid frames. Errors are std::runtime_error with the place and the reason.
#pragma once

#include <optional>
#include <string>

#include "demo/scene.h"
#include "pipeline/frame/frame.h"

namespace demo {

class FrameSource {
  public:
    // limit: how many times pipeline::kMostWork a frame may take.
    explicit FrameSource(const std::string& scene, int limit = 1);

    // The scene without directory and extension: the stem of default output names.
    const std::string& name() const { return name_; }
    bool is_dumped_frame() const { return dumped_.has_value(); }

    // A dumped frame has no other size than its own, no other frame than itself, and no options.
    pipeline::Frame frame(std::optional<Size> size, int index, const FrameOptions& options = {}) const;

  private:
    void require_valid(const pipeline::Frame& frame) const;

    std::string argument_, name_;
    int limit_;
    ScenePtr scene_;
    std::optional<pipeline::Frame> dumped_;
};

}  // namespace demo
