#include "common/app/environment.h"

#include <glm/gtc/packing.hpp>

namespace lightwalk {

EnvironmentLight::EnvironmentLight(Module& owner, std::string name) : Module(owner, std::move(name), "environment") {}

const Image& EnvironmentLight::picture_of(Frame& frame, const Scene& scene) {
    if (scene.environment) return *scene.environment;
    if (!even_made_.is_current(scene.file.ambient)) {
        const std::vector<uint64_t> texels(64 * 32, glm::packHalf4x16(glm::vec4(scene.file.ambient, 1.0f)));
        even_ = Image(frame.gpu.device, {.name = path() + " even", .size = {64, 32}});
        frame.upload(path() + " even", even_, std::as_bytes(std::span(texels)));
    }
    return even_;
}

void EnvironmentLight::record(Frame& frame, const Scene& scene) {
    scene_ = &scene;
    const Image& picture = picture_of(frame, scene);
    if (made_from_ == scene.environment && made_.is_current(scene.file.ambient)) return;
    made_from_ = scene.environment;

    // The level of at most 256 texels around. A lamp may be anywhere within a texel's 1.4°, and a cosine changes by at
    // most 0.017 from the texel's middle to its corner.
    int source_level = 0;
    while (picture.desc.size.x >> source_level > 256) ++source_level;

    const ImageView cube = radiance.as_array();
    frame.compute("environment", {.reads = {picture}, .writes = {cube, irradiance.as_array()}}, [&](Compute& pass) {
        pass.use(draw_).set("picture", picture);
        for (uint32_t m = 0; m < cube.mips; ++m)
            pass.set("level", cube.mip(m)).dispatch_threads(glm::uvec3(glm::uvec2(cube.mip(m).size()), 6));
        pass.use(sum_).set("picture", picture).set("source_level", source_level);
        pass.set("irradiance", irradiance.as_array()).dispatch_threads(irradiance.desc.size);
    });
}

EnvironmentScale environment_scale(const Scene& scene, float intensity, float turn_deg) {
    const bool given = static_cast<bool>(scene.environment);
    const float turn = glm::radians((given ? scene.file.environment.rotation_deg : 0.0f) + turn_deg);
    return {.cosine = std::cos(turn),
            .sine = std::sin(turn),
            .intensity = (given ? scene.file.environment.intensity : 1.0f) * intensity};
}

void EnvironmentLight::bind(Pass& pass) const {
    pass.set_if_present("environment_cube", radiance, linear_clamp);
    pass.set_if_present("environment_irradiance_cube", irradiance, linear_clamp);
    pass.set_if_present("environment_scale", environment_scale(*scene_, intensity, turn_deg));
}

}  // namespace lightwalk
