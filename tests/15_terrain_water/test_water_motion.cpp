// Motion of water: vectors against waves that travel here in double precision, and temporal anti-aliasing that follows them.
#include <fmt/core.h>

#include "../common/module_fixture.h"
#include "01_obj/obj.h"
#include "13_mlaa/mlaa.h"
#include "water_fixture.h"

using namespace lightwalk;

namespace {

struct OnMovingWater : OnWater {
    Taa taa{owner, "taa"};
    Moving moving;
    std::vector<uint64_t> vectors;
    static constexpr double dt_s = 1.0 / 20;

    OnMovingWater() {
        water.reflection.set("cube");
        water.roughness.value = 0;
        camera = {.position = {0, 3, 0}, .target = {0, 0, -9}, .fov_y_rad = 0.8f, .near_m = 0.1f, .far_m = 1e4f};
    }
    View view(int i, glm::vec2 shift = {0, 0}) const {
        Camera moved = camera;
        moved.position.x += 0.02f * float(i);
        return view_of(moved, size, {.whole = size, .shift = shift});
    }
    /// A frame; `then` is recorded behind the water.
    template <class Then>
    void frame_at(double time_s, const View& seen, const Then& then) {
        begin(size, float(time_s));
        look_from(seen, frame);
        light.record(frame, scene);
        Canvas canvas(frame.hdr, frame.depth, background);
        lightwalk::draw(frame, seen, canvas, {water});
        canvas.depth(frame);
        then();
        frame.end();
    }
    /// Two frames; false where the second one has no vectors.
    bool two_frames(double time_s) {
        bool moves = false;
        owner.forget_history();
        frame_at(time_s - dt_s, view(0), [] {});
        frame_at(time_s, view(1), [&] { moves = moving.record(frame, scene, view(1), view(0), frame.depth, {water}); });
        vectors = moves ? read<uint64_t>(moving.image()) : std::vector<uint64_t>();
        return moves;
    }
    glm::dvec2 place(const View& from, glm::dvec3 point) const {
        const glm::dvec4 clip = glm::dmat4(from.view_projection) * glm::dvec4(point, 1);
        return (0.5 * glm::dvec2(clip) / clip.w + 0.5) * glm::dvec2(size);
    }
    /// The largest distance of a vector, in pixels, from that of points which are `way(rest)` away a frame before.
    template <class Now, class Way>
    double worst_px(const Now& now, const Way& way) const {
        double worst = 0;
        int asked = 0;
        for (double x = -3; x <= 3; x += 0.5)
            for (double z = -12; z <= -5; z += 0.5) {
                const glm::dvec3 here = now(glm::dvec2(x, z));
                const glm::dvec2 at = place(view(1), here), before = place(view(0), here + way(glm::dvec2(x, z)));
                if (at.x < 1 || at.y < 1 || at.x > size.x - 1 || at.y > size.y - 1) continue;
                const glm::vec4 found = glm::unpackHalf4x16(vectors[size_t(at.y) * size.x + size_t(at.x)]);
                CHECK(found.a > 0.0f);
                worst = std::max(worst, glm::length(glm::dvec2(found) - (before - at)));
                ++asked;
            }
        CHECK(asked > 100);
        return worst;
    }
};

/// The motion by which a pattern of slopes changes least between two times: by its gradients, over many places.
template <class Slope>
glm::dvec2 least_change(const Slope& slope) {
    glm::dmat2 squares(0);
    glm::dvec2 turned(0);
    const double h = 1e-3;
    for (int i = 0; i < 20000; ++i) {
        const glm::dvec2 at(std::fmod(i * 7.54877666, 997.0), std::fmod(i * 5.69840291, 991.0));
        for (const int axis : {0, 1}) {
            const glm::dvec2 gradient(
                (slope(at + glm::dvec2(h, 0), 0.5)[axis] - slope(at - glm::dvec2(h, 0), 0.5)[axis]) / (2 * h),
                (slope(at + glm::dvec2(0, h), 0.5)[axis] - slope(at - glm::dvec2(0, h), 0.5)[axis]) / (2 * h));
            const double changed = slope(at, 0.5)[axis] - slope(at, -0.5)[axis];
            squares += glm::outerProduct(gradient, gradient);
            turned -= changed * gradient;
        }
    }
    return glm::inverse(squares) * turned;
}

}  // namespace

TEST_CASE_METHOD(OnMovingWater, "vectors of one wave follow its crests, at the speed of deep water",
                 "[15.water_motion]") {
    water.waves.value = 2;  // of one length and direction: their sum travels as it is
    water.longest_m.value = water.shortest_m.value = 6;
    water.spread_deg.value = 0;
    water.wind_deg.value = 30;
    water.slope.value = 0.1f;
    size = {384, 256};
    const double speed = std::sqrt(9.81 * 6 / (2 * M_PI)), angle = 30 * M_PI / 180;
    const glm::dvec3 way = -speed * dt_s * glm::dvec3(std::cos(angle), 0, std::sin(angle));
    for (const char* method : {"sines", "gerstner"})
        for (const double time_s : {0.4, 3.0}) {
            water.method.set(method);
            REQUIRE(two_frames(time_s));
            const auto now = [&](glm::dvec2 rest) {
                return glm::dvec3(rest.x, 0, rest.y) + moved_by(water.waves_at(time_s), rest);
            };
            const double worst = worst_px(now, [&](glm::dvec2) { return way; });
            INFO(method << " at " << time_s << " s: " << worst << " pixels");
            CHECK(worst < 0.1);
        }
}

