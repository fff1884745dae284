#include "19_ambiance/benchmark.h"

#include <unistd.h>

#include <chrono>
#include <cmath>
#include <ctime>
#include <fstream>
#include <nlohmann/json.hpp>
#include <set>
#include <thread>

#include "19_ambiance/ways.h"
#include "common/app/clock_warmer.h"
#include "common/app/headless.h"
#include "common/app/render.h"
#include "common/base/error.h"
#include "common/base/files.h"
#include "common/base/patience.h"
#include "common/base/statistics.h"
#include "common/gpu/gpu_work.h"

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
    return sum / double(std::max<size_t>(values.size(), 1));
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

namespace {

using nlohmann::json;

constexpr int a_second = 60, after_cut = 6;

double clock_ms(clockid_t clock) {
    timespec now{};
    clock_gettime(clock, &now);
    return 1e3 * static_cast<double>(now.tv_sec) + 1e-6 * static_cast<double>(now.tv_nsec);
}

// When this program started, on the clock since boot: field 22 of the line, counted after the name in brackets.
double started_ms() {
    std::ifstream line("/proc/self/stat");
    line.ignore(1 << 16, ')');
    std::string field;
    for (int i = 3; i <= 22; ++i) line >> field;
    return 1e3 * std::stod(field) / static_cast<double>(sysconf(_SC_CLK_TCK));
}

template <class Wanted>
std::vector<double> column(const std::vector<PlayedFrame>& frames, double PlayedFrame::*figure, const Wanted& wanted) {
    std::vector<double> values;
    for (size_t i = 0; i < frames.size(); ++i)
        if (wanted(i)) values.push_back(frames[i].*figure);
    return values;
}

template <class Wanted>
json summary(const std::vector<PlayedFrame>& frames, const Wanted& wanted) {
    const std::vector<double> all = column(frames, &PlayedFrame::wall_ms, wanted);
    if (all.empty()) return {{"frames", 0}};
    const double mean_ms = mean(all);
    return {{"frames", all.size()},
            {"mean_ms", mean_ms},
            {"frames_a_second", 1e3 / mean_ms},
            {"p99_ms", percentile(all, 0.99)},
            {"longest_ms", percentile(all, 1.0)},
            {"processor_ms", median(column(frames, &PlayedFrame::processor_ms, wanted))},
            {"gpu_ms", mean(column(frames, &PlayedFrame::gpu_ms, wanted))}};
}

}  // namespace

std::vector<int> played_numbers(const Timeline& film, std::optional<int> each_scene) {
    std::set<int> numbers;
    const int end = static_cast<int>(std::ceil(film.duration_s * a_second));
    const auto add = [&](int number) {
        if (number >= 0 && number < end) numbers.insert(number);
    };
    for (int i = 0; i < (each_scene ? a_second : end); ++i) add(i);
    for (const FilmScene& scene : film.scenes) {
        const int first = static_cast<int>(std::ceil(scene.from_s * a_second));
        for (int i = 0; i < after_cut; ++i) add(first + i);
        const double frames = (scene.to_s - scene.from_s) * a_second;
        for (int i = 0; i < each_scene.value_or(0); ++i)
            add(first + static_cast<int>((i + 0.5) / *each_scene * frames));
    }
    return {numbers.begin(), numbers.end()};
}

