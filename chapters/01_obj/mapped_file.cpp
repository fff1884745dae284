#include "01_obj/mapped_file.h"

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

#include "common/base/error.h"

namespace lightwalk {

MappedFile::MappedFile(const std::filesystem::path& path) {
    const auto fail = [&](const std::string& why) { throw InputError("{}: cannot be opened: {}", path.string(), why); };
    struct Descriptor {
        int number;
        ~Descriptor() {
            if (number >= 0) close(number);
        }
        // Not to block on a pipe that nobody writes to.
    } file{open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK)};
    struct stat status;
    if (file.number < 0 || fstat(file.number, &status) != 0) fail(std::strerror(errno));
    if (S_ISDIR(status.st_mode)) throw InputError("{}: is a folder, expected a file", path.string());
    if (!S_ISREG(status.st_mode)) throw InputError("{}: is not a regular file", path.string());
    size_ = static_cast<size_t>(status.st_size);
    // Zero pages first, then the file over them: what lies past its end reads as zeros and not as a bus error.
    const size_t page = static_cast<size_t>(sysconf(_SC_PAGESIZE));
    reserved_ = (size_ + page - 1) / page * page + page;
    memory_ = mmap(nullptr, reserved_, PROT_READ, MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0);
    if (memory_ == MAP_FAILED) fail(std::strerror(errno));
    if (size_ > 0 && mmap(memory_, size_, PROT_READ, MAP_PRIVATE | MAP_FIXED, file.number, 0) == MAP_FAILED) {
        const int error = errno;
        munmap(memory_, reserved_);
        fail(std::strerror(error));
    }
}

MappedFile::~MappedFile() { munmap(memory_, reserved_); }

}  // namespace lightwalk
