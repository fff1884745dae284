#include "17_planets/solar_system.h"

#include <cmath>
#include <cstdlib>
#include <fstream>

#include "17_planets/star_data.h"
#include "common/base/error.h"
#include "common/base/shared_lock.h"
#include "common/scene/scene_file.h"

namespace lightwalk {

namespace {

// A portrait's camera, from the body's centre: radii away, degrees from the Sun's direction eastwards, and upwards.
struct Stop {
    double radii, around_deg, up_deg;
};
constexpr Stop stops[body_count] = {{4.4, 0, 0},   {4.2, 52, 4},  {4.2, 40, 6},  {4.2, 52, 14},
                                    {4.4, 48, 5},  {4.2, 38, 10}, {4.4, 30, -4}, {7.5, 34, 9},
                                    {5.2, 22, 10}, {4.2, 34, 0},  {4.2, 26, 12}};

struct Pose {
    glm::dvec3 eye, forward;
    double from_body, from_sun;
};

Pose pose_at(size_t body, double days, double drift_deg) {
    const auto id = static_cast<BodyId>(body);
    const Stop& stop = stops[body];
    const glm::dvec3 place = place_body(id, days).position;
    const glm::dvec3 from =
        id == BodyId::sun ? glm::normalize(place_body(BodyId::earth, days).position) : -glm::normalize(place);
    const glm::dvec3 side = glm::normalize(glm::cross(glm::dvec3(0, 1, 0), from)), up = glm::cross(from, side);
    const double around = glm::radians(stop.around_deg + drift_deg), high = glm::radians(stop.up_deg);
    const glm::dvec3 away = std::cos(high) * (std::cos(around) * from + std::sin(around) * side) + std::sin(high) * up;
    const double distance = stop.radii * traits(id).radius_m;
    const double from_sun = glm::length(id == BodyId::sun ? place_body(BodyId::mercury, days).position : place);
    return {place + distance * away, -away, distance, from_sun};
}

glm::dquat looking(glm::dvec3 forward) {
    const glm::dvec3 right = glm::normalize(glm::cross(forward, glm::dvec3(0, 1, 0)));
    return glm::quat_cast(glm::dmat3(right, glm::cross(right, forward), -forward));
}

double smooth(double s) { return s * s * s * (s * (6 * s - 15) + 10); }

// Share of the distance travelled after a share `s` of the time: speed grows with the distance from the nearer end,
// so that neither a planet nor the void between takes all of it.
double travelled_at(double s, double near_a, double near_b, double way) {
    const auto half = [&](double share, double near) {
        return near * (std::pow(1 + 0.5 * way / near, share) - 1) / way;
    };
    return s < 0.5 ? half(2 * s, near_a) : 1 - half(2 - 2 * s, near_b);
}

}  // namespace

Stars::Stars(Module& owner, std::string name, const Planets& planets)
    : Drawing(owner, std::move(name), "stars"), planets_(planets) {}

Flight::Moment Flight::at(double time_s, double days) const {
    const double stay = static_cast<double>(stay_s), travel = static_cast<double>(travel_s);
    const double turn = stay + travel, all = turn * static_cast<double>(body_count);
    double t = std::fmod(time_s, all);
    if (t < 0) t += all;
    const size_t body = std::min(static_cast<size_t>(t / turn), body_count - 1), next = (body + 1) % body_count;
    const double within = t - static_cast<double>(body) * turn;
    const auto drift = [&](double s) { return static_cast<double>(drift_deg) * (s / stay - 0.5); };
    if (within <= stay) {
        const Pose pose = pose_at(body, days, drift(within));
        return {pose.eye, looking(pose.forward), pose.from_sun, body, 0};
    }
    const double s = smooth((within - stay) / travel);
    const Pose a = pose_at(body, days, drift(stay)), b = pose_at(next, days, drift(0));
    const double done = travelled_at(s, a.from_body, b.from_body, glm::length(b.eye - a.eye));
    return {glm::mix(a.eye, b.eye, done), glm::slerp(looking(a.forward), looking(b.forward), s),
            std::exp(glm::mix(std::log(a.from_sun), std::log(b.from_sun), s)), body, done};
}

Camera Flight::camera(const Moment& moment, const Camera& scene) const {
    planets_.exposed_for_m = moment.exposed_for_m;
    Camera camera = scene;
    camera.position = glm::vec3(0.0f);
    camera.target = glm::vec3(moment.turned * glm::dvec3(0, 0, -1));
    camera.up = glm::vec3(moment.turned * glm::dvec3(0, 1, 0));
    return camera;
}

std::vector<Star> read_stars(const std::filesystem::path& file) {
    std::ifstream in(file);
    if (!in) throw InputError("{}: cannot be read", file.string());
    std::vector<Star> stars;
    std::string line;
    for (int number = 1; std::getline(in, line); ++number) {
        if (number == 1 || line.empty()) continue;
        double values[3];
        const char* at = line.c_str();
        for (int i = 0; i < 3; ++i) {
            char* end = nullptr;
            values[i] = std::strtod(at, &end);
            if (end == at || (i < 2 && *end != ',') || !std::isfinite(values[i]))
                throw InputError("{}:{}: '{}' is no star; a line is v_mag,ra_deg,dec_deg", file.string(), number, line);
            at = end + 1;
        }
        stars.push_back(
            {glm::vec3(direction_of(values[1], values[2])), static_cast<float>(std::pow(10.0, -0.4 * values[0]))});
    }
    if (stars.empty()) throw InputError("{}: no stars", file.string());
    return stars;
}

void Stars::prepare(Gpu& gpu, Scene&) {
    pool_ = std::make_unique<ImagePool>(gpu);
    map_ = pool_->load(find_asset("planets_2k/stars.jpg"), TextureKind::color);
    const std::vector<Star> stars = unlocked([] { return read_stars(find_asset("planets/bright_stars.csv")); });
    count_ = static_cast<uint32_t>(stars.size());
    stars_ = gpu.upload("stars", stars);
}

void Stars::draw(Frame& frame, const View& view, Canvas& canvas) {
    const Planets::Outlook look = planets_.outlook(frame, view);
    const ImageView behind = canvas.color_overwritten();
    const glm::dmat3 to_world = glm::transpose(look.to_view);
    const StarsNow now{.rays = view_rays(view),
                       .to_galaxy = glm::mat3(world_to_galaxy() * to_world),
                       .to_view = glm::mat3(look.to_view),
                       .size = glm::vec2(view.size),
                       .sigma_px = sigma * static_cast<float>(view.crop.whole.y),
                       .brightness = brightness,
                       .milky_way = milky_way};
    frame.compute("milky way", {.writes = {behind}}, [&](Compute& pass) {
        pass.use(sky_).set("now", now).set("result", behind).set("star_map", *map_, Sampler{.wrap = Wrap::repeat});
        pass.dispatch_threads(view.size);
    });
    frame.raster("stars", {.color = {canvas.color_target()}},
                 [&](Raster& pass) { pass.use(points_).set("now", now).set("stars", stars_).draw(6, count_); });
}

}  // namespace lightwalk
