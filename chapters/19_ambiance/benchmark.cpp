#include "19_ambiance/benchmark.h"

#include <chrono>
#include <nlohmann/json.hpp>

#include "19_ambiance/ways.h"
#include "common/app/gpu_load.h"
#include "common/app/headless.h"
#include "common/app/render.h"
#include "common/base/error.h"
#include "common/base/files.h"
#include "common/base/patience.h"
#include "common/base/statistics.h"

namespace lightwalk {
namespace {

using nlohmann::json;

constexpr int around_cut = 6;  // frames before it, and as many after

double now_ms() {
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

// Of frames drawn one after the other.
struct Measured {
    std::vector<double> gpu_ms, cpu_ms, wall_ms;
    std::map<std::string, std::vector<double>> passes;
    std::vector<std::string> order;

    void draw(Chapter& chapter, Frame& frame, const Picture& picture) {
        const double started = now_ms();
        render(chapter, frame, picture);
        wall_ms.push_back(now_ms() - started);
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

double most(const std::vector<double>& values) { return percentile(values, 1.0); }

json figures(const Measured& of) {
    json passes = json::array();
    for (const std::string& name : of.order) passes.push_back({{"name", name}, {"gpu_ms", median(of.passes.at(name))}});
    return {
        {"min_ms", percentile(of.gpu_ms, 0.0)}, {"mean_ms", mean(of.gpu_ms)}, {"p99_ms", percentile(of.gpu_ms, 0.99)},
        {"processor_ms", mean(of.cpu_ms)},      {"frames", of.gpu_ms.size()}, {"passes", passes}};
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
    const int frames = options.frames_given ? options.frames : 60;
    Frame frame(*gpu);
    GpuLoad load(*gpu);
    const auto picture = [&](double time_s) {
        return Picture{options.size, static_cast<float>(time_s), options.seed, {}};
    };
    Patience patience("measuring", "scenes");

    json scenes = json::array(), cuts = json::array();
    for (const FilmScene& scene : film.scenes) {
        json by_method;
        std::map<std::string, Measured> measured;
        for (int i = -1; i < frames; ++i)
            for (const auto& [method, part] : {std::pair{"none", 0.25}, {"mlaa", 0.75}}) {
                antialias.method.set(method);
                if (i % 16 <= 0) load.run();
                // The middle half, without fades. Each at a time of its own, since a second frame would reuse the
                // first one's cache.
                const double share = 0.25 + 0.5 * (std::max(i, 0) + part) / frames;
                const Picture at = picture(scene.from_s + share * (scene.to_s - scene.from_s));
                i < 0 ? render(chapter, frame, at) : measured[method].draw(chapter, frame, at);
            }
        for (const auto& [method, of] : measured) by_method[method] = figures(of);
        scenes.push_back({{"name", scene.name}, {"kind", scene.kind}, {"antialiasing", by_method}});
        patience.show(static_cast<int>(scenes.size()), static_cast<int>(film.scenes.size()));
    }
    for (const FilmScene& scene : film.scenes) {
        if (scene.from_s <= 0) continue;
        Measured before, after;
        for (int i = -around_cut; i < around_cut; ++i)
            (i < 0 ? before : after).draw(chapter, frame, picture(scene.from_s + (i + 0.5) / 60));
        cuts.push_back({{"to", scene.name},
                        {"at_s", scene.from_s},
                        {"frames_ms", after.wall_ms},
                        {"longest_ms", most(after.wall_ms)},
                        {"mean_ms", mean(after.wall_ms)}});
    }
    write_file(file, json{{"device", gpu->device.info.name},
                          {"driver", gpu->device.info.driver},
                          {"software", gpu->device.software()},
                          {"size", {options.size.x, options.size.y}},
                          {"scenes", scenes},
                          {"cuts", cuts}}
                             .dump(1, '\t') +
                         "\n");
    return 0;
}
// [/run]

}  // namespace lightwalk
