#include "common/base/kept.h"

#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>
#include <zlib.h>

#include <chrono>
#include <cstdlib>
#include <cstring>
#include <utility>

#include "common/base/error.h"
#include "common/base/files.h"

namespace lightwalk {
namespace fs = std::filesystem;
namespace {

using Count = uint64_t;  // uncompressed size, stored first; zlib appends a checksum

thread_local bool skips_keeping = false;

// Access date, so that old files can be evicted.
void mark_used(const fs::path& file) {
    std::error_code error;
    const auto now = fs::file_time_type::clock::now();
    if (now - fs::last_write_time(file, error) > std::chrono::hours(24)) fs::last_write_time(file, now, error);
}

// Creates the folder if needed; empty unless it is private to this user.
fs::path private_folder(const fs::path& folder) {
    mkdir(folder.c_str(), 0700);
    struct stat about = {};
    const bool mine = lstat(folder.c_str(), &about) == 0 && S_ISDIR(about.st_mode) && about.st_uid == geteuid() &&
                      (about.st_mode & 077) == 0;
    return mine ? folder : fs::path();
}

}  // namespace

const fs::path& cache_folder() {
    static const fs::path folder = [] {
        std::error_code error;
        if (const char* given = std::getenv("LIGHTWALK_CACHE")) {
            fs::create_directories(given, error);
            return fs::path(given);
        }
        fs::path beside = course_root() / "build" / "shader_cache";
        fs::create_directories(beside, error);
        if (!error) return beside;
        return private_folder(fs::temp_directory_path(error) / fmt::format("lightwalk_shader_cache.{}", geteuid()));
    }();
    return folder;
}

fs::path kept_file(std::string_view key, std::string_view ending) {
    if (cache_folder().empty()) return {};
    return cache_folder() / fmt::format("{:016x}{:016x}{}", hash_bytes(key), hash_bytes(key, 7), ending);
}

std::optional<std::string> read_kept(const fs::path& file, size_t most) {
    if (file.empty() || !file_exists(file)) return {};
    try {
        const std::string all = read_file(file, sizeof(Count) + compressBound(most));
        Count count = 0;
        if (all.size() < sizeof count) return {};
        std::memcpy(&count, all.data(), sizeof count);
        if (count > most) return {};
        std::string bytes(count, '\0');
        uLongf length = count;
        const auto* const deflated = reinterpret_cast<const Bytef*>(all.data() + sizeof count);
        if (uncompress(reinterpret_cast<Bytef*>(bytes.data()), &length, deflated, all.size() - sizeof count) != Z_OK ||
            length != count)
            return {};
        mark_used(file);
        return bytes;
    } catch (const InputError&) { return {}; }
}

SkipKeeping::SkipKeeping(bool skips) : before_(std::exchange(skips_keeping, skips || skips_keeping)) {}
SkipKeeping::~SkipKeeping() { skips_keeping = before_; }

void keep(const fs::path& file, std::string_view bytes) {
    if (file.empty() || skips_keeping) return;
    const Count count = bytes.size();
    uLongf length = compressBound(count);
    std::string all(sizeof count + length, '\0');
    std::memcpy(all.data(), &count, sizeof count);
    // Fastest level: modules shrink to 36%, compared to 33% at zlib's default.
    if (compress2(reinterpret_cast<Bytef*>(all.data() + sizeof count), &length,
                  reinterpret_cast<const Bytef*>(bytes.data()), bytes.size(), Z_BEST_SPEED) != Z_OK)
        return;
    all.resize(sizeof count + length);
    try {
        write_file(file, all);
    } catch (const InputError&) {
        // Caching is optional.
    }
}

}  // namespace lightwalk
