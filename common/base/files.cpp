#include "common/base/files.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <charconv>
#include <cstdlib>
#include <cstring>
#include <memory>
#include <vector>

#include "common/base/error.h"
#include "common/base/own_files.h"

namespace lightwalk {
namespace fs = std::filesystem;
namespace {

bool is_course(const fs::path& folder) {
    std::error_code error;
    return fs::is_directory(folder / "shaders" / "common", error);
}

const char* kind_of(mode_t mode) {
    return S_ISREG(mode)                    ? ""
           : S_ISDIR(mode)                  ? "a folder"
           : S_ISFIFO(mode)                 ? "a pipe"
           : S_ISSOCK(mode)                 ? "a socket"
           : S_ISCHR(mode) || S_ISBLK(mode) ? "a device"
                                            : "something else";
}

void require_regular(const fs::path& path, const struct stat& status) {
    if (const std::string kind = kind_of(status.st_mode); !kind.empty())
        throw InputError("{}: is {}, expected a file", path.string(), kind);
}

[[noreturn]] void fail_to_write(const fs::path& path, const std::string& why) {
    throw InputError("{}: cannot be written: {}", path.string(), why);
}

}  // namespace

const fs::path& course_root() {
    static const fs::path root = [] {
        if (const char* given = std::getenv("LIGHTWALK_ROOT")) {
            if (is_course(given)) return fs::path(given);
            throw InputError("LIGHTWALK_ROOT={}: is not the course's folder, which holds shaders/common", given);
        }
        for (fs::path at = fs::read_symlink("/proc/self/exe"); at.has_relative_path(); at = at.parent_path())
            if (is_course(at)) return at;
        throw Failure("no course found above the executable: set LIGHTWALK_ROOT to the folder that holds shaders/");
    }();
    return root;
}

InputFile::InputFile(const fs::path& path) {
    // Checked before opening, since opening alone triggers some devices, and again afterwards, against replacement.
    struct stat status;
    const auto fail = [&] { throw InputError("{}: cannot be opened: {}", path.string(), std::strerror(errno)); };
    if (stat(path.c_str(), &status) != 0) fail();
    require_regular(path, status);
    descriptor = open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK);
    if (descriptor < 0 || fstat(descriptor, &status) != 0) fail();
    if (!S_ISREG(status.st_mode)) {
        close(descriptor);
        require_regular(path, status);
    }
    bytes = static_cast<size_t>(status.st_size);
}

InputFile::~InputFile() {
    if (descriptor >= 0) close(descriptor);
}

std::string read_file(const fs::path& path, size_t most) {
    const InputFile file(path);
    if (file.bytes > most)
        throw InputError("{}: is larger than {} MiB, which is the most that is read", path.string(), most >> 20);
    std::string text;
    text.reserve(file.bytes + 64);  // parsers append zeros to look ahead
    text.resize(file.bytes);
    size_t so_far = 0;
    while (so_far < text.size()) {
        const ssize_t count = read(file.descriptor, text.data() + so_far, text.size() - so_far);
        if (count < 0 && errno == EINTR) continue;
        if (count < 0) throw InputError("{}: cannot be read: {}", path.string(), std::strerror(errno));
        if (count == 0) throw InputError("{}: became shorter while it was read", path.string());
        so_far += static_cast<size_t>(count);
    }
    return text;
}

bool file_exists(const fs::path& path) {
    std::error_code error;
    return fs::exists(path, error);
}

bool lies_below(const fs::path& path, const fs::path& folder) {
    std::error_code error;
    const fs::path inside = fs::weakly_canonical(path, error).lexically_relative(fs::weakly_canonical(folder, error));
    return !inside.empty() && *inside.begin() != "..";
}

