// File access: course folder, whole-file reads, atomic writes.
#pragma once
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>

namespace lightwalk {

/// Root of the tree: $LIGHTWALK_ROOT, else the nearest folder above the executable that contains shaders/common. Throws
/// Failure if there is none, InputError if the variable names another folder.
const std::filesystem::path& course_root();

/// Regular file open for reading. Throws InputError: missing, unreadable, folder, or pipe and device, which may block.
class InputFile {
  public:
    explicit InputFile(const std::filesystem::path& path);
    ~InputFile();
    InputFile(const InputFile&) = delete;

    int descriptor = -1;
    size_t bytes = 0;
};

constexpr size_t most_file_bytes = size_t{1} << 31;

/// Contents of a regular file. Throws InputError as InputFile, or if larger than `most` or truncated meanwhile.
std::string read_file(const std::filesystem::path& path, size_t most = most_file_bytes);

bool file_exists(const std::filesystem::path& path);

/// True if the path, with links resolved, is inside the folder.
bool lies_below(const std::filesystem::path& path, const std::filesystem::path& folder);

/// Replaces a file atomically: writes a temporary file beside it and renames it. Follows links and keeps permissions;
/// an existing file must be regular and writable. "/dev/fd/N", a regular file opened by the parent process, is written
/// in place. Throws InputError.
void write_file(const std::filesystem::path& path, std::string_view bytes);

/// write_file() with fsync() of file and folder: after a power failure, the old or the whole new file exists.
void write_file_to_disk(const std::filesystem::path& path, std::string_view bytes);

/// Throws InputError unless write_file() could write `path`, without side effects. Lets long runs fail early.
void check_writable(const std::filesystem::path& path);

/// FNV-1a, 64 bits, for cache keys and checksums; not cryptographic.
constexpr uint64_t hash_bytes(std::string_view bytes, uint64_t seed = 14695981039346656037ull) {
    for (const char c : bytes) seed = (seed ^ static_cast<unsigned char>(c)) * 1099511628211ull;
    return seed;
}

}  // namespace lightwalk
