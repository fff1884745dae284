// Depth of field: exact cases, and the error of the method first taught.
#include <fmt/core.h>

#include "01_obj/camera_view.h"
#include "09_post_effects/depth_of_field.h"
#include "post_fixture.h"

using namespace lightwalk;

namespace {

struct Card {
    glm::vec4 rectangle;  // of the picture, 0 to 1: left, top, right, bottom
    glm::vec3 light;
    double distance_m;
};

struct OnLens : OnModules {
    DepthOfField dof{owner, "dof"};
    Pipeline quad = quad_pipeline();
    Camera camera{.position = {0, 0, 0}, .target = {0, 0, -1}, .fov_y_rad = 0.7f, .near_m = 0.1f, .far_m = 100};
    glm::uvec2 size{160, 90};

    OnLens() {
        dof.focus_m.value = 2;
        dof.f_number.value = 0.2f;
        dof.most.value = 0.3f;
    }

    double depth_at(double z) const {
        const double near = double(camera.near_m), far = double(camera.far_m);
        return std::isinf(far) ? near / z : near * (far - z) / (z * (far - near));
    }

    struct CardsDrawing : Drawing {
        CardsDrawing(OnLens& l, const std::vector<Card>& c) : Drawing(l.owner, "cards"), lens(l), cards(c) {}
        void draw(Frame& one, const View&, Canvas& canvas) override {
            one.raster("cards", {.color = {canvas.color_target()}, .depth = canvas.depth_target()}, [&](Raster& pass) {
                for (const Card& card : cards) {
                    const glm::vec4 place = 2.0f * card.rectangle - 1.0f;
                    const float depth = std::isinf(card.distance_m) ? 0.0f : float(lens.depth_at(card.distance_m));
                    const glm::vec4 light(card.light, 1.0f);
                    pass.use(lens.quad)
                        .set("quad", Quad{place, depth, depth})
                        .set("paint", Paint{light, light})
                        .draw(6);
                }
            });
        }
        OnLens& lens;
        const std::vector<Card>& cards;
    };

    /// The picture of cards, the last in front.
    ImageRgb picture(const std::string& method, const std::vector<Card>& cards) {
        dof.method.set(method);
        frame.begin(size, 0);
        CardsDrawing drawn(*this, cards);
        Canvas canvas(frame.hdr, frame.depth, glm::vec4(0));
        dof.record(frame, view_of(camera, size), canvas, {drawn});
        frame.end();
        return read_linear(gpu, frame.hdr);
    }

    double disc_px(double z) const {
        return truth::circle_of_confusion(z, double(dof.focus_m.value), double(dof.focal_m(camera)),
                                          double(dof.f_number.value), 0.001 * double(dof.sensor_mm.value), size.y,
                                          double(dof.most.value) * size.y);
    }
};

const glm::vec4 everywhere{0, 0, 1, 1}, left_half{0, 0, 0.5f, 1};
const glm::vec3 white(1), black(0);

}  // namespace

TEST_CASE_METHOD(OnLens, "what is in focus stays as it is, to the last bit") {
    const std::vector<Card> cards{{everywhere, {0.25f, 0.5f, 1}, 2}, {{0.3f, 0.3f, 0.31f, 0.31f}, {20, 20, 20}, 2}};
    const ImageRgb sharp = picture("off", cards);
    CHECK(identical(picture("gather", cards), sharp));
}

TEST_CASE_METHOD(OnLens, "even light stays even at any distance: near, far, infinitely far, without a surface") {
    for (const std::string method : {"gather", "gaussian"})
        for (const double z : {0.12, 0.5, 1.9, 2.1, 5.0, 99.0, double(INFINITY)})
            for (const float far : {100.0f, INFINITY}) {
                camera.far_m = far;
                const ImageRgb found = picture(method, {{everywhere, white, z}});
                INFO(method << " at " << z << " m");
                CHECK(is_finite(found));
                for (const glm::vec3& c : found.pixels) CHECK(double(c.g) == Approx(1).epsilon(0.02));
            }
}

TEST_CASE_METHOD(OnLens, "a focus at the focal length and nearer: as wide as allowed, and finite") {
    const std::vector<Card> cards{{everywhere, {0.2f, 0.2f, 0.2f}, 20}, {left_half, white, 1}};
    for (const float focus : {dof.focal_m(camera), 0.5f * dof.focal_m(camera), 0.01f})
        for (const std::string method : {"gather", "gaussian"}) {
            dof.focus_m.value = focus;
            const ImageRgb found = picture(method, cards);
            CHECK(is_finite(found));
            CHECK(mean(found).g == Approx(0.6).epsilon(0.1));
        }
}

