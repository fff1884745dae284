#include "14_environment/music.h"

#include <cmath>

#include "14_environment/exercises.h"
#include "14_environment/sound_file.h"
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

// [measure]
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
// [/measure]

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

}  // namespace lightwalk
