// Files: where the course lies, whole-file reads, and writes that are never half done.
#pragma once
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>

namespace lightwalk {

/// The tree's root: $LIGHTWALK_ROOT, else the nearest folder above the executable that holds shaders/common.
/// Throws Failure where there is none.
const std::filesystem::path& course_root();

/// A file's bytes. Throws InputError (missing, a folder, unreadable).
std::string read_file(const std::filesystem::path& path);

/// Writes beside `path` and renames, so that a reader sees the old file or the whole new one.
/// Throws InputError where the folder cannot be written.
void write_file(const std::filesystem::path& path, std::string_view bytes);

/// Throws InputError unless a file could be written at `path`; leaves nothing behind. Lets a long run fail at once.
void check_writable(const std::filesystem::path& path);

/// FNV-1a, 64 bits: for cache keys and checksums, not against an adversary.
uint64_t hash_bytes(std::string_view bytes, uint64_t seed = 14695981039346656037ull);

}  // namespace lightwalk
