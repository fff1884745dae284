// A chapter's study: a sweep over methods and knobs that measures time and error. chapters/NN_name/study.json says what
// to sweep; docs/study_format.md what comes out.
#pragma once
#include <nlohmann/json.hpp>

#include "common/app/options.h"
#include "common/measure/image.h"

namespace lightwalk {

/// The sweep of one frame study.
///
///     {"title": "...", "error_metric": "flip_mean", "stage": "fragment", "size": [960, 540], "rounds": 11,
///      "truth": {"set": {"samples": 8}, "doubled": {"samples": 16}, "most_change": 0.001},
///      "scenes": ["assets/scenes/teapot.json"],
///      "curves": [{"method": "gouraud"}, {"method": "phong", "set": {"samples": [1, 2, 4]}}]}
struct StudyPoint {
    std::string method;
    std::vector<std::pair<std::string, std::string>> set;
};

/// Every curve's points: the product of the values its knobs list.
std::vector<StudyPoint> study_points(const nlohmann::json& study);

/// The HDR target as linear RGB.
ImageRgb read_hdr(Gpu& gpu, const Image& hdr);

/// Errors of `test` against `truth`: FLIP mean and 99th percentile (LDR, of what is clamped to [0, 1]), RMSE, relative
/// RMSE and maximum in linear light, counts of NaN and Inf.
nlohmann::json study_errors(const ImageRgb& truth, const ImageRgb& test);

/// Runs chapters/NN_name/study.json and writes options.study. What is done is kept beside it in FILE.partial after each
/// scene, from which an interrupted study goes on. Throws InputError or, where the truth has not converged, Failure.
void run_study(const Options& options, Chapter& chapter, Gpu& gpu);

/// Runs a study of something else than frames, without a device. False where the chapter has none.
bool run_cpu_study(const Options& options, Chapter& chapter);

/// A line with a bar on stderr; on a terminal it is drawn over.
void show_progress(const std::string& what, size_t done, size_t of);

}  // namespace lightwalk
