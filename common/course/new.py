"""The scaffold of a new chapter: two methods and a truth, an exercise with its check, a property test, a study, a shot, a lesson."""

import contextlib
import re

from check.starters import check_starters
from pages.quotes import check_quotes
from tree import MANIFEST, ROOT, UsageError, chapters, say, write_atomically

HELP = """Writes a new chapter that builds, draws and is tested: replace its example, natural vignetting, with what it teaches.

  ./course new 20_caustics     chapters/20_caustics, shaders/20_caustics, tests/20_caustics, docs/20_caustics.md

The name is the chapter's number, the one after the last chapter's, and a title of lower-case letters, digits and _.
Nothing is written if a chapter has that number or that title."""

NAME = re.compile(r"([0-9]{2})_([a-z][a-z0-9]*(?:_[a-z0-9]+)*)")

MAIN = """// Chapter NN: TITLE.
#include "01_obj/model_chapter.h"
#include "05_shadow_maps/lit_scene.h"
#include "FOLDER/vignette.h"
#include "common/window/run.h"

using namespace lightwalk;

struct STRUCT : ModelChapter {
    LitScene objects{*this, "objects"};
    Vignette vignette{*this, "vignette"};

    STRUCT() {
        vignette.method.preferred = true;  // --method is about the vignette here
    }
    std::string default_scene() const override { return "scenes/colonnade.json"; }

    // [frame]
    void frame(Frame& frame) override {
        // 1. The objects of the scene, in linear light.
        const View view = set_view(frame);
        Canvas canvas(frame.hdr, frame.depth, glm::vec4(scene.file.background, 1.0f));
        draw(frame, view, canvas, {objects});

        // 2. Darker corners, in place (vignette.h).
        vignette.record(frame, frame.hdr);

        // 3. Linear light, encoded as sRGB.
        encode_srgb(frame);
    }
    // [/frame]
};

CHAPTER(STRUCT)
"""
MODULE = """// Vignette module: a picture that darkens towards its corners, as a simple lens makes it.
#pragma once
#include "common/app/module.h"
#include "common/app/target.h"
#include "common/gpu/frame.h"

namespace lightwalk {

// [vignette]
/// Once a frame: record() darkens an RGBA16F picture of the frame's size, in linear light.
struct Vignette : Module {
    Vignette(Module& owner, std::string name) : Module(owner, std::move(name), "vignette") {}

    Choice method{*this,
                  "method",
                  {"parabola", "rational", "exact"},
                  "exact",
                  "Falloff: two terms of its series, a quotient with the same two terms, or cos^4 of the angle"};
    Knob<float> strength{
        *this, "strength", 0.5f, {0.0f, 4.0f}, "Squared tangent of half the vertical field of view of the lens"};

    void record(Frame& frame, const Image& picture) {
        // The frame may draw a part of a larger picture: its first pixel, and the size of the whole.
        const glm::vec4 part(frame.crop.origin, frame.crop.whole);
        frame.compute("vignette shares", {.writes = {shares_}, .with = {*this}}, [&](Compute& pass) {
            pass.use(find_shares_).set("shares", shares_).set("part", part).dispatch_threads(frame.size);
        });
        frame.compute("vignette", {.reads = {shares_, picture}, .writes = {picture}}, [&](Compute& pass) {
            pass.use(darken_).set("shares", shares_, nearest_clamp);
            pass.set("picture", picture).dispatch_threads(frame.size);
        });
    }
    // [/vignette]

  private:
    Target shares_{*this, {.name = "shares"}};
    Pipeline find_shares_ = compute({.shader = "FOLDER/shares.comp"});
    Pipeline darken_ = compute({.shader = "FOLDER/darken.comp"});
};

}  // namespace lightwalk
"""
TRUTH = """// References of this chapter in double precision.
#pragma once

namespace lightwalk::truth {

inline double falloff(double radius, double strength) {
    const double square = 1 + strength * radius * radius;  // 1 / cos² of the angle
    return 1 / (square * square);
}

}  // namespace lightwalk::truth
"""
SHARES = """// Share of the light that reaches each pixel.
#include "FOLDER/falloff.glsl"

layout(local_size_x = 8, local_size_y = 8) in;

layout(scalar) uniform VignetteBlock { float strength; } vignette;
layout(scalar) uniform PartBlock { vec4 part; };  // first pixel and size of the whole picture
layout(rgba16f) writeonly uniform image2D shares;

// [methods]
float share_at(float radius) {
#if VIGNETTE_METHOD == VIGNETTE_METHOD_PARABOLA
    return max(1.0 - 2.0 * vignette.strength * radius * radius, 0.0);
#elif VIGNETTE_METHOD == VIGNETTE_METHOD_RATIONAL
    return 1.0 / (1.0 + 2.0 * vignette.strength * radius * radius);
#else
    return falloff(radius, vignette.strength);
#endif
}
// [/methods]

void main() {
    ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(pixel, imageSize(shares)))) return;
    float radius = length(2.0 * (vec2(pixel) + 0.5 + part.xy) - part.zw) / part.w;
    imageStore(shares, pixel, vec4(share_at(radius)));
}
"""
DARKEN = """// Multiplies a picture by the share of light that reaches each pixel, in place.
layout(local_size_x = 8, local_size_y = 8) in;

uniform sampler2D shares;
layout(rgba16f) uniform image2D picture;

void main() {
    ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(pixel, imageSize(picture)))) return;
    vec4 light = imageLoad(picture, pixel);
    imageStore(picture, pixel, vec4(light.rgb * texelFetch(shares, pixel, 0).r, light.a));
}
"""
EXERCISE = """// Exercise NN.falloff: how much light reaches a pixel off the axis of the lens.
// Starter: all of it.

// [falloff]
// Returns the share of light that reaches a pixel, cos^4 of its angle to the axis of the
// lens (natural vignetting).
// - `radius`, 0 or more, is the pixel's distance from the middle of the picture, in half
//   heights of the picture.
// - `strength`, 0 or more, is the squared tangent of the angle at radius 1.
// [/falloff]
float falloff(float radius, float strength) {
    return 1.0;
}
"""
SOLUTION = """// Solution of NN.falloff.
float falloff(float radius, float strength) {
    float square = 1.0 + strength * radius * radius;  // 1 / cos^2 of the angle
    return 1.0 / (square * square);
}
"""
CHECKS = """// Checks of chapter NN's exercises: ./course check NN.
#include "FOLDER/truth.h"
#include "common/check/check.h"

using namespace lightwalk;

CHECK_EXERCISE("NN.falloff", "1 + strength * radius * radius is 1 / cos^2 of the angle.") {
    Probe probe{.include = "FOLDER/falloff.glsl",
                .signature = "float falloff(float radius, float strength)",
                .inputs = {{0, 0.5}, {1, 0}, {1, 0.5}, {1.5, 1}, {2, 4}},
                .truth = [](std::span<const double> in) { return Row{truth::falloff(in[0], in[1])}; },
                .bound = {.absolute = 1e-6, .relative = 3e-6}};
    Random random;
    for (int i = 0; i < 200; ++i) probe.inputs.push_back({random.uniform(0, 3), random.uniform(0, 4)});
    check.probe(probe);
}
"""
PROPERTIES = """// Properties of the falloff.
#include <algorithm>

#include "catch.h"
#include "common/check/check.h"

using namespace lightwalk;

TEST_CASE("the axis keeps all light, and no pixel more than one nearer to the axis", "[NN.falloff]") {
    constexpr size_t radii = 33;
    Probe probe{.include = "FOLDER/falloff.glsl", .signature = "float falloff(float radius, float strength)"};
    for (const double strength : {0.0, 0.1, 1.0, 4.0})
        for (size_t i = 0; i < radii; ++i) probe.inputs.push_back({0.1 * double(i), strength});
    const Table shares = run_probe(check_device(), probe, 1);
    for (size_t i = 0; i < shares.size(); ++i) {
        CAPTURE(i, shares[i][0]);
        CHECK(shares[i][0] == (i % radii == 0 ? 1 : std::min(shares[i][0], shares[i - 1][0])));
        CHECK(shares[i][0] > 0);
    }
}
"""
SHOTS = """{"shots": [
\t{
\t\t"name": "corners",
\t\t"caption": "A colonnade, darker towards the corners of the picture.",
\t\t"scene": "assets/scenes/colonnade.json",
\t\t"exercises": ["NN.falloff"],
\t\t"rejects": [{"set": {"vignette.strength": 0}}, {"set": {"method": "parabola"}}, {"chapter": "05_shadow_maps"}]
\t}
]}
"""
STUDY = """{
\t"title": "Vignetting: time against error",
\t"module": "vignette",
\t"error_metric": "flip_mean",
\t"stage": "compute",
\t"size": [960, 540],
\t"rounds": 11,
\t"truth": {"set": {"method": "exact"}, "exact": true},
\t"scenes": [
\t\t{"scene": "assets/scenes/colonnade.json", "set": {"vignette.strength": 0.1}, "label": "long lens"},
\t\t{"scene": "assets/scenes/colonnade.json", "set": {"vignette.strength": 1}, "label": "wide lens"}
\t],
\t"curves": [{"method": "parabola"}, {"method": "rational"}, {"method": "exact"}],
\t"charts": [{"name": "vignette", "passes": ["vignette"]}]
}
"""
LESSON = """# NN TITLE

The picture, in one paragraph: what the reader wants to see, and why earlier chapters cannot draw it.

![The colonnade](../tests/05_shadow_maps/golden/columns.png)

    ./course run NN

This chapter builds on [chapter 05](05_shadow_maps.md) (shadows).

## What you will be able to do

- Three to six things, each one that a reader wants.

## The first ten minutes

1. Run `./course run NN` and move `vignette.strength` from 0 to 2. Look at the corners.
2. Solve [NN.falloff](#NNfalloff-easy).

## What you will see

`exact` keeps some light everywhere. At a large `strength`, `parabola` turns the corners black, and `rational` leaves them too
bright.

## The smallest program

The method in at most 60 lines, docs/minimal/FOLDER.frag or .cpp, quoted whole.

## The frame

<!-- quote: chapters/FOLDER/main.cpp#frame -->
```cpp
```

<!-- quote: shaders/FOLDER/shares.comp#methods -->
```glsl
```

## Exercises

One exercise is GLSL, in `shaders/FOLDER/exercise`, and takes effect when you save.

    ./course run NN --use exercise
    ./course check NN --hint

### NN.falloff (easy)

File `falloff.glsl`: how much light reaches a pixel off the axis of the lens.

<!-- quote: shaders/FOLDER/exercise/falloff.glsl#falloff -->
```glsl
```

- **See:** `./course run NN --shot corners --use solution,NN.falloff=exercise`
- **Check:** `./course check NN.falloff`
- **Typical mistakes:** cos² instead of cos⁴.

## What goes wrong

Each failure with its picture and its figure. A series of two terms falls below 0 where `strength` times the squared radius
exceeds ½ (`./course run NN --set vignette.strength=1 --method parabola`).

## Speed against accuracy

`./course study NN` measures the two approximations against `exact` and draws the chart.

## When to use which

The rule of thumb, and where a scene breaks it.

## Recap

What the reader can do now.

## Questions

1. Predict: which share of the light reaches the corner of a 16:9 picture at `strength` 1?

   <details><summary>Answer</summary>

   The corner has radius $\\sqrt{1 + (16/9)^2} = 2.04$, so $1/(1 + 4.16)^2 = 0.038$.

   </details>

## Further reading

Book or paper, year, page.
"""
INDEX = "docs/index.md"
ROW = ("natural vignetting", "| natural vignetting | cos^4 law | [NN](FOLDER.md#the-frame) | `vignette.strength` | NN.corners | "
       "[NN.falloff](FOLDER.md#NNfalloff-easy) |\n")
