// SPDX-License-Identifier: MIT
// Writes a stream, and leaves out registers that hold their value already.
#pragma once

#include <map>

#include "pipeline/emit/gs_stream.h"

namespace pipeline {

class GsBuilder {
  public:
    void group(std::string label);  // what registers hold is forgotten, so that a group can be read by itself
    void step(std::string what);    // of the group

    // write: always; set: if the register does not hold it.
    void write(GsReg reg, std::uint64_t value);
    void write(GsReg reg, std::initializer_list<GsFieldValue> fields) { write(reg, encode(reg, fields)); }
    void set(GsReg reg, std::uint64_t value);
    void set(GsReg reg, std::initializer_list<GsFieldValue> fields) { set(reg, encode(reg, fields)); }

    void image(std::vector<std::uint8_t> bytes);

    GsStream take() { return std::move(stream_); }

  private:
    GsStream stream_;
    std::map<GsReg, std::uint64_t> held_;
};

}  // namespace pipeline
