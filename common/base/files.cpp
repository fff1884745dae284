#include "common/base/files.h"

#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <fstream>

#include "common/base/error.h"

namespace lightwalk {
namespace fs = std::filesystem;

const fs::path& course_root() {
    static const fs::path root = [] {
        if (const char* given = std::getenv("LIGHTWALK_ROOT")) return fs::path(given);
        for (fs::path at = fs::read_symlink("/proc/self/exe"); at.has_relative_path(); at = at.parent_path())
            if (fs::is_directory(at / "shaders" / "common")) return at;
        throw Failure("no course found above the executable: set LIGHTWALK_ROOT to the folder that holds shaders/");
    }();
    return root;
}

std::string read_file(const fs::path& path) {
    std::error_code ignored;
    if (fs::is_directory(path, ignored)) throw InputError("{}: is a folder, expected a file", path.string());
    std::ifstream in(path, std::ios::binary);
    if (!in) throw InputError("{}: cannot be opened: {}", path.string(), std::strerror(errno));
    std::string bytes;
    if (const auto size = fs::file_size(path, ignored); !ignored) bytes.reserve(size);
    bytes.assign(std::istreambuf_iterator<char>(in), {});
    return bytes;
}

namespace {

fs::path temporary_beside(const fs::path& path) { return fmt::format("{}.part{}", path.string(), getpid()); }

}  // namespace

void write_file(const fs::path& path, std::string_view bytes) {
    const fs::path part = temporary_beside(path);
    std::error_code error;
    {
        std::ofstream out(part, std::ios::binary | std::ios::trunc);
        if (!out) throw InputError("{}: cannot be written: {}", path.string(), std::strerror(errno));
        out.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
        if (!out.flush()) {
            out.close();
            fs::remove(part, error);
            throw InputError("{}: cannot be written: {}", path.string(), std::strerror(errno));
        }
    }
    fs::rename(part, path, error);
    if (error) {
        const std::string why = error.message();
        fs::remove(part, error);
        throw InputError("{}: cannot be written: {}", path.string(), why);
    }
}

void check_writable(const fs::path& path) {
    std::error_code error;
    if (fs::is_directory(path, error)) throw InputError("{}: cannot be written: is a folder", path.string());
    const fs::path part = temporary_beside(path);
    if (!std::ofstream(part, std::ios::binary))
        throw InputError("{}: cannot be written: {}", path.string(), std::strerror(errno));
    fs::remove(part, error);
}

uint64_t hash_bytes(std::string_view bytes, uint64_t seed) {
    for (const char c : bytes) seed = (seed ^ static_cast<unsigned char>(c)) * 1099511628211ull;
    return seed;
}

}  // namespace lightwalk
