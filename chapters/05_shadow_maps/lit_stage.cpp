#include "05_shadow_maps/lit_stage.h"

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

namespace lightwalk {

SphereShadow::SphereShadow(Module& owner, std::string name) : Module(owner, std::move(name), "sphere_shadow") {}

LitStage::LitStage(Module& owner) : World(owner) {
    objects.surfaces.all_lights = [this](const Frame&) { return lamps(); };
}

const LightList& LitStage::lamps() {
    const LightList own = scene().lights();
    if (own == own_ && lamps_made_.is_current(epoch())) return lamps_;
    own_ = own;
    std::vector<Light> all = *own;
    for (Light& light : all) {
        light.size_m *= lamp;
        light.size_rad = std::min(light.size_rad * lamp, 1.5f);
    }
    lamps_ = std::make_shared<const std::vector<Light>>(std::move(all));
    return lamps_;
}

// Rays only if needed; planets with rings have analytic shadows.
void LitStage::choose_shading(Frame& frame) {
    const bool asks_rays = visibility.is("rays") || show.is("wrong"), plain = show.is("picture") && !asks_rays;
    sphere_shadow.update(scene());
    Shading shading;
    if (sphere_shadow)
        shading = {
            .opaque = &sphere_shadow.ringed, .transparent = &sphere_shadow.ringed_transparent, .with = {sphere_shadow}};
    else if (!plain)
        shading = {.opaque = &shown_, .seen = &shown_seen_};
    if (!plain) {
        rays.record(frame, scene(), &objects.maps);
        shading.with.emplace_back(rays);
    }
    objects.shading = std::move(shading);
}

namespace {

const DrawItem* item_of(const Scene& scene, Role role) {
    const auto has = [&](const DrawItem& item) { return item.role == role; };
    const auto found = std::find_if(scene.items.begin(), scene.items.end(), has);
    return found == scene.items.end() ? nullptr : &*found;
}

// Distances of the nearest and farthest vertex from the mesh's origin, world metres.
std::pair<float, float> radii(const DrawItem& item) {
    float nearest = INFINITY, farthest = 0;
    for (const Vertex& vertex : vertices_of(*item.model, item.mesh)) {
        const float r = glm::length(glm::mat3(item.transform) * vertex.position);
        nearest = std::min(nearest, r);
        farthest = std::max(farthest, r);
    }
    return {nearest, farthest};
}

}  // namespace

void SphereShadow::update(const Scene& scene) {
    planet = {};
    ring = nullptr;
    if (const DrawItem* sphere = item_of(scene, Role::planet)) {
        planet.center = glm::vec3(sphere->transform[3]);
        planet.radius = radii(*sphere).second;
        ring = &scene.texture(*sphere, MapSlot::diffuse);  // placeholder without a ring
    }
    if (const DrawItem* disc = item_of(scene, Role::ring)) {
        planet.center = glm::vec3(disc->transform[3]);
        planet.normal = glm::normalize(glm::vec3(disc->transform[1]));
        std::tie(planet.inner, planet.outer) = radii(*disc);
        ring = &scene.texture(*disc, MapSlot::diffuse);
    }
}

void SphereShadow::bind(Pass& pass) const {
    pass.set_if_present("sphere_shadow_planet", planet);
    if (ring) pass.set_if_present("sphere_shadow_ring", *ring, linear_clamp);
}

}  // namespace lightwalk