Played play(Chapter& chapter, Reel& reel, Gpu& gpu, const Options& options) {
    const Timeline& film = reel.film();
    const std::vector<int> numbers =
        played_numbers(film, options.frames_given ? std::optional(options.frames) : std::nullopt);
    Played played;
    std::vector<double> gpu_ms, ended_ms;  // of recordings; a picture of several samples has several
    std::vector<std::pair<size_t, size_t>> recordings;
    Frame frame(gpu);
    frame.set_frames_in_flight(2);
    frame.on_ended = [&](const std::vector<PassTime>& times) {
        gpu_ms.push_back(0);
        for (const PassTime& time : times) gpu_ms.back() += time.gpu_ms;
        ended_ms.push_back(gpu_work.ended_ms);
    };
    const auto draw = [&](int number) {
        Picture picture{options.size, static_cast<float>(number) / a_second, options.seed, {}};
        picture.gathered = 0;  // as in a window, it goes on from the one before
        render(chapter, frame, picture);
    };
    Patience patience("playing", "frames");
    double first_ms = 0;
    for (const int number : numbers) {
        const double time_s = static_cast<double>(number) / a_second;
        if (first_ms > 0) {
            const double from_ms = clock_ms(CLOCK_BOOTTIME);
            const auto is_early = [&] { return clock_ms(CLOCK_BOOTTIME) - first_ms < 1e3 * time_s; };
            while (is_early() && !reel.is_ready(time_s))
                unlocked([] { std::this_thread::sleep_for(std::chrono::milliseconds(1)); });
            const double stood_ms = clock_ms(CLOCK_BOOTTIME) - from_ms;
            played.stood_s += 1e-3 * stood_ms;
            for (int again = 0; stood_ms > 1 && again < 4; ++again) draw(played.frames.back().number);
        }
        const std::vector<Timeline::Shown> shown = film.shown(time_s);
        PlayedFrame& one = played.frames.emplace_back();
        one.number = number;
        if (!shown.empty()) one.scene = shown.back().scene;
        const double processor_ms = clock_ms(CLOCK_THREAD_CPUTIME_ID);
        const GpuWork before = gpu_work;
        const size_t first = frame.begun;
        draw(number);
        recordings.emplace_back(first, frame.begun);
        one.processor_ms = clock_ms(CLOCK_THREAD_CPUTIME_ID) - processor_ms;
        one.pipelines = gpu_work.pipelines - before.pipelines;
        one.allocations = gpu_work.allocations - before.allocations;
        one.transfers = gpu_work.transfers - before.transfers;
        if (played.frames.size() == 1) {
            frame.finish();  // a viewer waits until it is seen
            first_ms = clock_ms(CLOCK_BOOTTIME);
            one.wall_ms = first_ms - started_ms();
        }
        patience.show(static_cast<int>(played.frames.size()), static_cast<int>(numbers.size()));
    }
    frame.finish();
    for (size_t i = 0; i < recordings.size(); ++i) {
        const auto [first, end] = recordings[i];
        for (size_t j = first; j < end; ++j) played.frames[i].gpu_ms += gpu_ms.at(j);
        if (i > 0) played.frames[i].wall_ms = ended_ms.at(end - 1) - ended_ms.at(first - 1);
    }
    return played;
}

json played_figures(const Timeline& film, const std::vector<PlayedFrame>& frames) {
    using Wanted = std::function<bool(size_t)>;
    std::vector<int> in_scene(frames.size(), 0);  // number of a frame among its scene's
    for (size_t i = 1; i < frames.size(); ++i)
        in_scene[i] = frames[i].scene == frames[i - 1].scene ? in_scene[i - 1] + 1 : 0;
    json scenes = json::array(), cuts = json::array();
    for (size_t place = 0; place < film.scenes.size(); ++place) {
        const FilmScene& scene = film.scenes[place];
        const Wanted in_it = [&](size_t i) { return i > 0 && frames[i].scene == place; };
        json figures = summary(frames, in_it);
        const double mean_ms = figures.value("mean_ms", 0.0);
        figures.update({{"name", scene.name}, {"kind", scene.kind}});
        scenes.push_back(figures);
        if (scene.from_s <= 0) continue;
        const Wanted at_cut = [&](size_t i) { return in_it(i) && in_scene[i] < after_cut; };
        const Wanted steady = [&](size_t i) { return in_it(i) && in_scene[i] >= after_cut && in_scene[i] < a_second; };
        const std::vector<double> after = column(frames, &PlayedFrame::wall_ms, at_cut),
                                  later = column(frames, &PlayedFrame::wall_ms, steady);
        if (after.empty()) continue;
        json cut{{"to", scene.name},
                 {"at_s", scene.from_s},
                 {"frames_ms", after},
                 {"processor_ms", column(frames, &PlayedFrame::processor_ms, at_cut)},
                 {"gpu_ms", column(frames, &PlayedFrame::gpu_ms, at_cut)},
                 {"longest_ms", percentile(after, 1.0)},
                 {"mean_ms", mean_ms},
                 {"steady_ms", later.empty() ? mean_ms : median(later)}};
        for (const auto& [name, count] : {std::pair{"pipelines", &PlayedFrame::pipelines},
                                          {"allocations", &PlayedFrame::allocations},
                                          {"transfers", &PlayedFrame::transfers}}) {
            uint64_t sum = 0;
            for (size_t i = 0; i < frames.size(); ++i) sum += at_cut(i) ? frames[i].*count : 0;
            cut[name] = sum;
        }
        cuts.push_back(cut);
    }
    const Wanted any = [](size_t i) { return i > 0; };
    json all = summary(frames, any);
    all["first_frame_s"] = 1e-3 * frames.front().wall_ms;
    all["first_second_longest_ms"] = percentile(
        column(frames, &PlayedFrame::wall_ms, Wanted([&](size_t i) { return i > 0 && frames[i].number < a_second; })),
        1.0);
    return {{"in_order", all}, {"scenes", scenes}, {"cuts", cuts}};
}

}  // namespace lightwalk
