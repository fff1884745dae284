// Checks of chapter 07's functions: values against double precision, then properties.
#include "07_mipmaps/exercises.h"
#include "07_mipmaps/truth.h"
#include "common/check/check.h"

using namespace lightwalk;

namespace {

template <class Vector>
Row row_of(const Vector& v) {
    Row row;
    append(row, v);
    return row;
}

glm::dvec4 four(std::span<const double> in) { return {in[0], in[1], in[2], in[3]}; }

Macros content_macros() {
    struct Owner : Module {
    } owner;
    return MipChain(owner, "mips").macros();
}

std::string size_text(glm::uvec2 size) { return fmt::format("{}x{}", size.x, size.y); }

}  // namespace

CHECK_EXERCISE("07.level_sizes", "Halve both sides, rounded down but never below 1, until both are 1.") {
    std::vector<glm::uvec2> all{{4, 4},      {1, 1},       {1, 7},       {1023, 1}, {3, 5},
                                {1366, 683}, {1080, 1920}, {4096, 4096}, {4097, 2}, {16384, 1}};
    Random random(2);
    for (int i = 0; i < 8; ++i) all.emplace_back(random.logarithmic(1, 9000), random.logarithmic(1, 9000));
    for (const glm::uvec2 size : all) {
        const std::string what = "level_sizes(" + size_text(size) + ")";
        check.call(what, [&]() -> std::string {
            const std::vector<glm::uvec2> sizes = level_sizes(size);
            if (sizes.empty() || sizes[0] != size)
                return what + ": the first level is the image itself, " + size_text(size);
            for (size_t i = 1; i < sizes.size(); ++i) {
                const glm::uvec2 right = glm::max(sizes[i - 1] / 2u, glm::uvec2(1));
                if (sizes[i - 1] == glm::uvec2(1)) return what + ": nothing comes after 1x1";
                if (sizes[i] != right)
                    return what + ": after " + size_text(sizes[i - 1]) + " came " + size_text(sizes[i]) +
                           ", expected " + size_text(right);
            }
            return sizes.back() == glm::uvec2(1)
                       ? ""
                       : what + ": the last level is " + size_text(sizes.back()) + ", and levels go on until 1x1";
        });
    }
}

CHECK_EXERCISE("07.box_2x2", "The texel `at` covers 2 at and the next texel in each direction, unless there is none.") {
    for (const glm::ivec2 size : {glm::ivec2{8, 6}, {2, 2}, {7, 5}, {1, 6}, {6, 1}, {1, 1}, {3, 1}}) {
        Macros macros = content_macros();
        macros.set("FIELD_WIDTH", std::to_string(size.x));
        macros.set("FIELD_HEIGHT", std::to_string(size.y));
        Probe probe{.include = "07_mipmaps/box_2x2.glsl",
                    .before = "#include \"../tests/07_mipmaps/known_source.glsl\"\n",
                    .signature = "vec4 box_2x2(ivec2 at)",
                    .truth =
                        [size](std::span<const double> in) {
                            glm::dvec4 sum(0);
                            for (int i = 0; i < 4; ++i) {
                                const double x = std::min(2 * in[0] + (i & 1), size.x - 1.0);
                                const double y = std::min(2 * in[1] + (i >> 1), size.y - 1.0);
                                sum += 0.25 * glm::dvec4(x, y, x * x, x * y);
                            }
                            return row_of(sum);
                        },
                    .bound = {.absolute = 1e-4},
                    .macros = macros};
        probe.words = [size](const std::string& name, std::span<const double> v) {
            return name == "at"
                       ? fmt::format(
                             "({}, {}) of a level above of {}x{} texels, where texel((x, y)) = (x, y, x x, x y)", v[0],
                             v[1], size.x, size.y)
                       : std::string();
        };
        probe.hint = [size](auto, auto got) -> std::string {
            if (std::fabs(got[0]) > 1e6)
                return "A texel outside of the level above was read: p must be from (0, 0) to source_size() - 1.";
            return size.x == 1 || size.y == 1
                       ? "A side of one texel has no second texel: take the mean of those that exist."
                       : "";
        };
        const glm::ivec2 smaller = glm::max(size / 2, glm::ivec2(1));
        for (int y = 0; y < smaller.y; ++y)
            for (int x = 0; x < smaller.x; ++x) probe.inputs.push_back({double(x), double(y)});
        check.probe(probe);
    }
}

