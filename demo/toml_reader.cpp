// SPDX-License-Identifier: MIT
#include "demo/toml_reader.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <utility>

namespace demo {
namespace {

std::string decimal(double value) {
    if (std::isnan(value)) return "nan";
    std::array<char, 64> text{};
    const auto end = std::to_chars(text.data(), text.data() + text.size(), value).ptr;
    return {text.data(), end};
}

// A path needs its end: most = npos.
std::string quoted(const std::string& text, std::size_t most = 40) {
    std::string clean = text.size() <= most ? text : text.substr(0, most) + "...";
    std::replace_if(
        clean.begin(), clean.end(), [](char c) { return static_cast<unsigned char>(c) < 0x20 || c == 0x7f; }, ' ');
    return '"' + clean + '"';
}

std::string describe(const toml::node& node) {
    if (const auto* value = node.as_integer()) return std::to_string(value->get());
    if (const auto* value = node.as_floating_point()) return decimal(value->get());
    if (const auto* value = node.as_boolean()) return value->get() ? "true" : "false";
    if (const auto* value = node.as_string()) return quoted(value->get());
    if (const auto* value = node.as_array()) return "an array of " + std::to_string(value->size());
    if (node.is_table()) return "a table";
    return "a date or time";
}

std::string got(const toml::node& node) {
    return " (got " + describe(node) + ")";
}

std::size_t edit_distance(std::string_view a, std::string_view b) {
    std::vector<std::size_t> row(b.size() + 1);
    for (std::size_t j = 0; j <= b.size(); ++j) row[j] = j;
    for (std::size_t i = 1; i <= a.size(); ++i) {
        std::size_t diagonal = row[0];
        row[0]               = i;
        for (std::size_t j = 1; j <= b.size(); ++j) {
            const std::size_t above = row[j];
            row[j]   = std::min({above + 1, row[j - 1] + 1, diagonal + (a[i - 1] == b[j - 1] ? 0u : 1u)});
            diagonal = above;
        }
    }
    return row.back();
}

}  // namespace

std::optional<std::string> nearest_word(std::string_view word, const std::vector<std::string>& known) {
    std::optional<std::string> nearest;
    // A third of the word may be wrong.
    std::size_t least = word.size() / 3 + 2;
    for (const std::string& candidate : known) {
        const std::size_t distance = edit_distance(word, candidate);
        if (distance >= least) continue;
        least   = distance;
        nearest = candidate;
    }
    return nearest;
}

TableReader::TableReader(const toml::table& table, std::string file, std::string name)
    : table_(&table), file_(std::move(file)), name_(std::move(name)) {}

bool TableReader::read(const char* key, double& value, Range range) {
    const toml::node* node = find(key);
    if (node != nullptr) value = number(*node, full_name(key), range);
    return node != nullptr;
}

bool TableReader::read(const char* key, float& value, Range range) {
    double wide      = 0.0;
    const bool there = read(key, wide, range);
    if (there) value = static_cast<float>(wide);
    return there;
}

bool TableReader::read(const char* key, std::optional<float>& value, Range range) {
    float given      = 0.0f;
    const bool there = read(key, given, range);
    if (there) value = given;
    return there;
}

bool TableReader::read(const char* key, int& value, int low, int high) {
    const toml::node* node = find(key);
    if (node != nullptr) value = static_cast<int>(integer(*node, full_name(key), low, high));
    return node != nullptr;
}

bool TableReader::read(const char* key, std::uint32_t& value) {
    const toml::node* node = find(key);
    if (node != nullptr) value = static_cast<std::uint32_t>(integer(*node, full_name(key), 0, 0xffffffffLL));
    return node != nullptr;
}

bool TableReader::read(const char* key, bool& value) {
    const toml::node* node = find(key);
    if (node == nullptr) return false;
    const auto* boolean = node->as_boolean();
    if (boolean == nullptr) fail(key, "must be true or false" + got(*node));
    value = boolean->get();
    return true;
}

bool TableReader::read(const char* key, std::string& value) {
    const toml::node* node = find(key);
    if (node != nullptr) value = text(key, *node);
    return node != nullptr;
}

bool TableReader::read(const char* key, Vec2& value, Range range) {
    const toml::node* node = find(key);
    if (node == nullptr) return false;
    const toml::array& array = array_of(*node, full_name(key), 2, "numbers");
    for (int i = 0; i < 2; ++i)
        value[i] = static_cast<float>(number(array[static_cast<std::size_t>(i)], full_name(key), range));
    return true;
}

bool TableReader::read(const char* key, Vec3& value, Range range) {
    const toml::node* node = find(key);
    if (node == nullptr) return false;
    const toml::array& array = array_of(*node, full_name(key), 3, "numbers");
    for (int i = 0; i < 3; ++i)
        value[i] = static_cast<float>(number(array[static_cast<std::size_t>(i)], full_name(key), range));
    return true;
}

bool TableReader::read(const char* key, std::optional<Vec3>& value, Range range) {
    Vec3 given(0.0f);
    const bool there = read(key, given, range);
    if (there) value = given;
    return there;
}

bool TableReader::read(const char* key, Size& value, int low, int high) {
    const toml::node* node = find(key);
    if (node == nullptr) return false;
    const toml::array& array = array_of(*node, full_name(key), 2, "integers");
    value.width              = static_cast<int>(integer(array[0], full_name(key), low, high));
    value.height             = static_cast<int>(integer(array[1], full_name(key), low, high));
    return true;
}

bool TableReader::read(const char* key, FileReference& value) {
    const toml::node* node = find(key);
    if (node == nullptr) return false;
    namespace fs        = std::filesystem;
    const fs::path path = fs::path(file_).parent_path() / text(key, *node);
    std::error_code error;
    if (!fs::is_regular_file(path, error)) fail(key, "names no file: " + quoted(path.string(), std::string::npos));
    value = {path.string(), place(node->source()) + full_name(key)};
    return true;
}

std::optional<int> TableReader::read_choice(const char* key, std::initializer_list<const char*> names) {
    const toml::node* node = find(key);
    if (node == nullptr) return std::nullopt;
    const std::string word = text(key, *node);
    std::string all;
    int position = 0;
    for (const char* name : names) {
        if (word == name) return position;
        all += (position == 0 ? "" : ", ") + std::string(name);
        ++position;
    }
    fail(key, "must be one of " + all + got(*node));
}

std::vector<std::vector<double>> TableReader::read_rows(const char* key, std::size_t width, std::size_t most) {
    std::vector<std::vector<double>> rows;
    const toml::node* node = find(key);
    if (node == nullptr) return rows;
    const toml::array* array = node->as_array();
    if (array == nullptr) fail(key, "must be an array of arrays of " + std::to_string(width) + " numbers" + got(*node));
    if (array->size() > most) fail(key, "must hold at most " + std::to_string(most) + got(*node));
    for (const toml::node& row : *array) {
        const toml::array& numbers = array_of(row, full_name(key), width, "numbers");
        std::vector<double>& out   = rows.emplace_back();
        for (const toml::node& element : numbers) out.push_back(number(element, full_name(key), kCoordinate));
    }
    return rows;
}

std::optional<TableReader> TableReader::table(const char* key) {
    const toml::node* node = find(key);
    if (node == nullptr) return std::nullopt;
    const toml::table* table = node->as_table();
    if (table == nullptr) fail(key, "must be a table" + got(*node));
    return TableReader(*table, file_, full_name(key));
}

std::vector<TableReader> TableReader::tables(const char* key, std::size_t most) {
    std::vector<TableReader> readers;
    const toml::node* node = find(key);
    if (node == nullptr) return readers;
    const toml::array* array = node->as_array();
    const std::string form   = "must be an array of tables, each [[" + full_name(key) + "]]";
    if (array == nullptr) fail(key, form + got(*node));
    if (array->size() > most)
        fail_at((*array)[most], full_name(key), "may be there at most " + std::to_string(most) + " times");
    for (const toml::node& element : *array) {
        const toml::table* table = element.as_table();
        if (table == nullptr) fail_at(element, full_name(key), form + got(element));
        readers.emplace_back(*table, file_, full_name(key));
    }
    return readers;
}

void TableReader::finish(const std::string& owner) const {
    // In the order of the file, not of the alphabet.
    const toml::key* first = nullptr;
    for (const auto& [key, value] : *table_) {
        if (std::find(asked_.begin(), asked_.end(), key.str()) != asked_.end()) continue;
        if (first == nullptr || key.source().begin < first->source().begin) first = &key;
    }
    if (first == nullptr) return;
    const std::string key(first->str());
    std::string message = place(first->source()) + full_name(quoted(key).substr(1, quoted(key).size() - 2).c_str()) +
                          " is not a key of " + owner;
    if (const auto nearest = nearest_word(key, asked_)) message += " (did you mean '" + *nearest + "'?)";
    throw SceneError(message);
}

void TableReader::fail(const char* key, const std::string& what) const {
    const toml::node* node = table_->get(key);
    fail_at(node != nullptr ? *node : static_cast<const toml::node&>(*table_), full_name(key), what);
}

void TableReader::fail_at_row(const char* key, std::size_t row, const std::string& what) const {
    const toml::array* array = table_->get(key) != nullptr ? table_->get(key)->as_array() : nullptr;
    if (array == nullptr || row >= array->size()) fail(key, what);
    fail_at((*array)[row], full_name(key), what);
}

const toml::node* TableReader::find(const char* key) {
    asked_.emplace_back(key);
    return table_->get(key);
}

double TableReader::number(const toml::node& node, const std::string& name, Range range) const {
    const std::optional<double> value = node.is_number() ? node.value<double>() : std::nullopt;
    if (!value) fail_at(node, name, "must be a number" + got(node));
    if (!std::isfinite(*value)) fail_at(node, name, "must be finite" + got(node));
    if (range.above && *value <= range.low) fail_at(node, name, "must be > " + decimal(range.low) + got(node));
    if (*value < range.low) fail_at(node, name, "must be >= " + decimal(range.low) + got(node));
    if (*value > range.high) fail_at(node, name, "must be <= " + decimal(range.high) + got(node));
    return *value;
}

std::int64_t TableReader::integer(const toml::node& node, const std::string& name, std::int64_t low,
                                  std::int64_t high) const {
    const auto* value = node.as_integer();
    if (value == nullptr) fail_at(node, name, "must be an integer" + got(node));
    if (value->get() < low) fail_at(node, name, "must be >= " + std::to_string(low) + got(node));
    if (value->get() > high) fail_at(node, name, "must be <= " + std::to_string(high) + got(node));
    return value->get();
}

const toml::array& TableReader::array_of(const toml::node& node, const std::string& name, std::size_t size,
                                         const char* kind) const {
    const toml::array* array = node.as_array();
    if (array == nullptr || array->size() != size)
        fail_at(node, name, "must be an array of " + std::to_string(size) + " " + kind + got(node));
    return *array;
}

std::string TableReader::text(const char* key, const toml::node& node) const {
    const auto* value = node.as_string();
    if (value == nullptr) fail(key, "must be a string" + got(node));
    return value->get();
}

std::string TableReader::full_name(const char* key) const {
    return name_.empty() ? key : name_ + "." + key;
}

std::string TableReader::place(const toml::source_region& where) const {
    return file_ + ":" + std::to_string(where.begin.line) + ":" + std::to_string(where.begin.column) + ": ";
}

void TableReader::fail_at(const toml::node& node, const std::string& name, const std::string& what) const {
    throw SceneError(place(node.source()) + name + " " + what);
}

}  // namespace demo
