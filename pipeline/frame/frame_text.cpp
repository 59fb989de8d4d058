// SPDX-License-Identifier: MIT
#include "pipeline/frame/frame_text.h"

#include "pipeline/frame/text_reader.h"
#include "pipeline/frame/text_writer.h"

namespace pipeline {

std::string to_text(const Frame& frame) {
    const FrameNames names(frame);
    TextWriter writer(names);
    writer.append("nimbus7 frame 1\n");
    writer.write_top_level(frame);
    return writer.take();
}

Frame parse_frame(std::string_view text) {
    Frame frame;
    TextReader reader(text);
    reader.read_first_line();
    reader.read_top_level(frame);
    return frame;
}

}  // namespace pipeline
