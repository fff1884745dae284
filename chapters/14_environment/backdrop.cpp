#include "14_environment/backdrop.h"

#include <glm/gtc/constants.hpp>
#include <utility>

#include "05_shadow_maps/casting.h"
#include "14_environment/backdrop_data.h"
#include "common/image/luminance.h"

namespace lightwalk {

GroundShadow::GroundShadow(Module& owner, std::string name) : Module(owner, std::move(name), "ground_shadow") {}

Backdrop::Backdrop(Module& owner, std::string name, const ImageLight& light)
    : Drawing(owner, std::move(name)), light_(light) {}

void Backdrop::draw(Frame& frame, const View& view, Canvas& canvas) {
    if (!scene_->environment || canvas.has_color()) return;
    const Image& picture = *scene_->environment;
    const EnvironmentScale turn = environment_scale(*scene_, light_.intensity, light_.turn_deg);
    const bool has_ground = ground.is("projected"), shaded = has_ground && !scene_->items.empty();
    if (shaded) shadow.record(frame, *scene_, cut_by_, turn, ground_y);
    const ImageView behind = canvas.color_overwritten();
    const ImageView arriving = shaded ? ImageView(shadow.arriving) : ImageView(picture).mip(0);
    frame.compute("backdrop", {.reads = {picture, arriving}, .writes = {behind}}, [&](Compute& pass) {
        pass.use(fill_).set("picture", picture).set("rays", view_rays(view)).set("result", behind);
        pass.set("environment_scale", turn).set("arriving", arriving, linear_clamp);
        pass.set("now", BackdropNow{.ground_y = ground_y,
                                    .camera_m = camera_m,
                                    .radius_m = radius_m,
                                    .has_ground = has_ground ? 1u : 0u,
                                    .level = level,
                                    .map_corner =
                                        shaded ? shadow.state().corner : glm::vec2(1e9f),  // nothing is within the map
                                    .map_extent = shaded ? shadow.state().extent : glm::vec2(1.0f)});
        pass.dispatch_threads(glm::uvec2(behind.size()));
    });
}

namespace {

// Direction through the middle of a texel: unit length.
glm::dvec3 direction_of(int column, int row, const ImageRgb& picture) {
    const double pi = glm::pi<double>();
    const double phi = pi * (2.0 * (column + 0.5) / picture.width - 1.0), theta = pi * (row + 0.5) / picture.height;
    return {std::sin(phi) * std::sin(theta), std::cos(theta), -std::cos(phi) * std::sin(theta)};
}

}  // namespace

std::vector<GroundLight> ground_lights(const ImageRgb& picture, const EnvironmentScale& turn, int count) {
    struct Texel {
        glm::dvec3 direction, light;
        double until;  ///< luminance of all texels so far
    };
    std::vector<Texel> texels;
    double sum = 0;
    for (int row = 0; row < picture.height; ++row) {
        // Every other row is walked the other way, so that neighbours in the list are neighbours in the sky.
        for (int i = 0; i < picture.width; ++i) {
            const int column = row % 2 ? picture.width - 1 - i : i;
            const glm::dvec3 d = direction_of(column, row, picture);
            if (d.y <= 0) continue;
            // Rows are shorter near the zenith; only shares of the whole count.
            const glm::dvec3 light = std::hypot(d.x, d.z) * d.y * glm::dvec3(picture.at(column, row));
            sum += luminance(light);
            texels.push_back({d, light, sum});
        }
    }
    std::vector<GroundLight> lights;
    if (sum <= 0) return lights;
    glm::dvec3 all(0);
    std::vector<glm::dvec3> colors;
    size_t at = 0;
    for (int i = 0; i < count; ++i) {
        while (at + 1 < texels.size() && texels[at].until < (i + 0.5) / count * sum) ++at;
        const Texel& texel = texels[at];
        const glm::dvec3 color = texel.light / std::max(luminance(texel.light), 1e-30);
        const glm::dvec3& d = texel.direction;  // from the picture's space to the world's
        lights.push_back({{turn.cosine * d.x + turn.sine * d.z, d.y, turn.cosine * d.z - turn.sine * d.x}, {}});
        colors.push_back(color);
        all += color;
    }
    for (size_t i = 0; i < lights.size(); ++i) lights[i].share = colors[i] / glm::max(all, glm::dvec3(1e-9));
    return lights;
}

void GroundShadow::prepare(Gpu& gpu, Scene& scene) {
    if (std::exchange(environment_, scene.environment) == scene.environment) return;
    made_.forget();
    picture_ = scene.environment ? small_picture(gpu, *scene.environment, 256) : ImageRgb();
}

void GroundShadow::record(Frame& frame, const Scene& scene, const Maps* maps, const EnvironmentScale& turn,
                          float ground_y) {
    arriving.ensure(frame.gpu.device, {.name = path() + ".arriving",
                                       .format = VK_FORMAT_R16G16B16A16_SFLOAT,
                                       .size = glm::uvec2(uint32_t(resolution.value)),
                                       .kept = true});
    if (scene.items.empty() || made_.is_current(scene.epoch, turn.cosine, turn.sine, ground_y, epoch(),
                                                arriving.desc.size.x, maps ? holes_cut(*maps, scene, frame.time_s) : 0))
        return;
    rays.record(frame, scene, maps);
    std::vector<GroundLight> lights = ground_lights(picture_, turn, directions);
    const auto count = static_cast<int>(lights.size());
    if (lights.empty()) lights.emplace_back();
    frame.upload(path() + " lights", lights_, lights);

    // It extends around the objects by their height, and by half their width.
    const Bounds& box = scene.bounds;
    const float margin = 0.5f + 1.0f * std::max(box.extent().y, 0.0f);
    state_ = {.corner = glm::vec2(box.lower.x, box.lower.z) - margin,
              .extent = glm::vec2(box.extent().x, box.extent().z) + 2.0f * margin,
              .ground_y = ground_y,
              .directions = count};
    frame.compute("ground shadow", {.reads = {lights_}, .writes = {arriving}, .with = {rays}}, [&](Compute& pass) {
        pass.use(trace_).set("state", state_).set("ground_lights", lights_).set("arriving", arriving);
        pass.dispatch_threads(arriving.desc.size);
    });
}

}  // namespace lightwalk
