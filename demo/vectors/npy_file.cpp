// SPDX-License-Identifier: MIT
#include "demo/vectors/npy_file.h"

#include <cassert>
#include <functional>
#include <numeric>

namespace demo {

std::string to_npy(std::span<const std::size_t> shape, std::span<const std::uint8_t> values) {
    assert(std::accumulate(shape.begin(), shape.end(), std::size_t{1}, std::multiplies<>()) == values.size());
    std::string dictionary = "{'descr': '|u1', 'fortran_order': False, 'shape': (";
    for (const std::size_t size : shape) dictionary += std::to_string(size) + ", ";
    dictionary += "), }";
    // Magic, version, and the length of what follows: two bytes, the lower first.
    std::string file("\x93NUMPY\x01\x00", 8);
    const std::size_t length = kNpyHeaderBytes - file.size() - 2;
    file += static_cast<char>(length & 0xff);
    file += static_cast<char>(length >> 8);
    assert(dictionary.size() < length);
    dictionary.resize(length - 1, ' ');
    file.reserve(kNpyHeaderBytes + values.size());
    file += dictionary;
    file += '\n';
    file.append(reinterpret_cast<const char*>(values.data()), values.size());
    return file;
}

}  // namespace demo
