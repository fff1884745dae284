#include "common/base/kept.h"

#include <fmt/format.h>
#include <zlib.h>

#include <chrono>
#include <cstdlib>
#include <cstring>

#include "common/base/error.h"
#include "common/base/files.h"

namespace lightwalk {
namespace fs = std::filesystem;
namespace {

using Count = uint64_t;  // before what is deflated: how many bytes it was; behind it zlib puts a checksum of them

// Its time says when it was last used, to a day: what has not been for long is removed when the cache grows too large.
void mark_used(const fs::path& file) {
    std::error_code error;
    const auto now = fs::file_time_type::clock::now();
    if (now - fs::last_write_time(file, error) > std::chrono::hours(24)) fs::last_write_time(file, now, error);
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
        fs::path temporary = fs::temp_directory_path(error) / "lightwalk_shader_cache";
        fs::create_directories(temporary, error);
        return temporary;
    }();
    return folder;
}

fs::path kept_file(std::string_view key, std::string_view ending) {
    return cache_folder() / fmt::format("{:016x}{:016x}{}", hash_bytes(key), hash_bytes(key, 7), ending);
}

std::optional<std::string> read_kept(const fs::path& file, size_t most) {
    if (!file_exists(file)) return {};
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

void keep(const fs::path& file, std::string_view bytes) {
    const Count count = bytes.size();
    uLongf length = compressBound(count);
    std::string all(sizeof count + length, '\0');
    std::memcpy(all.data(), &count, sizeof count);
    // The fastest level: a module shrinks to 36% of its bytes, to 33% at zlib's usual one.
    if (compress2(reinterpret_cast<Bytef*>(all.data() + sizeof count), &length,
                  reinterpret_cast<const Bytef*>(bytes.data()), bytes.size(), Z_BEST_SPEED) != Z_OK)
        return;
    all.resize(sizeof count + length);
    try {
        write_file(file, all);
    } catch (const InputError&) {
        // The next run is only slower.
    }
}

}  // namespace lightwalk
