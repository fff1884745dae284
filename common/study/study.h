// A chapter's study: a sweep over methods and knobs that measures time and error. chapters/NN_name/study.json says what
// to sweep; docs/study_format.md what comes out.
#pragma once
#include <nlohmann/json.hpp>

#include "common/app/options.h"
#include "common/image/image.h"
#include "common/study/study_plan.h"

namespace lightwalk {

/// Errors of `test` against `truth`: FLIP mean and 99th percentile (LDR, of what is clamped to [0, 1]), RMSE, relative
/// RMSE and maximum in linear light, counts of NaN and Inf.
nlohmann::json study_errors(const ImageRgb& truth, const ImageRgb& test);

/// Measures the study that is `text`, of `file`, and returns it as docs/study_format.md has it. What is done is kept in
/// options.study + ".partial" after each scene, from which an interrupted study goes on. options.size stands for the
/// study's "size" where it was given; LIGHTWALK_STUDY_ROUNDS in the environment, a whole number from 1, for its
/// "rounds" (tests need errors, not times). Throws InputError or, where the truth has not converged, Failure.
nlohmann::json measure_study(const std::string& text, const std::string& file, const Options& options, Chapter& chapter,
                             Gpu& gpu);

/// Measures chapters/NN_name/study.json, or the file that LIGHTWALK_STUDY_FILE in the environment names, and writes
/// options.study; makes the device in `gpu`, which must outlive the chapter. Returns the exit code. Throws as
/// measure_study.
int run_study(const Options& options, Chapter& chapter, std::unique_ptr<Gpu>& gpu);

/// What --method auto does while a scene is loaded: nothing where it was not asked for. Throws InputError where the
/// chapter has no study.
Loading automatic_choice(const Options& options, Chapter& chapter);

/// A line with a bar on stderr; on a terminal it is drawn over.
void show_progress(const std::string& what, size_t done, size_t of);

}  // namespace lightwalk
