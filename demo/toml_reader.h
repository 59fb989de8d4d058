// SPDX-License-Identifier: MIT
// Strict reading of one TOML table: each key is asked for once, with its type and range; what was never asked for is
// unknown. Every complaint is a SceneError of one line that starts with the file, the line and the column of the value:
// "scenes/x.toml:12:8: cloud.blur must be >= 0 (got -3)". Only scene_file.cpp includes this.
#pragma once

#include <cstdint>
#include <functional>
#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <toml++/toml.h>

#include "demo/scene_data.h"

namespace demo {

// Inclusive bounds, but for above: then low itself is refused.
struct Range {
    double low, high;
    bool above = false;
};
inline constexpr Range kCoordinate{-1e5, 1e5};
inline constexpr Range kLength{0.0, 1e5, true};
inline constexpr Range kShare{0.0, 1.0};

class TableReader {
  public:
    // file: as the user named it. name: the table's, "camera"; empty for the whole file.
    TableReader(const toml::table& table, std::string file, std::string name);

    // Each leaves `value` as it is where the key is absent, and tells whether it was there.
    bool read(const char* key, float& value, Range range);
    bool read(const char* key, double& value, Range range);
    bool read(const char* key, int& value, int low, int high);
    bool read(const char* key, std::uint32_t& value);
    bool read(const char* key, bool& value);
    bool read(const char* key, std::string& value);
    bool read(const char* key, std::optional<float>& value, Range range);
    bool read(const char* key, Vec2& value, Range range);
    bool read(const char* key, Vec3& value, Range range);
    bool read(const char* key, std::optional<Vec3>& value, Range range);
    bool read(const char* key, Size& value, int low, int high);
    bool read(const char* key, FileReference& value);

    // One of `names`: its position among them.
    std::optional<int> read_choice(const char* key, std::initializer_list<const char*> names);

    // Rows of `width` numbers, all finite; the caller looks closer, with fail_at_row.
    std::vector<std::vector<double>> read_rows(const char* key, std::size_t width, std::size_t most);

    std::optional<TableReader> table(const char* key);
    std::vector<TableReader> tables(const char* key, std::size_t most);

    // Complains of the first key that nobody asked for. owner: "[camera]", "a box".
    void finish(const std::string& owner) const;

    // what: "must be > camera.near"; the place is the key's value, or the table where there is no such key.
    [[noreturn]] void fail(const char* key, const std::string& what) const;
    [[noreturn]] void fail_at_row(const char* key, std::size_t row, const std::string& what) const;

  private:
    const toml::node* find(const char* key);
    double number(const toml::node& node, const std::string& name, Range range) const;
    std::int64_t integer(const toml::node& node, const std::string& name, std::int64_t low, std::int64_t high) const;
    const toml::array& array_of(const toml::node& node, const std::string& name, std::size_t size,
                                const char* kind) const;
    std::string text(const char* key, const toml::node& node) const;
    std::string full_name(const char* key) const;
    std::string place(const toml::source_region& where) const;
    [[noreturn]] void fail_at(const toml::node& node, const std::string& name, const std::string& what) const;

    const toml::table* table_;
    std::string file_, name_;
    std::vector<std::string> asked_;
};

// The one of `known` that `word` is most likely a misspelling of, if any is near.
std::optional<std::string> nearest_word(std::string_view word, const std::vector<std::string>& known);

}  // namespace demo