CHECK_EXERCISE("07.to_linear", "Codes are not light, vectors or variances: decode them before averaging.") {
    Probe srgb{
        .include = "07_mipmaps/to_linear.glsl",
        .signature = "vec3 srgb_to_linear(vec3 code)",
        .truth =
            [](std::span<const double> in) {
                return Row{truth::srgb_to_linear(in[0]), truth::srgb_to_linear(in[1]), truth::srgb_to_linear(in[2])};
            },
        .bound = {.absolute = 1e-8, .relative = 5e-5},
        .hint = [](auto in, auto) -> std::string {
            const bool near = in[0] > 0.039 && in[2] < 0.042;
            return near ? "The two formulas meet at 0.04045: use the linear one up to there." : "";
        }};
    for (int c = 0; c < 256; c += 3)
        srgb.inputs.push_back({c / 255.0, std::min(c + 1, 255) / 255.0, std::min(c + 2, 255) / 255.0});
    // Beside the threshold the two formulas differ by 9e-5 to 2.5e-4 of the value (IEC 61966-2-1).
    srgb.inputs.push_back({0.0394, 0.04, 0.0402});
    srgb.inputs.push_back({0.0408, 0.0409, 0.041});
    check.probe(srgb);

    Probe normal{.include = srgb.include,
                 .signature = "vec3 normal_to_linear(vec4 code)",
                 .inputs = {{0.5, 0.5, 1, 0},
                            {1, 0.5, 0.5, 0},
                            {0.5, 0.5, 0.5, 0},
                            {0.5, 0.5, 1, 1},
                            {0.5, 0.5, 1, 0.5},
                            {0.53, 0.5, 0.5, 0}},
                 .truth = [](std::span<const double> in) { return row_of(truth::normal_to_linear(four(in))); },
                 .bound = {.absolute = 1e-5},
                 .hint = [](auto in, auto) -> std::string {
                     if (in[0] == 0.5 && in[1] == 0.5 && in[2] == 0.5)
                         return "This code has no direction: use (0, 0, 1), times the length.";
                     return in[3] > 0 ? "The mean is shorter than 1 here: its length is 1 - a a."
                                      : "Normalise the direction.";
                 }};
    Random random;
    for (int i = 0; i < 500; ++i) {
        const glm::vec3 n = 0.5f + 0.45f * random.direction();
        normal.inputs.push_back({double(n.x), double(n.y), double(n.z), i % 2 ? 0.0 : random.uniform(0, 1)});
    }
    const Table normals = check.probe(normal);
    check.property(normal, normals, "which is longer than 1",
                   [](auto, auto out) { return glm::length(vector3(out)) < 1 + 1e-5; });

    Probe rough{.include = srgb.include,
                .signature = "float roughness_to_linear(float r)",
                .truth = [](std::span<const double> in) { return Row{std::pow(in[0], 4)}; },
                .bound = {.absolute = 1e-6, .relative = 1e-5}};
    for (int c = 0; c <= 255; c += 5) rough.inputs.push_back({c / 255.0});
    check.probe(rough);
}

CHECK_EXERCISE("07.from_linear", "Invert to_linear, for every mean that a filter can produce.") {
    Probe srgb{
        .include = "07_mipmaps/from_linear.glsl",
        .signature = "vec3 linear_to_srgb(vec3 linear)",
        .inputs = {{-0.1, 1.3, 0.5}, {0, 1, 0.002}, {0.0031308, 0.0031309, 0.18}},
        .truth =
            [](std::span<const double> in) {
                return Row{truth::linear_to_srgb(in[0]), truth::linear_to_srgb(in[1]), truth::linear_to_srgb(in[2])};
            },
        .bound = {.absolute = 1e-4},
        .hint = [](auto in, auto) -> std::string {
            return in[0] < 0 || in[1] > 1 ? "Clamp to 0 to 1 first: some of Kaiser's weights are negative." : "";
        }};
    Random random;
    for (int i = 0; i < 500; ++i)
        srgb.inputs.push_back({random.uniform(0, 1), random.uniform(0, 0.01), random.uniform(-0.2, 1.2)});
    check.probe(srgb);

    Probe normal{.include = srgb.include,
                 .signature = "vec4 normal_from_linear(vec3 mean)",
                 .inputs = {{0, 0, 1},
                            {0, 0, 0},
                            {0, 0, 0.5},
                            {0, 0, 1.1},
                            {0.6, 0, 0.8},
                            {-0.3, 0.2, 0.1},
                            {1e-6, 0, 0},
                            {5e-5, 0, 0},
                            {2e-4, 0, 0},
                            {0, -6e-4, 3e-4}},
                 .truth = [](std::span<const double> in) { return row_of(truth::normal_from_linear(vector3(in))); },
                 .bound = {.absolute = 1e-3},  // a root near 0
                 .hint = [](auto in, auto) -> std::string {
                     const double length = glm::length(vector3(in));
                     if (length < 1e-4) return "Normals that cancel have no direction: use (0, 0, 1), and 1 in alpha.";
                     return length > 1 ? "For a mean longer than 1 alpha is 0: avoid the root of a negative number."
                                       : "";
                 }};
    for (int i = 0; i < 500; ++i)
        normal.inputs.push_back(row_of(glm::vec3(random.direction()) * float(random.uniform(0.01, 1))));
    check.probe(normal);

    Probe rough{.include = srgb.include,
                .signature = "float roughness_from_linear(float mean)",
                .inputs = {{0}, {1}, {-0.01}, {0.0625}, {1e-6}},
                .truth = [](std::span<const double> in) { return Row{std::pow(std::max(in[0], 0.0), 0.25)}; },
                .bound = {.absolute = 1e-4}};
    for (int c = 0; c <= 255; c += 5) rough.inputs.push_back({c / 255.0});
    check.probe(rough);
}

