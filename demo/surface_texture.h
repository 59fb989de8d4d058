// SPDX-License-Identifier: MIT
// The textures of a scene's surfaces, each made or read once and kept in the scene's geometry.
#pragma once

#include <optional>
#include <string>

#include "demo/scene_data.h"

namespace demo {

class TextureLibrary {
  public:
    explicit TextureLibrary(SceneGeometry& geometry) : geometry_(geometry) {}

    // Index of the texture in the geometry; -1 for none. Throws SceneError for a file that cannot be read.
    int find(const SurfaceTexture& surface);
    // What the ground's second stage multiplies the surface by, twice: plants and stones for sand, else slow variation.
    int detail(const SurfaceTexture& surface);
    static Vec2 detail_size(const SurfaceTexture& surface);

    // Metres that one tile covers across and down: given, or the texture's own.
    static Vec2 tile_size(const SurfaceTexture& surface, const std::optional<float>& tile_m);

  private:
    int find_named(const std::string& name) const;
    int add(pipeline::Texture texture);

    SceneGeometry& geometry_;
};

}  // namespace demo
