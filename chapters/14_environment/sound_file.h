// Ogg Vorbis files.
#pragma once
#include <filesystem>

#include "common/base/sound.h"

namespace lightwalk {

inline constexpr int slowest_rate_hz = 8000, fastest_rate_hz = 192000;
inline constexpr double longest_sound_s = 600;

/// Decodes the file with libvorbisfile. Averages the channels; keeps the sample rate. Throws InputError "file:
/// reason" if the file cannot be read, is not Ogg Vorbis, ends in the middle, is damaged, changes its rate, lasts
/// longer than longest_sound_s, or has a rate outside of the limits above.
Sound read_sound(const std::filesystem::path& path);

}  // namespace lightwalk
