// SPDX-License-Identifier: MIT
#include "tests/support/include_rules.h"

#include <filesystem>
#include <fstream>
#include <regex>
#include <set>
#include <sstream>
#include <stdexcept>

namespace tests {
namespace {

namespace fs = std::filesystem;

struct Include {
    std::string path;
    bool is_quoted;
};

bool is_in(const std::string& path, const std::string& folder) {
    return path.starts_with(folder);
}

bool is_header(const std::string& path) {
    return path.ends_with(".h");
}

std::vector<Include> includes_of(const std::string& text) {
    static const std::regex pattern(R"(^\s*#\s*include\s*([<"])([^>"]+)[>"])");
    std::vector<Include> includes;
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);) {
        std::smatch match;
        if (std::regex_search(line, match, pattern)) includes.push_back({match[2], match[1] == "\""});
    }
    return includes;
}

// What files below `folder` may include of our own files. The first folder that fits decides.
struct Layer {
    std::string folder;
    std::vector<std::string> may_include;
};
const std::vector<Layer> kLayers = {
    {"raster/", {"raster/"}},
    {"pipeline/frame/", {"pipeline/frame/"}},
    {"pipeline/execute/", {"pipeline/", "raster/"}},
    {"pipeline/truth/", {"pipeline/truth/", "pipeline/frame/"}},
    {"pipeline/", {"pipeline/"}},
    {"cloud/", {"cloud/", "pipeline/frame/"}},
    {"demo/", {"demo/", "cloud/", "pipeline/"}},
    {"tests/", {"tests/", "demo/", "cloud/", "pipeline/", "raster/"}},
};

const Layer* layer_of(const std::string& path) {
    for (const Layer& layer : kLayers) {
        if (is_in(path, layer.folder)) return &layer;
    }
    return nullptr;
}

// The reason against an include of one of our own files, or "".
std::string fault_of_own(const std::string& from, const std::string& to) {
    const Layer* layer = layer_of(from);
    if (!layer) return "the file is in no layer";
    std::string allowed;
    for (const std::string& folder : layer->may_include) {
        if (is_in(to, folder)) return "";
        allowed += (allowed.empty() ? "" : ", ") + folder;
    }
    return layer->folder + " may include only " + allowed;
}

// The same for a header of a library. Those of the standard library have no folder.
std::string fault_of_library(const std::string& from, const std::string& to) {
    if (is_in(to, "hwy/") && is_header(from) && !from.ends_with("-inl.h")) return "a header must not need Highway";
    if (is_in(to, "OpenImageIO/") && from != "demo/image_module.cpp") {
        return "only demo/image_module.cpp may use OpenImageIO";
    }
    const bool is_standard = to.find('/') == std::string::npos;
    if (is_in(from, "cloud/") && !is_standard && !is_in(to, "glm/")) return "cloud/ may use no library but GLM";
    return "";
}

// Depth first; `open` is the way from the start to here.
void find_cycles(const std::string& file, const std::map<std::string, std::vector<std::string>>& edges,
                 std::vector<std::string>& open, std::set<std::string>& done, std::vector<std::string>& faults) {
    for (std::size_t i = 0; i < open.size(); ++i) {
        if (open[i] != file) continue;
        std::string cycle;
        for (std::size_t k = i; k < open.size(); ++k) cycle += open[k] + " -> ";
        faults.push_back("include cycle: " + cycle + file);
        return;
    }
    if (done.count(file) > 0) return;
    open.push_back(file);
    const auto found = edges.find(file);
    if (found != edges.end()) {
        for (const std::string& next : found->second) find_cycles(next, edges, open, done, faults);
    }
    open.pop_back();
    done.insert(file);
}

}  // namespace

Sources read_sources(const std::string& top) {
    Sources sources;
    for (const char* folder : {"raster", "pipeline", "cloud", "demo", "tests"}) {
        for (const fs::directory_entry& entry : fs::recursive_directory_iterator(fs::path(top) / folder)) {
            const std::string extension = entry.path().extension();
            if (!entry.is_regular_file() || (extension != ".h" && extension != ".cpp")) continue;
            std::ifstream file(entry.path());
            std::ostringstream text;
            text << file.rdbuf();
            if (!file) throw std::runtime_error(entry.path().string() + ": cannot be read");
            sources[fs::relative(entry.path(), top).generic_string()] = text.str();
        }
    }
    return sources;
}

std::vector<std::string> include_faults(const Sources& sources) {
    std::vector<std::string> faults;
    std::map<std::string, std::vector<std::string>> edges;
    for (const auto& [from, text] : sources) {
        for (const Include& include : includes_of(text)) {
            const bool is_ours    = layer_of(include.path) != nullptr;
            // Highway is included in quotes by custom.
            const bool is_library = !is_ours && (!include.is_quoted || is_in(include.path, "hwy/"));
            std::string reason;
            if (is_library) {
                reason = fault_of_library(from, include.path);
            } else if (sources.count(include.path) == 0) {
                reason = "there is no such file (paths start at the top of the repository)";
            } else if (!include.is_quoted) {
                reason = "our own files are included in quotes";
            } else {
                reason = fault_of_own(from, include.path);
                edges[from].push_back(include.path);
            }
            if (!reason.empty()) faults.push_back(from + " includes " + include.path + ": " + reason);
        }
    }
    std::set<std::string> done;
    for (const auto& [file, text] : sources) {
        std::vector<std::string> open;
        find_cycles(file, edges, open, done, faults);
    }
    return faults;
}

}  // namespace tests
