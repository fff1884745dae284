// The probes themselves.
#include "catch.h"
#include "common/check/check.h"
#include "common/check/undefined.h"

using namespace lightwalk;

namespace {

Probe probe_of(const std::string& include, const std::string& signature, Table inputs) {
    return {.include = include, .signature = signature, .inputs = std::move(inputs)};
}

}  // namespace

TEST_CASE("a probe runs a GLSL function over a table") {
    Probe probe = probe_of("common/srgb.glsl", "vec3 encode_srgb(vec3 linear)", {{0, 1, 0.5}, {0.0031308, -1, 2}});
    const Table results = run_probe(check_device(), probe, 3);
    CHECK(results[0][0] == 0);
    CHECK(results[0][1] == Approx(1));
    CHECK(results[0][2] == Approx(0.735357).margin(1e-5));
    CHECK(results[1][1] == 0);
    CHECK(results[1][2] == Approx(1));
}

TEST_CASE("a NaN is found whatever the bound, and named with its input") {
    Probe probe = probe_of("common/srgb.glsl", "vec3 encode_srgb(vec3 linear)", {{0, 0, 0}, {1, 2, 3}});
    probe.bound = {.absolute = 1e9};
    probe.truth = [](std::span<const double>) { return Row{0, 0, 0}; };
    CHECK(worst_of(probe, {{0, 0, 0}, {0, 0, 0}}).empty());
    CHECK(worst_of(probe, {{0, 0, 0}, {0, std::nan(""), 0}}) ==
          "encode_srgb(linear = (1, 2, 3)) gave (0, NaN, 0), expected (0, 0, 0)");
}

TEST_CASE("the worst input is the one furthest outside its bound") {
    Probe probe = probe_of("x.glsl", "float f(float a)", {{1}, {2}, {3}});
    probe.truth = [](std::span<const double> in) { return Row{in[0]}; };
    probe.bound = {.absolute = 0.01};
    CHECK(worst_of(probe, {{1.02}, {2.5}, {3.0}}) == "f(a = 2) gave 2.5, expected 2");
    CHECK(worst_of(probe, {{1.009}, {2}, {3}}).empty());
}

TEST_CASE("a number is told with as many digits as tell it from the expected one", "[common.digits]") {
    CHECK(gave_text(0.1, 0.25) == "gave 0.1, expected 0.25");
    CHECK(gave_text(16777217, 16777216) == "gave 16777217, expected 16777216");
    CHECK(gave_text(1 + 1e-9, 1) == "gave 1.000000001, expected 1");
    const double got[] = {0.5, 1.0 / 3}, expected[] = {0.5, 1.0 / 3 + 1e-12};
    CHECK(gave_text(got, expected) == "gave (0.5, 0.333333333333), expected (0.5, 0.333333333334)");
    CHECK(gave_text(std::nan(""), 2) == "gave NaN, expected 2");
}

TEST_CASE("a bound in units of the last place follows the truth's size") {
    const Bound bound{.ulps = 1};
    CHECK(bound.allowed(1.0) == Approx(1.1920929e-7));
    CHECK(bound.allowed(1024.0) == Approx(1.2207e-4).epsilon(1e-3));
}

TEST_CASE("a row that does not fit the signature is refused") {
    CHECK_THROWS(run_probe(check_device(), probe_of("common/srgb.glsl", "vec3 encode_srgb(vec3 linear)", {{1, 2}}), 3));
}

TEST_CASE("a function that is not there is a compile error with file and line") {
    CHECK_THROWS_WITH(run_probe(check_device(), probe_of("common/srgb.glsl", "float absent(float x)", {{1}}), 1),
                      Catch::Matchers::Contains("absent"));
}

TEST_CASE("every division becomes a call, with both operands whole") {
    // Without spaces, which are no matter.
    const auto body = [](const std::string& glsl) {
        std::string text = instrumented(glsl);
        std::erase(text, ' ');
        return text;
    };
    CHECK(body("float y = a * b / c.x[i](2) - d;") ==
          "floaty=undefined_divide(a*b,c.x[undefined_index(i,c.x.length())](2))-d;");
    CHECK(body("return -a / -b / (c + d / e);") ==
          "return-undefined_divide(undefined_divide(a,-b),(c+undefined_divide(d,e)));");
    CHECK(body("x /= y - 1.0; i %= 3;") == "x=undefined_divide(x,y-1.0);i=undefined_remainder(i,3);");
    CHECK(body("a / 2.0; // b / c\n#define H d / e\n/* f / g */ int v[3];") ==
          "a/2.0;//b/c\n#defineHd/e\n/*f/g*/intv[3];");
    CHECK(body("const float k = 1.0;\nfloat f(const float x) { return x / k; }") ==
          "constfloatk=1.0;\nfloatf(constfloatx){returnundefined_divide(x,k);}");
    // Sizes of arrays stay constants; what is initialised by a call, or by such a one, cannot.
    CHECK(body("const int n = 2 * 4 / m; float q[n];") == "constintn=2*4/m;floatq[n];");
    CHECK(body("const vec2 v = vec2(1.0, 2.0);") == "constvec2v=vec2(1.0,2.0);");
    CHECK(body("const float r = sqrt(2.0); const float s = 2.0 * r, t = 1.0 / r;") ==
          "floatr=sqrt(2.0);floats=2.0*r,t=undefined_divide(1.0,r);");
    CHECK_THROWS(instrumented("float f() { return (1.0; }"));
    // A directive goes on after a backslash: braces opened in it are never closed.
    CHECK_NOTHROW(instrumented("#define BEGIN \\\n namespace x {\nfloat f(float a) { return g(a) * 2.0; }"));
}

TEST_CASE("an operation without a defined result is noted with its operands, and its result is any") {
    // encode_srgb takes pow(c, 1 / 2.4), but only above 0.0031308.
    Probe fine = probe_of("common/srgb.glsl", "vec3 encode_srgb(vec3 linear)", {{0, -1, 2}});
    CHECK(run_undefined(check_device(), fine, 3).value().empty());
    Probe root = probe_of("common/srgb.glsl", "float undefined_sqrt(float x)", {{4}, {-4}});
    const std::vector<Undefined> found = run_undefined(check_device(), root, 1).value();
    REQUIRE(found.size() == std::size(undefined_results));
    for (size_t i = 0; i < found.size(); ++i) {
        CHECK(found[i].row == 1);
        CHECK(undefined_words(found[i].what, found[i].a, found[i].b) == "takes the square root of -4");
        if (!std::isnan(undefined_results[i])) CHECK(found[i].result[0] == static_cast<double>(undefined_results[i]));
    }
}

TEST_CASE("a check says where it could not look for undefined operations") {
    Probe probe = probe_of("common/srgb.glsl", "int abs(int x)", {{-7}});
    probe.truth = [](std::span<const double> x) { return Row{std::fabs(x[0])}; };
    Check check;
    check.probe(probe);
    CHECK(check.note.empty());
    probe.macros = {{"undefined_note", "7"}};  // breaks only functions called by instrumented text
    CHECK_FALSE(run_undefined(check_device(), probe, 1));
    check.probe(probe);
    CHECK(check.failed == 0);
    CHECK(check.note.find("common/srgb.glsl") != std::string::npos);
}

TEST_CASE("ints travel as ints") {
    const Probe probe = probe_of("common/srgb.glsl", "int abs(int x)", {{-7}, {5}});
    const Table results = run_probe(check_device(), probe, 1);
    CHECK(results[0][0] == 7);
    CHECK(results[1][0] == 5);
}
