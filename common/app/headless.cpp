#include <cmath>
#include <cstdio>
#include <cstring>
#include <nlohmann/json.hpp>

#include "common/app/options.h"
#include "common/study/study.h"
#include "common/base/error.h"
#include "common/base/files.h"
#include "common/image/image.h"
#include "common/measure/statistics.h"

namespace lightwalk {
namespace {

using nlohmann::json;

// Half floats whose exponent is all ones: infinite, or NaN where the mantissa is not zero.
void report_non_finite(Gpu& gpu, const Image& hdr) {
    const std::vector<std::byte> texels = gpu.read_back(hdr);
    size_t nan = 0, infinite = 0;
    for (size_t i = 0; i + 1 < texels.size(); i += 2) {
        uint16_t half = 0;
        std::memcpy(&half, texels.data() + i, 2);
        if ((half & 0x7c00) == 0x7c00) ++((half & 0x03ff) ? nan : infinite);
    }
    if (nan || infinite)
        throw Failure("the HDR target holds " + std::to_string(nan) + " NaN and " + std::to_string(infinite) +
                      " infinite values");
}

json timings_json(const Gpu& gpu, const Options& options, const Chapter& chapter,
                  const std::vector<std::vector<PassTime>>& frames) {
    json passes = json::array();
    for (size_t i = 0; i < frames[0].size(); ++i) {
        std::vector<double> samples;
        for (const auto& frame : frames)
            if (i < frame.size()) samples.push_back(frame[i].gpu_ms);
        const Quartiles q = quartiles(samples);
        passes.push_back({{"name", frames[0][i].name},
                          {"stage", frames[0][i].stage},
                          {"gpu_ms", q.median},
                          {"q1_ms", q.q1},
                          {"q3_ms", q.q3}});
    }
    return {{"device", gpu.device.info.name},    {"driver", gpu.device.info.driver},
            {"software", gpu.device.software()}, {"size", {options.size.x, options.size.y}},
            {"frames", frames.size()},           {"passes", passes},
            {"status", chapter.status()}};
}

}  // namespace

int run_headless(const Options& options, Chapter& chapter, std::unique_ptr<Gpu>& holder) {
    for (const std::string& path : {options.screenshot, options.timings, options.study})
        if (!path.empty()) check_writable(path);
    if (!options.study.empty() && run_cpu_study(options, chapter)) return 0;
    holder = std::make_unique<Gpu>(
        DeviceOptions{.name = options.device, .validate = options.validate, .surface_extensions = {}});
    Gpu& gpu = *holder;
    const uint32_t most = gpu.device.properties.limits.maxImageDimension2D;
    if (std::max(options.size.x, options.size.y) > most)
        throw InputError("--size: this device renders at most " + std::to_string(most) + " pixels a side");
    if (!options.study.empty()) {
        run_study(options, chapter, gpu);
        gpu.device.check_validation();
        return 0;
    }
    const auto explanation = load_scene(chapter, gpu, options.scene.empty() ? chapter.default_scene() : options.scene,
                                        options.automatic ? options.budget : std::nullopt, options.size);
    if (options.explain)
        for (const std::string& line : explanation) std::printf("%s\n", line.c_str());
    Frame frame(gpu);
    // The first frame of a timing run compiles and warms up, and is not counted.
    const int warm_up = options.timings.empty() ? 0 : 1;
    std::vector<std::vector<PassTime>> times;
    for (int i = 0; i < options.frames + warm_up; ++i) {
        const int counted = std::max(i - warm_up, 0);
        render(chapter, frame, options.size, options.time_s + static_cast<float>(counted) / 60.0f, options.seed);
        if (i >= warm_up) times.push_back(frame.times);
    }
    if (!options.screenshot.empty()) {
        Image8 picture(static_cast<int>(options.size.x), static_cast<int>(options.size.y));
        const std::vector<std::byte> texels = gpu.read_back(frame.output);
        std::memcpy(picture.pixels.data(), texels.data(), texels.size());
        write_png(options.screenshot, picture);
    }
    if (!options.timings.empty())
        write_file(options.timings, timings_json(gpu, options, chapter, times).dump(1) + "\n");
    report_non_finite(gpu, frame.hdr);
    gpu.device.check_validation();
    return 0;
}

}  // namespace lightwalk
