#include "15_terrain_water/shore.h"

#include "15_terrain_water/sun_shadow.h"

namespace lightwalk {

Shore::Shore(Module& owner) : World(owner) {
    sky.map.change_default("plain");
    fog.method.change_default("none");
    water.method.change_default("none");
    light.method.change_default("mirror");
    light.radiance_alone = true;  // water looks along single directions
    water.tracer = &reflected;
    probe.update.change_default("moved");
    probe.distant = true;
    probe.in_use = light.in_use = [this] { return !water.method.is("none"); };
}

// [frame]
// Once for all views: the ground's levels, and the light that water reflects.
void Shore::record(Frame& frame) {
    ground.record(frame, false);
    if (light.in_use()) light.record(frame, scene());
}

// Before each view: shadows of houses and objects; the sky in a cube or the mirror image, as the water needs them.
void Shore::record_view(Frame& frame, const View& view) {
    sun_shadow.record(frame, view, scene(), drawings());
    if (water.sees_surroundings(view)) probe.record(frame, scene(), light, drawings());
    water.reflect(frame, view, drawings());
}

void Shore::draw_view(Frame& frame, const View& view, Canvas& canvas) {
    canvas.blended_by(&transparency);
    draw(frame, view, canvas, drawings());
}
// [/frame]

namespace {

// Diffuse colour of each triangle, in the order of ray_triangles().
std::vector<glm::vec3> triangle_colors(const Scene& scene) {
    std::vector<glm::vec3> all;
    for (const DrawItem& item : scene.items) {
        if (item.transparent) continue;
        const uint32_t triangles = item.model->model.meshes[item.mesh].parts[item.part].index_count / 3;
        all.insert(all.end(), triangles, item.material.diffuse);
    }
    return all;
}

}  // namespace

void ReflectedRays::prepare(Gpu& gpu, Scene& scene) {
    scene_ = &scene;
    has_colors_ = false;
    none_ = gpu.upload("no houses", std::vector<CityBox>(1));
    none_cells_ = gpu.upload("no blocks", std::vector<glm::uvec2>(1));
    no_ground_ = Image(gpu.device, {.name = "no ground", .size = glm::uvec2(1), .layers = 2});
    gpu.upload(no_ground_, std::vector<std::byte>(2 * sizeof(uint64_t)));
}

void ReflectedRays::record(Frame& frame, const View& view, const Image& rays, const Image& met) {
    objects.record(frame, *scene_, maps_);
    if (!std::exchange(has_colors_, true)) {
        const std::vector<glm::vec3> of_items = triangle_colors(*scene_);
        std::vector<glm::vec3> colors(std::max<size_t>(of_items.size(), 1), glm::vec3(0.0f));
        const std::vector<uint32_t>& order = objects.bvh().order();
        for (size_t i = 0; i < of_items.size(); ++i) colors[i] = of_items[order[i]];
        colors_ = frame.gpu.upload("colours of triangles", colors);
    }
    const bool houses = city_.box_count() > 0;
    std::vector<With> with{ground_, land_, city_, atmosphere_, objects};
    const Pipeline& shader = add_shadow(city_.shadowed_by, with) ? trace_shadowed_ : trace_;
    frame.compute("reflected rays", {.reads = {rays}, .writes = {met}, .with = with}, [&](Compute& pass) {
        pass.use(shader).set("reflected", rays, nearest_clamp).set("met", met).set("water_rays", view_rays(view));
        pass.set("ray_colors", colors_).set("city_light", city_.light_of(view));
        pass.set("rays_meet", glm::uvec3(ground_.exists(), houses, !scene_->opaque().items().empty()));
        if (!houses) pass.set("city_boxes", none_).set("city_cells", none_cells_).set("city_grid", CityGrid{.yaw = 0});
        if (!ground_.exists()) {  // never read, but a shader that may read it has it bound
            for (const char* name : {"land_heights", "land_slopes", "land_bounds", "heights_between"})
                pass.set_if_present(name, no_ground_.layer(0), nearest_clamp);
            for (const char* name : {"materials", "material_bumps"}) pass.set_if_present(name, no_ground_.as_array());
        }
        pass.dispatch_threads(met.desc.size);
    });
}

}  // namespace lightwalk
