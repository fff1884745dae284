// A file's bytes without reading them: the kernel shows its page cache to the program.
#pragma once
#include <cstddef>
#include <filesystem>
#include <string_view>

namespace lightwalk {

/// A whole file, read-only in memory, followed by at least 64 zero bytes, so that a parser may look ahead without
/// asking where the end is. The file must not become shorter while it is mapped. Throws InputError (missing,
/// unreadable, not a file).
class MappedFile {
  public:
    explicit MappedFile(const std::filesystem::path& path);
    ~MappedFile();
    MappedFile(const MappedFile&) = delete;
    MappedFile& operator=(const MappedFile&) = delete;
    std::string_view text() const { return {static_cast<const char*>(memory_), size_}; }

  private:
    void* memory_ = nullptr;
    size_t size_ = 0, reserved_ = 0;
};

}  // namespace lightwalk
