#include "01_obj/mapped_file.h"

#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <mutex>

#include "common/base/error.h"

namespace lightwalk {
namespace {

size_t page_bytes() {
    static const size_t bytes = static_cast<size_t>(sysconf(_SC_PAGESIZE));
    return bytes;
}

// The stretches of memory that are files, for the signal's handler, which may neither lock nor allocate.
struct Mapped {
    std::atomic<uintptr_t> begin = 0, end = 0;
    std::atomic<bool> gone = false;
};
std::array<Mapped, 64> all_mapped;

// The kernel sends SIGBUS where a page lies past the file's end as it is now. Zero pages take the place of all that is
// left, and the instruction is tried again; mmap() is a plain system call.
void on_bus_error(int signal, siginfo_t* info, void*) {
    const auto at = reinterpret_cast<uintptr_t>(info->si_addr);
    for (Mapped& file : all_mapped) {
        const uintptr_t end = file.end;
        if (at < file.begin || at >= end) continue;
        const uintptr_t page = at & ~(uintptr_t{4096} - 1);
        file.gone = true;
        if (mmap(reinterpret_cast<void*>(page), end - page, PROT_READ,
                 MAP_PRIVATE | MAP_ANONYMOUS | MAP_FIXED | MAP_NORESERVE, -1, 0) != MAP_FAILED)
            return;
    }
    std::signal(signal, SIG_DFL);  // not ours: it happens again, and ends the program
}

size_t remember(void* memory, size_t bytes) {
    static std::once_flag once;
    std::call_once(once, [] {
        struct sigaction action = {};
        action.sa_sigaction = on_bus_error;
        action.sa_flags = SA_SIGINFO;
        sigaction(SIGBUS, &action, nullptr);
    });
    for (size_t place = 0; place < all_mapped.size(); ++place) {
        uintptr_t nobody = 0;
        const auto begin = reinterpret_cast<uintptr_t>(memory);
        if (!all_mapped[place].begin.compare_exchange_strong(nobody, begin)) continue;
        all_mapped[place].gone = false;
        all_mapped[place].end = begin + bytes;
        return place;
    }
    throw Failure("more than {} files are mapped at once", all_mapped.size());
}

}  // namespace

MappedFile::MappedFile(const std::filesystem::path& path) : path_(path), file_(path), size_(file_.bytes) {
    const auto fail = [&](int error) {
        throw InputError("{}: cannot be opened: {}", path.string(), std::strerror(error));
    };
    // Zero pages first, then the file over them: reads past its end give zeros instead of a bus error.
    reserved_ = (size_ + page_bytes() - 1) / page_bytes() * page_bytes() + page_bytes();
    memory_ = mmap(nullptr, reserved_, PROT_READ, MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0);
    if (memory_ == MAP_FAILED) fail(errno);
    if (size_ > 0 && mmap(memory_, size_, PROT_READ, MAP_PRIVATE | MAP_FIXED, file_.descriptor, 0) == MAP_FAILED) {
        const int error = errno;
        munmap(memory_, reserved_);
        fail(error);
    }
    try {
        place_ = remember(memory_, reserved_);
    } catch (...) {
        munmap(memory_, reserved_);
        throw;
    }
}

MappedFile::~MappedFile() {
    all_mapped[place_].end = 0;
    munmap(memory_, reserved_);
    all_mapped[place_].begin = 0;
}

void MappedFile::check() const {
    struct stat status;
    const bool same = fstat(file_.descriptor, &status) == 0 && static_cast<size_t>(status.st_size) >= size_;
    if (!same || all_mapped[place_].gone) throw InputError("{}: became shorter while it was read", path_.string());
}

}  // namespace lightwalk
