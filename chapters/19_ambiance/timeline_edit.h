// Camera keys written into the text of a film's file: the rest stays unchanged, to the byte.
#pragma once
#include <filesystem>
#include <string>

#include "19_ambiance/timeline.h"

namespace lightwalk {

// [timeline_edit]
/// The text of a film in which the camera of `scene` (its place in the film) has a key: instead of the one that is
/// within near_s of its time, else as a line of its own between its neighbours; a scene without a camera gets one.
/// `text` is a right film. Times and lengths are rounded to thousandths.
std::string with_key(const std::string& text, size_t scene, const CameraKey& key, double near_s);

/// The text without the key that is within near_s of a time of the scene. Throws InputError where there is none, or no
/// other.
std::string without_key(const std::string& text, size_t scene, double time_s, double near_s);

/// A key as it stands in a film.
std::string key_text(const CameraKey& key);
// [/timeline_edit]

}  // namespace lightwalk
