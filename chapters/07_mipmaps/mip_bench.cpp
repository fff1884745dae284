#include "07_mipmaps/mip_bench.h"

#include <cstdlib>
#include <nlohmann/json.hpp>

#include "07_mipmaps/texels.h"
#include "common/app/clock_warmer.h"
#include "common/base/error.h"
#include "common/base/files.h"
#include "common/base/statistics.h"
#include "common/base/text.h"
#include "common/image/image.h"
#include "common/scene/asset_path.h"
#include "common/study/study.h"

namespace lightwalk {
namespace {

using nlohmann::json;

const Pipeline copy_bytes = compute({.shader = "07_mipmaps/copy_bytes.comp"});
constexpr VkFormat half4 = VK_FORMAT_R16G16B16A16_SFLOAT;
constexpr uint32_t most_measured = 1366;  // texels a side up to which errors are computed on the host
const std::vector<std::string> methods{"copy", "blit", "box", "single_pass", "bilinear", "polyphase", "kaiser"};

truth::Texels noise(glm::uvec2 size) {
    truth::Texels texels{size, {}};
    uint32_t n = 1;
    for (size_t i = 0; i < size_t(size.x) * size.y; ++i) {
        n = n * 1664525u + 1013904223u;  // Numerical Recipes' generator
        texels.values.emplace_back(double(n >> 8 & 255) / 255, double(n >> 16 & 255) / 255, double(n >> 24) / 255, 1);
    }
    return texels;
}

truth::Texels picture(const char* asset) {
    const TexelImage image = read_texels(find_asset(asset), false);
    truth::Texels texels{{image.width, image.height}, {}};
    for (size_t i = 0; i < image.bytes.size(); i += 4) {
        glm::dvec4 value;
        for (int c = 0; c < 4; ++c) value[c] = std::to_integer<int>(image.bytes[i + size_t(c)]) / 255.0;
        texels.values.push_back(value);
    }
    return texels;
}

// One image, every method in turn.
class Bench {
  public:
    Bench(Gpu& gpu, json& result, int rounds) : gpu_(gpu), result_(result), rounds_(rounds) {}

    void measure(const std::string& scene, const json& knobs, const truth::Texels& texels, VkFormat format,
                 Content content, bool by_level = false) {
        show_progress(scene, done_++, 12);
        result_["scenes"][scene] = {{"file", ""}, {"set", knobs}};
        const Image image(
            gpu_.device,
            {.name = scene, .format = format, .size = texels.size, .mips = full_mip_count(texels.size), .kept = true});
        Frame frame(gpu_);
        frame.begin({4, 4}, 0);
        frame.upload("first level", ImageView(image).mip(0), to_bytes(texels, format));
        frame.end();
        VkDeviceSize bytes = 0;
        for (uint32_t m = 0; m < image.desc.mips; ++m) bytes += byte_count(image.mip(m));
        from_ = Buffer(gpu_.device, {.name = "copied from", .bytes = bytes / 2});
        to_ = Buffer(gpu_.device, {.name = "copied to", .bytes = bytes / 2});

        std::vector<std::string> measured;
        for (const std::string& method : methods)  // hundreds of lookups for each texel: not on a processor
            if ((method != "kaiser" || !gpu_.device.software_paths || texels.size.x <= 2048) &&
                (method != "bilinear" || content == Content::linear))
                measured.push_back(method);
        std::map<std::string, std::vector<double>> times;
        std::map<std::string, std::vector<double>> errors;
        load_.run(std::chrono::milliseconds(1500));
        for (int round = -1; round < rounds_; ++round)
            for (const std::string& method : measured) {
                load_.run();
                const double ms = time(frame, image, method, content);
                if (round >= 0) times[method].push_back(ms);
                if (round < 0 && method != "copy" && texels.size.x <= most_measured)
                    errors[method] = level_errors(gpu_, image, content);
            }
        for (const std::string& method : measured) {
            const Quartiles q = quartiles(times[method]);
            json point{{"scene", scene},
                       {"method", method},
                       {"knobs", knobs},
                       {"error", {{"nan", 0}, {"inf", 0}, {"gb_per_s", static_cast<double>(bytes) / q.median / 1e6}}},
                       {"time_ms", {{"median", q.median}, {"q1", q.q1}, {"q3", q.q3}, {"rounds", rounds_}}}};
            double sum = 0, level = 0;
            for (const double error : errors[method]) {
                sum += error * error / static_cast<double>(errors[method].size());
                if (!by_level) continue;
                json one = point;
                one["scene"] = scene + ", level by level";
                one["knobs"]["level"] = level += 1;
                one["error"]["level_rmse"] = error;
                result_["points"].push_back(one);
            }
            if (!errors[method].empty()) point["error"]["level_rmse"] = std::sqrt(sum);
            result_["points"].push_back(point);
        }
        from_ = Buffer();
        to_ = Buffer();
    }

  private:
    struct Owner : Module {};

