"""More submissions that attack their grading, in later chapters: answers that know where they run, that bring their own
checks, and that have a table of the inputs everybody can see."""

from graded_class import PLACES, REAL, right
from check.variants import variants


def variant(chapter: str, name: str) -> str:
    """An answer with a known verdict, a file or an entry of a list."""
    return next(one.text for one in variants(chapter)[0] if one.name == name + ".glsl")


NAIVE_LIGHTS = variant("06_deferred", "accumulate_lights.each_alone")
NAIVE_LAB = variant("13_mlaa", "lab_edges.asks_all")
NAIVE_LINE = variant("08_bloom", "blur_line.all_read_all")
EARLY = variant("06_deferred", "accumulate_lights.returns_early")
TWO_BARRIERS = variant("08_bloom", "blur_line.two_barriers")
CELL = (REAL / "shaders/03_attenuation/cell.glsl").read_text()


def own_reach() -> str:
    """An answer that asks every light by itself, in a copy of the function that is counted."""
    body = CELL[CELL.index("bool light_reaches_cell"):CELL.index("// [/light_reaches_cell]")]
    return NAIVE_LIGHTS.replace("Lit accumulate_lights", body.replace("light_reaches_cell", "mine") + "Lit accumulate_lights")\
        .replace("(light_reaches_cell(", "(mine(")


def begins(text: str, function: str, line: str) -> str:
    """GLSL with a line inserted at the start of the function."""
    at = text.index("{\n", text.index(f" {function}(")) + 2
    return text[:at] + f"    {line}\n" + text[at:]


def before(text: str, place: str, line: str) -> str:
    """GLSL with a line more before the first of these places."""
    at = text.index(place)
    return text[:at] + line + text[at:]


FORGED = """#include "02_lambert_phong/exercises.h"
#include <string>
#include <string_view>
namespace lightwalk {
using Answer = std::string (*)(std::string_view);
struct RegisterAnswer { RegisterAnswer(const char* id, Answer answer); };
static std::string forged(std::string_view) { return std::string(64, '\\0'); }
%s static const RegisterAnswer mine("02.record_mist try_record_mist", forged);
}
"""

# name: (exercise, answer, words of the verdict)
ATTACKS = {
    "sets the count back": ("06.accumulate_lights", begins(NAIVE_LIGHTS, "accumulate_lights", "asked = 0u;"),
                            "asked' : undeclared"),
    "sets the check's count back": (
        "06.accumulate_lights", begins(NAIVE_LIGHTS, "accumulate_lights", "check_asked[0] = 0u;"), "the checks' own"),
    "calls what is not counted": (
        "06.accumulate_lights", NAIVE_LIGHTS.replace("(light_reaches_cell(", "(check_reaches("), "the checks' own"),
    "counts in a copy": ("06.accumulate_lights", own_reach(), "lights where|lights reach|plain loop"),
    "takes the macro away": (
        "06.accumulate_lights", NAIVE_LIGHTS.replace("Lit accum", "#undef light_reaches_cell\nLit accum"), "a name that others use"),
    "waits for nobody": ("06.accumulate_lights", "void barrier() {}\n" + NAIVE_LIGHTS, "syntax error"),
    "sets the pixels' counts back": ("13.lab_edges", begins(NAIVE_LAB, "lab_edges", "check_asked[0] = 0u;"), "the checks' own"),
    "knows that it is checked": (
        "13.propagate_distance", begins(right("13.propagate_distance"), "propagate_distance",
                                        "\n#ifdef KNOWN_DISTANCES\n    return 0u;\n#endif\n"), "by which shaders know"),
    "does not let the check wait": ("13.lab_edges", "void barrier() {}\n" + NAIVE_LAB, "syntax error"),
    "says itself which barriers it passed": (
        "08.blur_line", before(TWO_BARRIERS, "    int middle", "    check_barriers_passed = 1u;\n"), "the checks' own"),
    "says so by another name": (
        "08.blur_line", before(TWO_BARRIERS, "    int middle", "    barriers_passed = 1u;\n"), "barriers_passed' : undeclared"),
    "says so of its own": (
        "08.blur_line", before(before(TWO_BARRIERS, "    int middle", "    barriers_passed = 1u;\n"), "vec3 blur_line",
                               "uint barriers_passed;\n"), "different barriers"),
    "notes barriers where it has none": (
        "06.accumulate_lights", before(EARLY, "    if (!has_surface) return", "    if (!has_surface) check_pass_barrier(11u);\n"),
        "the checks' own"),
    "waits unseen": (
        "08.blur_line", TWO_BARRIERS.replace("barrier();", "check_barrier();"), "the checks' own"),
    "takes the tracing away": (
        "08.blur_line", before(TWO_BARRIERS, "vec3 blur_line", "#undef barrier\n"), "a name that others use"),
    "lets a memory barrier wait": (
        "08.blur_line", "#undef memoryBarrierShared\n" + TWO_BARRIERS.replace("barrier()", "memoryBarrierShared()"),
        "a name that others use"),
    "reads past the count": (
        "08.blur_line", NAIVE_LINE.replace("texel(", "texelFetch(check_known, ivec2(1024), 0).rgb + 0.0 * texel("),
        "the checks' own"),
    "looks how it is counted": ("08.down_filter", begins(right("08.down_filter"), "down_filter", "int n = IMPULSE_X;"), "by which shaders know"),
    "makes the check agree": (
        "08.blur_line", '#include "08_bloom/line_source.glsl"\n'
        "vec4 texelFetch(sampler2D s, ivec2 at, int level) { return vec4(0.0); }\n"
        "vec3 blur_line(int start, int radius) { return vec3(0.0); }\n", "gave 0.0000|overloaded functions"),
    "adds to the picture by itself": (
        "09.histogram_bin", right("09.histogram_bin").replace("    if (counts) atomicAdd(own_bins[bin], 1u);",
                                                              "    if (counts) atomicAdd(picture_bins[bin], 1u);"),
        "names picture_bins"),
    "takes another's reference": (
        "11.quintic_noise", '#include "11_fractals/solution/noise_derivative.glsl"\n'
        "float quintic_noise(ivec2 cell, vec2 f) { return noise_derivative(cell, f).x; }\n", "no file of that name"),
    "takes another's answer": (
        "11.quintic_noise", '#include "11_fractals/noise_derivative.glsl"\n'
        "float quintic_noise(ivec2 cell, vec2 f) { return noise_derivative(cell, f).x; }\n", "11.noise_derivative"),
    "brings its own trial": ("02.record_mist", FORGED % "" + right("02.record_mist"), "is there twice"),
    "brings its own trial first": (
        "02.record_mist", FORGED % "[[gnu::init_priority(101)]]" + right("02.record_mist"), "is there twice"),
}


