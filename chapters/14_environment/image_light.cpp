#include "14_environment/image_light.h"

#include <cmath>
#include <cstring>
#include <glm/gtc/packing.hpp>

namespace lightwalk {
namespace {

constexpr double pi = 3.14159265358979323846;

}  // namespace

Prefilter::Prefilter(Module& owner, std::string name) : Module(owner, std::move(name), "prefilter") {}

ImageLight::ImageLight(Module& owner, std::string name) : Module(owner, std::move(name), "image_light") {
    levels.method.change_default("box");
}

ImageRgb small_picture(Gpu& gpu, const Image& picture, uint32_t most) {
    uint32_t level = 0;
    while ((picture.desc.size.x >> level) > most && level + 1 < picture.desc.mips) ++level;
    const ImageView view = picture.mip(level);
    const std::vector<std::byte> bytes = gpu.read_back(view);
    ImageRgb small(static_cast<int>(view.size().x), static_cast<int>(view.size().y));
    for (int y = 0; y < small.height; ++y)
        for (int x = 0; x < small.width; ++x) {
            uint64_t texel = 0;
            std::memcpy(&texel, bytes.data() + 8 * (size_t(y) * size_t(small.width) + size_t(x)), 8);
            small.at(x, y) = glm::vec3(glm::unpackHalf4x16(texel));
        }
    return small;
}

// P.-P. Sloan, "Stupid Spherical Harmonics (SH) Tricks", GDC 2008, "Windowing".
std::array<double, 3> sh_window(size_t which) {
    std::array<double, 3> factors{1, 1, 1};
    for (int degree = 1; degree < 3; ++degree) {
        const double hann = 0.5 * (1 + std::cos(pi * degree / 5)), x = pi * degree / 3;
        factors[size_t(degree)] = which == 1 ? hann : which == 2 ? std::pow(std::sin(x) / x, 4) : 1;
    }
    return factors;
}

void ImageLight::prepare(Gpu& gpu, Scene& scene) {
    now_ = &sky;
    if (std::exchange(environment_, scene.environment) == scene.environment &&
        prepared_.is_current(scene.file.ambient, Exercises::epoch()))
        return;
    made_.forget();
    if (scene.environment) {
        const ImageRgb small = small_picture(gpu, *scene.environment, 128);  // a cosine sees no more
        picture_sh_ = sh_project(small.width, small.height, small.pixels);
    } else {
        picture_sh_ = sh_project(64, 32, std::vector<glm::vec3>(64 * 32, scene.file.ambient));
    }
    picture_sh_.resize(9);
}

const Image& ImageLight::picture_of(Frame& frame, const Scene& scene) {
    if (scene.environment) return *scene.environment;
    const std::vector<uint64_t> texels(64 * 32, glm::packHalf4x16(glm::vec4(scene.file.ambient, 1.0f)));
    even_ = Image(frame.gpu.device, {.name = path() + " even", .size = {64, 32}});
    frame.upload(path() + " even", even_, std::as_bytes(std::span(texels)));
    return even_;
}

void ImageLight::record_table(Frame& frame) {
    frame.compute("split sum", {.writes = {table}}, [&](Compute& pass) {
        pass.use(split_sum_).set("table", table).set("table_samples", 1024u);
        pass.dispatch(glm::uvec3(table.desc.size, 1));
    });
}

void ImageLight::record(Frame& frame, const Scene& scene) {
    scene_ = &scene;
    now_ = &sky;
    if (made_.is_current(limit.value, sh_window.index, prefilter.epoch(), levels.epoch())) return;
    const Image& picture = picture_of(frame, scene);
    const ImageView cube = sky.radiance.as_array().mip(0);
    frame.compute("equirect to cube", {.reads = {picture}, .writes = {cube}}, [&](Compute& pass) {
        pass.use(to_cube_).set("picture", picture).set("limit", limit.value).set("cube", cube);
        pass.dispatch_threads(glm::uvec3(cube.size().x, cube.size().y, 6));
    });
    filter(frame, sky);
    if (radiance_alone) return;

    // 14.sh_project has summed the picture itself; that of a drawn cube is summed on the device.
    std::vector<glm::vec4> windowed;
    const std::array<double, 3> factors = lightwalk::sh_window(sh_window.index);
    for (size_t i = 0; i < 9; ++i)
        windowed.emplace_back(glm::vec3(picture_sh_[i] * factors[i == 0 ? 0u : i < 4 ? 1u : 2u]), 0.0f);
    frame.upload(path() + " sh", sky.sh, windowed);
}

void ImageLight::record_drawn(Frame& frame, const ImageLightState& box) {
    filter(frame, drawn);
    box_ = box;
    now_ = &drawn;
    if (radiance_alone) return;
    const std::array<double, 3> factors = lightwalk::sh_window(sh_window.index);
    const ImageView array = drawn.radiance.as_array();
    if (!drawn.sh) drawn.sh = Buffer(frame.gpu.device, {.name = path() + " drawn sh", .bytes = 9 * sizeof(glm::vec4)});
    frame.compute("spherical harmonics", {.reads = {array}, .writes = {drawn.sh}}, [&](Compute& pass) {
        pass.use(sh_sums_).set("radiance", array, nearest_clamp).set("source_level", 4).set("sh_buffer", drawn.sh);
        pass.set("window_now", glm::vec3(factors[0], factors[1], factors[2])).dispatch({1, 1, 1});
    });
}

void ImageLight::filter(Frame& frame, LightCubes& cubes) {
    levels.record(frame, cubes.radiance.all_mips());
    if (radiance_alone) return;
    prefilter_faces(frame, {face_, cubes.radiance, cubes.prefiltered, {prefilter}});

    // From the level of 16 by 16: a cosine sees no more.
    const ImageView array = cubes.radiance.as_array(), result = cubes.irradiance.as_array();
    frame.compute("irradiance", {.reads = {array}, .writes = {result}}, [&](Compute& pass) {
        pass.use(irradiance_).set("radiance", array, nearest_clamp).set("source_level", 4).set("irradiance", result);
        const glm::uvec2 size = cubes.irradiance.desc.size;
        pass.dispatch({size.x / 8, size.y, 6});  // a workgroup for eight normals
    });
    if (!table_made_.is_current(Exercises::epoch())) record_table(frame);
}

void ImageLight::bind(Pass& pass) const {
    const LightCubes& cubes = *now_;
    pass.set_if_present("image_light_radiance", cubes.radiance, linear_clamp);
    pass.set_if_present("image_light_texels", cubes.radiance.as_array(), nearest_clamp);
    if (!radiance_alone) {
        pass.set_if_present("image_light_prefiltered", cubes.prefiltered, linear_clamp);
        pass.set_if_present("image_light_irradiance", cubes.irradiance, linear_clamp);
        pass.set_if_present("image_light_table", table, linear_clamp);
        pass.set_if_present("image_light_sh", cubes.sh);
    }
    ImageLightState state = now_ == &drawn ? box_ : ImageLightState{};
    state.levels = static_cast<float>(cubes.prefiltered.desc.mips);
    state.texels = static_cast<float>(LightCubes::face_texels);
    pass.set_if_present("image_light_state", state);
    // A drawn cube already includes the scene's rotation and intensity.
    pass.set_if_present("environment_scale", now_ == &drawn
                                                 ? EnvironmentScale{.cosine = 1.0f, .sine = 0.0f, .intensity = 1.0f}
                                                 : environment_scale(*scene_, intensity, turn_deg));
}

}  // namespace lightwalk
