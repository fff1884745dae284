#include "11_fractals/terrain.h"

#include "01_obj/camera_view.h"
#include "05_shadow_maps/visibility_buffer.h"

namespace lightwalk {

Terrain::Terrain(Module& owner, std::string name) : Drawing(owner, std::move(name), "terrain") {}
void Terrain::prepare(Gpu& gpu, Scene& loaded) {
    scene_ = &loaded;
    if (images_) return;
    images_ = std::make_unique<ImagePool>(gpu);
    land_ = images_->load(find_asset("textures/bark_albedo.jpg"), TextureKind::color);
    rock_ = images_->load(find_asset("planets/moon.jpg"), TextureKind::color);
}

double Terrain::ground_m(glm::dvec2 world_m, double octave_count) const {
    const NoisePlace place = NoisePlace::at(world_m / double(wave_m));
    return double(height_m) * eroded_height(place, octave_count, double(erosion), double(gain));
}

glm::dvec2 Terrain::flight_m(const Camera& camera, double time_s) const {
    const glm::dvec2 along(camera.target.x - camera.position.x, camera.target.z - camera.position.z);
    const double length = glm::length(along), way = double(speed_m_s) * time_s;
    return 1e3 * glm::dvec2(start_x_km.value, start_z_km.value) + (length > 0 ? way / length * along : glm::dvec2(0));
}

World::Eye Terrain::eye(const Camera& camera, float time_s) const {
    const glm::dvec2 flight = flight_m(camera, double(time_s));
    const double ground = ground_m(flight + glm::dvec2(camera.position.x, camera.position.z), 4);
    return {camera, glm::dvec3(flight.x, ground, flight.y)};
}

// The grid stays below the camera; its origin in the noise moves by whole cells, so that no vertex slides over the
// ground. The camera itself moves the remainder.
void Terrain::place(const Frame& frame, const View& view) {
    const Camera& camera = view.camera;
    // The caller's place if it has one, which is then that of all drawings.
    const glm::dvec3 origin = view.exact_eye ? *view.exact_eye : *eye(camera, frame.time_s).exact;
    const glm::dvec2 flight(origin.x, origin.z), spacing(static_cast<double>(spacing_m));
    const glm::dvec2 middle = glm::floor(flight / spacing) * spacing, rest = flight - middle;
    const NoisePlace noise = NoisePlace::at(middle / double(wave_m));
    const glm::vec3 moved(rest.x, origin.y, rest.y);
    Camera from = camera;
    from.position += moved;
    from.target += moved;
    from_ = view_of(from, view.size, view.crop);
    now_ = {.cell = noise.cell,
            .offset = glm::vec2(noise.offset),
            .eye = from.position,
            .pixel_rad = view.pixel_rad(),
            .to_sun = scene_->sun().to_sun,
            .cells = std::max(4, cells / 4 * 4),
            .spacing_m = spacing_m,
            .rings = rings};
}

void Terrain::bind(Pass& pass) const {
    pass.set_if_present("terrain_now", now_);
    struct Look {
        glm::vec3 land, rock, snow;
        glm::vec2 begins, ends;
    };
    pass.set_if_present("terrain_mix_look", Look{look.land,
                                                 look.rock,
                                                 look.snow,
                                                 {look.begins.value, look.begins_slope.value},
                                                 {look.ends.value, look.ends_slope.value}});
}

void Terrain::bind_maps(Pass& pass) const {
    pass.set_if_present("land_map", *land_);
    pass.set_if_present("rock_map", *rock_);
}

// The innermost ring whole, the others hollow.
void Terrain::draw_ground(Frame& frame, Canvas& canvas) {
    frame.raster("terrain", {.color = {canvas.color_target()}, .depth = canvas.depth_target(), .with = {*this}},
                 [&](Raster& pass) {
                     pass.use(ground_);
                     bind_maps(pass);
                     grid_.draw(pass, static_cast<uint32_t>(now_.rings));
                 });
}

// Which triangle a pixel shows is drawn, and shaded afterwards: each pixel once, and no fragment does more than write
// two numbers.
void Terrain::draw_visible(Frame& frame, const View& view, Canvas& canvas) {
    const auto count = static_cast<uint32_t>(now_.rings), side = static_cast<uint32_t>(now_.cells) + 1;
    const VkDeviceSize bytes = sizeof(glm::vec3) * count * side * side;
    if (lifted_.bytes < bytes) lifted_ = Buffer(frame.gpu.device, {.name = path() + ".lifted", .bytes = bytes});

    frame.compute("terrain vertices", {.writes = {lifted_}, .with = {*this}}, [&](Compute& pass) {
        pass.use(lift_).set("ground_vertices", lifted_).dispatch_threads({side * side, count});
    });
    const Attachment seen = visibility_target(frame, seen_, canvas);
    frame.raster("terrain visible",
                 {.color = {seen}, .depth = canvas.depth_target(), .reads = {lifted_}, .with = {*this}},
                 [&](Raster& pass) {
                     pass.use(visible_).set("ground_vertices", lifted_);
                     grid_.draw(pass, count);
                 });
    const ImageView color = canvas.color(frame);
    frame.compute("terrain shade", {.reads = {seen_, lifted_}, .writes = {color}, .with = {*this}}, [&](Compute& pass) {
        pass.use(shade_).set("visible", seen_, nearest_clamp).set("ground_vertices", lifted_).set("result", color);
        pass.set("indices", grid_.indices()).set("grid", static_cast<int>(grid_.hollow_from()));
        bind_maps(pass);
        pass.dispatch_threads(view.size);
    });
}

// [draw]
void Terrain::draw(Frame& frame, const View& view, Canvas& canvas) {
    place(frame, view);
    grid_.ensure(frame.gpu, static_cast<uint32_t>(now_.cells));
    const ViewScope scope(frame, from_);

    // 1. The ground.
    if (shaded.is("visibility"))
        draw_visible(frame, view, canvas);
    else
        draw_ground(frame, canvas);
    if (!show.is("picture") || !own_sky) return;

    // 2. The sky behind it, and chapter 10's fog before both.
    const ImageView depth = canvas.depth(frame), color = canvas.color(frame);
    frame.compute("terrain sky", {.reads = {depth}, .writes = {color}, .with = {sky}}, [&](Compute& pass) {
        pass.use(sky_).set("depth", depth, nearest_clamp).set("result", color);
        pass.set("rays", view_rays(from_)).set("to_sun", now_.to_sun).dispatch_threads(view.size);
    });
    fog.draw(frame, from_, canvas);
}
// [/draw]

}  // namespace lightwalk