def table(exercise: str, known: str) -> str:
    """An answer that is right if `known` holds, an expression of its input, and wrong elsewhere."""
    text = right(exercise)
    at = text.index("{\n", text.index(f" {exercise[3:]}(")) + 2
    wrong = {"13.area": "return 9.0f;", "07.odd_size_weights": "return vec3(9.0);", "11.record_cones": "return;",
             "13.propagate_distance": "return 99u;"}.get(exercise, "return {};")
    return text[:at] + f"    if (!({known})) {wrong}\n" + text[at:]


def one_of(value: str, *numbers) -> str:
    return " || ".join(f"{value} == {number}" for number in numbers)


# Answers that know every input of their check that does not move with the seed.
TABLES = {
    "01.triangulate": table("01.triangulate", one_of("polygon.size()", 2, 3, 4, 5, 6, 10, 42, 100, 1000)),
    "07.level_sizes": table("07.level_sizes", one_of("size.x", 4, 1, 1023, 3, 1366, 1080, 4096, 4097, 16384)),
    "07.odd_size_weights": table("07.odd_size_weights", one_of("size", 1, 2, 3, 5, 7, 8, 255, 683, 1023, 1366, 4097)),
    "08.gaussian_weights": table("08.gaussian_weights", one_of(
        "sigma_px", "0.0f", "1e-20f", "1e-30f", "0.1f", "0.3f", "1.0f", "2.5f", "10.0f", "33.3f", "200.0f")),
    "08.pair_taps": table("08.pair_taps", "weights[0] >= 0.15f || weights.size() > 30 || weights[0] == 0.0f || "
                          + one_of("weights.size()", 1, 4, 5, 7, 22)),
    "13.area": table("13.area", one_of("length", 1, 2, 3, 4, 5, 7, 8, 31, 64, 255, 256, 509)),
    "13.propagate_distance": table("13.propagate_distance", one_of("known(0u) * 256u + known(5u)", *(
        f"{a}u * 256u + {b}u" for a, b in ((1, 1), (4, 4), (3, 4), (2, 2), (0, 1), (200, 1), (254, 254), (100, 100))))
        + " || known(0u) == 0u"),
    "11.record_cones": table("11.record_cones", one_of("passes.found.desc.size.x", 40, 61)),
}
assert set(TABLES) <= set(PLACES)
