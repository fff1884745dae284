// Motion on a body: Jupiter's clouds by its winds, the Sun's granules.
#include <fmt/core.h>

#include "planets_fixture.h"

using namespace lightwalk;

namespace {

// A map with its coordinates as texels.
const std::string flow_before =
    "#define textureSize(map, level) ivec2(2048, 1024)\n"
    "#define textureLod(map, at, level) vec4(at, level, 1.0)\n"
    "#define sampler2D int\n"
    "#define PLANETS_FLOW_FROZEN 0\n#define PLANETS_FLOW_SCROLLED 1\n#define PLANETS_FLOW_NEAREST 2\n"
    "#define PLANETS_FLOW_CROSS_FADE 3\n#define PLANETS_FLOW_TWO_FRAMES 4\n#define PLANETS_FLOW_ADVECTED 5\n"
    "#define PLANETS_FLOW_FRAMES_FIVE 1\n";

Probe flow_probe(int method, const std::string& function, const std::string& signature, int frames = 0) {
    return {.include = "common/srgb.glsl",
            .before = flow_before +
                      fmt::format("#define PLANETS_FLOW {}\n#define PLANETS_FLOW_FRAMES {}\n", method, frames) +
                      "#include \"17_planets/flow.glsl\"\n" + function,
            .signature = signature};
}

constexpr double around_m = 2 * 3.14159265358979 * 71.492e6;  // Jupiter's equator

}  // namespace

TEST_CASE_METHOD(DeviceTest, "winds in metres a second become shares of the map a day, more of it near the poles") {
    Probe probe = flow_probe(0, "vec4 winds(vec2 uv) { return vec4(wind(uv, 0.0), flow_speed(uv, 0.0)); }\n",
                             "vec4 winds(vec2 uv)");
    for (const double v : {0.02, 0.05, 0.11, 0.31, 0.4, 0.5, 0.6, 0.606, 0.63, 0.82, 0.93, 0.98})
        for (const double u : {0.1, 0.35, 0.372, 0.39, 0.8})
            probe.inputs.push_back({double(float(u)), double(float(v))});
    const Table found = run_probe(gpu, probe, 4);
    for (size_t i = 0; i < found.size(); ++i) {
        const double cosine = std::max(std::cos(glm::pi<double>() * (0.5 - probe.inputs[i][1])), 0.05);
        INFO(call_text(probe, probe.inputs[i]));
        CHECK(found[i][2] == Approx(86400 * found[i][0] / (around_m * cosine)).epsilon(1e-4).margin(1e-7));
        CHECK(found[i][3] == Approx(-86400 * found[i][1] / (0.5 * around_m)).epsilon(1e-4).margin(1e-7));
    }
    // Read in their sources: 140 m/s at 25 degrees north; and no wind at the poles.
    Probe zonal = flow_probe(0, "vec2 wind_at(vec2 uv) { return wind(uv, 0.0); }\n", "vec2 wind_at(vec2 uv)");
    zonal.inputs = {{0.9, 0.5 - 25.0 / 180}, {0.9, 0.5 + 10.0 / 180}, {0.9, 0.5 - 7.5 / 180}, {0.9, 0}, {0.9, 1}};
    zonal.truth = [](auto in) {
        const double latitude = std::round(1800 * (0.5 - in[1])) / 10;
        return Row{latitude == 25 ? 140.0 : latitude == -10 ? 130.0 : latitude == 7.5 ? 72.5 : 0.0, 0};
    };
    zonal.bound = {.absolute = 0.05};
    CHECK(worst_of(zonal, run_probe(gpu, zonal, 2)) == "");
}

