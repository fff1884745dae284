// Transparent layers by every method, on the device and in double precision; and where each method fails, by how much.
#include <fmt/core.h>

#include <cmath>

#include "common/check/probe.h"
#include "transparency_fixture.h"

using namespace lightwalk;
using truth::Layer;

namespace {

// Of colours as vectors, and of their single channels at most.
struct Errors {
    double mean = 0, most = 0;
    size_t count = 0;
    void add(const glm::dvec3& found, const glm::dvec3& right) {
        const glm::dvec3 off = glm::abs(found - right);
        mean += (glm::length(off) - mean) / double(++count);
        most = std::max({most, off.x, off.y, off.z});
    }
};

// `count` layers of random colours, evenly at random between two distances, in no order. The far plane is at infinity.
std::vector<Layer> layers(Random& random, int count, double least_m, double most_m, double least_alpha,
                          double most_alpha) {
    std::vector<Layer> all;
    for (int i = 0; i < count; ++i) {
        const double z = random.uniform(least_m, most_m);
        all.push_back({{random.uniform(0, 1), random.uniform(0, 1), random.uniform(0, 1)},
                       random.uniform(least_alpha, most_alpha),
                       z,
                       1 - 0.1 / z});
    }
    return all;
}

// By method: unsorted, the five weights, four and six moments over depths from 0.1 m to 200 m, and four layers.
std::vector<Errors> table(double least_m, double most_m, double least_alpha, double most_alpha) {
    Random random(15);
    std::vector<Errors> errors(9);
    for (int trial = 0; trial < 4000; ++trial) {
        const std::vector<Layer> all = layers(random, 8, least_m, most_m, least_alpha, most_alpha);
        const glm::dvec3 background(random.uniform(0, 1)), right = truth::in_order(all, background);
        errors[0].add(truth::over(all, background), right);
        for (int equation = 0; equation < 5; ++equation)
            errors[size_t(1 + equation)].add(truth::weighted(all, background, equation), right);
        errors[6].add(truth::by_moments(all, background, 0.1, 200), right);
        errors[7].add(truth::by_moments(all, background, 0.1, 200, true), right);
        errors[8].add(truth::by_four_layers(all, background), right);
    }
    const char* const names[] = {"unsorted", "mean", "eq 7", "eq 8", "eq 9", "eq 10", "moments", "six", "four layers"};
    fmt::print("8 layers, {}-{} m, alpha {}-{}:", least_m, most_m, least_alpha, most_alpha);
    for (size_t i = 0; i < 9; ++i) fmt::print(" {} {:.3f}/{:.2f}", names[i], errors[i].mean, errors[i].most);
    fmt::print("\n");
    return errors;
}

}  // namespace

TEST_CASE("eight layers of alpha 0.5 between 1 and 50 m: what each method is off by, in double precision",
          "[15.layers_in_disorder]") {
    const std::vector<Errors> e = table(1, 50, 0.5, 0.5);
    const double means[] = {0.292, 0.213, 0.117, 0.150, 0.094, 0.176, 0.056},
                 most[] = {0.72, 0.43, 0.39, 0.41, 0.32, 0.40, 0.18};
    for (size_t i = 0; i < 7; ++i) {
        CHECK(e[i].mean == Approx(means[i]).margin(0.01));
        CHECK(e[i].most == Approx(most[i]).margin(0.03));
    }
    for (size_t i = 0; i < 6; ++i) CHECK(e[6].mean < e[i].mean);
}

TEST_CASE("layers that lie close together, or are thin: a weight tells nothing, and no order does least harm",
          "[15.layers_in_disorder]") {
    // Within a metre all weights are alike: WBOIT is a plain mean.
    const std::vector<Errors> close = table(10, 11, 0.5, 0.5);
    for (size_t i = 1; i < 6; ++i) CHECK(close[i].mean == Approx(0.208).margin(0.01));
    const std::vector<Errors> thin = table(1, 50, 0.1, 0.3);
    CHECK(thin[0].mean == Approx(0.097).margin(0.01));
    CHECK(thin[2].mean == Approx(0.161).margin(0.02));
    const std::vector<Errors> dense = table(1, 50, 0.9, 0.9);
    CHECK(dense[2].mean == Approx(0.163).margin(0.02));
    CHECK(dense[7].mean == Approx(0.059).margin(0.01));
    CHECK(dense[7].most > 0.3);  // six moments, where one layer hides nearly all
}

