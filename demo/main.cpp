// SPDX-License-Identifier: MIT
// nimbus7: runs one command. Exit status: 0 done, 1 a fault of ours, 2 bad input or usage, 3 a chip that cannot do what is
// asked of it; an error is one line on standard error.
#include <cstdio>
#include <exception>
#include <new>
#include <stdexcept>
#include <string>

#include "demo/chip_frame.h"
#include "demo/cli.h"
#include "demo/new_file.h"

namespace {

int report(const std::string& text, int status) {
    std::string line = "nimbus7: " + text;
    for (char& c : line) {
        if (c == '\n' || c == '\r') c = ' ';
    }
    std::fprintf(stderr, "%s\n", line.c_str());
    return status;
}

}  // namespace

int main(int argc, char** argv) {
    demo::clean_up_on_signals();
    try {
        demo::run_command_line(argc, argv);
        return 0;
    } catch (const demo::ChipCannot& reason) {
        std::fputs(reason.details().c_str(), stderr);
        return report(reason.what(), 3);
    } catch (const std::runtime_error& error) {
        return report(error.what(), 2);
    } catch (const std::bad_alloc&) {
        return report("out of memory", 1);
    } catch (const std::exception& error) {
        return report(std::string("internal error: ") + error.what(), 1);
    }
}