TEST_CASE_METHOD(DeviceTest, "the Great Red Spot turns anticlockwise, once in six days, on whichever turn of the map") {
    Probe probe = flow_probe(0, "vec2 wind_at(vec2 uv) { return wind(uv, 0.0); }\n", "vec2 wind_at(vec2 uv)");
    // To the east, the north, the west and the south of its middle, by half its axes.
    const glm::dvec2 middle(0.372, 0.606), half(9.5 / 360, 5.5 / 180);
    for (const double turn : {0.0, 1.0, -1.0})
        for (const glm::dvec2 side : {glm::dvec2(1, 0), {0, -1}, {-1, 0}, {0, 1}})
            probe.inputs.push_back({double(float(middle.x + turn + 0.5 * side.x * half.x)),
                                    double(float(middle.y + 0.5 * side.y * half.y))});
    const Table found = run_probe(gpu, probe, 2);
    for (size_t i = 0; i < found.size(); ++i) {
        INFO(call_text(probe, probe.inputs[i]));
        const glm::dvec2 wind(found[i][0], found[i][1]);
        if (i % 2 == 0) CHECK((i % 4 == 0 ? 1 : -1) * wind.y > 20);  // north in the east, south in the west
        if (i % 2 == 1) CHECK((i % 4 == 1 ? -1 : 1) * wind.x > 40);  // west in the north, east in the south
        for (int c = 0; c < 2; ++c) CHECK(found[i][size_t(c)] == Approx(found[i % 4][size_t(c)]).margin(0.05));
    }
}

TEST_CASE_METHOD(DeviceTest,
                 "clouds scrolled by a mean wind of 30 m/s, or carried by each latitude's own, come from upwind") {
    const std::string function = "vec2 from(vec2 uv, float days) { return flowed(0, 0, uv, 0.001, days, 2.0).xy; }\n";
    const char* const signature = "vec2 from(vec2 uv, float days)";
    Probe scrolled = flow_probe(1, function, signature);
    scrolled.truth = [](auto in) { return Row{in[0] - 30 * 86400 * in[2] / around_m, in[1]}; };
    scrolled.bound = {.absolute = 1e-5};
    // Far from the spot, where the wind of a latitude is the same all around.
    Probe carried = flow_probe(5, function, signature);
    carried.truth = [](auto in) {
        return Row{in[0] - 140 * 86400 * in[2] / (around_m * std::cos(glm::radians(25.0))), in[1]};
    };
    carried.bound = {.absolute = 1e-4};
    for (const double days : {0.0, 1.0, 3.0}) {
        scrolled.inputs.push_back({double(float(0.8)), 0.25, days});
        carried.inputs.push_back({double(float(0.8)), double(float(0.5 - 25.0 / 180)), days});
    }
    CHECK(worst_of(scrolled, run_probe(gpu, scrolled, 2)) == "");
    CHECK(worst_of(carried, run_probe(gpu, carried, 2)) == "");
}

TEST_CASE_METHOD(DeviceTest, "two frames of clouds are mixed by the share of their period that has passed",
                 "[17.two_frames]") {
    // Of a map of squares: (1 - t) (u - s t)² + t (u + s (1 - t))² is u² + s² t (1 - t).
    Probe probe = flow_probe(4, "vec2 seen(vec2 uv, float days) { return flowed(0, 0, uv, 0.001, days, 2.0).xy; }\n",
                             "vec2 seen(vec2 uv, float days)");
    const std::string plain = "vec4(at, level, 1.0)";
    probe.before.replace(probe.before.find(plain), plain.size(), "vec4((at) * (at), level, 1.0)");
    probe.truth = [](auto in) {
        const double moved = 2 * 140 * 86400 / (around_m * std::cos(glm::radians(25.0))), t = std::fmod(in[2] / 2, 1);
        return Row{in[0] * in[0] + moved * moved * t * (1 - t), in[1] * in[1]};
    };
    probe.bound = {.absolute = 2e-5};
    for (const double days : {0.0, 0.5, 1.0, 1.5, 2.5})
        probe.inputs.push_back({double(float(0.8)), double(float(0.5 - 25.0 / 180)), days});
    CHECK(worst_of(probe, run_probe(gpu, probe, 2)) == "");
}

TEST_CASE_METHOD(DeviceTest, "clouds carried around the Great Red Spot stay as far from its middle",
                 "[17.carried_around]") {
    Probe probe = flow_probe(5, "vec2 from(vec2 uv, float days) { return flowed(0, 0, uv, 0.001, days, 2.0).xy; }\n",
                             "vec2 from(vec2 uv, float days)");
    const glm::dvec2 middle(0.372, 0.606), half(9.5 / 360, 5.5 / 180);
    for (const glm::dvec2 side : {glm::dvec2(0.3, 0), {0, -0.3}, {-0.3, 0}, {0, 0.3}})
        probe.inputs.push_back(
            {double(float(middle.x + side.x * half.x)), double(float(middle.y + side.y * half.y)), 6});
    for (const Row& found : run_probe(gpu, probe, 2)) {
        const glm::dvec2 from = (glm::dvec2(found[0], found[1]) - middle) / half;
        CHECK(glm::length(from) == Approx(0.3).epsilon(0.08));
    }
}

