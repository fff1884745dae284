// A chapter's study: a sweep over methods and knobs that measures time and error, read from
// chapters/NN_name/study.json. Output: docs/study_format.md.
#pragma once
#include <nlohmann/json.hpp>

#include "common/app/options.h"
#include "common/image/image.h"
#include "common/study/study_plan.h"

namespace lightwalk {

/// Errors of `test` against `truth`: FLIP mean and 99th percentile (LDR, values clamped to [0, 1]), RMSE, relative
/// RMSE and maximum in linear light, counts of NaN and Inf.
nlohmann::json study_errors(const ImageRgb& truth, const ImageRgb& test);

/// Measures the study `text` of `file` and returns it in the format of docs/study_format.md. After each scene it
/// saves progress in options.study + ".partial", so that an interrupted study can go on. options.size overrides the
/// study's "size"; options.study_rounds, from 1, its "rounds" (tests need errors, not times). Throws InputError or, if the truth has not converged, Failure.
nlohmann::json measure_study(const std::string& text, const std::string& file, const Options& options, Chapter& chapter,
                             Gpu& gpu);

/// Measures chapters/NN_name/study.json, or options.study_file, and writes
/// options.study; makes the device in `gpu`, which must outlive the chapter. Returns the exit code. Throws as
/// measure_study.
int run_study(const Options& options, Chapter& chapter, std::unique_ptr<Gpu>& gpu);

/// The work of --method auto while a scene is loaded; none if it was not requested. Throws InputError if the chapter
/// has no study.
Loading automatic_choice(const Options& options, Chapter& chapter);

/// A line with a bar on stderr; on a terminal it is drawn over.
void show_progress(const std::string& what, size_t done, size_t of);

}  // namespace lightwalk