FILES = {"chapters/FOLDER/main.cpp": MAIN, "chapters/FOLDER/vignette.h": MODULE, "chapters/FOLDER/truth.h": TRUTH,
         "chapters/FOLDER/study.json": STUDY, "shaders/FOLDER/shares.comp": SHARES, "shaders/FOLDER/darken.comp": DARKEN,
         "shaders/FOLDER/exercise/falloff.glsl": EXERCISE, "shaders/FOLDER/solution/falloff.glsl": SOLUTION,
         "tests/FOLDER/checks_exercises.cpp": CHECKS, "tests/FOLDER/test_falloff.cpp": PROPERTIES,
         "tests/FOLDER/shots.json": SHOTS, "docs/FOLDER.md": LESSON}


def add_arguments(parser):
    parser.add_argument("name", metavar="NN_name")


def refusal(name: str) -> str:
    """Why a chapter cannot have this name; empty where it can."""
    last = chapters()[-1]
    match = NAME.fullmatch(name)
    if not match:
        return f"'{name}' is not a chapter's name; expected two digits, _ and lower-case letters, such as {int(last[:2]) + 1:02}_caustics"
    for other in chapters():
        if match[1] == other[:2] or match[2] == other[3:]:
            return f"there is a chapter {other} already; the last chapter is {last}"
    if match[1] < last[:2]:
        return f"chapter {match[1]} would come before the last one, {last}, and may use only earlier chapters"
    following = f"{int(last[:2]) + 1:02}_{match[2]}"
    if name != following:
        return f"chapter {match[1]} would leave a gap after the last one, {last}; the next is {following}"
    taken = [path for path in written(name) if (ROOT / path).exists()]
    return f"{taken[0]} exists already; nothing was written" if taken else ""


