#include "14_environment/sound_file.h"

#include <vorbis/vorbisfile.h>

#include <cmath>
#include <cstring>

#include "common/base/error.h"
#include "common/base/files.h"

namespace lightwalk {
namespace {

constexpr size_t most_file_bytes_of_sound = size_t{256} << 20;

// libvorbisfile reads from memory, through these.
struct Bytes {
    std::string_view all;
    size_t at = 0;
};

size_t read_bytes(void* into, size_t size, size_t count, void* source) {
    Bytes& bytes = *static_cast<Bytes*>(source);
    const size_t n = std::min(size * count, bytes.all.size() - bytes.at);
    std::memcpy(into, bytes.all.data() + bytes.at, n);
    bytes.at += n;
    return size ? n / size : 0;
}

int seek_bytes(void* source, ogg_int64_t offset, int from) {
    Bytes& bytes = *static_cast<Bytes*>(source);
    const auto start = static_cast<int64_t>(from == SEEK_SET ? 0 : from == SEEK_CUR ? bytes.at : bytes.all.size());
    if (start + offset < 0 || start + offset > static_cast<int64_t>(bytes.all.size())) return -1;
    bytes.at = static_cast<size_t>(start + offset);
    return 0;
}

long tell_bytes(void* source) { return static_cast<long>(static_cast<Bytes*>(source)->at); }

// An Ogg stream ends with a page that is marked as the last. libvorbisfile takes any page for it, and so a part of a
// file for the whole.
bool last_page_is_marked(std::string_view bytes) {
    ogg_sync_state sync;
    ogg_sync_init(&sync);
    bool marked = false;
    for (size_t at = 0; at < bytes.size();) {
        const size_t n = std::min(bytes.size() - at, size_t{1} << 16);
        std::memcpy(ogg_sync_buffer(&sync, static_cast<long>(n)), bytes.data() + at, n);
        ogg_sync_wrote(&sync, static_cast<long>(n));
        at += n;
        for (ogg_page page; ogg_sync_pageseek(&sync, &page) != 0;)
            if (page.header_len > 0) marked = ogg_page_eos(&page) != 0;
    }
    ogg_sync_clear(&sync);
    return marked;
}

// An open file, closed at the end.
struct Decoder {
    Bytes bytes;
    OggVorbis_File file{};

    Decoder(std::string_view all, const std::string& name) : bytes{all} {
        const int error = ov_open_callbacks(&bytes, &file, nullptr, 0, {read_bytes, seek_bytes, nullptr, tell_bytes});
        if (error == 0) return;
        const bool ogg = all.substr(0, 4) == "OggS";
        if (error == OV_EREAD || (ogg && !last_page_is_marked(all)))
            throw InputError("{}: ends before its sound begins: the file is incomplete", name);
        throw InputError("{}: is {}; expected Ogg Vorbis", name,
                         ogg ? "an Ogg file without Vorbis sound" : "not sound");
    }
    ~Decoder() { ov_clear(&file); }
    Decoder(const Decoder&) = delete;
};

}  // namespace

Sound read_sound(const std::filesystem::path& path) {
    const std::string name = path.string(), all = read_file(path, most_file_bytes_of_sound);
    Decoder decoder(all, name);
    Sound sound{.rate_hz = static_cast<int>(ov_info(&decoder.file, -1)->rate)};
    if (sound.rate_hz < slowest_rate_hz || sound.rate_hz > fastest_rate_hz)
        throw InputError("{}: has {} samples per second; expected {} to {}", name, sound.rate_hz, slowest_rate_hz,
                         fastest_rate_hz);
    const auto too_long = [&](double seconds) {
        return InputError("{}: lasts {:.1f} s; at most {:.0f} s are read", name, seconds, longest_sound_s);
    };
    const auto most = static_cast<size_t>(longest_sound_s * sound.rate_hz);
    const ogg_int64_t total = ov_pcm_total(&decoder.file, -1);
    if (total > static_cast<ogg_int64_t>(most)) throw too_long(double(total) / sound.rate_hz);

    for (int stream = -1;;) {
        float** channels = nullptr;
        int now = stream;
        const long count = ov_read_float(&decoder.file, &channels, 4096, &now);
        if (count == 0) break;
        const auto damaged = [&] { return InputError("{}: is damaged at {:.2f} s", name, sound.duration_s()); };
        if (count < 0) throw damaged();
        const vorbis_info& info = *ov_info(&decoder.file, now);
        if (info.rate != sound.rate_hz)
            throw InputError("{}: changes from {} to {} samples per second at {:.2f} s; expected one rate", name,
                             sound.rate_hz, info.rate, sound.duration_s());
        stream = now;
        for (long i = 0; i < count; ++i) {
            float sum = 0;
            for (int c = 0; c < info.channels; ++c) sum += channels[c][i];
            if (!std::isfinite(sum)) throw damaged();
            sound.samples.push_back(sum / static_cast<float>(info.channels));
        }
        if (sound.samples.size() > most) throw too_long(sound.duration_s());
    }
    if (!last_page_is_marked(all))
        throw InputError("{}: ends in the middle, after {:.2f} s: the file is incomplete", name, sound.duration_s());
    if (sound.samples.empty()) throw InputError("{}: holds no samples", name);
    return sound;
}

}  // namespace lightwalk
