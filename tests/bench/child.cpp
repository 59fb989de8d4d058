// SPDX-License-Identifier: MIT
#include "tests/bench/child.h"

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <csignal>
#include <stdexcept>

namespace bench {

namespace {

std::array<int, 2> new_pipe() {
    std::array<int, 2> ends{};
    if (pipe2(ends.data(), O_CLOEXEC) != 0) throw std::runtime_error("no pipe for a child");
    return ends;
}

}  // namespace

Child::Child(std::vector<std::string> arguments) {
    std::string program = "nimbus7_bench";
    std::vector<char*> words{program.data()};
    for (std::string& argument : arguments) words.push_back(argument.data());
    words.push_back(nullptr);

    std::signal(SIGPIPE, SIG_IGN);  // a child that has ended is an error, not our end
    const std::array<int, 2> requests = new_pipe(), answers = new_pipe();
    process_ = fork();
    if (process_ == 0) {
        if (dup2(requests[0], STDIN_FILENO) >= 0 && dup2(answers[1], STDOUT_FILENO) >= 0)
            execv("/proc/self/exe", words.data());
        _exit(127);
    }
    close(requests[0]);
    close(answers[1]);
    requests_ = fdopen(requests[1], "w");
    answers_  = fdopen(answers[0], "r");
}

Child::~Child() {
    std::fclose(requests_);  // which ends it
    std::fclose(answers_);
    if (process_ > 0) waitpid(process_, nullptr, 0);
}

std::string Child::read_line() {
    std::string line;
    for (int c = std::fgetc(answers_); c != '\n'; c = std::fgetc(answers_)) {
        if (c == EOF) throw std::runtime_error("the child process has ended");
        line += static_cast<char>(c);
    }
    return line;
}

std::string Child::ask() {
    if (std::fputc('\n', requests_) == EOF || std::fflush(requests_) != 0)
        throw std::runtime_error("the child process has ended");
    return read_line();
}

}  // namespace bench