TEST_CASE("four moments bound the transmittance before each layer from both sides", "[15.moment_bounds]") {
    Random random(15);  // the same layers as in the table
    const double fractions[] = {0, 0.25, 0.5, 1};
    Errors errors[4];
    for (int trial = 0; trial < 4000; ++trial) {
        std::vector<Layer> all = layers(random, 8, 1, 50, 0.5, 0.5);
        const glm::dvec3 background(random.uniform(0, 1)), right = truth::in_order(all, background);
        for (size_t i = 0; i < 4; ++i)
            errors[i].add(truth::by_moments(all, background, 0.1, 200, false, 5e-7, fractions[i]), right);
        // Depths at even steps of their own, without a bias: no distribution with these moments leaves the bounds.
        glm::dvec4 means(0);
        for (int k = 0; k < 4; ++k)
            for (const Layer& l : all) means[k] += std::pow(l.z_m / 25 - 1, k + 1) / 8;
        std::sort(all.begin(), all.end(), [](const Layer& a, const Layer& b) { return a.z_m < b.z_m; });
        for (size_t i = 0; i < all.size(); ++i) {
            const double z = all[i].z_m / 25 - 1, absorbance = 8 * std::log(2), passed = std::pow(0.5, double(i));
            CHECK(truth::moment_transmittance(means, absorbance, z, 0, 0) > passed * 0.999999);
            CHECK(truth::moment_transmittance(means, absorbance, z, 0, 1) < passed * 0.500001);  // the layer's own, too
        }
    }
    for (size_t i = 0; i < 4; ++i)
        fmt::print("fraction {}: {:.3f}, at most {:.2f}\n", fractions[i], errors[i].mean, errors[i].most);
    CHECK(errors[2].mean < errors[1].mean);
    CHECK(errors[1].mean < std::min(errors[0].mean, errors[3].mean));
}

TEST_CASE_METHOD(OnTransparency, "every method on the device is what its formula says in double precision",
                 "[15.formulas]") {
    Random random(3);
    constexpr int cells = 16;
    std::vector<std::vector<Layer>> by_cell;
    for (int cell = 0; cell < cells * cells; ++cell) by_cell.push_back(layers(random, 8, 1, 50, 0.3, 0.8));
    for (size_t layer = 0; layer < 8; ++layer)
        for (int cell = 0; cell < cells * cells; ++cell) {
            const Layer& l = by_cell[size_t(cell)][layer];
            const glm::vec2 from(2.0f * float(cell % cells) / cells - 1, 1 - 2.0f * float(cell / cells + 1) / cells);
            add(from, from + 2.0f / cells, float(l.z_m), glm::vec4(l.color, l.alpha));
        }
    const glm::vec3 background(0.4f, 0.5f, 0.6f);
    double farthest = 0;
    for (const Pane& quad : drawing.quads) farthest = std::max(farthest, double(glm::length(quad.middle())));
    transparency.sums.set("fp32");
    for (const char* method : every_transparency) {
        const std::string name = method;
        for (int equation = 0; equation < (name == "wboit" ? 5 : 1); ++equation) {
            transparency.weight.set(transparency.weight.options[size_t(equation)]);
            const ImageRgb seen = picture(name, background);
            Errors off;
            for (int cell = 0; cell < cells * cells; ++cell) {
                const std::vector<Layer>& all = by_cell[size_t(cell)];
                const glm::dvec3 right = name == "unsorted" ? truth::over(all, background)
                                         : name == "wboit"  ? truth::weighted(all, background, equation)
                                         : name.starts_with("moments")
                                             ? truth::by_moments(all, background, 0.1, 4 * farthest, name == "moments6")
                                             : truth::in_order(all, background);
                const size_t at = size_t((cell / cells * 4 + 2) * 64 + cell % cells * 4 + 2);
                off.add(seen.pixels[at], right);
            }
            INFO(name << " " << equation);
            fmt::print("{} {}: {:.5f}/{:.4f} off its formula\n", name, equation, off.mean, off.most);
            CHECK(off.mean < 0.002);
            CHECK(off.most < 0.004);
        }
    }
}

TEST_CASE_METHOD(OnTransparency, "sums of half floats overflow at a weight of 3000", "[15.half_sums]") {
    // At 0.2 m each layer of white and alpha 0.71 adds 0.71² times 3000; a half float ends at 65504.
    const double each = 0.71 * 0.71 * 3000;
    CHECK(43 * each < 65504);
    CHECK(44 * each > 65504);
    add(0.2f, {100, 100, 100, 0.71f});
    transparency.sums.set("fp32");
    CHECK(middle("wboit").g == Approx(71).epsilon(0.01));
    // Infinity, or where the device's blending ends at the largest number, that over the weight.
    transparency.sums.set("fp16");
    const float found = middle("wboit").g;
    fmt::print("a layer of 71 at a weight of 3000: {:.1f} from half floats\n", found);
    CHECK((!std::isfinite(found) || found < 0.71 * 65504 / each * 1.01));
    drawing.quads.clear();
    add(0.2f, {40, 40, 40, 0.71f});
    CHECK(middle("wboit").g == Approx(40 * 0.71).epsilon(0.01));
}

