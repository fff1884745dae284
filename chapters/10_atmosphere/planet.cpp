#include "10_atmosphere/planet.h"

#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <utility>

#include "common/base/error.h"
#include "common/scene/scene_file.h"

namespace lightwalk {

Planet::Planet(Module& owner, std::string name, Atmosphere& atmosphere)
    : Drawing(owner, std::move(name), "planet"), atmosphere_(atmosphere) {}

void Planet::prepare(Gpu& gpu, Scene&) {
    if (!images_) images_ = std::make_unique<ImagePool>(gpu);
    const auto load = [&](const char* file, TextureKind kind) { return images_->load(find_asset(file), kind); };
    stars_ = load("textures/stars.jpg", TextureKind::color);
    if (map.is("mars")) day_ = load("planets/mars.jpg", TextureKind::color);
    if (!map.is("earth")) return;
    day_ = load("planets/earth_day.jpg", TextureKind::color);
    night_ = load("planets/earth_night.jpg", TextureKind::color);
    clouds_ = load("planets/earth_clouds.jpg", TextureKind::data);
    water_ = load("planets/earth_specular.jpg", TextureKind::data);
}

void Planet::bind(Pass& pass) const {
    // The world's +y is where the origin lies on the map, -z is north of it before it is turned.
    glm::mat4 turn(1.0f);
    turn = glm::rotate(turn, glm::radians(longitude_deg.value), glm::vec3(0, 1, 0));
    turn = glm::rotate(turn, glm::radians(-latitude_deg.value), glm::vec3(1, 0, 0));
    turn = glm::rotate(turn, glm::radians(90.0f), glm::vec3(1, 0, 0));
    turn = glm::rotate(turn, glm::radians(turn_deg.value), glm::vec3(0, 1, 0));
    pass.set_if_present("to_map", glm::mat3(turn));
    const std::pair<const char*, const std::shared_ptr<Image>&> maps[] = {
        {"day_map", day_}, {"night_map", night_}, {"cloud_map", clouds_}, {"water_map", water_}, {"star_map", stars_}};
    for (const auto& [name, image] : maps)
        if (image) pass.set_if_present(name, *image, Sampler{.wrap = Wrap::repeat});
}

void Planet::draw(Frame& frame, const View& view, Canvas& canvas) {
    const ImageView depth = canvas.depth(frame), hdr = canvas.color(frame);
    frame.compute("ground", {.reads = {depth}, .writes = {hdr}, .with = {atmosphere_, *this}}, [&](Compute& pass) {
        pass.use(ground_).set("depth", depth, nearest_clamp).set("result", hdr);
        pass.set("rays", view_rays(view)).set("strength", atmosphere_.exposure.value);
        pass.dispatch_threads(view.size);
    });
}

void CloudLayer::update(Frame& frame) {
    if (method.is("none") || std::exchange(has_noise_, true)) return;
    noise_.ensure(
        frame.gpu.device,
        {.name = path() + " noise", .format = VK_FORMAT_R16_SFLOAT, .size = glm::uvec2(64), .depth = 64, .kept = true});
    frame.compute("cloud noise", {.writes = {noise_}},
                  [&](Compute& pass) { pass.use(make_noise_).set("result", noise_).dispatch_threads(glm::uvec3(64)); });
}

void CloudLayer::draw(Frame& frame, const View& view, Canvas& canvas) {
    if (method.is("none")) return;
    const Image *transmittance = atmosphere_.table("transmittance"), *multiple = atmosphere_.table("multiple");
    if (!transmittance) throw InputError("{}: clouds need the air's tables; set atmosphere.method to tables", path());
    const ImageView hdr = canvas.color(frame), depth = canvas.depth(frame);
    // The drift in double precision: after hours a float would move the clouds in steps.
    const double moved_m = std::fmod(static_cast<double>(drift_m_s) * static_cast<double>(frame.time_s), 1e7);
    frame.compute("clouds",
                  {.reads = {depth, hdr, noise_, *transmittance, *multiple},
                   .writes = {hdr},
                   .with = {atmosphere_, planet_, *this}},
                  [&](Compute& pass) {
                      pass.use(march_).set("result", hdr).set("depth", depth, nearest_clamp);
                      pass.set("cloud_noise", noise_, Sampler{.wrap = Wrap::repeat});
                      pass.set("air_transmittance", *transmittance, linear_clamp);
                      pass.set_if_present("air_multiple", *multiple, linear_clamp);
                      pass.set("rays", view_rays(view)).set("moved_m", static_cast<float>(moved_m));
                      pass.set("jitter", static_cast<float>(frame.samples.index));
                      pass.dispatch_threads(view.size);
                  });
}

}  // namespace lightwalk