def named(text: str, name: str) -> str:
    title = name[3:].replace("_", " ").capitalize()
    for word, value in (("FOLDER", name), ("STRUCT", title.title().replace(" ", "") + "Chapter"), ("TITLE", title), ("NN", name[:2])):
        text = text.replace(word, value)
    return text


def written(name: str) -> dict[str, str]:
    return {named(path, name): named(text, name) for path, text in FILES.items()}


def with_row(index: str, name: str) -> str:
    lines = index.splitlines(keepends=True)
    terms = [(number, line.split("|")[1].strip().casefold()) for number, line in enumerate(lines) if line.count("|") == 7]
    after = [number for number, term in terms if ROW[0] >= term != "term" and term != "---"]
    return "".join([*lines[:after[-1] + 1], named(ROW[1], name), *lines[after[-1] + 1:]]) if after else index


@contextlib.contextmanager
def all_or_none(names):
    """Files from the root that are written: where one cannot be, all are as they were."""
    before = {path: path.read_bytes() if path.exists() else None for path in (ROOT / name for name in names)}
    try:
        yield
    except BaseException:
        for path, data in before.items():
            with contextlib.suppress(OSError):  # what a folder has beside it stays
                if data is None:
                    path.unlink(missing_ok=True)
                    path.parent.rmdir()
                    path.parent.parent.rmdir()
                elif path.read_bytes() != data:
                    write_atomically(path, data)
        raise


def run(arguments, _rest) -> int:
    if why := refusal(arguments.name):
        raise UsageError(why)
    files, number = written(arguments.name), arguments.name[:2]
    with all_or_none([*files, INDEX, MANIFEST]):
        for path, text in files.items():
            write_atomically(ROOT / path, text)
            say(path)
        if (ROOT / INDEX).exists():
            write_atomically(ROOT / INDEX, with_row((ROOT / INDEX).read_text(encoding="utf-8"), arguments.name))
            say(INDEX)
        check_quotes(f"docs/{arguments.name}.md", write=True)
        check_starters(write=True)
    say(f"\nLook at it:    ./course run {number}\n"
        f"Accept its picture, which no test has seen yet:    ./course accept {number}.corners\n"
        "Test it:       ./course test --changed HEAD\n"
        f"Then replace the example; .github/CONTRIBUTING.md says where a knob, a method and an exercise go.")
    return 0
