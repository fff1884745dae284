// The loaders' study and need rule: megabytes per second against error, and which loader a session wants.
#pragma once
#include <nlohmann/json_fwd.hpp>

#include "01_obj/obj.h"
#include "common/scene/scene_file.h"

namespace lightwalk {

/// Measures every loader on study["scenes"] (files, from the root; one that is missing is left out with a warning),
/// study["rounds"] times each. `result` gets points, device and so on as docs/study_format.md has them for "loader".
void study_loaders(const nlohmann::json& study, nlohmann::json& result);

/// What a loader costs: milliseconds before the first byte, and its rate. Fitted to medians on two cores of an
/// Intel Xeon: the start to cube.obj, the rate to suzanne.obj and bunny.obj (--load-bench FILE).
struct LoaderCost {
    Loader loader;
    double start_ms, mb_per_s, ulp;
    double total_ms(double megabytes, int loads) const { return loads * (start_ms + 1e3 * megabytes / mb_per_s); }
};

/// The size of the scene's .obj files, each counted once.
double megabytes(const SceneFile& scene);

/// The least total time for `loads` readings of a file of that size, among the loaders whose error is at most `budget`
/// ULP. Lines that say so go to `lines`.
LoaderCost choose_loader(double megabytes, int loads, double budget, std::vector<std::string>& lines);

}  // namespace lightwalk
