#include "15_terrain_water/ground.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <utility>

#include "common/base/exercise.h"
#include "common/base/shared_lock.h"

namespace lightwalk {

namespace {

// To the nearest of 2^bits - 1 steps between the least and the greatest.
void quantise(std::vector<float>& heights, double bits) {
    const auto [low, high] = std::minmax_element(heights.begin(), heights.end());
    const double least = double(*low), step = (double(*high) - least) / (std::exp2(bits) - 1);
    if (step <= 0) return;
    for (float& height : heights)
        height = static_cast<float>(least + step * std::round((double(height) - least) / step));
}

std::filesystem::path height_map_of(const SceneFile& scene) {
    const SceneObject* const object = first_shown(scene, is_height_map_file);
    return object ? object->model : std::filesystem::path();
}

}  // namespace

Ground::Ground(Module& owner, std::string name) : Module(owner, std::move(name), "ground") {}

void Ground::prepare(Gpu& gpu, Scene& scene) {
    source_ = {};
    made_.forget();
    file_ = height_map_of(scene.file);
    if (file_.empty()) return;
    name_unused_placement(scene.file, is_height_map_file, "a terrain");
    source_ = unlocked([&] { return read_height_map(find_asset(file_)); });
    if (!precision.is("float")) quantise(source_.elevation_m, std::stod(precision.text()));
    texels_ = Image(gpu.device, {.name = "elevations",
                                 .format = VK_FORMAT_R32_SFLOAT,
                                 .size = {uint32_t(source_.width), uint32_t(source_.height)}});
    gpu.upload(texels_, std::as_bytes(std::span(source_.elevation_m)));
}

void Ground::follow(Gpu& gpu, Scene& scene) {
    if (height_map_of(scene.file) != file_) prepare(gpu, scene);
}

LandSource Ground::land_source() const {
    const glm::vec2 size_m = source_.sample_m * glm::vec2(source_.width - 1, source_.height - 1);
    const float side_m = span_km > 0 ? 1000.0f * span_km : std::min(size_m.x, size_m.y);
    const int samples = (1 << levels) + 1;
    const float spacing_m = side_m / static_cast<float>(samples - 1);
    const glm::vec2 first_m = 1000.0f * glm::vec2(center_x_km.value, center_z_km.value) - 0.5f * side_m;
    return {.first = (first_m + 0.5f * size_m) / source_.sample_m,
            .step = spacing_m / source_.sample_m,
            .place_m = first_m,
            .spacing_m = spacing_m,
            .samples = samples,
            .datum_m = datum_m,
            .height_scale = height_scale,
            .detail_m = detail_m,
            .cliffs = cliffs,
            .cliff_m = cliff_m,
            .edge_m = 1000.0f * edge_km,
            .plain = {1000.0f * plain_km.value, plain_m.value}};
}

void Ground::make_images(Device& device) {
    const uint32_t cells = static_cast<uint32_t>(map_.samples) - 1, top = static_cast<uint32_t>(map_.top);
    const auto image = [&](Image& it, const char* name, VkFormat format, uint32_t side, uint32_t mips) {
        it.ensure(device,
                  {.name = path() + name, .format = format, .size = glm::uvec2(side), .mips = mips, .kept = true});
    };
    image(heights_, " heights", VK_FORMAT_R32_SFLOAT, cells + 1, 1);
    image(slopes_, " slopes", VK_FORMAT_R16G16B16A16_SFLOAT, cells + 1, full_mip_count(glm::uvec2(cells + 1)));
    image(bounds_, " bounds", VK_FORMAT_R32G32_SFLOAT, cells, full_mip_count(glm::uvec2(cells)));
    image(errors_, " errors", VK_FORMAT_R32_SFLOAT, 1u << top, top + 1);
}

void Ground::make_heights(Frame& frame, const LandSource& from) {
    frame.compute("ground heights", {.reads = {texels_}, .writes = {heights_}}, [&](Compute& pass) {
        pass.use(make_heights_).set("land_source", from).set("source", texels_, nearest_clamp);
        pass.set("result", heights_).dispatch_threads(heights_.desc.size);
    });
    frame.compute("ground slopes", {.reads = {heights_, slopes_}, .writes = {slopes_}}, [&](Compute& pass) {
        pass.use(make_slopes_).set("land_map", map_).set("heights", heights_, nearest_clamp);
        pass.set("result", slopes_.mip(0)).dispatch_threads(slopes_.desc.size);
        for (uint32_t m = 1; m < slopes_.desc.mips; ++m) {
            pass.wait();
            pass.use(make_mip_).set("finer", slopes_.mip(m - 1), linear_clamp).set("result", slopes_.mip(m));
            pass.dispatch_threads(glm::uvec2(slopes_.mip(m).size()));
        }
    });
    frame.compute("ground bounds", {.reads = {heights_, bounds_}, .writes = {bounds_}}, [&](Compute& pass) {
        for (uint32_t m = 0; m < bounds_.desc.mips; ++m) {
            pass.use(make_bounds_).set("from_heights", m == 0 ? 1 : 0).set("result", bounds_.mip(m));
            pass.set("finer", m == 0 ? ImageView(heights_) : bounds_.mip(m - 1), nearest_clamp);
            pass.dispatch_threads(glm::uvec2(bounds_.mip(m).size())).wait();
        }
    });
}

void Ground::make_errors(Frame& frame) {
    frame.compute("ground errors", {.reads = {heights_, errors_}, .writes = {errors_}}, [&](Compute& pass) {
        for (uint32_t m = 0; m < errors_.desc.mips; ++m) {
            const struct {
                int level;
                float spacing_m;
            } level{static_cast<int>(m), map_.spacing_m};
            pass.use(make_errors_).set("heights", heights_, nearest_clamp).set("result", errors_.mip(m));
            pass.set("finer", m == 0 ? ImageView(heights_) : errors_.mip(m - 1), nearest_clamp);
            pass.set("error_level", level).dispatch(errors_.mip(m).size()).wait();
        }
    });
}

void Ground::record(Frame& frame, bool with_errors) {
    if (!exists()) return;
    const LandSource from = land_source();
    if (!made_.is_current(from, Exercises::epoch())) {
        const auto [low, high] = std::minmax_element(source_.elevation_m.begin(), source_.elevation_m.end());
        map_ = {.corner = -0.5f * from.spacing_m * static_cast<float>(from.samples - 1) * glm::vec2(1.0f),
                .spacing_m = from.spacing_m,
                .samples = from.samples,
                .top = levels - CHUNK_LEVELS,
                .highest_m = height_scale * (*high - datum_m) + 4 * detail_m + 0.5f * cliff_m};
        make_images(frame.gpu.device);
        make_heights(frame, from);
        errors_made_ = false;
    }
    if (with_errors && !std::exchange(errors_made_, true)) make_errors(frame);
}

void Ground::bind(Pass& pass) const {
    pass.set_if_present("land_map", map_);
    if (!heights_) return;
    pass.set_if_present("land_heights", heights_, nearest_clamp);
    pass.set_if_present("land_slopes", slopes_, linear_clamp);
    pass.set_if_present("land_bounds", bounds_, nearest_clamp);
    if (errors_made_) pass.set_if_present("land_errors", errors_, nearest_clamp);
}

std::vector<Resource> Ground::reads() const {
    if (!heights_) return {};
    std::vector<Resource> all{heights_, slopes_, bounds_};
    if (errors_made_) all.emplace_back(errors_);
    return all;
}

std::optional<float> GroundHeights::height_at(const glm::dvec2& place) const {
    const glm::dvec2 at = (place - glm::dvec2(map.corner)) / double(map.spacing_m);
    const int last = map.samples - 1;
    if (heights_m.empty() || !(at.x >= 0 && at.y >= 0 && at.x <= last && at.y <= last)) return std::nullopt;
    const int x = std::min(int(at.x), last - 1), y = std::min(int(at.y), last - 1);
    const auto sample = [&](int dx, int dy) {
        return double(heights_m[size_t(y + dy) * size_t(map.samples) + size_t(x + dx)]);
    };
    const double fx = at.x - x, fy = at.y - y;
    return float(glm::mix(glm::mix(sample(0, 0), sample(1, 0), fx), glm::mix(sample(0, 1), sample(1, 1), fx), fy));
}

std::optional<GroundHeights::Met> GroundHeights::met_by(const PickRay& ray, float most_m) const {
    if (heights_m.empty()) return std::nullopt;
    const glm::dvec3 origin(ray.origin), direction(ray.direction);
    const auto above = [&](double t) -> std::optional<double> {
        const glm::dvec3 at = origin + t * direction;
        const auto height = height_at({at.x, at.z});
        return height ? std::optional(at.y - double(*height)) : std::nullopt;
    };
    const double step = std::max(0.5 * double(map.spacing_m), double(most_m) / 50000);
    double before_t = 0;
    std::optional<double> before = above(0);
    while (before_t < double(most_m)) {
        const double t = std::min(before_t + step, double(most_m));
        const auto now = above(t);
        if (before && now && *before > 0 && *now <= 0) {
            double low = before_t, high = t;
            for (int i = 0; i < 40; ++i) {
                const double middle = 0.5 * (low + high);
                (above(middle).value_or(0) > 0 ? low : high) = middle;
            }
            const glm::dvec3 at = origin + high * direction;
            const double reach = 0.5 * double(map.spacing_m);
            const auto near = [&](double x, double z) { return double(height_at({x, z}).value_or(float(at.y))); };
            const glm::dvec3 normal(near(at.x - reach, at.z) - near(at.x + reach, at.z), 2 * reach,
                                    near(at.x, at.z - reach) - near(at.x, at.z + reach));
            return Met{float(high), glm::vec3(glm::normalize(normal))};
        }
        before = now;
        before_t = t;
    }
    return std::nullopt;
}

GroundHeights read_heights(Gpu& gpu, const Ground& ground) {
    if (!ground.exists() || !ground.heights()) return {};
    const std::vector<std::byte> bytes = gpu.read_back(ground.heights());
    GroundHeights all{ground.map(), std::vector<float>(bytes.size() / sizeof(float))};
    std::memcpy(all.heights_m.data(), bytes.data(), bytes.size());
    return all;
}

}  // namespace lightwalk
