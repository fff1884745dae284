// Memory shared between two processes.
#pragma once
#include <cstddef>

namespace lightwalk {

/// Anonymous memory file, mapped by both processes. Sealed, since reading beyond its end would kill a process.
class SharedBytes {
  public:
    SharedBytes();
    ~SharedBytes();
    SharedBytes(const SharedBytes&) = delete;

    /// Grows to at least `bytes`. Pages use memory once written.
    void grow(size_t bytes);
    /// Releases memory from byte `first` on; it then reads as zeros.
    void release(size_t first);
    /// Maps at least `bytes`. May move the mapping.
    char* reach(size_t bytes);
    int file() const { return file_; }

  private:
    int file_ = -1;
    char* data_ = nullptr;
    size_t size_ = 0, mapped_ = 0;
};

}  // namespace lightwalk
