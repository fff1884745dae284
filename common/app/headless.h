// Pictures and times without a window.
#pragma once
#include "common/app/options.h"

namespace lightwalk {

/// Draws for --screenshot and --timings. Makes the device in `gpu` if there is none; it must outlive the chapter.
/// Returns the exit code.
int run_headless(const Options& options, Chapter& chapter, std::unique_ptr<Gpu>& gpu, const Loading& loading);

/// The device that the options name. Throws InputError, also where it cannot render so large a picture.
std::unique_ptr<Gpu> make_gpu(const Options& options);

}  // namespace lightwalk
