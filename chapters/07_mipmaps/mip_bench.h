// Benchmark of the construction of levels: time and error for images of many sizes.
#pragma once
#include <string>

#include "common/app/options.h"

namespace lightwalk {

/// Writes a study (docs/study_format.md) to `file`: noise in RGBA16F from 64×64 to 8192×8192 texels, as far as the
/// device's memory goes, and a photograph, a checker and sizes that are no powers of two in their own formats. Each
/// method's time, the rate of the bytes that must be read and written (level 0 once, the others once), and the error of
/// its levels. `copy` is the device's own copy of as many bytes: nothing can be faster. --size is the
/// longest side that is tried, --study-rounds how often each is timed. Returns the exit code. Throws InputError.
int run_mip_bench(const std::string& file, const Options& options);

}  // namespace lightwalk
