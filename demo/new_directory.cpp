// SPDX-License-Identifier: MIT
#include "demo/new_directory.h"

#include <fcntl.h>
#include <pthread.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <stdexcept>

#include "demo/new_file.h"

namespace demo {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void fail(const std::string& path, const std::string& reason) {
    throw std::runtime_error(path + ": " + reason);
}

// The directory that `path` means: links are followed, a slash at the end says nothing.
fs::path resolve(const std::string& path) {
    std::error_code error;
    if (const fs::path there = fs::canonical(path, error); !error) return there;
    fs::path wanted = fs::path(path).lexically_normal();
    if (!wanted.has_filename()) wanted = wanted.parent_path();
    return wanted;
}

fs::path parent_of(const fs::path& path) {
    return path.has_parent_path() ? path.parent_path() : fs::path(".");
}

class BlockedSignals {
  public:
    BlockedSignals() {
        sigset_t signals;
        sigemptyset(&signals);
        for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGPIPE}) sigaddset(&signals, signal);
        pthread_sigmask(SIG_BLOCK, &signals, &before_);
    }
    ~BlockedSignals() { pthread_sigmask(SIG_SETMASK, &before_, nullptr); }
    BlockedSignals(const BlockedSignals&)            = delete;
    BlockedSignals& operator=(const BlockedSignals&) = delete;

  private:
    sigset_t before_;
};

// Removed at the end with all that is in it.
struct Temporary {
    fs::path path;
    ~Temporary() {
        std::error_code error;
        fs::remove_all(path, error);
    }
};

// What stands at `place` is at `with` afterwards.
void exchange(const fs::path& with, const fs::path& place, const std::string& name) {
    if (renameat2(AT_FDCWD, with.c_str(), AT_FDCWD, place.c_str(), RENAME_EXCHANGE) == 0) return;
    if (errno != EINVAL && errno != ENOSYS) fail(name, std::strerror(errno));
    // A file system that cannot: in three steps.
    const fs::path aside = with.string() + "-old";
    std::error_code error;
    fs::rename(place, aside, error);
    if (error) fail(name, error.message());
    fs::rename(with, place, error);
    if (error) {
        const std::string reason = error.message();
        fs::rename(aside, place, error);
        fail(name, reason);
    }
    fs::rename(aside, with, error);
}

}  // namespace

void check_new_directory(const std::string& path, const std::vector<std::string>& names) {
    if (path.empty()) fail("output", "the path is empty");
    std::error_code error;
    const fs::path place = resolve(path), parent = parent_of(place);
    if (fs::exists(place, error)) {
        if (!fs::is_directory(place, error)) fail(path, "is not a directory");
        fs::directory_iterator entries(place, error);
        if (error) fail(path, error.message());
        for (const fs::directory_entry& entry : entries)
            if (std::find(names.begin(), names.end(), entry.path().filename().string()) == names.end())
                fail(path, "holds " + entry.path().filename().string() + ", which would be lost");
    }
    if (!fs::exists(parent, error)) fail(path, "directory " + parent.string() + " does not exist");
    if (!fs::is_directory(parent, error)) fail(path, parent.string() + " is not a directory");
    if (access(parent.c_str(), W_OK | X_OK) != 0)
        fail(path, "directory " + parent.string() + ": " + std::strerror(errno));
}

void write_directory(const std::string& path, const NamedFiles& files) {
    std::vector<std::string> names;
    for (const auto& [name, bytes] : files) names.push_back(name);
    const BlockedSignals blocked;
    check_new_directory(path, names);
    const fs::path place = resolve(path);
    const auto now       = std::chrono::system_clock::now().time_since_epoch().count();
    const Temporary temporary{parent_of(place) /
                              (".nimbus7-" + std::to_string(getpid()) + "-" + std::to_string(now) + ".d")};
    if (mkdir(temporary.path.c_str(), 0777) != 0) fail(path, std::strerror(errno));
    for (const auto& [name, bytes] : files) {
        try {
            write_file((temporary.path / name).string(), bytes);
        } catch (const std::runtime_error& error) {
            std::string reason   = error.what();
            const std::size_t at = reason.find(temporary.path.string());
            if (at != std::string::npos) reason.replace(at, temporary.path.string().size(), path);
            throw std::runtime_error(reason);
        }
    }
    std::error_code error;
    if (fs::exists(place, error)) {
        exchange(temporary.path, place, path);
    } else if (rename(temporary.path.c_str(), place.c_str()) != 0) {
        fail(path, std::strerror(errno));
    }
}

}  // namespace demo
