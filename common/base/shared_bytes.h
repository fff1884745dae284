// Memory that two processes share.
#pragma once
#include <cstddef>

namespace lightwalk {

/// A file without a name, in memory: both processes map it, so that large data crosses without a pipe. Sealed, so that
/// neither can shorten it: to read a mapped page behind the end of a file kills a process.
class SharedBytes {
  public:
    SharedBytes();
    ~SharedBytes();
    SharedBytes(const SharedBytes&) = delete;

    /// At least so many bytes; pages take memory once they are written.
    void grow(size_t bytes);
    /// Gives the memory from byte `first` on back; zeros remain.
    void release(size_t first);
    /// The first `bytes` of the file, mapped.
    char* reach(size_t bytes);
    int file() const { return file_; }

  private:
    int file_ = -1;
    char* data_ = nullptr;
    size_t size_ = 0, mapped_ = 0;
};

}  // namespace lightwalk
