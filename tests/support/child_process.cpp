// SPDX-License-Identifier: MIT
#include "tests/support/child_process.h"

#include <fcntl.h>
#include <sys/ptrace.h>
#include <sys/resource.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <thread>

namespace tests {
namespace {

namespace fs = std::filesystem;

// Between fork and exec: system calls alone.
[[noreturn]] void become(const char* program, char* const* arguments, const char* directory, const char* out,
                         const char* error, const RunOptions& options) {
    const int out_file   = open(options.has_full_output ? "/dev/full" : out, O_WRONLY | O_CREAT | O_TRUNC, 0600);
    const int error_file = open(error, O_WRONLY | O_CREAT | O_TRUNC, 0600);
    if (out_file < 0 || error_file < 0 || dup2(out_file, 1) < 0 || dup2(error_file, 2) < 0) _exit(126);
    if (chdir(directory) != 0) _exit(126);
    signal(SIGINT, SIG_DFL);  // a test run in the background has it ignored
    if (options.max_file_bytes > 0) {
        const rlimit limit{static_cast<rlim_t>(options.max_file_bytes), static_cast<rlim_t>(options.max_file_bytes)};
        if (setrlimit(RLIMIT_FSIZE, &limit) != 0) _exit(126);
    }
    if (options.interrupt_in_midst != Midst::Never && ptrace(PTRACE_TRACEME, 0, nullptr, nullptr) != 0) _exit(126);
    execv(program, arguments);
    _exit(127);
}

// Follows the child's main thread from one system call to the next, up to that which makes a new file, or the first that
// writes to it; the signal reaches the child when the call has been done.
void interrupt_in_midst(pid_t child, Midst midst) {
    bool is_made = false;
    for (;;) {
        siginfo_t info{};
        // Leaves a child that has ended to the caller.
        if (waitid(P_PID, static_cast<id_t>(child), &info, WEXITED | WSTOPPED | WNOWAIT) != 0) return;
        if (info.si_code != CLD_TRAPPED && info.si_code != CLD_STOPPED) return;
        int state = 0;
        waitpid(child, &state, 0);
        const int stopped_by = WSTOPSIG(state);
        __ptrace_syscall_info call{};
        ptrace(PTRACE_SETOPTIONS, child, nullptr, PTRACE_O_TRACESYSGOOD | PTRACE_O_EXITKILL);
        ptrace(PTRACE_GET_SYSCALL_INFO, child, sizeof call, &call);
        if (stopped_by == (SIGTRAP | 0x80) && call.op == PTRACE_SYSCALL_INFO_ENTRY) {
            const bool makes  = call.entry.nr == SYS_openat && (call.entry.args[2] & O_EXCL) != 0;
            const bool writes = is_made && call.entry.nr == SYS_write;
            is_made           = is_made || makes;
            if (midst == Midst::Made ? makes : writes) {
                // To that thread: another would take a signal to the process, and end it too late.
                syscall(SYS_tgkill, child, child, SIGINT);
                ptrace(PTRACE_DETACH, child, nullptr, nullptr);
                return;
            }
        }
        const bool is_own = stopped_by == (SIGTRAP | 0x80) || stopped_by == SIGTRAP;  // exec stops by the second
        ptrace(PTRACE_SYSCALL, child, nullptr, is_own ? 0 : stopped_by);
    }
}

}  // namespace

ScratchDirectory::ScratchDirectory() {
    path_ = (fs::temp_directory_path() / "nimbus7-test-XXXXXX").string();
    if (!mkdtemp(path_.data())) throw std::runtime_error("no scratch directory: " + path_);
}

ScratchDirectory::~ScratchDirectory() {
    std::error_code error;
    fs::remove_all(path_, error);
}

std::vector<std::string> ScratchDirectory::files() const {
    std::vector<std::string> names;
    for (const fs::directory_entry& entry : fs::directory_iterator(path_)) names.push_back(entry.path().filename());
    std::sort(names.begin(), names.end());
    return names;
}

std::string read_file(const std::string& path) {
    std::ifstream file(path, std::ios::binary);
    if (!file) throw std::runtime_error(path + ": cannot be read");
    std::ostringstream text;
    text << file.rdbuf();
    return text.str();
}

void write_file(const std::string& path, const std::string& text) {
    std::ofstream file(path, std::ios::binary);
    file << text;
    if (!file.flush()) throw std::runtime_error(path + ": cannot be written");
}

Ended run_program(const std::string& program, const std::vector<std::string>& arguments, const std::string& directory,
                  const RunOptions& options) {
    const ScratchDirectory streams;
    const std::string out = streams / "out", error = streams / "error";
    std::vector<std::string> words{program};
    words.insert(words.end(), arguments.begin(), arguments.end());
    std::vector<char*> pointers;
    for (std::string& word : words) pointers.push_back(word.data());
    pointers.push_back(nullptr);

    const pid_t child = fork();
    if (child < 0) throw std::runtime_error("fork failed");
    if (child == 0) {
        become(program.c_str(), pointers.data(), directory.c_str(), out.c_str(), error.c_str(), options);
    }
    if (options.interrupt_in_midst != Midst::Never) interrupt_in_midst(child, options.interrupt_in_midst);
    if (options.interrupt_after_ms > 0) {
        std::this_thread::sleep_for(std::chrono::milliseconds(options.interrupt_after_ms));
        kill(child, SIGINT);
    }
    int state = 0;
    if (waitpid(child, &state, 0) != child) throw std::runtime_error("waitpid failed");
    const int status = WIFEXITED(state) ? WEXITSTATUS(state) : 128 + WTERMSIG(state);
    return {status, options.has_full_output ? std::string() : read_file(out), read_file(error)};
}

}  // namespace tests
