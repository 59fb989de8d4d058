// SPDX-License-Identifier: MIT
#include "tests/bench/table.h"

#include <cstdio>

namespace bench {

namespace {

constexpr std::string_view kOurs = "nimbus7", kThreads = "threads:";

// "frame/canyon_1080p/nimbus7/threads:2" taken apart. What has no implementation in its name is all `frame_case`.
struct Name {
    std::string frame_case, implementation, threads;
};
Name taken_apart(std::string name) {
    Name parts;
    const auto last = [&] { return name.substr(name.rfind('/') + 1); };
    if (last().starts_with(kThreads)) {
        parts.threads = last().substr(kThreads.size());
        name.resize(name.rfind('/'));
    }
    parts.frame_case     = name.substr(0, name.rfind('/'));
    parts.implementation = last();
    return parts;
}

std::string case_text(const Name& name) {
    return name.frame_case + (name.threads.empty()  ? ""
                              : name.threads == "1" ? ", 1 thread"
                                                    : ", " + name.threads + " threads");
}

std::string rate_text(const Figure& figure) {
    const bool billions = figure.rate >= 1e9;
    char text[64];
    std::snprintf(text, sizeof text, "%.3g %s%s/s", figure.rate / (billions ? 1e9 : 1e6), billions ? "G" : "M",
                  figure.unit == "pixels" ? "pixel" : "triangle");
    return text;
}

std::string value_text(const Figure& figure) {
    return figure.rate > 0.0 ? rate_text(figure) : format_time(figure.seconds);
}

// A peer that is timed on one thread alone does not name its threads.
bool are_beside(const Name& ours, const Name& peer) {
    return ours.implementation == kOurs && peer.implementation != kOurs && ours.frame_case == peer.frame_case &&
           (ours.threads == peer.threads || peer.threads.empty());
}

std::string comparison_row(const Figure& ours, const Figure& peer) {
    const Name name = taken_apart(ours.name), peer_name = taken_apart(peer.name);
    char ratio[32];
    std::snprintf(ratio, sizeof ratio, "%.2f", peer.seconds / ours.seconds);
    return "| " + case_text(name) + " | " + value_text(ours) + " | " + peer_name.implementation + " " +
           value_text(peer) + " | " + ratio + " |\n";
}

}  // namespace

std::string to_table(const std::vector<Figure>& figures) {
    std::string comparisons, alone;
    for (const Figure& figure : figures) {
        bool has_other = false;
        for (const Figure& other : figures) {
            const Name name = taken_apart(figure.name), other_name = taken_apart(other.name);
            if (are_beside(name, other_name)) comparisons += comparison_row(figure, other);
            has_other = has_other || are_beside(name, other_name) || are_beside(other_name, name);
        }
        if (has_other) continue;
        alone += "| " + figure.name + " | " + format_time(figure.seconds) + " | " +
                 (figure.rate > 0.0 ? rate_text(figure) : "") + " |\n";
    }
    std::string table;
    if (!comparisons.empty())
        table += "| case | nimbus7 | peer | times as fast |\n| --- | ---: | ---: | ---: |\n" + comparisons;
    if (!comparisons.empty() && !alone.empty()) table += "\n";
    if (!alone.empty()) table += "| case | time | rate |\n| --- | ---: | ---: |\n" + alone;
    return table;
}

}  // namespace bench
