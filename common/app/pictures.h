// Many pictures by one process.
#pragma once
#include "common/app/options.h"

namespace lightwalk {

/// Draws the pictures requested on standard input, on one device, which it makes in `gpu`: tests need hundreds of them,
/// and most of a process's time goes into starting the device, compiling for it and reading the scene. Each line is a
/// command line as a JSON list:
///
///     ["--shot", "bunny", "--screenshot", "bunny.png"]
///
/// The answer is {"code": 0, "error": ""}: the exit code and message of a separate process. A chapter is made for each;
/// consecutive ones share compiled pipelines, and the scene's files if they would be read alike. Throws InputError
/// without a device.
int draw_pictures(const Options& options, const std::string& name, const MakeChapter& make, std::unique_ptr<Gpu>& gpu);

}  // namespace lightwalk