TEST_CASE_METHOD(DeviceTest, "frames of turned bands: their flow gives the turned band at each time, a fade two ghosts",
                 "[17.turned_bands]") {
    // The first map has waves, the second the same waves where the wind of 25 degrees north has carried them in two days.
    const double moved = 2 * 140 * 86400 / (around_m * std::cos(glm::radians(25.0))), number = 6.5 / moved;
    for (const int method : {4, 3}) {
        Probe probe =
            flow_probe(method, "float seen(vec2 uv, float days) { return flowed(0, 1, uv, 0.001, days, 2.0).x; }\n",
                       "float seen(vec2 uv, float days)");
        const std::string plain = "vec4(at, level, 1.0)";
        probe.before.replace(
            probe.before.find(plain), plain.size(),
            fmt::format("vec4(cos(6.2831853 * {:.9f} * ((at).x - {:.9f} * float(map))))", number, moved));
        probe.truth = [&](auto in) {
            return Row{std::cos(glm::two_pi<double>() * number * (in[0] - moved * std::fmod(in[2] / 2, 1)))};
        };
        probe.bound = {.absolute = 1e-3};
        for (const double days : {0.0, 0.3, 1.0, 1.7, 1.999999})
            for (const double u : {0.7, 0.71, 0.8})
                probe.inputs.push_back({double(float(u)), double(float(0.5 - 25.0 / 180)), days});
        const Table found = run_probe(gpu, probe, 1);
        INFO((method == 4 ? "moved" : "faded"));
        CHECK((worst_of(probe, found) == "") == (method == 4));
    }
}

TEST_CASE_METHOD(DeviceTest, "an oval's middle comes with its band from where the map has it", "[17.sequence]") {
    Probe probe = flow_probe(5, "vec2 from(vec2 uv, float days) { return flowed(0, 0, uv, 0.001, days, 1.0).xy; }\n",
                             "vec2 from(vec2 uv, float days)", 1);
    Probe band = flow_probe(5, "vec2 drift(float v) { return on_map(vec2(zonal_wind_at(v), 0.0), v); }\n",
                            "vec2 drift(float v)");
    const glm::dvec2 ovals[] = {{0.292, 0.73}, {0.4136, 0.727}, {0.2243, 0.2757}, {0.7214, 0.2757}};
    for (const glm::dvec2 oval : ovals) band.inputs.push_back({double(float(oval.y))});
    const Table drift = run_probe(gpu, band, 2);
    for (size_t i = 0; i < drift.size(); ++i)
        probe.inputs.push_back({double(float(ovals[i].x + 4 * drift[i][0])), double(float(ovals[i].y)), 4});
    const Table found = run_probe(gpu, probe, 2);
    for (size_t i = 0; i < found.size(); ++i)
        for (int c = 0; c < 2; ++c) CHECK(found[i][size_t(c)] == Approx(ovals[i][c]).margin(2e-4));
}

TEST_CASE("intervals of five frames: each day one, two or four of them, and from the last to the first",
          "[17.sequence]") {
    const auto interval = [](double days, float period) {
        const FrameInterval in = frame_interval(days, period);
        return fmt::format("{} {} {:.2f} {:.0f}", in.first, in.second, in.days, in.period_days);
    };
    CHECK(interval(0, 1) == "0 1 0.00 1");
    CHECK(interval(1, 1) == "1 2 1.00 1");
    CHECK(interval(3.75, 0.01f) == "3 4 3.75 1");
    CHECK(interval(4.5, 1) == "4 0 4.50 1");
    CHECK(interval(5, 1) == "0 1 0.00 1");
    CHECK(interval(-0.25, 1) == "4 0 4.75 1");
    CHECK(interval(1.99, 2) == "0 2 1.99 2");
    CHECK(interval(5, 2) == "4 0 5.00 2");
    CHECK(interval(4, 100) == "4 0 4.00 4");
    CHECK(frame_interval(5 - 1e-12, 1).first == 0);  // where a float is the loop's end
}