namespace {

struct Place {
    fs::path path;
    bool exists = false;
    mode_t permissions = 0666;
};

Place place_of(const fs::path& path) {
    Place place{path};
    struct stat status;
    if (stat(path.c_str(), &status) == 0) {
        if (const std::string kind = kind_of(status.st_mode); !kind.empty()) fail_to_write(path, "is " + kind);
        if (access(path.c_str(), W_OK) != 0) fail_to_write(path, std::strerror(errno));
        place.exists = true;
        place.permissions = status.st_mode & 07777;
    } else if (errno != ENOENT) {
        fail_to_write(path, std::strerror(errno));
    }
    std::error_code error;
    while (fs::is_symlink(place.path, error)) {  // terminates: stat() followed all links
        const fs::path next = fs::read_symlink(place.path, error);
        place.path = next.is_absolute() ? next : place.path.parent_path() / next;
    }
    struct stat named;  // /dev/fd of a removed file leads to a stale name
    if (place.exists && (stat(place.path.c_str(), &named) != 0 || named.st_ino != status.st_ino))
        fail_to_write(path, "was removed while it was open");
    return place;
}

void write_all(int descriptor, const fs::path& path, std::string_view bytes) {
    while (!bytes.empty()) {
        const ssize_t count = write(descriptor, bytes.data(), bytes.size());
        if (count < 0 && errno == EINTR) continue;
        if (count < 0) fail_to_write(path, std::strerror(errno));
        bytes.remove_prefix(static_cast<size_t>(count));
    }
}

// N of "/dev/fd/N" if inherited and open for writing; else -1.
int open_descriptor(const fs::path& path) {
    const std::string text = path.string(), folder = "/dev/fd/";
    int number = -1;
    if (!text.starts_with(folder)) return -1;
    const auto [end, error] = std::from_chars(text.data() + folder.size(), text.data() + text.size(), number);
    if (error != std::errc() || end != text.data() + text.size() || number < 3) return -1;
    struct stat status;
    if (fstat(number, &status) != 0 || !S_ISREG(status.st_mode)) return -1;
    return (fcntl(number, F_GETFL) & O_ACCMODE) == O_RDONLY ? -1 : number;
}

class Part {
  public:
    Part(const fs::path& path, const Place& place)
        : path_(path), name_(fmt::format("{}.part{}", place.path.string(), getpid())) {
        descriptor_ = open(name_.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC | O_NOFOLLOW, 0666);
        if (descriptor_ < 0) fail_to_write(path, std::strerror(errno));
        if (place.exists) fchmod(descriptor_, place.permissions);
    }
    ~Part() {
        if (descriptor_ >= 0) close(descriptor_);
        if (!renamed_) unlink(name_.c_str());
    }
    Part(const Part&) = delete;

    void write_all(std::string_view bytes) { lightwalk::write_all(descriptor_, path_, bytes); }
    void sync() {
        if (fsync(descriptor_) != 0) fail();
    }
    void rename_to(const fs::path& target) {
        if (const int open_one = std::exchange(descriptor_, -1); close(open_one) != 0) fail();
        if (rename(name_.c_str(), target.c_str()) != 0) fail();
        renamed_ = true;
    }

  private:
    [[noreturn]] void fail() { fail_to_write(path_, std::strerror(errno)); }
    const fs::path& path_;
    const std::string name_;
    int descriptor_ = -1;
    bool renamed_ = false;
};

}  // namespace

void write_file(const fs::path& path, std::string_view bytes) {
    if (const int open_one = open_descriptor(path); open_one >= 0) return write_all(open_one, path, bytes);
    const Place place = place_of(path);
    Part part(path, place);
    part.write_all(bytes);
    part.rename_to(place.path);
}

void write_files(const std::map<fs::path, std::string>& files) {
    std::vector<std::pair<std::unique_ptr<Part>, fs::path>> parts;
    for (const auto& [path, bytes] : files) {
        const Place place = place_of(path);
        parts.emplace_back(std::make_unique<Part>(path, place), place.path);
        parts.back().first->write_all(bytes);
    }
    for (const auto& [part, target] : parts) part->rename_to(target);
}

void write_file_to_disk(const fs::path& path, std::string_view bytes) {
    const Place place = place_of(path);
    Part part(path, place);
    part.write_all(bytes);
    part.sync();
    part.rename_to(place.path);
    // Without syncing the folder, a power failure may restore the old name. Some file systems refuse it.
    const fs::path folder = place.path.parent_path();
    const int descriptor = open(folder.empty() ? "." : folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    if (descriptor < 0) return;
    fsync(descriptor);
    close(descriptor);
}

void check_writable(const fs::path& path) {
    if (open_descriptor(path) < 0) Part(path, place_of(path));
}

}  // namespace lightwalk
