// SPDX-License-Identifier: MIT
#include "demo/new_file.h"

#include <fcntl.h>
#include <pthread.h>
#include <sys/stat.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <chrono>
#include <climits>
#include <csignal>
#include <cstring>
#include <deque>
#include <filesystem>
#include <stdexcept>

namespace demo {
namespace {

namespace fs = std::filesystem;

// A temporary file that a signal must remove. A signal handler may touch no std::string, hence the buffer; the path is
// in place before the flag is set and before the file is made, and no path is used twice.
struct Unfinished {
    char path[PATH_MAX];
    std::atomic<bool> is_there{false};
};
Unfinished unfinished[kMaxFilesTogether];
static_assert(std::atomic<bool>::is_always_lock_free);
pthread_t main_thread;

void clean_up(int signal) {
    // Only the main thread makes files: running there, the handler cannot be overtaken by one that is being made.
    if (!pthread_equal(pthread_self(), main_thread)) {
        pthread_kill(main_thread, signal);
        return;
    }
    for (const Unfinished& file : unfinished)
        if (file.is_there) unlink(file.path);
    _exit(128 + signal);
}

[[noreturn]] void fail(const std::string& path, const std::string& reason) {
    throw std::runtime_error(path + ": " + reason);
}

fs::path directory_of(const fs::path& path) {
    return path.has_parent_path() ? path.parent_path() : fs::path(".");
}

// The file that `path` means: a link is followed, so that it stays a link.
fs::path resolve(const std::string& path) {
    std::error_code error;
    const fs::path target = fs::canonical(path, error);
    return error ? fs::path(path) : target;
}

void write_all(int file, std::string_view text, const std::string& path) {
    while (!text.empty()) {
        const ssize_t written = write(file, text.data(), text.size());
        if (written < 0 && errno == EINTR) continue;
        if (written < 0) fail(path, std::strerror(errno));
        text.remove_prefix(static_cast<std::size_t>(written));
    }
}

}  // namespace

void check_output(const std::string& path) {
    if (path.empty()) fail("output", "the path is empty");
    std::error_code error;
    const fs::file_status status = fs::status(path, error);
    if (fs::is_directory(status)) fail(path, "is a directory");
    if (fs::exists(status)) {
        if (!fs::is_regular_file(status)) fail(path, "is not a regular file");
        if (access(path.c_str(), W_OK) != 0) fail(path, std::strerror(errno));
    }
    const std::string directory = directory_of(resolve(path));
    if (!fs::exists(directory, error)) fail(path, "directory " + directory + " does not exist");
    if (!fs::is_directory(directory, error)) fail(path, directory + " is not a directory");
    if (access(directory.c_str(), W_OK | X_OK) != 0) fail(path, "directory " + directory + ": " + std::strerror(errno));
}

namespace {

struct OpenFile {
    int number;
    ~OpenFile() {
        if (number >= 0) close(number);
    }
};

class NewFile {
  public:
    NewFile(const std::string& path, Unfinished& slot) : path_(path), unfinished_(slot) {
        check_output(path);
        target_          = resolve(path);
        // Unique among processes that share the directory but not their numbering, such as containers.
        static int count = 0;
        const auto now   = std::chrono::system_clock::now().time_since_epoch().count();
        temporary_ = directory_of(target_) / (".nimbus7-" + std::to_string(getpid()) + "-" + std::to_string(now) + "-" +
                                              std::to_string(count++));
        if (temporary_.size() >= sizeof unfinished_.path) fail(path_, std::strerror(ENAMETOOLONG));
        std::memcpy(unfinished_.path, temporary_.c_str(), temporary_.size() + 1);
        unfinished_.is_there = true;
    }
    ~NewFile() {
        if (!is_committed_ && is_made_) unlink(temporary_.c_str());
        unfinished_.is_there = false;
    }
    NewFile(const NewFile&)            = delete;
    NewFile& operator=(const NewFile&) = delete;

    void write(std::string_view bytes) {
        const OpenFile file{open(temporary_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666)};
        if (file.number < 0) fail(path_, std::strerror(errno));
        is_made_ = true;
        struct stat old;
        if (stat(target_.c_str(), &old) == 0) fchmod(file.number, old.st_mode & 07777);
        write_all(file.number, bytes, path_);
    }

    void commit() {
        if (rename(temporary_.c_str(), target_.c_str()) != 0) fail(path_, std::strerror(errno));
        is_committed_ = true;
    }

  private:
    std::string path_, target_, temporary_;
    Unfinished& unfinished_;
    bool is_made_ = false, is_committed_ = false;
};

// /dev/stdout may stand for a regular file that a shell has open.
bool is_written_as_it_is(const std::string& path) {
    std::error_code error;
    return path.starts_with("/dev/") || fs::is_fifo(path, error);
}

void write_as_it_is(const FileToWrite& to_write) {
    const OpenFile file{open(to_write.path.c_str(), O_WRONLY | O_CLOEXEC)};
    if (file.number < 0) fail(to_write.path, std::strerror(errno));
    write_all(file.number, to_write.bytes, to_write.path);
}

}  // namespace

void write_files(std::span<const FileToWrite> files) {
    if (files.size() > kMaxFilesTogether) throw std::logic_error("too many files to write together");
    std::deque<NewFile> made;
    for (const FileToWrite& file : files)
        if (!is_written_as_it_is(file.path)) made.emplace_back(file.path, unfinished[made.size()]).write(file.bytes);
    for (const FileToWrite& file : files)
        if (is_written_as_it_is(file.path)) write_as_it_is(file);
    for (NewFile& file : made) file.commit();
}

void write_file(const std::string& path, std::string_view bytes) {
    const FileToWrite file{path, bytes};
    write_files({&file, 1});
}

void clean_up_on_signals() {
    main_thread = pthread_self();
    struct sigaction action {};
    action.sa_handler = &clean_up;
    sigfillset(&action.sa_mask);
    action.sa_flags = SA_RESTART;
    for (int signal : {SIGINT, SIGTERM, SIGHUP, SIGPIPE}) {
        // A signal that our parent chose to ignore (nohup) stays ignored.
        struct sigaction inherited {};
        sigaction(signal, nullptr, &inherited);
        if (inherited.sa_handler != SIG_IGN) sigaction(signal, &action, nullptr);
    }
    std::signal(SIGXFSZ, SIG_IGN);
}

}  // namespace demo
