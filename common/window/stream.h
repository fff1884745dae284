// Pictures for a page: a chapter that stays, and answers.
#pragma once
#include "common/app/options.h"

namespace lightwalk {

/// Draws what each line of standard input asks for, on one device, which it makes in `gpu`, and writes the picture to
/// standard output. What was loaded for the last few shots stays, so that a knob or the camera is all that changes from
/// one picture to the next. A line is a JSON object, of which all but "words" may be left out:
///
///     {"words": ["--shot", "lamp"],                 what is loaded, as on the command line
///      "use": "solution,05.pcf=exercise",           --use, for this picture
///      "set": {"shadow.filter": "vsm"},             knobs; the others are as the words have them
///      "turn_rad": 0.1, "tilt_rad": 0, "notches": 2, "pan": [0.1, 0],   from the scene's camera: around its target,
///                                                   closer, and along with the picture in shares of its height
///      "size": [480, 270], "time_s": 0.5,           the time is counted from the shot's own
///      "look": "shade", "still": true}              whole frames as a PNG, instead of one frame as a JPEG
///
/// The answer is a line, {"code": 0, "error": "", "bytes": 20000, "size": [480, 270], ...}, and so many bytes behind it:
/// the picture, or none where it failed. It tells the times of the passes, what can be looked at, what did not compile
/// (a list of "file:line: message"; the picture is that of the last version that did), and "changed" where a file of the
/// shaders was edited since the picture before. Throws InputError where there is no device.
int stream_pictures(const Options& options, const std::string& name, const MakeChapter& make,
                    std::unique_ptr<Gpu>& gpu);

}  // namespace lightwalk