TEST_CASE_METHOD(
    OnLens, "a near edge bleeds over what is in focus, as far as its disc; a blur by the pixel's own depth is cut off",
    "[figures]") {
    const std::vector<Card> cards{{everywhere, black, 2}, {left_half, white, 0.6}};
    const double half_disc = -disc_px(0.6) / 2;
    CHECK(half_disc > 8);
    const auto light_at = [&](const ImageRgb& found, double from_edge) {
        return double(found.at(80 + static_cast<int>(from_edge), 45).g);
    };
    const ImageRgb gathered = picture("gather", cards), blurred = picture("gaussian", cards);
    fmt::print(
        "a near edge with a disc of {:.1f} pixels: light 2 pixels and half a radius outside: gather {:.3f} {:.3f}, "
        "gaussian "
        "{:.3f} {:.3f}\n",
        2 * half_disc, light_at(gathered, 2), light_at(gathered, half_disc / 2), light_at(blurred, 2),
        light_at(blurred, half_disc / 2));
    // The share of a disc behind a straight edge: at the edge a half, half a radius outside 0.196.
    CHECK(light_at(gathered, half_disc / 2) == Approx(0.196).margin(0.07));
    CHECK(light_at(gathered, half_disc + 4) < 0.02);
    CHECK(light_at(blurred, 2) == 0);  // areas in focus take nothing from the blurred picture
}

TEST_CASE_METHOD(OnLens, "what is in focus gives no light to what is behind it; a blur of the whole picture does",
                 "[figures][09.focus_leaks]") {
    const std::vector<Card> cards{{everywhere, black, 50}, {left_half, white, 2}};
    const ImageRgb gathered = picture("gather", cards), blurred = picture("gaussian", cards);
    double leaks = 0, halo = 0;
    for (int x = 83; x < 160; ++x) {
        leaks = std::max(leaks, double(gathered.at(x, 45).g));
        halo = std::max(halo, double(blurred.at(x, 45).g));
    }
    fmt::print("light on the black wall behind something white in focus: gather {:.3f}, gaussian {:.3f}\n", leaks,
               halo);
    CHECK(leaks < 0.02);
    CHECK(halo > 0.05);
    CHECK(gathered.at(78, 45).g == 1.0f);
}

TEST_CASE_METHOD(OnLens, "a far point of light becomes a disc of the formula's width, and keeps its light",
                 "[figures]") {
    size = {240, 240};
    dof.taps.value = 256;
    const std::vector<Card> cards{{everywhere, black, 50}, {{0.495f, 0.495f, 0.505f, 0.505f}, {100, 100, 100}, 50}};
    const ImageRgb sharp = picture("off", cards), found = picture("gather", cards);
    double light = 0, square = 0;
    for (int y = 0; y < 240; ++y)
        for (int x = 0; x < 240; ++x) {
            const double w = double(found.at(x, y).g);
            light += w;
            square += w * (std::pow(x - 119.5, 2) + std::pow(y - 119.5, 2));
        }
    const double disc = std::sqrt(8 * square / light);  // the mean square distance in a disc of diameter d is d² / 8
    const double wanted = disc_px(50);
    fmt::print("a point 50 m away: a disc of {:.2f} pixels, by the formula {:.2f}; {:.3f} of its light is there\n",
               disc, wanted, light / (mean(sharp).g * 240 * 240));
    CHECK(wanted > 15);
    CHECK(disc == Approx(wanted).epsilon(0.12));
    CHECK(light / (mean(sharp).g * 240 * 240) == Approx(1).epsilon(0.12));
}

TEST_CASE_METHOD(OnLens, "the lens that is sampled is the formula's: discs of the two agree") {
    for (const float focus : {0.5f, 2.0f, 10.0f})
        for (const double z : {0.3, 1.0, 5.0, 1e6}) {
            dof.focus_m.value = focus;
            const double f = double(focus), slope = 1 / std::tan(0.35);  // half the field of view
            const double seen = 2 * double(dof.radius_m(camera)) * (1 / f - 1 / z) * slope * size.y / 2;
            const double most = double(dof.most.value) * size.y;
            CHECK(std::clamp(seen, -most, most) == Approx(disc_px(z)).epsilon(1e-3));
        }
}
