// SPDX-License-Identifier: MIT
#include "demo/command_dump.h"

#include "demo/frame_source.h"
#include "demo/new_file.h"
#include "demo/standard_output.h"
#include "pipeline/frame/frame_text.h"

namespace demo {

void dump(const DumpOptions& options) {
    const FrameSource source(options.scene);
    const std::string text = pipeline::to_text(source.frame(options.size, options.frame, options.changes));
    if (options.output) {
        write_file(*options.output, text);
    } else {
        print(text);
    }
}

}  // namespace demo
