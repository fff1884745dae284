#include "15_terrain_water/water.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "01_obj/camera_view.h"
#include "15_terrain_water/exercises.h"
#include "15_terrain_water/ocean.h"
#include "common/base/error.h"

namespace lightwalk {

namespace {

// The sector of the rings that a view shows, as an angle and a width; all of it where the view looks down or up steeply.
glm::vec2 sector_of(const View& view) {
    const ViewRays rays = view_rays(view);
    const glm::vec3 middle = ray_through(rays, 0.5f * glm::vec2(view.size));
    const float ahead = std::atan2(middle.z, middle.x);
    float wide = 0;
    for (const glm::vec2 corner : {glm::vec2(0, 0), glm::vec2(1, 0), glm::vec2(0, 1), glm::vec2(1, 1)}) {
        const glm::vec3 ray = ray_through(rays, corner * glm::vec2(view.size));
        if (std::fabs(ray.y) > 1.7f * glm::length(glm::vec2(ray.x, ray.z))) return {0.0f, 2.0f * float(M_PI)};
        wide = std::max(wide, std::fabs(std::remainder(std::atan2(ray.z, ray.x) - ahead, 2.0f * float(M_PI))));
    }
    wide = 1.25f * wide + 0.1f;  // waves come in from the sides
    return wide > 2.5f ? glm::vec2(0.0f, 2.0f * float(M_PI)) : glm::vec2(ahead - wide, 2.0f * wide);
}

// Two triangles between neighbouring rings and spokes.
std::vector<uint32_t> ring_indices() {
    std::vector<uint32_t> all;
    for (uint32_t ring = 0; ring + 1 < RINGS; ++ring)
        for (uint32_t spoke = 0; spoke < SPOKES; ++spoke) {
            const uint32_t inner = ring * (SPOKES + 1) + spoke, outer = inner + SPOKES + 1;
            all.insert(all.end(), {inner, inner + 1, outer + 1, inner, outer + 1, outer});
        }
    return all;
}

}  // namespace

Mirror::Mirror(Module& owner, std::string name) : Module(owner, std::move(name), "mirror") {}

Waterline::Waterline(Module& owner, std::string name) : Module(owner, std::move(name), "waterline") {}

Water::Water(Module& owner, std::string name, const ImageLight& light)
    : Drawing(owner, std::move(name), "water"), light_(light) {}

glm::dvec3 moved_by(const std::vector<WaveData>& waves, glm::dvec2 at) {
    glm::dvec3 sum(0);
    for (const WaveData& w : waves) {
        const glm::dvec2 k(w.k), along = k / glm::length(k) * double(w.steepness) * double(w.amplitude);
        const double t = glm::dot(k, at) - double(w.phase);
        sum += glm::dvec3(along.x * std::cos(t), double(w.amplitude) * std::sin(t), along.y * std::cos(t));
    }
    return sum;
}

double height_at(const std::vector<WaveData>& waves, glm::dvec2 place, int rounds) {
    glm::dvec2 rest = place;
    for (int i = 0; i < rounds; ++i) {
        const glm::dvec3 moved = moved_by(waves, rest);
        rest = place - glm::dvec2(moved.x, moved.z);
    }
    return moved_by(waves, rest).y;
}

std::vector<WaveData> Water::waves_at(double time_s) const {
    std::vector<WaveData> all;
    for (int i = 0; i < waves; ++i) {
        // Wavelengths in equal ratios; directions to both sides of the wind in turn, the short waves farther.
        const double share = double(i) / (waves - 1);
        const double length_m = double(longest_m) * std::pow(double(shortest_m) / double(longest_m), share);
        const double k = 2 * M_PI / length_m, omega = std::sqrt(gravity * k);  // in deep water
        const double side = std::fmod(0.5 + 0.6180339887498949 * i, 1.0) * 2 - 1;
        const double angle = (double(wind_deg) + double(spread_deg) * side) * M_PI / 180;
        // The phase in double precision, and whole turns left out: of 1e5 s a float would keep steps of an eighth of a
        // radian at a wavelength of 0.5 m.
        const double phase = std::fmod(omega * time_s + 2.399963 * i, 2 * M_PI);
        const double amplitude = double(slope) / k;
        all.push_back({.k = glm::vec2(glm::dvec2(std::cos(angle), std::sin(angle)) * k),
                       .amplitude = static_cast<float>(amplitude),
                       .steepness = slope > 0 && !method.is("sines")
                                        ? static_cast<float>(double(steepness) / (k * amplitude * waves))
                                        : 0.0f,
                       .phase = static_cast<float>(phase)});
    }
    return all;
}

float Water::height_above(glm::vec2 place, double time_s) const {
    if (!method.is("sines") && !method.is("gerstner")) return level_m;
    return level_m + static_cast<float>(height_at(waves_at(time_s), place));
}

void Water::prepare(Gpu&, Scene& loaded) {
    scene_ = &loaded;
    if (shortest_m > longest_m)
        throw InputError(
            "water.shortest_m: {} m is longer than water.longest_m, {} m; the shortest wave is at most as "
            "long as the longest",
            shortest_m.value, longest_m.value);
}

WaterNow Water::now(const Frame& frame, const View& view) const {
    const glm::vec2 sector = sector_of(view);
    const float above = std::fabs(view.eye.y - level_m), first = std::clamp(0.2f * above, 0.05f, 1000.0f);
    const ViewRays rays = view_rays(view);
    const Sun sun = scene_->sun();
    WaterNow n{.center = {view.eye.x, view.eye.z},
               .level_m = level_m,
               .first_m = first,
               // To where a ring is less than a pixel above the horizon, or 200 km.
               .growth = std::pow(std::max(2e5f, 2.0f * above / view.pixel_rad()) / first, 1.0f / float(RINGS - 2)),
               .from_rad = sector.x,
               .wide_rad = sector.y,
               .pixel_rad = view.pixel_rad(),
               .absorption = absorption,
               .turbid = turbid,
               .to_sun = sun.to_sun,
               .sun = sun.light,
               .sky = sun.sky,
               .roughness = roughness,
               .refraction = refraction,
               .shore_m = shore_m,
               .foam = foam,
               .foam_scale = 1.0f / foam_m,
               .inverse_near = rays.inverse_near,
               .inverse_far = rays.inverse_far,
               .eye_depth_m = height_above({view.eye.x, view.eye.z}, double(frame.time_s)) - view.eye.y,
               .tile_m = Ocean::tile_m(),
               .cut_m = {24.0f, 2.2f, 0.25f},
               .hidden = ocean.slope_variance(),
               .chop = ocean.chop,
               .mirrored = mirrored_ == view.id ? 1u : 0u};
    if (method.is("sines") || method.is("gerstner"))
        for (const WaveData& wave : waves_at(double(frame.time_s))) n.wave[n.waves++] = wave;
    return n;
}

void Water::update(Frame& frame) {
    if (method.is("none")) return;
    if (method.is("fft")) ocean.record(frame);
    const float towards_rad = glm::radians(method.is("fft") ? ocean.wind_deg.value : wind_deg.value);
    waterline.record(frame, *scene_, level_m, -glm::vec2(std::cos(towards_rad), std::sin(towards_rad)));
    foam_tile_.ensure(
        frame.gpu.device,
        {.name = path() + " foam", .format = VK_FORMAT_R16_SFLOAT, .size = glm::uvec2(256), .mips = 1, .kept = true});
    black_.ensure(frame.gpu.device, {.name = path() + " black", .size = glm::uvec2(1), .layers = 3, .kept = true});
    if (std::exchange(has_foam_, true)) return;
    frame.upload("water rings", rings_, ring_indices());
    frame.compute("foam", {.writes = {foam_tile_}},
                  [&](Compute& pass) { pass.use(foam_).set("tile", foam_tile_).dispatch_threads(glm::uvec2(256)); });
    frame.raster("black", {.color = {clear(black_, glm::vec4(0))}, .layers = 3}, [](Raster&) {});
}

bool Water::is_mirrored(const View& view) const {
    return !method.is("none") && reflection.is("planar") && view.eye.y > level_m;
}

bool Water::sees_surroundings(const View& view) const {
    return !method.is("none") && !reflection.is("none") && !is_mirrored(view);
}

void Water::reflect(Frame& frame, const View& view, const Drawings& drawings) {
    mirrored_ = ~0u;
    if (!is_mirrored(view)) return;
    const ViewScope scope(frame, view);
    mirror.record(frame, view, level_m, drawings);
    mirrored_ = view.id;
}

void Water::bind(Pass& pass) const {
    pass.set_if_present("water_now", now_);
    pass.set_if_present("ocean_moved", method.is("fft") ? ImageView(ocean.moved()) : ImageView(black_).as_array());
    pass.set_if_present("ocean_sloped", method.is("fft") ? ImageView(ocean.sloped()) : ImageView(black_).as_array());
    pass.set_if_present("foam_tile", foam_tile_);
    if (behind_) {
        pass.set_if_present("behind", behind_, nearest_clamp);
        pass.set_if_present("behind_depth", behind_depth_, nearest_clamp);
    }
}

// No rings where nothing crosses the water.
Macros Water::around_objects() const {
    Macros variant;
    if (!waterline.exists()) variant.set("WATERLINE_METHOD", "WATERLINE_METHOD_NONE");
    return variant;
}

// The surface is drawn once more before its own pass, as the rays that leave it: that is compute's work.
void Water::follow_rays(Frame& frame, const View& view, Canvas& canvas) {
    const auto fit = [&](Image& image, const char* name, VkFormat format) {
        image.ensure(frame.gpu.device, {.name = path() + name, .format = format, .size = canvas.size()});
    };
    fit(rays_, " rays", VK_FORMAT_R32G32B32A32_SFLOAT);
    fit(met_, " met", VK_FORMAT_R16G16B16A16_SFLOAT);
    RasterTargets targets{
        .color = {clear(rays_, glm::vec4(0.0f))}, .depth = canvas.depth_target(), .reads = {black_}, .with = {*this}};
    if (method.is("fft")) targets.reads = {ocean.moved(), ocean.sloped()};
    frame.raster("water rays", targets, [&](Raster& pass) {
        pass.use(rays_of_, around_objects()).draw_indexed(rings_, 0, 6 * SPOKES * (RINGS - 1));
    });
    tracer->record(frame, view, rays_, met_);
}

void Water::draw(Frame& frame, const View& view, Canvas& canvas) {
    if (method.is("none")) return;
    now_ = now(frame, view);
    if (view.id == 0) kept_.now = {method.index, double(frame.time_s), waterline.exists(), waterline.map().phase, now_};
    const bool mirrored = now_.mirrored == 1u, below = now_.eye_depth_m > 0;

    // 1. The picture behind the water, with its distance.
    behind_.ensure(frame.gpu.device, {.name = path() + " behind", .size = canvas.size()});
    behind_depth_.ensure(frame.gpu.device,
                         {.name = path() + " behind depth", .format = VK_FORMAT_R32_SFLOAT, .size = canvas.size()});
    const ImageView color = canvas.color(frame), depth = canvas.depth(frame);
    frame.compute("behind the water", {.reads = {color, depth}, .writes = {behind_, behind_depth_}},
                  [&](Compute& pass) {
                      pass.use(keep_).set("picture", color, nearest_clamp).set("depth", depth, nearest_clamp);
                      pass.set("kept", behind_).set("kept_depth", behind_depth_).dispatch_threads(canvas.size());
                  });

    // 2. The surface. Without a mirror image, the picture behind is bound instead.
    const bool by_rays = reflection.is("rays") && tracer && !below;
    if (by_rays) follow_rays(frame, view, canvas);
    const ImageView mirror_image = mirrored ? ImageView(mirror.image()) : ImageView(by_rays ? met_ : behind_);
    std::vector<Resource> reads{behind_, behind_depth_, foam_tile_, black_, mirror_image};
    if (method.is("fft")) reads.insert(reads.end(), {ocean.moved(), ocean.sloped()});
    Macros variant = around_objects();
    if ((reflection.is("planar") && !mirrored) || (reflection.is("rays") && !by_rays))
        variant.set("WATER_REFLECTION", "WATER_REFLECTION_CUBE");
    frame.raster(
        "water",
        {.color = {canvas.color_target()}, .depth = canvas.depth_target(), .reads = reads, .with = {*this, light_}},
        [&](Raster& pass) {
            pass.use(surface_, variant).set("water_rays", view_rays(view));
            pass.set_if_present("mirror", mirror_image, linear_clamp);
            pass.draw_indexed(rings_, 0, 6 * SPOKES * (RINGS - 1));
        });

    // 3. From below, all of it through water.
    if (!below) return;
    const ImageView seen = canvas.color(frame), surface = canvas.depth(frame);
    frame.compute("under water", {.reads = {seen, surface}, .writes = {seen}, .with = {*this}}, [&](Compute& pass) {
        pass.use(under_).set("water_rays", view_rays(view)).set("depth", surface, nearest_clamp);
        pass.set("picture", seen).dispatch_threads(canvas.size());
    });
}

Camera mirrored_camera(const Camera& camera, float level_m) {
    Camera mirrored = camera;
    mirrored.position.y = 2.0f * level_m - camera.position.y;
    mirrored.target.y = 2.0f * level_m - camera.target.y;
    mirrored.up.y = -camera.up.y;
    return mirrored;
}

void Mirror::record(Frame& frame, const View& view, float level_m, const Drawings& drawings) {
    const Drawings solid = of_phases({Phase::backdrop, Phase::opaque}, drawings);
    const Drawings air = of_phases({Phase::sky, Phase::air, Phase::fog}, drawings);
    const glm::uvec2 size = glm::max(glm::uvec2(glm::vec2(view.size) * scale.value), 1u);
    const auto fit = [&](Image& image, const char* name, VkFormat format) {
        image.ensure(frame.gpu.device, {.name = path() + name, .format = format, .size = size});
    };
    fit(color_, " color", VK_FORMAT_R16G16B16A16_SFLOAT);
    fit(oblique_, " oblique depth", VK_FORMAT_D32_SFLOAT);
    fit(depth_, " depth", VK_FORMAT_D32_SFLOAT);

    // 1. Seen from below: the same part of the picture, counted from the other edge.
    const glm::vec2 shrunk = glm::vec2(size) / glm::vec2(view.size);
    Crop crop = view.crop;
    crop.whole = glm::max(glm::uvec2(glm::vec2(crop.whole) * shrunk), 1u);
    crop.origin.x = view.crop.whole.x - view.crop.origin.x - view.size.x;
    crop.origin = glm::uvec2(glm::vec2(crop.origin) * shrunk);
    crop.shift = glm::vec2(-crop.shift.x, crop.shift.y) * shrunk;
    View plain = view_of(mirrored_camera(view.camera, level_m), size, crop);
    plain.id = views_.of(view.id);
    plain.sun_disc = false;  // water adds the sun's glitter
    View clipped = plain;
    clipped.view_projection = mirror_view(view.view_projection, level_m);

    // 2. Opaque surfaces, clipped at the water. Their light comes through the air, which is drawn later.
    update(frame, in_order(drawings));
    Canvas below(color_, oblique_);
    draw_opaque(frame, clipped, below, solid);
    below.depth(frame);

    // 3. Its depth as the air wants it. The third row of the matrix is the fourth less `scale` times the water's plane.
    const glm::mat4 rows = glm::transpose(clipped.view_projection);
    const struct { float level_m, scale; } oblique{level_m, rows[3].y - rows[2].y};
    frame.raster("plain depth", {.depth = clear(depth_, 0.0f), .reads = {oblique_}}, [&](Raster& pass) {
        pass.use(plain_depth_).set("oblique_depth", oblique_, nearest_clamp).set("oblique", oblique);
        pass.set("mirror_rays", view_rays(plain)).draw(3);
    });

    // 4. The sky behind it and the air in front; then transparent surfaces, always back to front by object.
    Canvas canvas(color_, depth_);
    canvas.color_overwritten();
    canvas.depth_overwritten();
    if (!air.empty()) draw_opaque(frame, plain, canvas, air);
    draw_transparent(frame, clipped, below, solid);
}

void Water::Kept::begin_frame(Gpu&, glm::uvec2) { before = std::exchange(now, State()); }

bool Water::has_moved() const {
    const Kept::State &now = kept_.now, &before = kept_.before;
    if (now.method == Kept::none || now.method != before.method) return false;
    const bool has_waves = !method.is("flat") || (now.has_rings && before.has_rings);
    return (has_waves && now.time_s != before.time_s) || now.water.level_m != before.water.level_m;
}

void Water::draw_motion(Frame& frame, const MotionPass& given) const {
    const WaterNow& water = kept_.before.water;
    WaterBefore before{.level_m = water.level_m, .waves = water.waves, .ring_phase = kept_.before.ring_phase};
    std::copy(std::begin(water.wave), std::end(water.wave), before.wave);
    for (int part = 0; part < 3; ++part)
        before.ocean[part] = ocean.travel(part, kept_.now.time_s - kept_.before.time_s);
    const bool fft = method.is("fft");
    const ImageView ocean_before = fft ? ImageView(ocean.moved_before()) : ImageView(black_).as_array();
    std::vector<Resource> reads{given.depth, black_};
    if (fft) reads.insert(reads.end(), {ocean.moved(), ocean.moved_before(), ocean.sloped()});
    frame.raster("motion of water", {.color = {keep(given.into)}, .reads = reads, .with = {*this}}, [&](Raster& pass) {
        pass.use(moved_, around_objects()).set("water_now", kept_.now.water).set("water_before", before);
        pass.set("depth", given.depth, nearest_clamp).set("from_to", given.from_to);
        pass.set_if_present("ocean_moved_before", ocean_before);
        pass.draw_indexed(rings_, 0, 6 * SPOKES * (RINGS - 1));
    });
}

}  // namespace lightwalk
