// The levels of a piece of music as a file beside it: decoders differ in the last bits, and measuring takes seconds.
#pragma once
#include <filesystem>

#include "14_environment/music.h"

namespace lightwalk {

/// audio/a.levels for audio/a.ogg.
std::filesystem::path levels_of(const std::filesystem::path& music);

/// Each level as a share of its largest, in 16 bits. Throws InputError where the file is missing or cut off.
LevelTable read_levels(const std::filesystem::path& file);

/// Measures a piece of music and writes its table beside it. Throws InputError.
void write_levels(const std::filesystem::path& music);

}  // namespace lightwalk
