#include "common/base/shared_bytes.h"

#include <fcntl.h>
#include <sys/mman.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <new>
#include <string>

#include "common/base/error.h"

namespace lightwalk {

SharedBytes::SharedBytes() : file_(memfd_create("lightwalk", MFD_CLOEXEC | MFD_ALLOW_SEALING)) {
    if (file_ >= 0 && fcntl(file_, F_ADD_SEALS, F_SEAL_SHRINK | F_SEAL_SEAL) == 0) return;
    const std::string why = std::strerror(errno);
    if (file_ >= 0) close(file_);
    throw Failure("shared memory: {}", why);
}

SharedBytes::~SharedBytes() {
    if (data_) munmap(data_, mapped_);
    close(file_);
}

void SharedBytes::grow(size_t bytes) {
    if (bytes <= size_) return;
    if (ftruncate(file_, static_cast<off_t>(bytes)) != 0) throw Failure("shared memory: {}", std::strerror(errno));
    size_ = bytes;
}

void SharedBytes::release(size_t first) {
    if (first >= size_) return;
    const int hole = FALLOC_FL_PUNCH_HOLE | FALLOC_FL_KEEP_SIZE;
    fallocate(file_, hole, static_cast<off_t>(first), static_cast<off_t>(size_ - first));
}

char* SharedBytes::reach(size_t bytes) {
    constexpr size_t step = size_t{1} << 20;
    const size_t wanted = (bytes + step) / step * step;
    if (wanted <= mapped_) return data_;
    void* const mapped = data_ ? mremap(data_, mapped_, wanted, MREMAP_MAYMOVE)
                               : mmap(nullptr, wanted, PROT_READ | PROT_WRITE, MAP_SHARED, file_, 0);
    if (mapped == MAP_FAILED) throw std::bad_alloc();
    data_ = static_cast<char*>(mapped);
    mapped_ = wanted;
    return data_;
}

}  // namespace lightwalk
