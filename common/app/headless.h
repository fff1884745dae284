// Screenshots and timings without a window.
#pragma once
#include "common/app/options.h"

namespace lightwalk {

/// Runs --screenshot and --timings. Returns the exit code. `gpu`, created if null, must outlive the chapter.
int run_headless(const Options& options, Chapter& chapter, std::unique_ptr<Gpu>& gpu, const Loading& loading);

/// Creates the device selected by the options. Throws InputError, also if the picture exceeds the device's limits.
std::unique_ptr<Gpu> make_gpu(const Options& options);

}  // namespace lightwalk
