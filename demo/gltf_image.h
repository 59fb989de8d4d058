// SPDX-License-Identifier: MIT
// Pictures of a glTF file as textures: PNG or JPEG in the file, or any picture beside it that image_file.h reads.
// Their bytes are taken as they are, alpha too; they repeat in both directions, whatever the file's samplers say.
// Only gltf_*.cpp include this.
#pragma once

#include "demo/gltf_file.h"
#include "pipeline/frame/frame.h"

namespace demo {

// texture: an index into the file's textures. The name is the file's and the picture's: "models/rock.glb#2".
pipeline::Texture read_gltf_texture(const GltfFile& file, int texture);

}  // namespace demo