CHECK_EXERCISE("07.odd_size_weights",
               "New texel i extends from i size / m to (i + 1) size / m; compute its overlap with each old texel.") {
    Probe probe{.include = "07_mipmaps/odd_size_weights.glsl",
                .signature = "vec3 odd_size_weights(int i, int size)",
                .truth =
                    [](std::span<const double> in) {
                        const auto i = static_cast<uint32_t>(in[0]), size = static_cast<uint32_t>(in[1]);
                        const truth::Span span = truth::span(i, size, std::max(size / 2, 1u));
                        Row row{0, 0, 0};
                        for (size_t k = 0; k < span.shares.size(); ++k) row[span.first - 2 * i + k] = span.shares[k];
                        return row;
                    },
                .bound = {.absolute = 3e-4},  // i size / m in single precision
                .hint = [](auto in, auto got) -> std::string {
                    if (in[1] == 1) return "There is only one texel: it has all the weight.";
                    if (std::fabs(got[0] + got[1] + got[2] - 1) > 1e-5) return "The three weights must add up to 1.";
                    return int(in[1]) % 2 == 0 ? "For an even size the weights are 1/2, 1/2 and 0." : "";
                }};
    std::vector<int> sizes{1, 2, 3, 5, 7, 8, 255, 683, 1023, 1366, 4097};
    Random random(3);
    for (int i = 0; i < 8; ++i) sizes.push_back(static_cast<int>(random.logarithmic(9, 4096)));
    for (const int size : sizes)
        for (int i = 0; i < std::max(size / 2, 1); i += std::max(size / 40, 1))
            probe.inputs.push_back({double(i), double(size)});
    const Table results = check.probe(probe);
    check.property(probe, results, "which weighs a texel that is not there",
                   [](auto in, auto out) { return 2 * in[0] + 2 < in[1] || out[2] == 0; });
}

CHECK_EXERCISE("07.keep_coverage",
               "Count from the greatest alpha down until the wanted number is reached; that alpha must land just above "
               "the cutoff.") {
    const auto texels_with = [](int field, int code) -> int {
        switch (field) {
            case 0:
                return 4;
            case 1:
                return code == 60 ? 1000 : 0;
            case 2:
                return code < 128 ? 128 - code : 0;
            case 3:
                return code == 0 ? 90 : code == 255 ? 10 : 0;
            case 4:
                return code == 0 ? 64 : 0;
            default:
                return code * 37 % 11;
        }
    };
    constexpr const char* levels[] = {"four texels of each alpha",
                                      "a thousand texels of alpha 60 / 255",
                                      "128 - code texels of each alpha",
                                      "90 texels of alpha 0 and 10 of alpha 1",
                                      "64 texels of alpha 0",
                                      "mixed alphas"};
    for (int field = 0; field < 6; ++field) {
        int all = 0;
        for (int code = 0; code < 256; ++code) all += texels_with(field, code);
        Probe probe{.include = "07_mipmaps/keep_coverage.glsl",
                    .before = "#include \"../tests/07_mipmaps/known_alpha.glsl\"\n",
                    .signature = "float keep_coverage(float wanted, float cutoff)",
                    .truth = [](std::span<const double>) { return Row{1}; },
                    .bound = {.absolute = 1e9},  // many are right: the property says which
                    .macros = {{"FIELD", std::to_string(field)}}};
        for (const double share : {0.0, 0.05, 0.1, 0.3, 0.5, 0.9, 1.0})
            for (const double cutoff : {0.5, 0.25, 0.9, 1.0})
                probe.inputs.push_back({std::floor(share * all), static_cast<double>(static_cast<float>(cutoff))});
        const Table results = check.probe(probe);
        const auto reach = [&](double lowest) {
            int count = 0;
            for (int code = 1; code < 256; ++code) count += code >= lowest ? texels_with(field, code) : 0;
            return count;
        };
        const auto nearest = [&](double wanted) {
            double best = wanted;  // none
            for (int code = 1; code < 256; ++code) best = std::min(best, std::fabs(reach(code) - wanted));
            return best;
        };
        check.property(probe, results,
                       "but then not as many texels stay as can be where the level has " + std::string(levels[field]),
                       [&](auto in, auto out) {
                           return out[0] > 0 && std::fabs(reach(255 * in[1] / out[0]) - in[0]) <= nearest(in[0]);
                       });
        check.property(probe, results, "which leaves texels on the edge: after rounding they fall to either side",
                       [&](auto in, auto out) {
                           const double edge = 255 * in[1] / out[0];
                           for (int code = 1; code < 256; ++code)
                               if (texels_with(field, code) > 0 && std::fabs(code - edge) < 0.2) return false;
                           return true;
                       });
    }
}
