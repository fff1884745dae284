// Files: where the course lies, whole-file reads, and writes that are never half done.
#pragma once
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>

namespace lightwalk {

/// The tree's root: $LIGHTWALK_ROOT, else the nearest folder above the executable that holds shaders/common.
/// Throws Failure if there is none, InputError if the variable names something else.
const std::filesystem::path& course_root();

/// A regular file, open for reading and closed at the end. Anything else is refused before it is opened: a pipe would
/// be waited for, a device need not end. Throws InputError (missing, unreadable, a folder, a pipe, a device).
class InputFile {
  public:
    explicit InputFile(const std::filesystem::path& path);
    ~InputFile();
    InputFile(const InputFile&) = delete;

    int descriptor = -1;
    size_t bytes = 0;  ///< when it was opened
};

/// Default size limit of read_file().
constexpr size_t most_file_bytes = size_t{1} << 31;

/// A regular file's bytes. Throws InputError as InputFile does, where the file is larger than `most`, and where it
/// becomes shorter while it is read.
std::string read_file(const std::filesystem::path& path, size_t most = most_file_bytes);

/// True if a file or folder is there; false also where its name is one that no file can have.
bool file_exists(const std::filesystem::path& path);

/// True if the path, its links followed, is below the folder.
bool lies_below(const std::filesystem::path& path, const std::filesystem::path& folder);

/// Writes a file beside `path` and renames it, so that a reader sees the old file or the whole new one, even if the
/// program ends. Follows links and keeps permissions; an existing file must be regular and writable. "/dev/fd/N", a
/// regular file opened for writing by the parent process, is written in place. Throws InputError on failure.
void write_file(const std::filesystem::path& path, std::string_view bytes);

/// The same, and on the disk when it returns, the folder's entry too: after a power cut there is the old file or the whole
/// new one.
void write_file_to_disk(const std::filesystem::path& path, std::string_view bytes);

/// Throws InputError unless write_file() could write `path`; leaves nothing behind. Lets a long run fail at once.
void check_writable(const std::filesystem::path& path);

/// FNV-1a, 64 bits: for cache keys and checksums, not against an adversary.
constexpr uint64_t hash_bytes(std::string_view bytes, uint64_t seed = 14695981039346656037ull) {
    for (const char c : bytes) seed = (seed ^ static_cast<unsigned char>(c)) * 1099511628211ull;
    return seed;
}

}  // namespace lightwalk
