// Pictures and times without a window.
#pragma once
#include "common/app/options.h"

namespace lightwalk {

/// Makes the device in `gpu` where there is none yet, which must outlive the chapter, and draws what the options ask
/// for: --screenshot and --timings. Returns the exit code.
int run_headless(const Options& options, Chapter& chapter, std::unique_ptr<Gpu>& gpu, const Loading& loading);

/// The device that the options name. Throws InputError, also where it cannot render so large a picture.
std::unique_ptr<Gpu> make_gpu(const Options& options);

}  // namespace lightwalk
