// SPDX-License-Identifier: MIT
// The library tinygltf, which takes a glTF file's JSON apart. It is a header: what its classes hold depends on these
// words, so all that use it include this file. Files and pictures are read by our own code. Only gltf_*.cpp include
// this.
#pragma once

#define TINYGLTF_NO_STB_IMAGE
#define TINYGLTF_NO_STB_IMAGE_WRITE
#define TINYGLTF_NO_EXTERNAL_IMAGE
#define TINYGLTF_NO_FS
#include <tiny_gltf.h>
