// Pictures by one process that stays, for tests and for pages.
#pragma once
#include "common/app/options.h"

namespace lightwalk {

/// Draws a picture for each line of standard input, on one device, which it makes in `gpu`: starting a device, compiling
/// for it and reading a scene take most of a process's time. The answer is a line, {"code": 0, "error": "", "bytes": 0, ...}:
/// the exit code and message of a separate process, followed by so many bytes.
///
/// A line that is a JSON list is a command line. A chapter is made for it; consecutive ones share compiled pipelines,
/// and the scene's files if they would be read alike:
///
///     ["--shot", "bunny", "--screenshot", "bunny.png"]
///
/// A JSON object asks for a picture of a chapter that stays loaded, as the last few do, so that only a knob or the camera
/// changes. All keys but "words" are optional:
///
///     {"words": ["--shot", "lamp"],                 the command line to load
///      "use": "solution,05.pcf=exercise",           --use, for this picture
///      "set": {"shadow.filter": "vsm"},             knobs; the others are as the words have them
///      "turn_rad": 0.1, "tilt_rad": 0, "notches": 2, "pan": [0.1, 0],   from the scene's camera: orbit, zoom in,
///                                                   and shift in fractions of the picture's height
///      "size": [480, 270], "time_s": 0.5,           the time is counted from the shot's own
///      "look": "shade", "still": true}              whole frames as a PNG, instead of one frame as a JPEG
///
/// Its bytes are the picture, or none after a failure. The answer lists the times of the passes, viewable outputs, compile
/// errors (as "file:line: message"; the picture uses the last version that compiled), and "changed" if a shader file was
/// edited since the previous picture. Throws InputError without a device.
int draw_pictures(const Options& options, const std::string& name, const MakeChapter& make, std::unique_ptr<Gpu>& gpu);

}  // namespace lightwalk
