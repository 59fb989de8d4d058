// SPDX-License-Identifier: MIT
// The library's own code, compiled once.
#include <fstream>  // which its writer needs and only includes to read files

#define TINYGLTF_IMPLEMENTATION
#include "demo/tinygltf.h"
