// SPDX-License-Identifier: MIT
#include "tests/peers/known_differences.h"

#include <fstream>
#include <sstream>
#include <stdexcept>

namespace peers {

std::vector<KnownDifference> parse_known_differences(const std::string& text, const std::string& path) {
    std::vector<KnownDifference> list;
    std::istringstream lines(text);
    int number = 0;
    for (std::string line; std::getline(lines, line);) {
        ++number;
        if (line.empty() || line[0] == '#') continue;
        std::istringstream words(line);
        KnownDifference known;
        words >> known.frame >> known.driver >> known.pixels >> known.units >> std::ws;
        std::getline(words, known.reason);
        if (known.reason.empty() || known.pixels == 0 || known.units <= 0)
            throw std::runtime_error(path + ':' + std::to_string(number) +
                                     ": must be <frame> <driver> <pixels> <units> <reason>");
        list.push_back(known);
    }
    return list;
}

std::vector<KnownDifference> read_known_differences(const std::string& path) {
    std::ifstream file(path);
    std::ostringstream text;
    text << file.rdbuf();
    if (!file) throw std::runtime_error(path + ": cannot be read");
    return parse_known_differences(text.str(), path);
}

Verdict judge(const Comparison& comparison, const KnownDifference* known) {
    if (comparison.failed == 0) return known != nullptr ? Verdict::Stale : Verdict::Ok;
    if (known == nullptr || comparison.failed > known->pixels || comparison.worst.units > known->units)
        return Verdict::Failed;
    return Verdict::Known;
}

}  // namespace peers
