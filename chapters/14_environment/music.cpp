#include "14_environment/music.h"

#include <vorbis/vorbisfile.h>

#include <cmath>
#include <cstring>

#include "14_environment/exercises.h"
#include "common/base/error.h"
#include "common/base/files.h"
#include "common/scene/scene.h"

namespace lightwalk {

namespace {

constexpr int window_samples = 2048;
constexpr float softest = 1e-4f;  // -80 dB: the quietest visible level
constexpr float rest = 1e-5f;     // of the loudest: decays below it are dropped

// The root of the mean square under a Hann window: A / sqrt(2) of a steady tone of amplitude A.
float loudness(const std::vector<float>& samples) {
    double square = 0, weights = 0;
    for (size_t n = 0; n < samples.size(); ++n) {
        const double weight = 0.5 - 0.5 * std::cos(2 * M_PI * double(n) / window_samples);
        square += weight * weight * double(samples[n]) * double(samples[n]);
        weights += weight * weight;
    }
    return static_cast<float>(std::sqrt(square / weights));
}

}  // namespace

Levels LevelTable::at(double time_s) const {
    const double place = time_s / hop_s;
    if (!(place >= 0) || place >= double(entries.size())) return Levels(0.0f);
    const auto first = static_cast<size_t>(place);
    const Levels next = first + 1 < entries.size() ? entries[first + 1] : Levels(0.0f);
    return glm::mix(entries[first], next, static_cast<float>(place - double(first)));
}

Levels LevelTable::most() const {
    Levels most(0.0f);
    for (const Levels& entry : entries) most = glm::max(most, entry);
    return most;
}

LevelTable measure_levels(const Sound& sound) {
    LevelTable table;
    const auto bands = spectrum_bands.function();
    std::vector<float> around(window_samples);
    const auto count = static_cast<int64_t>(sound.samples.size());
    for (size_t i = 0; count > 0; ++i) {
        const int64_t first = std::llround(double(i) * LevelTable::hop_s * sound.rate_hz) - window_samples / 2;
        if (first >= count) break;
        for (int64_t n = 0; n < window_samples; ++n) {
            const int64_t at = first + n;
            around[size_t(n)] = at >= 0 && at < count ? sound.samples[size_t(at)] : 0.0f;
        }
        table.entries.push_back(Levels(bands(around, static_cast<float>(sound.rate_hz)), loudness(around)));
    }
    return table;
}

// [smooth]
LevelTable smooth_levels(const LevelTable& table, double attack_s, double release_s) {
    const auto share = [](double constant_s) {  // of the remaining way, done in one hop
        return constant_s > 0 ? static_cast<float>(-std::expm1(-LevelTable::hop_s / constant_s)) : 1.0f;
    };
    const float attack = share(attack_s), release = share(release_s);
    const Levels end = rest * table.most();
    LevelTable smoothed;
    Levels level(0.0f);
    for (size_t i = 0; i < table.entries.size() || glm::any(glm::greaterThan(level, end)); ++i) {
        const Levels now = i < table.entries.size() ? table.entries[i] : Levels(0.0f);
        level += (now - level) * glm::mix(Levels(release), Levels(attack), glm::greaterThan(now, level));
        smoothed.entries.push_back(level);
    }
    return smoothed;
}
// [/smooth]

void Music::prepare(Gpu&, Scene& scene) { load(scene.file); }

void Music::load(const SceneFile& scene) {
    const SceneMusic& music = scene.music;
    if (!music) return take({});
    try {
        take(read_sound(find_asset(music.file)));
    } catch (const InputError& error) { throw InputError("{}: {}", music.where, error.what()); }
}

void Music::take(Sound sound) {
    LevelTable measured = measure_levels(sound);
    take(std::move(sound), std::move(measured));
}

void Music::take(Sound sound, LevelTable measured) {
    measured_ = std::move(measured);
    sound_ = std::move(sound);
    smoothed_with_ = glm::vec2(-1.0f);
}

Levels Music::levels(double time_s) const {
    if (!animated()) return Levels(0.0f);
    if (const glm::vec2 with(attack_ms.value, release_ms.value); smoothed_with_ != with) {
        smoothed_ = smooth_levels(measured_, 1e-3 * double(with.x), 1e-3 * double(with.y));
        smoothed_with_ = with;
    }
    return smoothed_.at(time_s) / glm::max(measured_.most(), Levels(softest));
}

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
