#include "common/window/child_process.h"

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdio>
#include <cstring>
#include <utility>

#include "common/base/error.h"

extern char** environ;

namespace lightwalk {

ChildProcess::ChildProcess(const std::filesystem::path& program, const std::vector<std::string>& options) {
    int ends[2];
    if (pipe2(ends, O_CLOEXEC) != 0) throw Failure(program.string() + ": " + std::strerror(errno));
    errors_ = ends[0];
    fcntl(errors_, F_SETFL, O_NONBLOCK);
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_adddup2(&actions, ends[1], STDERR_FILENO);
    std::vector<std::string> words{program.string()};
    words.insert(words.end(), options.begin(), options.end());
    std::vector<char*> arguments;
    for (std::string& word : words) arguments.push_back(word.data());
    arguments.push_back(nullptr);
    const int failed = posix_spawn(&pid_, program.c_str(), &actions, nullptr, arguments.data(), environ);
    posix_spawn_file_actions_destroy(&actions);
    close(ends[1]);
    if (failed) {
        close(errors_);
        throw Failure(program.string() + ": " + std::strerror(failed));
    }
}

ChildProcess::~ChildProcess() {
    if (pid_ > 0) waitpid(pid_, nullptr, 0);
    close(errors_);
}

void ChildProcess::read_errors() {
    char bytes[4096];
    for (ssize_t count = 0; (count = read(errors_, bytes, sizeof bytes)) > 0;) {
        std::fwrite(bytes, 1, static_cast<size_t>(count), stderr);
        for (const char c : std::string_view(bytes, static_cast<size_t>(count))) {
            if (c != '\n')
                line_ += c;
            else if (!line_.empty())
                last_words_ = std::exchange(line_, {});
        }
    }
}

std::optional<int> ChildProcess::poll() {
    read_errors();
    int status = 0;
    if (pid_ <= 0 || waitpid(pid_, &status, WNOHANG) != pid_) return std::nullopt;
    pid_ = -1;
    read_errors();
    return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

}  // namespace lightwalk