TEST_CASE_METHOD(OnMovingWater, "vectors of several waves are the motion that leaves the least change of slope",
                 "[15.water_motion]") {
    water.method.set("sines");
    water.waves.value = 5;
    water.longest_m.value = 12;
    water.shortest_m.value = 4;
    water.spread_deg.value = 70;
    water.slope.value = 0.08f;
    size = {384, 256};
    const double time_s = 2;
    REQUIRE(two_frames(time_s));
    // Slopes are the derivatives of the height.
    const auto slope = [&](glm::dvec2 at, double frames) {
        glm::dvec2 sum(0);
        for (const WaveData& w : water.waves_at(time_s + (frames - 0.5) * dt_s))
            sum += glm::dvec2(w.k) * double(w.amplitude) * std::cos(glm::dot(glm::dvec2(w.k), at) - double(w.phase));
        return sum;
    };
    const glm::dvec2 moved = least_change(slope);
    const auto now = [&](glm::dvec2 rest) {
        return glm::dvec3(rest.x, 0, rest.y) + moved_by(water.waves_at(time_s), rest);
    };
    const double worst = worst_px(now, [&](glm::dvec2 rest) {
        const glm::dvec3 there = moved_by(water.waves_at(time_s - dt_s), rest - moved);
        return glm::dvec3(-moved.x, there.y - moved_by(water.waves_at(time_s), rest).y, -moved.y);
    });
    INFO(worst << " pixels");
    CHECK(glm::length(moved) > 0.02);
    CHECK(worst < 0.1);
}

TEST_CASE_METHOD(OnMovingWater, "a spectrum's slopes travel as those of its tiles are seen to", "[15.water_motion]") {
    water.method.set("fft");
    std::vector<uint64_t> slopes[2];
    for (const int i : {0, 1}) {
        frame_at(5 + i * 0.05, view(0), [] {});
        slopes[i] = read<uint64_t>(water.ocean.sloped().mip(0));
    }
    const int n = int(OCEAN_TEXELS);
    for (int part = 0; part < 2; ++part) {
        const double texel_m = double(Ocean::tile_m()[part]) / n;
        glm::dmat2 squares(0);
        glm::dvec2 turned(0);
        const auto at = [&](int i, int x, int y) {
            const size_t place = (size_t(part) * n + size_t((y + n) % n)) * n + size_t((x + n) % n);
            return glm::dvec2(glm::unpackHalf4x16(slopes[i][place]));
        };
        const auto mean = [&](int x, int y) { return 0.5 * (at(0, x, y) + at(1, x, y)); };
        const auto derivative = [&](int x, int y, int dx, int dy) {  // of fourth order
            return (8.0 * (mean(x + dx, y + dy) - mean(x - dx, y - dy)) - mean(x + 2 * dx, y + 2 * dy) +
                    mean(x - 2 * dx, y - 2 * dy)) /
                   (12 * texel_m);
        };
        for (int y = 0; y < n; ++y)
            for (int x = 0; x < n; ++x) {
                const glm::dvec2 by_x = derivative(x, y, 1, 0), by_z = derivative(x, y, 0, 1),
                                 changed = at(1, x, y) - at(0, x, y);
                for (const int axis : {0, 1}) {
                    const glm::dvec2 gradient(by_x[axis], by_z[axis]);
                    squares += glm::outerProduct(gradient, gradient);
                    turned -= changed[axis] * gradient;
                }
            }
        const glm::dvec2 seen = glm::inverse(squares) * turned;
        const OceanTravel travel = water.ocean.travel(part, 0.05);
        const glm::dmat2 m(travel.squares.x, travel.squares.y, travel.squares.y, travel.squares.z);
        const glm::dvec2 said = glm::inverse(m) * glm::dvec2(travel.turned);
        INFO("part " << part << ": seen " << seen.x << " " << seen.y << " m, said " << said.x << " " << said.y);
        CHECK(glm::length(seen) > 0.02);
        CHECK(glm::length(said - seen) < 0.08 * glm::length(seen));
    }
}

