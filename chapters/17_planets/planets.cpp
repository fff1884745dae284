#include "17_planets/planets.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <glm/gtc/constants.hpp>

#include "17_planets/exercises.h"
#include "common/base/text.h"
#include "common/gpu/warm_up.h"

namespace lightwalk {
namespace {

constexpr double small_px = 4;  // bodies below this diameter are drawn by small_body.comp

// A rectangle of pixels around the ball of `reach_m` about `center`, from the camera; empty if it is behind it.
struct Rectangle {
    glm::ivec2 first{0}, end{0};
    double diameter_px = 0;
};

Rectangle pixels_of(const View& view, glm::dvec3 center, double reach_m) {
    const glm::ivec2 size(view.size);
    const ViewRays rays = view_rays(view);
    const glm::dvec3 right(rays.right), down(rays.down), corner(rays.corner);
    const double pixel = glm::length(right), away = glm::length(center);
    glm::dvec3 forward = glm::normalize(glm::cross(right, down));
    if (glm::dot(forward, corner) < 0) forward = -forward;
    Rectangle all{.first = {0, 0}, .end = size, .diameter_px = 1e6};
    if (away <= reach_m * 1.001) return all;
    const double angle = std::asin(reach_m / away) * 1.02 + 2 * pixel;
    const glm::dvec3 towards = center / away;
    if (angle > 1.2) return all;
    const glm::dvec3 side =
        glm::normalize(glm::cross(std::fabs(towards.y) < 0.9 ? glm::dvec3(0, 1, 0) : glm::dvec3(1, 0, 0), towards));
    const glm::dvec3 up = glm::cross(towards, side);
    glm::dvec2 least(1e9), most(-1e9);
    int behind = 0;
    constexpr int points = 24;
    for (int i = 0; i < points; ++i) {
        const double around = i * glm::two_pi<double>() / points;
        const glm::dvec3 edge =
            std::cos(angle) * towards + std::sin(angle) * (std::cos(around) * side + std::sin(around) * up);
        const double along = glm::dot(edge, forward);
        if (along < 1e-3) {
            ++behind;
            continue;
        }
        const glm::dvec3 at = edge / along - corner;
        const glm::dvec2 place(glm::dot(at, right) / (pixel * pixel), glm::dot(at, down) / (pixel * pixel));
        least = glm::min(least, place);
        most = glm::max(most, place);
    }
    if (behind == points) return {};
    if (behind) return all;
    const auto within = [&](glm::dvec2 p) { return glm::ivec2(glm::clamp(p, glm::dvec2(0.0), glm::dvec2(size))); };
    return {.first = within(glm::floor(least - 2.0)),
            .end = within(glm::ceil(most + 2.0)),
            .diameter_px = 2 * reach_m / away / pixel};
}

}  // namespace

Planets::Planets(Module& owner, std::string name) : Drawing(owner, std::move(name), "planets") {}

void Planets::prepare(Gpu& gpu, Scene&) {
    pool_ = std::make_unique<ImagePool>(gpu);
    maps_.clear();
    white_ = pool_->constant(glm::vec4(0.5f, 0.5f, 0.5f, 1.0f));
    flat_ = pool_->constant({0.5f, 0.5f, 1.0f, 0.0f});
    for (size_t i = 0; i < body_count; ++i) {
        const auto body = static_cast<BodyId>(i);
        const bool pair = (at.is("earth") && body == BodyId::moon) || (at.is("moon") && body == BodyId::earth);
        if (body == body_at() || pair || maps.is("all"))
            maps_[body] = load_maps(gpu, *pool_, body, flow_frames.is("five"));
    }
}

Planets::Outlook Planets::outlook(const Frame& frame, const View& view) const {
    Outlook look;
    look.days = days_at(static_cast<double>(frame.time_s));
    if (look.days < 0.0 || look.days > accurate_until_days)
        warn_once(
            fmt::format("{}.date_days: before 2000 and after 2050 the planets are up to a third of a degree from "
                        "their true positions, the Moon 3.9°; from 0 to {} d a sixth of a degree, and 3.1°",
                        path(), accurate_until_days));
    if (view.exact_eye) {
        look.eye_m = *view.exact_eye;
        return look;
    }
    const glm::dvec3 middle = place_body(body_at(), look.days).position;
    const glm::dvec3 target = at.is("sun") ? place_body(BodyId::earth, look.days).position : glm::dvec3(0.0);
    const glm::dvec3 z = glm::normalize(target - middle), x = glm::normalize(glm::cross(glm::dvec3(0, 1, 0), z));
    look.to_view = glm::transpose(glm::dmat3(x, glm::cross(z, x), z));
    look.eye_m = middle + glm::transpose(look.to_view) * (static_cast<double>(away) * glm::dvec3(view.eye));
    return look;
}

std::vector<Planets::Shown> Planets::shown(const Outlook& look) const {
    const auto placed = [&](BodyId body, glm::dvec3 offset) {
        Placement place = place_body(body, look.days);
        if (body == body_at()) {
            const double turn = glm::radians(static_cast<double>(turn_deg));
            const glm::dvec3 east = place.axes[0], meridian = place.axes[2];
            place.axes[2] = std::cos(turn) * meridian + std::sin(turn) * east;
            place.axes[0] = std::cos(turn) * east - std::sin(turn) * meridian;
        }
        const glm::dmat4 turned(look.to_view);
        glm::dmat4 matrix = turned * place.matrix();
        matrix[3] += glm::dvec4(offset, 0.0);
        return camera_relative(matrix, look.to_view * look.eye_m);
    };
    std::vector<Shown> all;
    if (show.is("laws")) {
        const int laws[] = {LAW_LAMBERT, LAW_WRAPPED, LAW_LOMMEL_SEELIGER, LAW_HAPKE};
        // In a row across the picture.
        const glm::dvec3 eye = look.to_view * (look.eye_m - place_body(body_at(), look.days).position);
        const glm::dvec3 right = glm::normalize(glm::cross(glm::dvec3(0, 1, 0), eye));
        for (int i = 0; i < 4; ++i)
            all.push_back(
                {body_at(), placed(body_at(), (i - 1.5) * 2.12 * traits(body_at()).radius_m * right), laws[i]});
        return all;
    }
    for (size_t i = 0; i < body_count; ++i) {
        const auto body = static_cast<BodyId>(i);
        all.push_back({body, placed(body, glm::dvec3(0.0))});
    }
    std::sort(all.begin(), all.end(), [](const Shown& a, const Shown& b) {
        return glm::length(glm::vec3(a.placed[3])) > glm::length(glm::vec3(b.placed[3]));
    });
    return all;
}

BodyNow Planets::now(const Shown& one, const Outlook& look, const Frame& frame, const View& view) const {
    const BodyTraits& of = traits(one.body);
    const Placement place = place_body(one.body, look.days);
    const double from_sun = std::max(glm::length(place.position), sun_radius_m);
    const double counts = exposed_for_m.value_or(glm::length(place_body(body_at(), look.days).position));
    const double light =
        static_cast<double>(exposure) * (at.is("sun") && !exposed_for_m ? 1.0 : counts / from_sun * counts / from_sun);
    BodyNow now{};
    now.rays = view_rays(view);
    now.center = glm::vec3(one.placed[3]);
    now.radius = static_cast<float>(of.radius_m);
    now.to_body = glm::transpose(glm::mat3(one.placed));
    now.flattening = static_cast<float>(of.flattening);
    now.to_sun =
        glm::vec3(look.to_view * -(one.body == BodyId::sun ? glm::dvec3(0, 0, 1) : glm::normalize(place.position)));
    now.sun_rad = static_cast<float>(std::asin(std::min(sun_radius_m / from_sun, 1.0)));
    now.surface = of.surface;
    if (one.law) now.surface.law = one.law;
    now.rings = rings_of(one.body);
    now.rings.brightness *= ring_exposure;
    const float top_m = air_of(one.body, glm::vec3(1.0f), 0.0f).top;
    now.reach = std::max(now.radius + (top_m > 1 ? top_m : 0.0f), now.rings.outer);
    if (one.body == BodyId::sun) {
        // As a picture holds it: exposed for the disc where that fills the picture, as bright as the knob says where it
        // is small, and where it is less than a pixel, so much more that the pixel is.
        const double pixel = static_cast<double>(view.pixel_rad());
        const double disc = sun_radius_m / static_cast<double>(glm::length(now.center));
        const double fills = std::clamp((disc / pixel - 20) / 60, 0.0, 1.0), knob = static_cast<double>(sun);
        const double light_of_disc = knob * std::max(1.0, 0.5 * pixel * pixel / (disc * disc));
        now.sunlight = glm::vec3(
            static_cast<float>(glm::mix(light_of_disc, std::min(knob, 0.8), fills * fills * (3 - 2 * fills))));
    } else {
        now.sunlight = glm::vec3(static_cast<float>(light));
    }
    for (const BodyId other : {BodyId::earth, BodyId::moon}) {
        const bool pair = (one.body == BodyId::earth && other == BodyId::moon) ||
                          (one.body == BodyId::moon && other == BodyId::earth);
        if (!pair) continue;
        now.other = glm::vec3(look.to_view * (place_body(other, look.days).position - place.position));
        now.other_radius = static_cast<float>(traits(other).radius_m);
    }
    const double passed = static_cast<double>(frame.time_s) * static_cast<double>(days_per_s);
    now.cloud_turn = static_cast<float>(std::fmod(passed * -0.02, 1.0));  // to the east, 9 m/s at the equator
    now.flow_days = static_cast<float>(static_cast<double>(flow_days) + passed);
    now.flow_period = flow_period_days;
    now.moment = static_cast<float>(std::fmod(0.4 * static_cast<double>(frame.time_s), 4096.0));
    return now;
}

void Planets::draw(Frame& frame, const View& view, Canvas& canvas) {
    const Outlook look = outlook(frame, view);
    for (const Shown& one : shown(look)) draw_body(frame, view, canvas, one, look);
}

void Planets::draw_body(Frame& frame, const View& view, Canvas& canvas, const Shown& one, const Outlook& look) {
    BodyNow now = this->now(one, look, frame, view);
    Rectangle around = pixels_of(view, glm::dvec3(now.center), static_cast<double>(now.reach));
    const bool outside = around.first.x >= around.end.x || around.first.y >= around.end.y;
    if (outside && !WarmUp::is_recording()) return;
    if (outside) around = {glm::ivec2(0), glm::ivec2(1)};
    now.corner = around.first;
    const auto found = maps_.find(one.body);
    const bool mapped = found != maps_.end();
    const BodyMaps none, &of = mapped ? found->second : none;
    const BodyKind kind = traits(one.body).kind;
    const bool earth = mapped && kind == BodyKind::earth, tables = earth && air.method.is("tables");
    const Drawn& drawn = kind == BodyKind::star              ? star_
                         : !mapped || kind == BodyKind::rock ? rock_
                         : earth                             ? (tables ? earth_tables_ : earth_)
                         : kind == BodyKind::flowing         ? flowing_
                         : kind == BodyKind::ringed          ? ringed_
                                                             : clouded_;
    const bool is_small = around.diameter_px < small_px;
    const Pipeline &pipeline = is_small ? drawn.small : drawn.large, &other = is_small ? drawn.large : drawn.small;
    std::shared_ptr<Image> color = of.color, next = of.color;
    if (flow_frames.is("five") && !of.frames.empty() &&
        (flow.is("nearest") || flow.is("cross_fade") || flow.is("two_frames"))) {
        const FrameInterval in = frame_interval(static_cast<double>(now.flow_days), flow_period_days);
        color = of.frames[in.first], next = of.frames[in.second];
        now.flow_days = in.days, now.flow_period = in.period_days;
    }
    const Air air_here = air_of(one.body, now.sunlight, now.sun_rad);
    if (earth && sky_table_.follow(air_here)) frame.upload("skylight", skylight_, sky_table_.entries());
    const ImageView hdr = canvas.color(frame), depth = canvas.depth(frame);
    ComputeAccess access{.reads = {hdr, depth}, .writes = {hdr}, .with = {*this}};
    if (tables) {
        air_tables_.record(frame, *this, air_here, air.orders.is("multiple"));
        access.reads.insert(access.reads.end(), {air_tables_.transmittance(), air_tables_.multiple()});
    }
    frame.compute(body_names()[static_cast<size_t>(one.body)], access, [&](Compute& pass) {
        if (WarmUp::is_recording()) pass.use(other);  // it may come nearer, or go
        pass.use(pipeline).set("result", hdr).set("depth", depth, nearest_clamp).set("body", now);
        pass.set_if_present("air", air_here);
        if (earth) {
            pass.set_if_present("skylight", skylight_);
            pass.set_if_present("seed", frame.seed * 4096u + static_cast<unsigned>(frame.samples.index));
        }
        if (tables) air_tables_.set(pass);
        const Sampler around_it{.wrap = Wrap::repeat};
        const auto set_if_present = [&](const char* name, const std::shared_ptr<Image>& image,
                                        const std::shared_ptr<Image>& otherwise) {
            pass.set_if_present(name, image ? *image : *otherwise, around_it);
        };
        set_if_present("body_map", color, white_);
        set_if_present("next_map", next, white_);
        set_if_present("normal_map", of.normals, flat_);
        set_if_present("night_map", of.night, white_);
        set_if_present("water_map", of.water, white_);
        set_if_present("cloud_map", of.clouds, white_);
        if (of.rings) pass.set_if_present("ring_tables", *of.rings, linear_clamp);
        pass.dispatch_threads(glm::uvec2(around.end - around.first));
    });
}

}  // namespace lightwalk
