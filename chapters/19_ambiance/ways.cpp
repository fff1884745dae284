#include "19_ambiance/ways.h"

#include <cstdio>
#include <nlohmann/json.hpp>

#include "common/app/clock_warmer.h"
#include "common/app/headless.h"
#include "common/app/read_picture.h"
#include "common/app/render.h"
#include "common/base/error.h"
#include "common/base/files.h"
#include "common/base/patience.h"
#include "common/base/statistics.h"
#include "common/measure/flip.h"
#include "common/scene/json_lines.h"
#include "common/study/cheapest.h"
#include "common/study/need.h"

namespace lightwalk {
namespace {

using nlohmann::json;

// Parts of a scene's time at which it is alone on the screen.
constexpr double looked_at[] = {0.25, 0.45, 0.65};
constexpr int rounds = 3;
constexpr int truth_samples = 16;  // for each of the film's

std::vector<KnobSettings> read_ways(const std::string& kind) {
    const std::filesystem::path file = course_root() / "chapters/19_ambiance/ways.json";
    std::vector<KnobSettings> all;
    const JsonWithLines source = parse_json(read_file(file), file.string());
    for (const json& way : source.root.at(kind)) {
        KnobSettings& knobs = all.emplace_back();
        for (const auto& [name, value] : way.items())
            knobs.emplace_back(name, value.is_string() ? value.get<std::string>() : value.dump());
    }
    return all;
}

std::vector<double> times_of(const FilmScene& scene) {
    std::vector<double> times_s;
    for (const double share : looked_at) times_s.push_back(scene.from_s + share * (scene.to_s - scene.from_s));
    return times_s;
}

json settings_json(const KnobSettings& knobs) {
    json object = json::object();
    for (const auto& [name, value] : knobs) object[name] = value;
    return object;
}

// Draws a scene at its times by several methods in turn: each one's picture and time.
class Measuring {
  public:
    Measuring(Chapter& chapter, Reel& reel, Gpu& gpu, size_t scene, const Options& options)
        : chapter_(chapter), reel_(reel), scene_(scene), options_(options), frame_(gpu) {}
    ~Measuring() { reel_.draw_by(scene_, {}); }
    Measuring(const Measuring&) = delete;

    std::vector<ImageRgb> pictures(const KnobSettings& way) {
        std::vector<ImageRgb> all;
        for (const double time_s : times_of(reel_.film().scenes.at(scene_))) {
            draw(way, time_s);
            all.push_back(read_linear(frame_.gpu, frame_.output));
        }
        return all;
    }
    std::vector<ImageRgb> truth(const KnobSettings& way) {
        KnobBase& smoothing = find_knob(chapter_.all_knobs(), "mlaa.method");
        const std::string smoothed_by = smoothing.text();
        const int samples = chapter_.samples;
        smoothing.set("none");
        chapter_.samples.value = truth_samples * samples;
        std::vector<ImageRgb> all = pictures(way);
        smoothing.set(smoothed_by);
        chapter_.samples.value = samples;
        return all;
    }
    /// Medians, one for each method, of frames in the middle of playing: one-time work was done in the frame before.
    std::vector<double> times_ms(const std::vector<KnobSettings>& ways) {
        std::vector<std::vector<double>> all(ways.size());
        ClockWarmer load(frame_.gpu);
        for (int round = 0; round < rounds; ++round)
            for (const double time_s : times_of(reel_.film().scenes.at(scene_)))
                for (size_t i = 0; i < ways.size(); ++i) {
                    draw(ways[i], time_s - 1.0 / 60.0);
                    load.run();
                    draw(ways[i], time_s);
                    all[i].push_back(gpu_ms(frame_));
                }
        std::vector<double> medians;
        for (const std::vector<double>& times : all) medians.push_back(median(times));
        return medians;
    }

