// Memory-mapped file: its bytes without a read, straight from the kernel's page cache.
#pragma once
#include <cstddef>
#include <filesystem>
#include <string_view>

#include "common/base/files.h"

namespace lightwalk {

/// A whole regular file, read-only in memory, followed by at least 64 zero bytes for parsers that look ahead. If
/// another program shortens it meanwhile, the missing part reads as zeros instead of raising SIGBUS, and check()
/// reports it. Throws InputError as InputFile does.
class MappedFile {
  public:
    explicit MappedFile(const std::filesystem::path& path);
    ~MappedFile();
    MappedFile(const MappedFile&) = delete;
    std::string_view text() const { return {static_cast<const char*>(memory_), size_}; }

    /// To be called when all is read. Throws InputError where the file is not the one that was opened any more.
    void check() const;

  private:
    std::filesystem::path path_;
    InputFile file_;
    void* memory_ = nullptr;
    size_t size_ = 0, reserved_ = 0, place_ = 0;
};

}  // namespace lightwalk