TEST_CASE_METHOD(OnTransparency, "8 bits of the background's share stick at 4/255 or 5/255 where half floats go on",
                 "[15.share_bits]") {
    for (int i = 0; i < 66; ++i) add(2.0f, {0, 0, 0, 0.1f});
    CHECK(std::pow(0.9, 66) == Approx(0.00096).margin(0.00002));
    transparency.revealage.set("r16f");
    CHECK(middle("wboit", glm::vec3(1)).g == Approx(0.00096).margin(0.0001));
    transparency.revealage.set("r8");
    const float stuck = middle("wboit", glm::vec3(1)).g;
    fmt::print("share of the background after 66 layers of alpha 0.1: {:.4f} with 8 bits, truth 0.00096\n", stuck);
    CHECK(stuck > 3.9 / 255);  // 3.6 is rounded to 4; 4.5 to 4 or to 5
    CHECK(stuck < 5.1 / 255);
}

TEST_CASE_METHOD(OnTransparency, "two layers at one depth are peeled as one; a list has both", "[15.equal_depth]") {
    add(2.0f, {1, 1, 1, 0.5f});
    add(2.0f, {1, 1, 1, 0.5f});
    CHECK(middle("lists").g == Approx(0.75).margin(0.001));
    CHECK(middle("sorted").g == Approx(0.75).margin(0.001));
    CHECK(middle("wboit").g == Approx(0.75).margin(0.001));
    CHECK(middle("peeling").g == Approx(0.5).margin(0.001));
}

TEST_CASE_METHOD(OnTransparency, "rectangles that cut each other: no order of objects is right", "[15.cutting]") {
    const auto wrong_share = [&](double least, double most) {
        Random random(20);
        size_t wrong = 0, layered = 0;
        size = {96, 96};
        camera.position = {5, 5, 20};
        camera.target = {5, 5, 5};
        camera.fov_y_rad = 0.8f;
        for (int pile = 0; pile < 4; ++pile) {
            drawing.quads.clear();
            for (int i = 0; i < 20; ++i) {
                const auto unit = [&] {
                    const glm::vec3 v(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1));
                    return glm::normalize(v + glm::vec3(1e-3f));
                };
                const glm::vec3 u = unit(), v = glm::normalize(glm::cross(u, unit()));
                const glm::vec3 middle(random.uniform(0, 10), random.uniform(0, 10), random.uniform(0, 10));
                const glm::vec3 a = 0.5f * float(random.uniform(least, most)) * u,
                                b = 0.5f * float(random.uniform(least, most)) * v;
                drawing.quads.push_back({{middle - a - b, middle + a - b, middle + a + b, middle - a + b},
                                         {random.uniform(0, 1), random.uniform(0, 1), random.uniform(0, 1), 0.5f}});
            }
            const ImageRgb sorted = picture("sorted"), right = picture("lists");
            for (Pane& pane : drawing.quads) pane.color = {1, 1, 1, 0.5f};
            const ImageRgb count = picture("unsorted");  // 1 - 2^-n of n layers
            for (size_t i = 0; i < right.pixels.size(); ++i) {
                const glm::vec3 off = glm::abs(sorted.pixels[i] - right.pixels[i]);
                layered += count.pixels[i].g > 0.6f;
                wrong += std::max({off.x, off.y, off.z}) > 0.01f;
            }
        }
        return double(wrong) / double(layered);
    };
    const double small = wrong_share(1, 4), large = wrong_share(4, 10);
    fmt::print("sorted by their middles, wrong at {:.0f}% of pixels with several layers (sides 1-4), {:.0f}% (4-10)\n",
               100 * small, 100 * large);
    CHECK(small > 0.005);
    CHECK(large > 0.2);
}

TEST_CASE_METHOD(OnTransparency, "any number of panes is mixed in order, however little room the lists begin with",
                 "[15.full_lists]") {
    std::vector<Layer> all;
    for (int i = 0; i < 70; ++i) {
        const glm::dvec3 color(i % 2, 0.5, i / 70.0);
        all.push_back({color, 0.1, 2.0 + i, 1 - 0.1 / (2.0 + i)});
        add(2.0f + float(i), glm::vec4(color, 0.1f));
        if (i != 19 && i != 69) continue;
        transparency.list_fragments.value = i == 19 ? 8 : 1;
        const glm::dvec3 right = truth::in_order(all, glm::dvec3(1));
        Errors off;
        for (const glm::vec3& pixel : picture("lists", glm::vec3(1)).pixels) off.add(pixel, right);
        CHECK(off.most < 0.003);
    }
}

