#include "01_obj/load_study.h"

#include <cmath>
#include <cstdio>
#include <fstream>
#include <nlohmann/json.hpp>
#include <set>
#include <thread>

#include "01_obj/load_bench.h"
#include "common/base/error.h"
#include "common/base/files.h"

namespace lightwalk {
namespace {

using nlohmann::json;

constexpr int rounds_to_choose = 3;

std::string processor_name() {
    std::ifstream in("/proc/cpuinfo");
    for (std::string line; std::getline(in, line);)
        if (line.rfind("model name", 0) == 0) return line.substr(line.find(": ") + 2);
    return "unknown processor";
}

}  // namespace

void LoaderSubject::measure(const json& study, json& result) {
    const unsigned threads = std::thread::hardware_concurrency();
    result = {{"subject", "loader"},
              {"device", processor_name()},
              {"driver", "CPU"},
              {"stage", fmt::format("{} threads", threads)},
              {"truth", {{"method", "strtof in the C locale"}, {"knobs", json::object()}, {"doubling_change", 0}}},
              {"error_metric", "ulp"},
              {"time_unit", "MB/s"},
              {"points", json::array()}};
    for (const json& file : study.at("scenes")) {
        const auto path = course_root() / file.get<std::string>();
        if (!std::filesystem::exists(path)) {
            std::fprintf(stderr, "warning: no %s; left out\n", path.c_str());
            continue;
        }
        const int rounds = study.value("rounds", 5);
        size_t bytes = 0;
        for (const LoaderFigures& f : measure_loaders(path, rounds, bytes)) {
            if (!f.error.empty()) continue;
            const double megabytes = static_cast<double>(bytes) / 1e6;
            const auto rate = [&](double share) { return 1e3 * megabytes / f.quantile(share); };
            result["points"].push_back(
                {{"scene", path.stem().string()},
                 {"method", loader_name(f.loader)},
                 {"knobs", {{"megabytes", std::round(megabytes * 100) / 100}}},
                 {"error", {{"ulp", f.largest_ulps}, {"index_agreement", f.index_agreement}}},
                 {"mb_per_s", {{"median", rate(0.5)}, {"q1", rate(0.75)}, {"q3", rate(0.25)}, {"rounds", rounds}}}});
        }
    }
}

// Every .obj file of the scene, each once: its loaders' times add up, of their errors the largest counts.
json LoaderSubject::choose(double budget) {
    std::map<std::string, json> candidates;
    std::set<std::filesystem::path> files;
    for (const SceneObject& object : scene.objects) {
        if (!is_obj(object.model) || !files.insert(object.model).second) continue;
        size_t bytes = 0;
        for (const LoaderFigures& f : measure_loaders(find_asset(object.model), rounds_to_choose, bytes)) {
            const std::string name(loader_name(f.loader));
            json& c =
                candidates.try_emplace(name, json{{"method", name}, {"error", 0.0}, {"time_ms", 0.0}}).first->second;
            if (f.error.empty()) {
                c["error"] = std::max(c["error"].get<double>(), static_cast<double>(f.largest_ulps));
                c["time_ms"] = c["time_ms"].get<double>() + f.quantile(0.5);
            } else {
                c["error"] = nullptr;  // it cannot read the file
            }
        }
    }
    json all = json::array();
    const json* best = nullptr;
    for (auto& [name, c] : candidates) {
        c["enough"] = !c["error"].is_null() && c["error"].get<double>() <= budget;
        all.push_back(c);
    }
    for (const json& c : all)
        if (c["enough"] == true && (!best || c["time_ms"] < best->at("time_ms"))) best = &c;
    if (best) loader.set(best->at("method").get<std::string>());
    return {{"budget", budget},
            {"error_metric", "ulp"},
            {"candidates", all},
            {"none_would_do", !best && !all.empty()},
            {"choice", {{"method", loader.text()}}}};
}

}  // namespace lightwalk
