#include "common/window/child_process.h"

#include <fcntl.h>
#include <signal.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdio>
#include <cstring>

#include "common/base/error.h"

extern char** environ;

namespace lightwalk {
namespace {

constexpr size_t most_said = 1 << 20;  // bytes that are kept

// Settings of posix_spawn for the child's descriptors and process group.
struct SpawnSettings {
    posix_spawn_file_actions_t files;
    posix_spawnattr_t attributes;

    SpawnSettings(ChildProcess::Kind kind, int output) {
        posix_spawn_file_actions_init(&files);
        posix_spawnattr_init(&attributes);
        if (kind != ChildProcess::Kind::program) {
            posix_spawn_file_actions_addopen(&files, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
            posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETPGROUP);  // a group of its own, to be ended as one
        }
        if (kind == ChildProcess::Kind::detached) {
            posix_spawn_file_actions_addopen(&files, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
            posix_spawn_file_actions_addopen(&files, STDERR_FILENO, "/dev/null", O_WRONLY, 0);
        } else {
            posix_spawn_file_actions_adddup2(&files, output, STDERR_FILENO);
            if (kind == ChildProcess::Kind::job) posix_spawn_file_actions_adddup2(&files, output, STDOUT_FILENO);
        }
    }
    ~SpawnSettings() {
        posix_spawnattr_destroy(&attributes);
        posix_spawn_file_actions_destroy(&files);
    }
    SpawnSettings(const SpawnSettings&) = delete;
};

}  // namespace

ChildProcess::ChildProcess(const std::filesystem::path& program, const std::vector<std::string>& options, Kind kind)
    : kind_(kind) {
    int ends[2];
    if (pipe2(ends, O_CLOEXEC) != 0) throw Failure(program.string() + ": " + std::strerror(errno));
    output_ = ends[0];
    fcntl(output_, F_SETFL, O_NONBLOCK);
    std::vector<std::string> words{program.string()};
    words.insert(words.end(), options.begin(), options.end());
    std::vector<char*> arguments;
    for (std::string& word : words) arguments.push_back(word.data());
    arguments.push_back(nullptr);
    const SpawnSettings settings(kind, ends[1]);
    const int failed =
        posix_spawnp(&pid_, program.c_str(), &settings.files, &settings.attributes, arguments.data(), environ);
    close(ends[1]);
    if (failed) {
        close(output_);
        throw Failure(program.string() + ": " + std::strerror(failed));
    }
}

ChildProcess::~ChildProcess() {
    if (pid_ > 0 && kind_ == Kind::program) waitpid(pid_, nullptr, 0);
    if (pid_ > 0 && kind_ == Kind::job) stop();
    close(output_);
}

// Interrupts first, so that a build removes its half-written files; then kills.
void ChildProcess::stop() {
    kill(-pid_, SIGTERM);
    for (int tenth = 0; tenth < 20; ++tenth) {
        if (waitpid(pid_, nullptr, WNOHANG) == pid_) {
            kill(-pid_, SIGKILL);  // the rest of the group
            return;
        }
        usleep(100000);
    }
    kill(-pid_, SIGKILL);
    waitpid(pid_, nullptr, 0);
}

void ChildProcess::read_output() {
    char bytes[4096];
    for (ssize_t count = 0; (count = read(output_, bytes, sizeof bytes)) > 0;) {
        if (kind_ == Kind::program) std::fwrite(bytes, 1, static_cast<size_t>(count), stderr);
        said_.append(bytes, static_cast<size_t>(count));
    }
    if (said_.size() > most_said) said_.erase(0, said_.size() - most_said);
}

std::string ChildProcess::last_words() const {
    const size_t end = said_.find_last_not_of('\n');
    if (end == std::string::npos) return {};
    const size_t begin = said_.rfind('\n', end);
    return said_.substr(begin + 1, end - begin);  // npos + 1 is 0
}

std::optional<int> ChildProcess::poll() {
    read_output();
    int status = 0;
    if (pid_ <= 0 || waitpid(pid_, &status, WNOHANG) != pid_) return std::nullopt;
    pid_ = -1;
    read_output();
    return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

}  // namespace lightwalk
