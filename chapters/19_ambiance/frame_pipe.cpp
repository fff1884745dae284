#include "19_ambiance/frame_pipe.h"

#include <fcntl.h>
#include <spawn.h>
#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cctype>
#include <cerrno>
#include <csignal>
#include <cstring>

#include "common/base/error.h"

extern char** environ;

namespace lightwalk {

FramePipe::FramePipe(const std::filesystem::path& file) : name_(file.string()) {
    std::signal(SIGXFSZ, SIG_IGN);  // a file that grows beyond a limit is an error, and no death
    output_ = open(file.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0644);
    if (output_ < 0) throw Failure("{}: {}", name_, std::strerror(errno));
}

FramePipe::FramePipe(const std::vector<std::string>& command) : name_(command.front()) {
    std::signal(SIGPIPE, SIG_IGN);  // a write to a program that has ended is an error, and no death
    int ends[2];
    if (pipe2(ends, O_CLOEXEC) != 0) throw Failure("{}: {}", name_, std::strerror(errno));
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_adddup2(&actions, ends[0], 0);
    messages_ = memfd_create("messages", MFD_CLOEXEC);
    if (messages_ >= 0) posix_spawn_file_actions_adddup2(&actions, messages_, 2);
    std::vector<char*> words;
    for (const std::string& word : command) words.push_back(const_cast<char*>(word.c_str()));
    words.push_back(nullptr);
    const int wrong = posix_spawnp(&program_, words[0], &actions, nullptr, words.data(), environ);
    posix_spawn_file_actions_destroy(&actions);
    close(ends[0]);
    output_ = ends[1];
    if (wrong) {
        program_ = -1;
        throw Failure("{} cannot be started: {}{}", name_, std::strerror(wrong),
                      wrong == ENOENT
                          ? "; it writes films (Debian's package ffmpeg); a name that ends with .raw needs none"
                          : "");
    }
}

FramePipe::~FramePipe() {
    if (output_ >= 0) close(output_);
    end_program();
    if (messages_ >= 0) close(messages_);
}

std::string FramePipe::last_words() const {
    char text[2000];
    const ssize_t size = messages_ < 0 ? 0 : lseek(messages_, 0, SEEK_END);
    const ssize_t got =
        size <= 0 ? 0 : pread(messages_, text, sizeof text, std::max<ssize_t>(0, size - ssize_t(sizeof text)));
    std::string said(text, size_t(std::max<ssize_t>(got, 0)));
    while (!said.empty() && std::isspace(static_cast<unsigned char>(said.back()))) said.pop_back();
    said.erase(0, said.rfind('\n') + 1);
    return said.empty() ? "" : ": " + said;
}

void FramePipe::end_program() {
    if (program_ < 0) return;
    int status = 0;
    while (waitpid(program_, &status, 0) < 0 && errno == EINTR) {}
    ended_with_ = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
    program_ = -1;
}

void FramePipe::write(std::span<const std::byte> bytes) {
    while (!bytes.empty()) {
        const ssize_t taken = ::write(output_, bytes.data(), bytes.size());
        if (taken < 0 && errno == EINTR) continue;
        if (taken <= 0) {
            const int why = errno;
            const bool is_program = program_ >= 0;
            close(output_);
            output_ = -1;
            end_program();
            if (is_program)
                throw Failure("{} ended before the last frame, with code {}{}", name_, ended_with_, last_words());
            throw Failure("{}: {}", name_, std::strerror(why));
        }
        bytes = bytes.subspan(static_cast<size_t>(taken));
    }
}

void FramePipe::finish() {
    const bool is_program = program_ >= 0;
    const int wrong = close(output_);
    output_ = -1;
    end_program();
    if (is_program && ended_with_ != 0) throw Failure("{} failed, with code {}{}", name_, ended_with_, last_words());
    if (wrong != 0) throw Failure("{}: {}", name_, std::strerror(errno));
}

}  // namespace lightwalk