TEST_CASE_METHOD(OnPlanets,
                 "five frames: each is seen at its time, without a jump, and between them the flow is nearest",
                 "[17.sequence]") {
    size = {240, 160};
    planets.flow_frames.set("five");
    planets.turn_deg.value = 171.4f;
    look_at("jupiter", 2, 20, -15);
    planets.flow_period_days.value = 1;
    const auto seen = [&](const char* flow, double days, const char* frames = "five") {
        planets.flow.set(flow);
        planets.flow_frames.set(frames);
        planets.flow_days.value = float(days);
        return picture();
    };
    const auto apart = [&](const ImageRgb& a, const ImageRgb& b) {
        double sum = 0, most = 0;
        for (size_t i = 0; i < a.pixels.size(); ++i) {
            const glm::dvec3 d = glm::abs(glm::dvec3(a.pixels[i]) - glm::dvec3(b.pixels[i]));
            sum += glm::dot(d, d) / 3;
            most = std::max({most, d.x, d.y, d.z});
        }
        return std::pair(std::sqrt(sum / double(a.pixels.size())), most);
    };
    CHECK(apart(seen("two_frames", 0), seen("frozen", 0, "one")).second == 0);
    double kept = 0, jump = 0;
    for (int day = 0; day <= 5; ++day) {
        const ImageRgb at = seen("two_frames", day);
        CHECK(apart(at, seen("nearest", day)).second == 0);
        jump = std::max(
            {jump, apart(at, seen("two_frames", day - 1e-4)).second, apart(at, seen("two_frames", day + 1e-4)).second});
        if (day == 5) CHECK(apart(at, seen("two_frames", 0)).second == 0);
        if (day > 0 && day < 5) kept = std::max(kept, apart(at, seen("advected", day)).first);
    }
    for (const double days : {0.5, 1.5, 2.5, 3.5}) {
        const ImageRgb truth = seen("advected", days);
        const double flow = apart(seen("two_frames", days), truth).first;
        const double fade = apart(seen("cross_fade", days), truth).first;
        const double nearest = apart(seen("nearest", days), truth).first;
        const double one = apart(seen("two_frames", days, "one"), truth).first;
        fmt::print("{} d, RMS from the carried map: flow {:.4f}, fade {:.4f}, nearest {:.4f}, one map {:.4f}\n", days,
                   flow, fade, nearest, one);
        CHECK(flow < 0.7 * std::min(fade, nearest));
        CHECK(flow < one);
    }
    fmt::print("kept frames, RMS from the carried map {:.4f}; largest step at a frame {:.5f}\n", kept, jump);
    CHECK(kept < 0.03);  // threads thinner than a texel alias, in the kept frames and in the carried map
    CHECK(jump < 0.002);
}

// After a day the ground is where it was. The same clouds over a body that is turned further show how far they went.
TEST_CASE_METHOD(OnPlanets, "the Earth's clouds drift east at 45 degrees as fast as the wind blows there, 5 to 10 m/s",
                 "[17.cloud_drift]") {
    size = {64, 64};
    look_at("earth", 4);
    planets.days_per_s.value = 1;
    const auto clouds = [&](float time_s, float turn_deg) {
        planets.turn_deg.value = turn_deg;
        planets.clouds.value = 1;
        ImageRgb with = picture(time_s);
        planets.clouds.value = 0;
        const ImageRgb without = picture(time_s);
        for (size_t i = 0; i < with.pixels.size(); ++i) with.pixels[i] -= without.pixels[i];
        return with;
    };
    const ImageRgb later = clouds(1, 0);
    float drift_deg = 0;
    double least = 1e9;
    for (int step = -6; step <= 6; ++step) {
        const float turn = 2.4f * float(step);
        const ImageRgb turned = clouds(0, turn);
        double change = 0;
        for (size_t i = 0; i < later.pixels.size(); ++i)
            change += std::pow(double(later.pixels[i].g) - double(turned.pixels[i].g), 2);
        if (change < least) {
            least = change;
            drift_deg = turn;
        }
    }
    const double speed = glm::radians(double(drift_deg)) * 6.378e6 * std::cos(glm::radians(45.0)) / 86400;
    INFO(drift_deg << " degrees to the east in a day, " << speed << " m/s");
    CHECK(speed > 5);
    CHECK(speed < 10);
}

