// SPDX-License-Identifier: MIT
// The list of what a frame's text may say.
#include "pipeline/frame/frame_fields.h"

#include <catch2/catch.hpp>
#include <sstream>

#include "pipeline/frame/field_traits.h"

using namespace pipeline;

namespace {

// Every line without indentation and what follows the first blank: the names in their order.
std::vector<std::string> names_of(const std::string& text) {
    std::vector<std::string> names;
    std::istringstream in(text);
    for (std::string line; std::getline(in, line);) {
        const std::size_t start = line.find_first_not_of(' ');
        if (start < 32) names.push_back(line.substr(start, line.find(' ', start) - start));
    }
    return names;
}

template <FieldStruct Struct>
std::size_t count_leaves(const Struct& value);

template <class T>
std::size_t leaves_of(const T& field) {
    if constexpr (FieldStruct<T>) {
        return count_leaves(field);
    } else if constexpr (kIsVariant<T>) {
        return count_leaves(DrawTriangles{}) + count_leaves(DrawRectangle{}) + count_leaves(CopyRectangle{}) +
               count_leaves(DrawWindowTriangles{});
    } else if constexpr (kIsList<T> || kIsArray<T>) {
        return leaves_of(typename T::value_type{});
    } else {
        return 1;
    }
}
template <FieldStruct Struct>
std::size_t count_leaves(const Struct& value) {
    std::size_t count = 0;
    visit_fields(value, [&](std::string_view, const auto& field) { count += leaves_of(field); });
    return count;
}

}  // namespace

TEST_CASE("every field of a frame is listed with what it is when it is left out", "[frame]") {
    const std::string text = describe_fields();
    std::size_t leaves     = 0;
    std::istringstream in(text);
    for (std::string line; std::getline(in, line);) {
        CHECK(line.size() <= 118);
        leaves += line.find_first_not_of(' ') < 32 && line.size() > 32;
    }
    CHECK(leaves == count_leaves(Frame{}));
    for (const char* line :
         {"\n    filter                      REFERENCE8      REFERENCE8 GS_FLOOR4 GS_NEAREST4 ",
          "\n        gs_blend\n            a                   CS              CS CD ZERO\n",
          "\n            matrix[16]          0               an integer\n",
          "\n        copy\n            source              none            \"name\", #number or none\n",
          "\n    view                        identity        4x4, rows as on paper\n",
          "\n    position                    (0 0 0)         3 numbers\n"})
        CHECK(text.find(line) != std::string::npos);
    const std::vector<std::string> names = names_of(text);
    CHECK(names.front() == "output");
    CHECK(names.back() == "indices[]");
}
