// Music as four levels that are functions of time alone.
#pragma once
#include <filesystem>

#include "common/app/module.h"
#include "common/base/sound.h"
#include "common/scene/scene_file.h"

namespace lightwalk {

inline constexpr int slowest_rate_hz = 8000, fastest_rate_hz = 192000;
inline constexpr double longest_sound_s = 600;

/// Decodes the file with libvorbisfile. Averages the channels; keeps the sample rate. Throws InputError "file:
/// reason" if the file cannot be read, is not Ogg Vorbis, ends in the middle, is damaged, changes its rate, lasts
/// longer than longest_sound_s, or has a rate outside of the limits above.
Sound read_sound(const std::filesystem::path& path);

/// Low, middle and high band, and loudness.
using Levels = glm::vec4;

/// Levels at i * hop_s seconds, from 0 on; 0 before and after.
struct LevelTable {
    /// 2,048 samples last 43 ms at 48 kHz and overlap by 82% at this distance.
    static constexpr double hop_s = 1.0 / 128;
    std::vector<Levels> entries;

    /// Interpolated linearly.
    Levels at(double time_s) const;
    Levels most() const;  ///< each one's largest
};

/// Entry i is measured from the 2,048 samples around i * hop_s seconds: bands by 14.spectrum_bands, loudness as the root
/// of the mean square under the same window. Samples before the first and after the last are 0.
LevelTable measure_levels(const Sound& sound);

/// Follows rising levels with the time constant `attack_s`, falling ones with `release_s`: in that time 63% of a step
/// is done (0: at once). From the first entry on, and beyond the last until all is below 1e-5 of `most`.
LevelTable smooth_levels(const LevelTable& table, double attack_s, double release_s);

/// The scene's `music`, as levels for moving objects.
struct Music : Module {
    Music(Module& owner, std::string name) : Module(owner, std::move(name), "music") {}
    Knob<float> attack_ms{*this, "attack_ms", 10.0f, {0.0f, 5000.0f}, "Time constant of rising levels", "ms"};
    Knob<float> release_ms{*this, "release_ms", 150.0f, {0.0f, 5000.0f}, "Time constant of falling levels", "ms"};
    Knob<bool> plays{*this, "plays", true, "Music on; off, all levels are 0 and the window is silent"};

    /// Throws InputError where the file is no music.
    void prepare(Gpu& gpu, Scene& scene) override;
    bool animated() const override { return plays && !measured_.entries.empty(); }
    std::vector<std::string> load_exercises() const override { return {"14.spectrum_bands"}; }
    const Sound* sound() const override { return animated() && !sound_.samples.empty() ? &sound_ : nullptr; }

    /// Loads the file's `music`, if any; the core of prepare().
    void load(const SceneFile& scene);

    /// Sound from elsewhere instead of a file's.
    void take(Sound sound);
    /// Its levels were measured before: measured_levels(), as measure_levels() gave them. The sound may be none.
    void take(Sound sound, LevelTable measured);
    const LevelTable& measured_levels() const { return measured_; }

    /// Smoothed, as shares of the largest level that the whole piece has (0 to 1). A level that never exceeds -80 dB
    /// (1e-4) is a share of that.
    Levels levels(double time_s) const;

  private:
    Sound sound_;
    LevelTable measured_;
    mutable LevelTable smoothed_;
    mutable glm::vec2 smoothed_with_{-1.0f};
};

}  // namespace lightwalk
