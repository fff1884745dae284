#include "05_shadow_maps/sphere_shadow.h"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace lightwalk {
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
