#include "common/app/headless.h"

#include <cmath>
#include <nlohmann/json.hpp>
#include <optional>

#include "common/app/clock_warmer.h"
#include "common/app/look.h"
#include "common/app/read_picture.h"
#include "common/app/render.h"
#include "common/base/error.h"
#include "common/base/files.h"
#include "common/base/patience.h"
#include "common/base/statistics.h"
#include "common/base/text.h"
#include "common/gpu/capture.h"

namespace lightwalk {
namespace {

using nlohmann::json;

void report_non_finite(const ImageRgb& linear, const std::string& why) {
    size_t nan = 0, infinite = 0;
    for (const glm::vec3& pixel : linear.pixels)
        for (int i = 0; i < 3; ++i) std::isnan(pixel[i]) ? ++nan : infinite += std::isinf(pixel[i]);
    if (nan || infinite)
        throw Failure("the HDR target holds {} NaN and {} infinite values{}{}", nan, infinite, why.empty() ? "" : ": ",
                      why);
}

// A picture of nothing is rarely meant.
void warn_of_black(const Options& options, const Image8& picture, const ImageRgb& linear, const Frame& frame) {
    if (options.pictures || !options.look.empty()) return;
    for (const glm::u8vec4& pixel : picture.pixels)
        if (pixel.r || pixel.g || pixel.b) return;
    float most = 0;
    for (const glm::vec3& pixel : linear.pixels) most = std::max({most, pixel.r, pixel.g, pixel.b});
    if (most > 0)
        return warn("{} is entirely black, and its linear light reaches {:.2g}: look at the exposure and the last pass",
                    options.screenshot, most);
    std::string passes, last;
    for (const auto& [pass, view] : frame.outputs)
        if (pass != std::exchange(last, pass)) passes += (passes.empty() ? "" : ", ") + pass;
    warn("{} is entirely black: look at the camera, at the lights and at what each pass wrote, --look PASS: {}",
         options.screenshot, passes);
}

json timings_json(const Gpu& gpu, const Options& options, const Chapter& chapter,
                  const std::vector<PassTime>& first_frame, const std::vector<std::vector<PassTime>>& frames,
                  const std::vector<double>& recording_ms) {
    // Union of all frames' passes: uploads, for instance, occur only in frames with changes.
    std::vector<std::pair<const PassTime*, std::vector<double>>> passes_of;
    for (const std::vector<PassTime>& frame : frames) {
        size_t behind = 0;
        for (const PassTime& pass : frame) {
            const auto known = std::find_if(passes_of.begin(), passes_of.end(),
                                            [&](const auto& one) { return one.first->name == pass.name; });
            const auto at = known != passes_of.end()
                                ? known
                                : passes_of.insert(passes_of.begin() + static_cast<long>(behind), {&pass, {}});
            at->second.push_back(pass.gpu_ms);
            behind = static_cast<size_t>(at - passes_of.begin()) + 1;
        }
    }
    json passes = json::array();
    for (const auto& [pass, samples] : passes_of) {
        const Quartiles q = quartiles(samples);
        passes.push_back({{"name", pass->name},
                          {"stage", pass->stage},
                          {"frames", samples.size()},
                          {"gpu_ms", q.median},
                          {"q1_ms", q.q1},
                          {"q3_ms", q.q3}});
    }
    json once = json::array();
    for (const PassTime& pass : first_frame)
        if (std::none_of(passes_of.begin(), passes_of.end(),
                         [&](const auto& one) { return one.first->name == pass.name; }))
            once.push_back({{"name", pass.name}, {"stage", pass.stage}, {"gpu_ms", pass.gpu_ms}});
    return {{"device", gpu.device.info.name},
            {"driver", gpu.device.info.driver},
            {"software", gpu.device.software()},
            {"size", {options.size.x, options.size.y}},
            {"frames", frames.size()},
            {"recording_cpu_ms", median(recording_ms)},
            {"passes", passes},
            {"once", once},
            {"status", chapter.all_status()}};
}

// CPU times of recording consecutive frames. ClockWarmer empties caches: up to twice as long on an H100's host.
std::vector<double> recording_in_a_row(Chapter& chapter, Frame& frame, const Options& options) {
    std::vector<double> recording_ms;
    for (int i = 0; i < options.frames; ++i) {
        Picture picture{
            options.size, options.time_s + static_cast<float>(options.frames + i) / 60.0f, options.seed, {}};
        picture.gathered = 0;
        render(chapter, frame, picture);
        frame.finish();
        recording_ms.push_back(frame.recording_ms);
    }
    return recording_ms;
}

}  // namespace

std::unique_ptr<Gpu> make_gpu(const Options& options) {
    if (!options.capture.empty()) load_renderdoc();
    auto gpu = std::make_unique<Gpu>(DeviceOptions{.name = options.device,
                                                   .validate = options.validate,
                                                   .software_paths = options.software_paths,
                                                   .surface_extensions = {}});
    const uint32_t most = gpu->device.properties.limits.maxImageDimension2D;
    if (std::max(options.size.x, options.size.y) > most)
        throw InputError("--size: this device renders at most {} pixels a side", most);
    return gpu;
}

int run_headless(const Options& options, Chapter& chapter, std::unique_ptr<Gpu>& holder, const Loading& loading) {
    for (const std::string& path : {options.screenshot, options.timings, options.capture})
        if (!path.empty()) check_writable(path);
    if (!holder) holder = make_gpu(options);
    Gpu& gpu = *holder;
    const size_t said_before = gpu.device.validation_message_count();
    load_scene(chapter, gpu, options.scene.empty() ? chapter.default_scene() : options.scene, loading);
    Frame frame(gpu);
    frame.set_frames_in_flight(2);  // as a window whose clock runs
    const Look look{.output = options.look};
    Image looked_at;
    look.attach(frame, looked_at, chapter.camera, chapter.scene.bounds);
    // Timing runs discard the first frame, which compiles shaders.
    ClockWarmer load(gpu);
    const int warm_up = options.timings.empty() ? 0 : 1;
    std::vector<PassTime> first_times;
    std::vector<std::vector<PassTime>> times;
    std::vector<double> recording_ms;
    Patience patience("drawing", "frames");
    for (int i = 0; i < options.frames + warm_up; ++i) {
        const int counted = std::max(i - warm_up, 0);
        if (!options.timings.empty()) load.run();
        const bool captured = !options.capture.empty() && i + 1 == options.frames + warm_up;
        std::optional<Capture> capture;
        if (captured) capture.emplace();
        Picture picture{options.size, options.time_s + static_cast<float>(counted) / 60.0f, options.seed, {}};
        if (!options.timings.empty() && i > 0) picture.gathered = 0;  // steady-state cost
        render(chapter, frame, picture);
        if (!options.timings.empty() || captured) frame.finish();
        if (captured) capture->write(options.capture);
        patience.show(i + 1, options.frames + warm_up);
        if (i < warm_up) add_times(first_times, frame.times);
        if (i < warm_up) continue;
        add_times(times.emplace_back(), frame.times);
        recording_ms.push_back(frame.recording_ms);
    }
    frame.finish();
    look.check(frame);
    // Checked first, so that an invalid picture does not overwrite a valid file.
    const ImageRgb linear = read_linear(gpu, frame.linear());
    report_non_finite(linear, chapter.why_not_finite());
    if (!options.screenshot.empty()) {
        const Image8 picture = read_picture(gpu, look.picture(frame, looked_at));
        write_png(options.screenshot, picture);
        warn_of_black(options, picture, linear, frame);
    }
    if (!options.timings.empty()) {
        json timings = timings_json(gpu, options, chapter, first_times, times, recording_ms);
        if (!gpu.device.software_paths) recording_ms = recording_in_a_row(chapter, frame, options);
        timings["recording_in_a_row_cpu_ms"] = median(recording_ms);
        write_file(options.timings, timings.dump(1, ' ', false, json::error_handler_t::replace) + "\n");
    }
    gpu.device.check_validation(said_before);
    return 0;
}

}  // namespace lightwalk
