#include "10_atmosphere/atmosphere.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/constants.hpp>

#include "common/base/error.h"
#include "common/base/exercise.h"

namespace lightwalk {

Atmosphere::Atmosphere(Module& owner, std::string name) : Drawing(owner, std::move(name), "atmosphere") {}

float cornette_shanks_g(float mean_cosine) {
    const double wanted = double(std::fabs(mean_cosine));
    double low = 0, high = 1;
    for (int i = 0; i < 50; ++i) {
        const double g = 0.5 * (low + high), mean = 3 * g * (4 + g * g) / (5 * (2 + g * g));
        (mean < wanted ? low : high) = g;
    }
    return static_cast<float>(std::copysign(low, double(mean_cosine)));
}

glm::vec3 Atmosphere::to_sun() const {
    const double up = glm::radians(double(sun_elevation_deg.value)), around = glm::radians(double(sun_azimuth_deg));
    return {std::cos(up) * std::sin(around), std::sin(up), -std::cos(up) * std::cos(around)};
}

float Atmosphere::mie_g() const {
    if (!phase.is("cornette_shanks")) return mean_cosine;
    if (!mie_g_ || mie_g_->first != mean_cosine) mie_g_ = {mean_cosine, cornette_shanks_g(mean_cosine)};
    return mie_g_->second;
}

Air Atmosphere::air() const {
    const auto per_m = [](glm::vec3 per_mm) { return 1e-6f * per_mm; };
    return {.rayleigh = per_m(rayleigh),
            .rayleigh_height = rayleigh_height_m,
            .mie = per_m(mie),
            .mie_height = mie_height_m,
            .mie_extinction = per_m(mie.value + mie_absorption.value),
            .mie_g = mie_g(),
            .layer = per_m(ozone),
            .layer_center = ozone_center_m,
            .layer_width = ozone_width_m,
            .radius = radius_m,
            .top = top_m,
            .sun = exposure * sun_klx * sun_color.value,
            .sun_rad = glm::radians(0.5f * sun_deg),
            .ground = ground};
}

void Atmosphere::bind(Pass& pass) const {
    pass.set_if_present("air", air());
    pass.set_if_present("to_sun", to_sun());
    if (skylight_) pass.set_if_present("skylight", skylight_);
}

void Atmosphere::update(Frame& frame) {
    if (sky_table_.follow(air()) || !skylight_uploaded_) frame.upload("skylight", skylight_, sky_table_.entries());
    skylight_uploaded_ = true;
}

Sun Atmosphere::sun() {
    const Air now = air();
    if (sky_table_.follow(now)) skylight_uploaded_ = false;
    const float up = to_sun().y;
    if (!sun_made_.is_current(now, up)) sunlight_ = sunlight_of(now, up);
    return {to_sun(), sunlight_, skylight_of(sky_table_.entries(), up) / glm::pi<float>()};
}

// Above the ground, at most that of the air's edge.
float Atmosphere::height_of(glm::vec3 position) const {
    const glm::dvec3 p(position);
    const double r = double(radius_m), k = p.y * (2 * r + p.y) + p.x * p.x + p.z * p.z;
    return static_cast<float>(std::clamp(k / (r + std::sqrt(std::max(r * r + k, 0.0))), 0.0, double(top_m)));
}

// How far the volume before the eye reaches: to the ground's horizon and as far behind it as a mountain of half the
// molecules' scale height can be seen. 0 at the air's edge and in space: from there nothing is near.
float Atmosphere::volume_reach_m(const Camera& camera) const {
    const float height = height_of(camera.position), mountain = 0.5f * rayleigh_height_m;
    if (height >= top_m) return 0.0f;
    return std::sqrt(height * (2 * radius_m + height)) + std::sqrt(mountain * (2 * radius_m + mountain));
}

void Atmosphere::make_images(Device& device) {
    const auto scaled = [&](float x) { return static_cast<uint32_t>(std::max(2.0f, std::round(x * table_scale))); };
    const auto table = [&](Image& image, const char* name, glm::vec2 size, float depth) {
        const uint32_t slices = depth > 0 ? scaled(depth) : 0;
        if (image.ensure(
                device,
                {.name = path() + name, .size = {scaled(size.x), scaled(size.y)}, .depth = slices, .kept = true}))
            sky_made_.forget();
    };
    table(sky_, " sky", {192, 108}, 0);
    table(light_, " light", {32, 32}, 32);
    table(through_, " through", {32, 32}, 32);
}

void Atmosphere::record_tables(Frame& frame, const View& view, float reach_m) {
    // 1. Tables of the air alone: remade after a change of its knobs.
    const bool often = orders.is("multiple");  // else nothing reads the second table
    const Air now = air();
    if (lasting_.record(frame, *this, now, often, table_scale, refresh.is("always"))) {
        ++tables_made;
        sky_made_.forget();
    }
    if (reach_m <= 0.0f) return;  // nothing of the rest is read from space

    // 2. Tables of the eye and the sun.
    const float height = height_of(view.eye);
    const glm::vec3 up = (view.eye + glm::vec3(0.0f, radius_m.value, 0.0f)) / (radius_m + height);
    const glm::vec2 eye(height, glm::dot(up, to_sun()));
    if (!sky_made_.is_current(now, phase.text(), often, eye, Exercises::epoch()) || refresh.is("always")) {
        ++skies_made;
        frame.compute("sky table",
                      {.reads = {lasting_.transmittance(), lasting_.multiple()}, .writes = {sky_}, .with = {*this}},
                      [&](Compute& pass) {
                          pass.use(make_sky_).set("result", sky_).set("eye", eye);
                          lasting_.set(pass);
                          pass.dispatch_threads(sky_.desc.size);
                      });
    }
    frame.compute(
        "aerial volume",
        {.reads = {lasting_.transmittance(), lasting_.multiple()}, .writes = {light_, through_}, .with = {*this}},
        [&](Compute& pass) {
            pass.use(make_aerial_).set("result", light_).set("transmitted", through_);
            lasting_.set(pass);
            pass.set("rays", view_rays(view)).set("reach", glm::vec3(view.size, reach_m));
            pass.dispatch_threads(light_.desc.size);
        });
}

// The work of the two methods with too many iterations, cut into parts.
std::vector<PathPart> Atmosphere::parts() const {
    if (method.is("truth"))
        return path_parts({.places = 32 * steps, .light_places = 48, .walks = orders.is("multiple") ? paths.value : 0},
                          air());
    if (method.is("march")) return path_parts({.places = steps, .light_places = light_steps}, air());
    return {{.begins = 1, .ends = 1}};
}

void Atmosphere::update_sun() {
    if (scene_) scene_->set_sun(sun());
}

void Atmosphere::draw(Frame& frame, const View& view, Canvas& canvas) {
    const ImageView hdr = canvas.color(frame), depth = canvas.depth(frame);
    const bool tables = method.is("tables"), truth = method.is("truth");
    const std::vector<PathPart> parts = this->parts();
    const bool in_parts = truth || parts.size() > 1;
    const Pipeline& look = method.is("preetham")     ? preetham_
                           : method.is("polynomial") ? polynomial_
                           : method.is("chapman")    ? chapman_
                           : method.is("march")      ? (in_parts ? march_parts_ : march_)
                           : tables                  ? look_tables_
                           : truth                   ? truth_
                                                     : none_;
    const float reach_m = tables ? volume_reach_m(view.camera) : 0.0f;
    ComputeAccess access{.reads = {depth, hdr}, .writes = {hdr}, .with = {*this}};
    if (tables) {
        make_images(frame.gpu.device);
        record_tables(frame, view, reach_m);
        access.reads.insert(access.reads.end(),
                            {lasting_.transmittance(), lasting_.multiple(), sky_, light_, through_});
    }
    if (truth) {
        doubt_.ensure(frame.gpu.device, {.name = path() + " standard error", .size = view.size});
        access.writes.push_back(doubt_);
    }
    if (in_parts) {
        const auto so_far = [&](Image& image, const char* name) {
            image.ensure(frame.gpu.device,
                         {.name = path() + name, .format = VK_FORMAT_R32G32B32A32_SFLOAT, .size = view.size});
            access.reads.push_back(image);
            access.writes.push_back(image);
        };
        so_far(light_so_far_, " light so far");
        so_far(through_so_far_, " through so far");
    }
    frame.compute("atmosphere", access, [&](Compute& pass) {
        for (const PathPart& part : parts) {
            if (!part.begins) pass.wait();
            pass.use(look).set("result", hdr).set("depth", depth, nearest_clamp);
            pass.set("rays", view_rays(view)).set("disc", view.sun_disc ? float(disc) : 0.0f);
            if (in_parts)
                pass.set("part", part).set("light_so_far", light_so_far_).set("through_so_far", through_so_far_);
            if (tables) {
                lasting_.set(pass);
                pass.set("air_sky", sky_, linear_clamp).set("air_light", light_, linear_clamp);
                pass.set("air_through", through_, linear_clamp).set("reach_m", reach_m);
            }
            if (truth) {
                pass.set_if_present("doubt", doubt_);
                pass.set_if_present("seed", frame.seed * 4096u + static_cast<unsigned>(frame.samples.index));
            }
            pass.dispatch_threads(view.size);
        }
    });
}

const Image* Atmosphere::table(std::string_view name) const {
    if (method.is("truth")) return name == "doubt" ? &doubt_ : nullptr;
    if (!method.is("tables")) return nullptr;
    return name == "transmittance" ? &lasting_.transmittance()
           : name == "multiple"    ? &lasting_.multiple()
           : name == "sky"         ? &sky_
                                   : nullptr;
}

namespace {

constexpr double most_rounds = 60000;
constexpr double places_of_a_walk = 8, most_turns = 64;  // as in random_paths.glsl

// After its fifth turn each walk goes on with a chance of 0.8: nine turns are the mean, and of many walks the mean is
// near that. Twenty-four leave room.
constexpr double turns_of_many = 24;

// Steps of delta tracking through all of the air where it is widest: its length in mean free ways of the densest air.
double steps_across(const Air& air) {
    const double top = double(air.top), way = 2 * std::sqrt(top * (2 * double(air.radius) + top));
    double densest = 0;
    for (int c = 0; c < 3; ++c)
        densest = std::max(densest, double(air.rayleigh[c]) + double(air.mie_extinction[c]) + double(air.layer[c]));
    return densest * way;
}

}  // namespace

std::vector<PathPart> path_parts(const PathWork& work, const Air& air) {
    // The round in which a loop ends counts as well.
    const double of_a_turn = 3 + steps_across(air), of_a_place = 2 + work.light_places;
    const double of_a_walk = 2 + places_of_a_walk + turns_of_many * of_a_turn;
    if (work.walks > 0 && most_turns * of_a_turn > most_rounds)
        throw InputError(
            "atmosphere.method: truth with orders multiple takes up to {:.0f} steps for a random walk through this "
            "air, and a driver may end a loop after {:.0f}; reduce the scattering coefficients or top_m, or set orders "
            "to single",
            most_turns * of_a_turn, most_rounds);
    if (work.walks * of_a_walk + work.places * of_a_place <= most_rounds)
        return {{.end_walk = work.walks, .end_place = work.places, .begins = 1, .ends = 1}};
    std::vector<PathPart> parts;
    const auto most_walks = std::max(1, static_cast<int>(most_rounds / of_a_walk));
    for (int first = 0; first < work.walks; first += most_walks)
        parts.push_back({.first_walk = first, .end_walk = std::min(first + most_walks, work.walks)});
    const auto most_places = std::max(1, static_cast<int>(most_rounds / of_a_place));
    for (int first = 0; first < work.places; first += most_places)
        parts.push_back({.first_place = first, .end_place = std::min(first + most_places, work.places)});
    parts.front().begins = 1;
    parts.back().ends = 1;
    return parts;
}

}  // namespace lightwalk