TEST_CASE_METHOD(DeviceTest, "the Sun's network changes a tenth as fast as its granules, and neither jumps") {
    Probe probe{.include = "17_planets/sun_surface.glsl",
                .signature = "vec3 sun_surface(vec3 place, float mu, float moment, float footprint_rad)"};
    // Light of the same 300 points at a moment, averaged over a pixel of that angle.
    const auto light = [&](double moment, double footprint) {
        probe.inputs.clear();
        Random random(5);
        for (int i = 0; i < 300; ++i) {
            const glm::vec3 place = random.direction();
            probe.inputs.push_back({double(place.x), double(place.y), double(place.z), 1, moment, footprint});
        }
        return run_probe(gpu, probe, 3);
    };
    const auto change = [&](double from, double to, double footprint) {
        const Table a = light(from, footprint), b = light(to, footprint);
        double sum = 0;
        for (size_t i = 0; i < a.size(); ++i) sum += (a[i][1] - b[i][1]) * (a[i][1] - b[i][1]);
        return std::sqrt(sum / double(a.size()));
    };
    // Half a cell of the granules' time, of the light that changes in fifty. A pixel of 6 thousandths of a radian shows the
    // network alone, of 3 the larger granules too, of 0.5 all.
    const auto share = [&](double footprint) {
        return change(40.001, 40.501, footprint) / change(40.001, 90.001, footprint);
    };
    const double network = share(0.006), larger = share(0.003), all = share(0.0005);
    fmt::print("in half a cell of time: the network {:.3f} of all change, larger granules {:.3f}, all {:.3f}\n",
               network, larger, all);
    CHECK(network < 0.05);
    CHECK(larger > 2 * network);
    CHECK(larger < 0.2);
    CHECK(all > 0.2);
    for (const double moment : {1.0, 2.0, 10.0, 20.0}) CHECK(change(moment - 0.002, moment + 0.002, 0.0005) < 0.002);
}

TEST_CASE_METHOD(DeviceTest,
                 "the Sun's edge is as dark in each colour as Hestroffer and Magnan measured it, and not black",
                 "[17.sun_limb]") {
    Probe probe{.include = "17_planets/sun_surface.glsl",
                .signature = "vec3 limb_darkening(float mu)",
                .inputs = {{1}, {0.5}, {0.1}, {1e-3}, {1e-4}, {0}},
                .truth =
                    [](auto in) {
                        const double mu = std::max(in[0], 1e-3);
                        Row row;  // their exponent, at wavelengths of red, green and blue
                        for (const double um : {0.65, 0.55, 0.45}) row.push_back(std::pow(mu, 0.292 / um - 0.023));
                        return row;
                    },
                .bound = {.absolute = 1e-3, .relative = 5e-3}};
    CHECK(worst_of(probe, run_probe(gpu, probe, 3)) == "");
}

TEST_CASE(
    "two frames of a wind known to within delta: contrast |cos(pi delta / lambda)| halfway; unrelated frames keep "
    "0.71",
    "[17.two_frames]") {
    const double wave = 1, pi = glm::pi<double>();
    for (const double delta : {0.1, 0.25, 0.5}) {
        // A(x - v t) and B(x + v (1 - t)) of clouds that move by v + delta.
        const double v = 0.37, t = 0.5;
        double most = 0;
        for (int i = 0; i < 2000; ++i) {
            const double x = i / 2000.0;
            const auto clouds = [&](double at, double time) {
                return std::cos(2 * pi * (at - (v + delta) * time) / wave);
            };
            most = std::max(most, std::fabs((1 - t) * clouds(x - v * t, 0) + t * clouds(x + v * (1 - t), 1)));
        }
        CHECK(most == Approx(std::fabs(std::cos(pi * delta / wave))).margin(1e-3));
    }
    CHECK(std::sqrt(0.5 * 0.5 + 0.5 * 0.5) == Approx(0.71).margin(0.01));
}
