// Many pictures by one process.
#pragma once
#include "common/app/options.h"

namespace lightwalk {

/// Draws what standard input asks for, on one device, which it makes in `gpu`: tests want hundreds of pictures, and
/// most of a process's time goes into starting the device, compiling for it and reading the scene. Each line is a
/// command line as a JSON list:
///
///     ["--shot", "bunny", "--screenshot", "bunny.png"]
///
/// and is answered with {"code": 0, "error": ""}: the exit code that a process of its own would have had, and what it
/// would have said. A chapter is made for each; what it shares with the one before is compiled pipelines, and the
/// scene's files where they would be read in the same way. Throws InputError where there is no device.
int draw_pictures(const Options& options, const std::string& name, const MakeChapter& make, std::unique_ptr<Gpu>& gpu);

}  // namespace lightwalk
