#include "common/scene/scene.h"

namespace lightwalk {
namespace {

MaterialNumbers overridden(MaterialNumbers material, const MaterialOverride& with) {
    if (with.diffuse) material.diffuse = *with.diffuse;
    if (with.specular) material.specular = *with.specular;
    if (with.emissive) material.emissive = *with.emissive;
    if (with.shininess) material.shininess = *with.shininess;
    if (with.opacity) material.opacity = *with.opacity;
    if (with.transmission) material.transmission = *with.transmission;
    if (with.blend) material.blend = *with.blend;
    return material;
}

}  // namespace

const Material& own_material(const DrawItem& item) {
    const Model& model = item.model->model;
    return model.materials[model.meshes[item.mesh].parts[item.part].material];
}

void set_material(DrawItem& item, const MaterialOverride& with, bool bare) {
    const Material& own = own_material(item);
    item.material = overridden(own, with);
    const std::vector<Node>& nodes = item.model->model.nodes;
    const glm::vec4 color = item.node < nodes.size() ? nodes[item.node].color : glm::vec4(1.0f);
    if (!with.diffuse) item.material.diffuse *= glm::vec3(color);
    if (!with.opacity && (own.blend || own.alpha_cutoff > 0.0f)) item.material.opacity *= color.a;
    const bool says_alpha = own.alpha_cutoff >= 0.0f && !with.opacity;
    item.transparent = item.material.blend || (item.material.opacity < 1.0f && !says_alpha);
    // Specular colour or exponent of the scene override the model's roughness.
    const bool classic = with.specular || with.shininess || (own.has_exponent && !bare);
    const bool rough = own.metallic_roughness && !classic;
    item.material.microfacets = own.microfacets && !classic;
    item.roughness = with.roughness.value_or(rough ? own.roughness : -1.0f);
    item.metalness = with.metalness.value_or(rough ? own.metalness : -1.0f);
    item.two_sided = own.sides == Sides::both || (own.sides == Sides::unknown && with.two_sided.value_or(false));
    // A missing emission texture must not turn into uniform emission.
    if (own.emissive_map && !item.maps[MapSlot::emissive] && !with.emissive) item.material.emissive = glm::vec3(0.0f);
}

MaterialData material_data(const DrawItem& item, float emission) {
    return {.diffuse = item.material.diffuse,
            .shininess = item.material.shininess,
            .specular = item.material.specular,
            .opacity = item.material.opacity,
            .emissive = emission * item.material.emissive,
            .maps = item.maps.bits(),
            .roughness = item.roughness,
            .metalness = item.metalness,
            .alpha_cutoff = item.material.alpha_cutoff,
            .normal_scale = item.material.normal_scale,
            .occlusion_strength = item.material.occlusion_strength,
            .transmission = item.material.transmission};
}

}  // namespace lightwalk
