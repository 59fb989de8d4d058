// SPDX-License-Identifier: MIT
// A glTF 2.0 file, `.gltf` or `.glb`, and the numbers in its buffers. As Blender exports it: y up, metres,
// right-handed, front faces counter-clockwise, which is what scenes have. Buffers may be in the file, in data URIs or
// in files beside it.
//
// Each complaint is a SceneError of one line, which begins with the place where the scene names the file and with the
// file: "scenes/x.toml:12:8: cloud.particles: cloud.glb: nodes[3].mesh names no mesh". Only gltf_*.cpp include this.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "demo/scene_data.h"
#include "demo/tinygltf.h"

namespace demo {

// What an accessor must be. Unless `or_normalized`, its numbers must be floats; else integers that stand for 0..1 or
// -1..1 will do too.
struct WantedNumbers {
    std::string what;  // for complaints: "POSITION of mesh 'Cube'"
    int least_components = 1, most_components = 1;
    bool or_normalized = false;
};

struct GltfNumbers {
    std::size_t count = 0, components = 1;
    std::vector<float> values;  // finite
    float at(std::size_t element, std::size_t component) const { return values[element * components + component]; }
};

class GltfFile {
  public:
    // Reads and checks the file and the buffers that it names.
    explicit GltfFile(FileReference file);

    const tinygltf::Model& model() const { return model_; }
    const std::string& path() const { return file_.path; }

    [[noreturn]] void fail(const std::string& reason) const;

    // The element of one of the model's lists; what: "nodes[3].mesh names no mesh".
    template <class Element>
    const Element& find(const std::vector<Element>& list, int index, const std::string& what) const {
        if (index < 0 || static_cast<std::size_t>(index) >= list.size()) fail(what);
        return list[static_cast<std::size_t>(index)];
    }

    // The accessor's elements. Neither reads outside its buffer view, and all calls together read 2^26 numbers at most.
    GltfNumbers read_numbers(int accessor, const WantedNumbers& wanted);
    std::vector<std::uint32_t> read_indices(int accessor, const std::string& what);

    // The path of a file that `uri` names, beside this one.
    std::string path_of(const std::string& uri) const;

  private:
    struct Elements;
    Elements elements(int accessor, const std::string& what);

    FileReference file_;
    tinygltf::Model model_;
    std::size_t may_read_ = std::size_t{1} << 26;
};

}  // namespace demo
