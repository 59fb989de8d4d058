// SPDX-License-Identifier: MIT
// The pictures of a frame's passes as files in one directory: for each pass that draws colour "NN_label.png", its
// alpha in grey as "NN_label_alpha.png", and all of them on "contact_sheet.png". NN counts from 0, as in the frame's
// text.
#pragma once

#include <cstddef>
#include <string>

#include "demo/contact_sheet.h"
#include "pipeline/execute/execute.h"

namespace demo {

class PassPictures {
  public:
    // Makes the directory if its parent is there. passes: how many the frame has.
    PassPictures(const std::string& directory, std::size_t passes);

    void add(const pipeline::FinishedPass& pass);
    void finish();  // writes the contact sheet

  private:
    std::string directory_;
    std::size_t digits_;
    ContactSheet sheet_;
};

// A label as part of a file name: letters, digits, '.', '_' and '-' stay, any other run of characters becomes one '-'.
std::string file_name_of(const std::string& label);

}  // namespace demo