  private:
    void draw(const KnobSettings& way, double time_s) {
        reel_.draw_by(scene_, way);
        render(chapter_, frame_, {options_.size, static_cast<float>(time_s), options_.seed, {}});
    }
    Chapter& chapter_;
    Reel& reel_;
    const size_t scene_;
    const Options& options_;
    Frame frame_;
};

double greatest_error(const std::vector<ImageRgb>& truth, const std::vector<ImageRgb>& drawn) {
    double greatest = 0;
    for (size_t i = 0; i < drawn.size(); ++i)
        greatest = std::max(greatest, double(summarize(flip_ldr(truth[i], drawn[i])).mean));
    return greatest;
}

}  // namespace

std::vector<Way> measure_ways(Chapter& chapter, Reel& reel, Gpu& gpu, size_t scene, const Options& options) {
    const std::vector<KnobSettings> all = read_ways(reel.film().scenes.at(scene).kind);
    Measuring measuring(chapter, reel, gpu, scene, options);
    const std::vector<ImageRgb> truth = measuring.truth(all.front());
    std::vector<Way> ways;
    for (const KnobSettings& knobs : all)
        ways.push_back({.knobs = knobs, .error = greatest_error(truth, measuring.pictures(knobs))});
    const std::vector<double> times_ms = measuring.times_ms(all);
    for (size_t i = 0; i < ways.size(); ++i) ways[i].gpu_ms = times_ms[i];
    return ways;
}

ChosenWay cheapest_way(const std::vector<Way>& ways, double budget) {
    std::vector<Measured> all;
    for (const Way& way : ways) all.push_back({way.error, way.gpu_ms, way.error <= budget});
    const size_t chosen = cheapest(all);
    return {ways[chosen], all[chosen].enough};
}

void choose_ways(Chapter& chapter, Reel& reel, Gpu& gpu, const Options& options) {
    for (size_t i = 0; i < reel.film().scenes.size(); ++i) {
        const std::vector<Way> ways = measure_ways(chapter, reel, gpu, i, options);
        const auto [way, enough] = cheapest_way(ways, *options.budget);
        std::printf("%-14s %9.2f ms, was %9.2f; error %.5f  %s%s\n", reel.film().scenes[i].name.c_str(), way.gpu_ms,
                    ways.front().gpu_ms, way.error, settings_json(way.knobs).dump().c_str(),
                    enough ? "" : "; no way is within the budget, the truest is kept");
        std::fflush(stdout);
        reel.draw_by(i, way.knobs);
    }
}

int write_ways(Chapter& chapter, Reel& reel, const std::string& file, const Options& options,
               std::unique_ptr<Gpu>& gpu) {
    check_writable(file);
    gpu = make_gpu(options);
    load_scene(chapter, *gpu, options.scene.empty() ? chapter.default_scene() : options.scene);
    if (!reel.is_open()) throw InputError("--ways: {} is no film", options.scene);
    json scenes = json::array();
    Patience patience("measuring", "scenes");
    for (size_t i = 0; i < reel.film().scenes.size(); ++i) {
        json ways = json::array();
        for (const Way& way : measure_ways(chapter, reel, *gpu, i, options))
            ways.push_back({{"knobs", settings_json(way.knobs)}, {"error", way.error}, {"gpu_ms", way.gpu_ms}});
        const double as_it_stands = Measuring(chapter, reel, *gpu, i, options).times_ms({{}}).front();
        scenes.push_back({{"name", reel.film().scenes[i].name},
                          {"kind", reel.film().scenes[i].kind},
                          {"as_set_ms", as_it_stands},
                          {"ways", ways}});
        patience.show(static_cast<int>(i) + 1, static_cast<int>(reel.film().scenes.size()));
    }
    write_file(file, json{{"device", gpu->device.info.name},
                          {"driver", gpu->device.info.driver},
                          {"software", gpu->device.software()},
                          {"size", {options.size.x, options.size.y}},
                          {"scenes", scenes}}
                             .dump(1, '\t') +
                         "\n");
    return 0;
}

}  // namespace lightwalk