TEST_CASE_METHOD(OnTransparency, "peeling has as many layers as it is told to", "[15.peels]") {
    for (int i = 0; i < 12; ++i) add(2.0f + float(i), {0.5f, 0.5f, 0.5f, 0.3f});
    CHECK(middle("peeling").g == Approx(0.5 * (1 - std::pow(0.7, 12))).margin(0.002));
    transparency.peels.value = 4;  // the nearest four alone
    CHECK(middle("peeling").g == Approx(0.5 * (1 - std::pow(0.7, 4))).margin(0.002));
}

TEST_CASE_METHOD(OnTransparency, "nothing transparent leaves the picture alone, and alpha 1 hides what is behind") {
    for (const char* method : every_transparency) {
        INFO(method);
        drawing.quads.clear();
        CHECK(middle(method, {0.25f, 0.5f, 0.75f}) == glm::vec3(0.25f, 0.5f, 0.75f));
        add(3.0f, {0, 1, 0, 1});
        CHECK(middle(method, {1, 0, 0}).g == Approx(1).margin(0.002));
        CHECK(middle(method, {1, 0, 0}).r == Approx(0).margin(0.002));
    }
}

TEST_CASE_METHOD(OnTransparency, "what lies behind something opaque is not seen; what lies before it is") {
    add(2.0f, {0, 1, 0, 0.5f});
    add(5.0f, {0, 0, 1, 0.5f});
    add(3.0f, {1, 0, 0, 1});
    drawing.solid = 1;
    for (const char* method : every_transparency) {
        INFO(method);
        const glm::vec3 seen = middle(method, glm::vec3(1));
        CHECK(seen.r == Approx(0.5).margin(0.002));
        CHECK(seen.g == Approx(0.5).margin(0.002));
        CHECK(seen.b == Approx(0).margin(0.002));
    }
}

namespace {

// Glass without a body: alpha 0, and the shares of light that pass.
const glm::vec3 red(0.9f, 0.12f, 0.06f), green(0.15f, 0.8f, 0.2f);

}  // namespace

TEST_CASE_METHOD(OnTransparency, "colours multiply through glass: a red pane and a green one over white", "[15.tint]") {
    add(2.0f, glm::vec4(0), red);
    add(4.0f, glm::vec4(0), green);
    const float mean = (red.r + red.g + red.b) / 3 * (green.r + green.g + green.b) / 3;
    for (const char* method : every_transparency) {
        INFO(method);
        transparency.tint.set("rgb");
        const glm::vec3 seen = middle(method, glm::vec3(1)), expected = red * green;
        for (int i = 0; i < 3; ++i) CHECK(seen[i] == Approx(expected[i]).margin(0.001));
        transparency.tint.set("grey");
        const glm::vec3 grey = middle(method, glm::vec3(1));
        for (int i = 0; i < 3; ++i) CHECK(grey[i] == Approx(mean).margin(0.001));
    }
}

TEST_CASE_METHOD(OnTransparency, "lists and peeling have the product of any shares, dark ones and eight layers of them",
                 "[15.tint_order]") {
    Random random(66);
    std::vector<Layer> all;
    for (int i = 0; i < 8; ++i) {
        Layer layer = layers(random, 1, 1, 50, 0, 0.5)[0];
        layer.tint = {random.logarithmic(0.05, 1), random.uniform(0, 1), 1};
        all.push_back(layer);
        add(float(layer.z_m), glm::vec4(layer.color, layer.alpha), layer.tint);
        const glm::dvec3 right = truth::in_order(all, glm::dvec3(1));
        for (const char* method : {"sorted", "sorted_triangles", "lists", "peeling"}) {
            INFO(method << " " << i);
            CHECK(glm::length(glm::dvec3(middle(method, glm::vec3(1))) - right) < 0.002);
        }
    }
}

TEST_CASE_METHOD(OnTransparency, "weighted sums and moments filter the background, and not what lies between",
                 "[15.tint_between]") {
    add(2.0f, glm::vec4(0), red);
    add(4.0f, {1, 1, 1, 0.5f});
    const glm::vec3 right = red, unfiltered = 0.5f * red + 0.5f;  // of white behind, and of a white body between
    for (const char* method : every_transparency) {
        INFO(method);
        const std::string name = method;
        const bool sums = name == "wboit" || name.starts_with("moments");
        const glm::vec3 expected = sums ? unfiltered : name == "unsorted" ? 0.5f * red + 0.5f : right;
        const glm::vec3 seen = middle(method, glm::vec3(1));
        for (int i = 0; i < 3; ++i) CHECK(seen[i] == Approx(expected[i]).margin(0.002));
    }
}
