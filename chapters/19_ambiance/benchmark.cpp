#include "19_ambiance/benchmark.h"

#include <nlohmann/json.hpp>

#include "19_ambiance/played.h"
#include "19_ambiance/ways.h"
#include "common/app/clock_warmer.h"
#include "common/app/headless.h"
#include "common/app/render.h"
#include "common/base/error.h"
#include "common/base/files.h"
#include "common/base/patience.h"
#include "common/base/statistics.h"

namespace lightwalk {
namespace {

using nlohmann::json;

// Of frames drawn one after the other.
struct Measured {
    std::vector<double> gpu_ms, cpu_ms;
    std::map<std::string, std::vector<double>> passes;
    std::vector<std::string> order;

    void draw(Chapter& chapter, Frame& frame, const Picture& picture) {
        render(chapter, frame, picture);
        std::vector<PassTime> times;
        add_times(times, frame.times);
        double sum = 0;
        for (const PassTime& time : times) {
            if (!passes.contains(time.name)) order.push_back(time.name);
            passes[time.name].push_back(time.gpu_ms);
            sum += time.gpu_ms;
        }
        gpu_ms.push_back(sum);
        cpu_ms.push_back(frame.recording_ms);
    }
};

double mean(const std::vector<double>& values) {
    double sum = 0;
    for (const double value : values) sum += value;
    return sum / double(values.size());
}

json figures(const Measured& of) {
    json passes = json::array();
    for (const std::string& name : of.order) passes.push_back({{"name", name}, {"gpu_ms", median(of.passes.at(name))}});
    return {
        {"min_ms", percentile(of.gpu_ms, 0.0)}, {"mean_ms", mean(of.gpu_ms)}, {"p99_ms", percentile(of.gpu_ms, 0.99)},
        {"processor_ms", median(of.cpu_ms)},    {"frames", of.gpu_ms.size()}, {"passes", passes}};
}

// Each scene on its own, warm: its passes' times, whatever a viewer would see.
json gpu_sum(Chapter& chapter, const FilmScene& scene, Mlaa& antialias, Frame& frame, ClockWarmer& load,
             const Options& options) {
    const int frames = options.frames_given ? options.frames : 60;
    std::map<std::string, Measured> measured;
    for (int i = -1; i < frames; ++i)
        for (const auto& [method, part] : {std::pair{"none", 0.25}, {"mlaa", 0.75}}) {
            antialias.method.set(method);
            if (i % 16 <= 0) load.run();
            // The middle half, without fades. Each at a time of its own, since a second frame would reuse the
            // first one's cache.
            const double share = 0.25 + 0.5 * (std::max(i, 0) + part) / frames;
            const auto time_s = static_cast<float>(scene.from_s + share * (scene.to_s - scene.from_s));
            const Picture at{options.size, time_s, options.seed, {}};
            i < 0 ? render(chapter, frame, at) : measured[method].draw(chapter, frame, at);
        }
    json by_method;
    for (const auto& [method, of] : measured) by_method[method] = figures(of);
    return by_method;
}

}  // namespace

// [run]
int run_benchmark(Chapter& chapter, Reel& reel, Mlaa& antialias, const std::string& file, const Options& options,
                  std::unique_ptr<Gpu>& gpu) {
    check_writable(file);
    chapter.plays = true;
    gpu = make_gpu(options);
    load_scene(chapter, *gpu, options.scene.empty() ? chapter.default_scene() : options.scene);
    if (!reel.is_open()) throw InputError("--benchmark: {} is no film", options.scene);
    if (options.automatic) choose_ways(chapter, reel, *gpu, options);
    const Timeline& film = reel.film();

    // 1. A viewer's frames, from a cold process on.
    const Played played = play(chapter, reel, *gpu, options);
    json written = played_figures(film, played.frames);
    written["in_order"]["stood_s"] = played.stood_s;

    // 2. Each scene's cost on the GPU.
    reel.wait_until_ready();
    Frame frame(*gpu);
    ClockWarmer load(*gpu);
    Patience patience("measuring", "scenes");
    for (size_t i = 0; i < film.scenes.size(); ++i) {
        written["scenes"][i]["gpu_sum"] = gpu_sum(chapter, film.scenes[i], antialias, frame, load, options);
        patience.show(static_cast<int>(i) + 1, static_cast<int>(film.scenes.size()));
    }
    written.update({{"device", gpu->device.info.name},
                    {"driver", gpu->device.info.driver},
                    {"software", gpu->device.software()},
                    {"size", {options.size.x, options.size.y}}});
    write_file(file, written.dump(1, '\t') + "\n");
    return 0;
}
// [/run]

}  // namespace lightwalk
