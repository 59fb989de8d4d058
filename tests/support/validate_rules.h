// SPDX-License-Identifier: MIT
// Rules of validate, each tried by one change to a valid frame and exactly the findings that it must give.
#pragma once

#include <catch2/catch.hpp>
#include <functional>
#include <string>
#include <vector>

#include "pipeline/validate/validate.h"

namespace test_support {

struct Rule {
    const char* name;
    std::function<void(pipeline::Frame&)> break_it;
    std::vector<pipeline::Finding> findings;
};

inline std::string text_of(const std::vector<pipeline::Finding>& findings) {
    std::string text;
    for (const pipeline::Finding& finding : findings) text += finding.where + ": " + finding.what + "\n";
    return text;
}

inline void check_rules(pipeline::Frame (*valid_frame)(), const std::vector<Rule>& rules) {
    for (const Rule& rule : rules) {
        INFO(rule.name);
        pipeline::Frame frame = valid_frame();
        rule.break_it(frame);
        CHECK(text_of(pipeline::validate(frame)) == text_of(rule.findings));
    }
}

}  // namespace test_support