TEST_CASE_METHOD(OnMovingWater, "level water moves where rings are, and nowhere else", "[15.water_motion]") {
    water.method.set("flat");
    CHECK(!two_frames(1));
    CHECK(!water.animated());
    water.waterline.method.set("rings");  // nothing stands in it
    CHECK(!two_frames(1));
    CHECK(!water.animated());
    SceneObject post;
    post.name = "post";
    post.model = "models/cube.obj";
    post.position = {0, 0, -6};
    post.scale = glm::vec3(0.6f);
    const Sun sun = scene.sun();
    scene.load(gpu, {.objects = {post}}, [](const auto& file) { return load_model(file); });
    scene.set_sun(sun);
    owner.prepare_all(gpu, scene);
    water.waterline.length_m.value = 0.4f;
    size = {384, 256};
    camera.position = {0, 3, -1.6f};
    camera.target = {0, 0, -6};
    REQUIRE(two_frames(1));
    CHECK(water.animated());
    // Speeds of waves under gravity and surface tension (H. Lamb), of which the pattern's is a mean.
    const auto speed = [](double length_m) {
        const double k = 2 * M_PI / length_m;
        return std::sqrt(9.81 / k + 7.4e-5 * k);
    };
    const double slowest = speed(0.4 * 0.62 * 0.62), fastest = speed(0.4);
    // By how far the point at a distance before the post was nearer to it a frame before.
    const auto outwards = [&](double away_m) {
        const glm::dvec3 here(0.05, 0, -6 + 0.3 + away_m);
        const glm::dvec2 at = place(view(1), here), still = place(view(0), here) - at,
                         metre = (place(view(0), here - glm::dvec3(0, 0, 0.01)) - place(view(0), here)) * 100.0;
        const glm::vec4 found = glm::unpackHalf4x16(vectors[size_t(at.y) * size.x + size_t(at.x)]);
        CHECK(found.a > 0.0f);
        return glm::dot(glm::dvec2(found) - still, metre) / glm::dot(metre, metre);
    };
    for (const double away_m : {0.1, 0.2, 0.4}) {
        INFO(away_m << " m from the post: " << outwards(away_m) / dt_s << " m/s, of " << slowest << " to " << fastest);
        CHECK(outwards(away_m) > 0.98 * slowest * dt_s);
        CHECK(outwards(away_m) < 1.02 * fastest * dt_s);
    }
    CHECK(std::abs(outwards(1.7)) < 1e-3 * dt_s);
}

TEST_CASE_METHOD(OnMovingWater,
                 "temporal anti-aliasing that follows the waves is nearer to the truth, and flickers less",
                 "[figures][15.water_motion]") {
    water.method.set("gerstner");
    water.longest_m.value = 1.6f;
    water.shortest_m.value = 0.18f;
    water.slope.value = 0.02f;
    water.roughness.value = 0.012f;
    camera = {.position = {0, 1.5f, 0}, .target = {0, 0, -5}, .fov_y_rad = 0.7f, .near_m = 0.1f, .far_m = 1e4f};
    size = {192, 108};
    const auto lit = [&](int i, glm::vec2 shift, bool gathers) {
        const View seen = view(0, shift);
        frame_at(2 + i / 60.0, seen, [&] {
            if (gathers) taa.record(frame, frame.hdr, {seen, frame.depth, &scene, {water}});
        });
        return read_linear(gpu, frame.hdr);
    };
    const auto truth = [&](int i) {
        ImageRgb sum = lit(i, {0, 0}, false);
        for (glm::vec3& p : sum.pixels) p = glm::vec3(0);
        for (int s = 0; s < 16; ++s) {
            const ImageRgb one = lit(i, taa.accumulation().shift(s), false);
            for (size_t p = 0; p < sum.pixels.size(); ++p) sum.pixels[p] += one.pixels[p] / 16.0f;
        }
        return sum;
    };
    const int first = 10, count = 8;  // frames compared, once the history stands
    std::vector<ImageRgb> truths;
    for (int i = first - 1; i < first + count; ++i) truths.push_back(truth(i));
    const auto errors = [&](bool follows) {
        taa.motion.value = follows;
        owner.forget_history();
        glm::dvec2 sum(0);
        ImageRgb before;
        for (int i = 0; i < first + count; ++i) {
            ImageRgb found = lit(i, taa.accumulation().shift(i), true);
            if (i < first - 1) continue;
            const ImageRgb& right = truths[size_t(i - first + 1)];
            for (size_t p = 0; p < right.pixels.size(); ++p) found.pixels[p] -= right.pixels[p];
            for (size_t p = 0; i >= first && p < right.pixels.size(); ++p)
                sum += glm::dvec2(glm::length(found.pixels[p]), glm::length(found.pixels[p] - before.pixels[p]));
            before = std::move(found);
        }
        return sum / double(count * size.x * size.y);
    };
    const glm::dvec2 still = errors(false), followed = errors(true);
    fmt::print(
        "waves, error and its change from frame to frame: {:.4f} and {:.4f} with the camera's motion alone, {:.4f} and "
        "{:.4f} "
        "with the waves'\n",
        still.x, still.y, followed.x, followed.y);
    CHECK(followed.x < 0.7 * still.x);
    CHECK(followed.y < still.y);
}
