// Screenshots and timings without a window.
#pragma once
#include "common/app/chapter.h"
#include "common/app/options.h"

namespace lightwalk {

/// Runs --screenshot and --timings. Returns the exit code. `gpu`, created if null, must outlive the chapter.
int run_headless(const Options& options, Chapter& chapter, std::unique_ptr<Gpu>& gpu, const Loading& loading);

/// Creates the device selected by the options. Throws InputError, also if the picture exceeds the device's limits.
std::unique_ptr<Gpu> make_gpu(const Options& options);

/// Compiles all variants; without `all`, those of default knobs. Writes `stamp`, and `stamp`.d for make. Throws
/// ShaderError.
int compile_all_shaders(Chapter& chapter, const std::string& stamp, bool all);

int print_list(const Options& options, Chapter& chapter);

}  // namespace lightwalk
