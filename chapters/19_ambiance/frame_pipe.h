// Where frames of a film go: a file, or the standard input of ffmpeg.
#pragma once
#include <sys/types.h>

#include <cstddef>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

namespace lightwalk {

class FramePipe {
  public:
    /// To a file. Throws Failure.
    explicit FramePipe(const std::filesystem::path& file);
    /// To a program, looked for in $PATH. Throws Failure where it cannot be started.
    explicit FramePipe(const std::vector<std::string>& command);
    ~FramePipe();
    FramePipe(const FramePipe&) = delete;

    /// Throws Failure where not all was taken: the disk is full, or the program has ended.
    void write(std::span<const std::byte> bytes);

    /// After the last frame. Throws Failure where the file is not whole, or the program failed.
    void finish();

  private:
    void end_program();
    std::string last_words() const;  ///< of the program's messages
    std::string name_;
    int output_ = -1, messages_ = -1;
    pid_t program_ = -1;
    int ended_with_ = 0;
};

}  // namespace lightwalk
