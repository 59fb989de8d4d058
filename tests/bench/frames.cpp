// SPDX-License-Identifier: MIT
#include "tests/bench/frames.h"

#include <stdexcept>

namespace bench {

const std::vector<FrameCase>& frame_cases() {
    static const std::vector<FrameCase> all = [] {
        std::vector<FrameCase> cases;
        for (const auto& part : {fill_cases(), triangle_cases(), scene_cases(), cloud_cases(), image_cases()})
            cases.insert(cases.end(), part.begin(), part.end());
        return cases;
    }();
    return all;
}

const FrameCase& find_frame_case(std::string_view name) {
    for (const FrameCase& each : frame_cases())
        if (each.name == name) return each;
    throw std::invalid_argument("no frame is called " + std::string(name));
}

}  // namespace bench
