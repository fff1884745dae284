#include "11_fractals/terrain.h"

#include "01_obj/exercises.h"
#include "common/scene/view.h"
#include "common/scene/view.h"

namespace lightwalk {
namespace {

// Two triangles for each cell of a grid, counter-clockwise seen from above; without those of the middle half of each
// side.
void add_cells(std::vector<uint32_t>& indices, uint32_t cells, bool hollow) {
    const auto in_hole = [&](uint32_t i) { return i >= cells / 4 && i < cells - cells / 4; };
    for (uint32_t z = 0; z < cells; ++z)
        for (uint32_t x = 0; x < cells; ++x) {
            if (hollow && in_hole(x) && in_hole(z)) continue;
            const uint32_t a = z * (cells + 1) + x, b = a + 1, c = a + cells + 1, d = c + 1;
            indices.insert(indices.end(), {a, c, b, b, c, d});
        }
}

}  // namespace

void Terrain::prepare(Gpu& gpu) {
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

// [place]
// The grid stays where it is, below the eye; what moves is the place of its middle in the noise, by whole cells of the
// grid, so that no vertex slides over the ground. What is left of the way the eye goes itself.
void Terrain::place(Frame& frame, const Scene& scene, const Camera& camera) {
    const glm::dvec2 flight = flight_m(camera, double(frame.time_s)), spacing(static_cast<double>(spacing_m));
    const glm::dvec2 middle = glm::floor(flight / spacing) * spacing, rest = flight - middle;
    const NoisePlace noise = NoisePlace::at(middle / double(wave_m));
    const double ground = ground_m(flight + glm::dvec2(camera.position.x, camera.position.z), 4);
    const glm::vec3 moved(rest.x, ground, rest.y);
    eye_ = camera;
    eye_.position += moved;
    eye_.target += moved;
    now_ = {.cell = noise.cell,
            .offset = glm::vec2(noise.offset),
            .eye = eye_.position,
            .pixel_rad = 2.0f * std::tan(0.5f * camera.fov_y_rad) / static_cast<float>(frame.crop.whole.y),
            .to_sun = {0, 1, 0},
            .cells = std::max(4, cells / 4 * 4),
            .spacing_m = spacing_m,
            .rings = rings};
    for (const Light& light : scene.file.lights)
        if (light.kind == Light::Kind::directional) {
            now_.to_sun = -glm::normalize(light.direction);
            break;
        }
}
// [/place]

void Terrain::bind(Pass& pass) const {
    pass.offer("terrain_now", now_);
    struct Look {
        glm::vec3 land, rock, snow;
        glm::vec2 begins, ends;
    };
    pass.offer("terrain_mix_look", Look{look.land,
                                        look.rock,
                                        look.snow,
                                        {look.begins.value, look.begins_slope.value},
                                        {look.ends.value, look.ends_slope.value}});
}

// [record]
void Terrain::record(Frame& frame, const Scene& scene, const Camera& camera) {
    place(frame, scene, camera);
    const glm::vec2 whole(frame.crop.whole);
    look_from({part_of(frame.crop, frame.size) * view_projection(eye_, whole.x / whole.y), eye_.position}, frame);
    if (const auto side = static_cast<uint32_t>(now_.cells); side != made_cells_) {
        std::vector<uint32_t> indices;
        add_cells(indices, side, false);
        whole_ = static_cast<uint32_t>(indices.size());
        add_cells(indices, side, true);
        hollow_ = static_cast<uint32_t>(indices.size()) - whole_;
        indices_ = frame.gpu.upload("terrain indices", indices);
        made_cells_ = side;
    }

    // 1. The ground: the innermost ring whole, the others hollow.
    frame.raster("terrain", {.color = {frame.hdr}, .depth = frame.depth, .with = {*this}}, [&](Raster& pass) {
        pass.use(ground_);
        if (pass.wants("land_map")) pass.set("land_map", *land_);
        if (pass.wants("rock_map")) pass.set("rock_map", *rock_);
        pass.draw_indexed(indices_, 0, whole_);
        if (now_.rings > 1) pass.draw_indexed(indices_, whole_, hollow_, static_cast<uint32_t>(now_.rings) - 1, 1);
    });
    if (!show.is("picture")) return;

    // 2. The sky behind it, and chapter 10's fog before both.
    frame.compute("terrain sky", {.reads = {frame.depth}, .writes = {frame.hdr}, .with = {sky}}, [&](Compute& pass) {
        pass.use(sky_).set("depth", frame.depth, nearest_clamp).set("result", frame.hdr);
        pass.set("rays", view_rays(eye_, frame)).set("to_sun", now_.to_sun).dispatch_threads(frame.size);
    });
    fog.record(frame, frame.hdr, frame.depth, eye_, now_.to_sun);
}
// [/record]

}  // namespace lightwalk