    double time(Frame& frame, const ImageView& image, const std::string& method, Content content) {
        frame.begin({4, 4}, 0);
        if (method == "copy") {
            record_copy(frame);
        } else {
            chain_.bilinear.value = method == "bilinear";  // the single pass with one lookup for four texels
            chain_.method.set(chain_.bilinear ? "single_pass" : method);
            chain_.record(frame, image, content);
        }
        frame.end();
        double ms = 0;
        for (const PassTime& pass : frame.times) ms += pass.gpu_ms;
        return ms;
    }

    // By a shader: an H200 copies buffers at a twentieth of its shaders' rate. On a CPU, memcpy.
    void record_copy(Frame& frame) {
        const auto count = static_cast<uint32_t>(from_.bytes / 16);
        if (gpu_.device.software_paths)
            frame.transfer("copy", {.reads = {from_}, .writes = {to_}, .with = {}}, [&](VkCommandBuffer commands) {
                const VkBufferCopy all{.size = from_.bytes};
                vkCmdCopyBuffer(commands, from_.handle, to_.handle, 1, &all);
            });
        else
            frame.compute("copy", {.reads = {from_}, .writes = {to_}}, [&](Compute& pass) {
                pass.use(copy_bytes).set("from", from_).set("to", to_).set("count", count);
                pass.dispatch_threads(glm::uvec2((count + 3) / 4, 1));
            });
    }

    Gpu& gpu_;
    json& result_;
    ClockWarmer load_{gpu_};
    Owner owner_;
    MipChain chain_{owner_, "mips"};
    Buffer from_, to_;
    int done_ = 0;
    const int rounds_;
};

}  // namespace

int run_mip_bench(const std::string& file, const Options& options) {
    check_writable(file);
    const int rounds = options.study_rounds.value_or(7);
    if (rounds < 1) throw InputError("--study-rounds {}: expected 1 or more", rounds);
    const uint32_t most = options.size_given ? std::max(options.size.x, options.size.y) : 8192;
    Gpu gpu({.name = options.device, .surface_extensions = {}});
    json result = {
        {"chapter", "07_mipmaps"},
        {"title", "Levels: time against error"},
        {"subject", "frame"},
        {"device", gpu.device.info.name},
        {"driver", gpu.device.info.driver},
        {"stage", "compute (blit: transfer; copy: compute, on a processor transfer)"},
        {"command", "build/chapters/07_mipmaps --mip-bench FILE"},
        {"truth", {{"method", "the mean over each texel's area, in double precision"}, {"exact", true}}},
        {"error_metric", "level_rmse"},
        {"time_unit", "ms"},
        {"metrics",
         {{"level_rmse", "error of the levels, RMSE, linear"}, {"gb_per_s", "GB/s of what must be read and written"}}},
        {"scenes", json::object()},
        {"points", json::array()}};
    Bench bench(gpu, result, rounds);
    bench.measure("noise, 1024x1024, RGBA16F", json::object(), noise({1024, 1024}), half4, Content::linear);
    bench.measure("city lights, 1366x683, sRGB", json::object(), picture("textures/city_lights.jpg"),
                  VK_FORMAT_R8G8B8A8_SRGB, Content::srgb, true);
    bench.measure("checker with a border, 1023x511, sRGB", json::object(), picture("textures/checker.png"),
                  VK_FORMAT_R8G8B8A8_SRGB, Content::srgb);
    bench.measure(
        "normals, 512x512, RGBA8", json::object(),
        [] {
            truth::Texels texels = picture("textures/stone_tiles_normal.png");
            for (glm::dvec4& texel : texels.values) texel.a = 0;
            return texels;
        }(),
        VK_FORMAT_R8G8B8A8_UNORM, Content::normal);
    json sides = json::array();
    for (uint32_t side = 64; side <= std::min(most, gpu.device.properties.limits.maxImageDimension2D); side *= 2) {
        const std::string label = fmt::format("noise, {} texels a side", side);
        try {
            bench.measure(label, {{"side", side}}, noise({side, side}), half4, Content::linear);
            sides.push_back(label);
        } catch (const Failure& e) {
            warn("{}: {}; left out", label, e.what());
            result["scenes"].erase(label);
        }
    }
    const json all{"noise, 1024x1024, RGBA16F", "city lights, 1366x683, sRGB", "checker with a border, 1023x511, sRGB",
                   "normals, 512x512, RGBA8"};
    const json makers(std::vector<std::string>(methods.begin() + 1, methods.end()));
    result["charts"] = {{{"name", "main"}, {"scenes", all}, {"methods", makers}},
                        {{"name", "rate"},
                         {"title", "Levels: bytes a second against size"},
                         {"x", "knob side"},
                         {"x_label", "texels a side"},
                         {"y", "gb_per_s"},
                         {"y_label", "GB/s of what must be read and written  (↑ faster)"},
                         {"scenes", sides}},
                        {{"name", "levels"},
                         {"title", "Levels: error level by level"},
                         {"x", "knob level"},
                         {"y", "level_rmse"},
                         {"x_scale", "linear"},
                         {"methods", makers},
                         {"scenes", {"city lights, 1366x683, sRGB, level by level"}}}};
    write_file(file, result.dump(1, ' ', false, json::error_handler_t::replace) + "\n");
    show_progress("written to " + file + "\n", 1, 1);
    return 0;
}

}  // namespace lightwalk
