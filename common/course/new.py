"""The scaffold of a new chapter: a program that draws, one exercise with its check, one shot, a lesson's skeleton."""

import re

from check.starters import check_starters
from pages.quotes import check_quotes
from tree import ROOT, UsageError, chapters, say, write_atomically

HELP = """Writes a new chapter that builds, draws and is tested: replace its example, natural vignetting, with what it teaches.

  ./course new 20_caustics     chapters/20_caustics, shaders/20_caustics, tests/20_caustics, docs/20_caustics.md

The name is the chapter's number, two digits after the last chapter's, and a title of lower-case letters, digits and _.
Nothing is written if a chapter has that number or that title."""

NAME = re.compile(r"([0-9]{2})_([a-z][a-z0-9]*(?:_[a-z0-9]+)*)")

MAIN = """// Chapter NN: TITLE.
#include "01_obj/model_chapter.h"
#include "05_shadow_maps/lit_scene.h"
#include "common/window/run.h"

using namespace lightwalk;

struct STRUCT : ModelChapter {
    LitScene objects{*this, "objects"};
    Knob<float> strength{*this,
                         "strength",
                         0.5f,
                         {0.0f, 4.0f},
                         "Strength of the vignetting: the squared tangent of half the field of view"};

    Pipeline darken = compute({.shader = "FOLDER/darken.comp"});

    std::string default_scene() const override { return "scenes/colonnade.json"; }

    // [frame]
    void frame(Frame& frame) override {
        // 1. The objects of the scene, in linear light.
        const View view = set_view(frame);
        Canvas canvas(frame.hdr, frame.depth, glm::vec4(scene.file.background, 1.0f));
        draw(frame, view, canvas, {objects});

        // 2. Darker corners, in place.
        frame.compute("darken", {.reads = {frame.hdr}, .writes = {frame.hdr}},
                      [&](Compute& pass) { pass.use(darken).set("hdr", frame.hdr).dispatch_threads(frame.size); });

        // 3. Linear light, encoded as sRGB.
        encode_srgb(frame);
    }
    // [/frame]
};

CHAPTER(STRUCT)
"""
TRUTH = """// References of this chapter in double precision.
#pragma once

namespace lightwalk::truth {

inline double vignette(double radius, double strength) {
    const double square = 1 + strength * radius * radius;  // 1 / cos² of the angle
    return 1 / (square * square);
}

}  // namespace lightwalk::truth
"""
DARKEN = """// Darkens the picture towards its corners, in place.
#include "FOLDER/vignette.glsl"

layout(local_size_x = 8, local_size_y = 8) in;

layout(scalar) uniform KnobBlock { float strength; } knobs;
layout(rgba16f) uniform image2D hdr;

void main() {
    ivec2 pixel = ivec2(gl_GlobalInvocationID.xy), size = imageSize(hdr);
    if (any(greaterThanEqual(pixel, size))) return;
    float radius = length(2.0 * (vec2(pixel) + 0.5) - vec2(size)) / float(size.y);
    vec4 light = imageLoad(hdr, pixel);
    imageStore(hdr, pixel, vec4(light.rgb * vignette(radius, knobs.strength), light.a));
}
"""
EXERCISE = """// Exercise NN.vignette: how much light reaches a pixel off the axis of the lens.
// Starter: all of it.

// [vignette]
// Returns the share of light that reaches a pixel, cos^4 of its angle to the axis of the
// lens (natural vignetting).
// - `radius`, 0 or more, is the pixel's distance from the middle of the picture, in half
//   heights of the picture.
// - `strength`, 0 or more, is the squared tangent of the angle at radius 1.
// [/vignette]
float vignette(float radius, float strength) {
    return 1.0;
}
"""
SOLUTION = """// Solution of NN.vignette.
float vignette(float radius, float strength) {
    float square = 1.0 + strength * radius * radius;  // 1 / cos^2 of the angle
    return 1.0 / (square * square);
}
"""
CHECKS = """// Checks of chapter NN's exercises: ./course check NN.
#include "FOLDER/truth.h"
#include "common/check/check.h"

using namespace lightwalk;

CHECK_EXERCISE("NN.vignette", "1 + strength * radius * radius is 1 / cos^2 of the angle.") {
    Probe probe{.include = "FOLDER/vignette.glsl",
                .signature = "float vignette(float radius, float strength)",
                .inputs = {{0, 0.5}, {1, 0}, {1, 0.5}, {1.5, 1}, {2, 4}},
                .truth = [](std::span<const double> in) { return Row{truth::vignette(in[0], in[1])}; },
                .bound = {.absolute = 1e-6, .relative = 3e-6}};
    Random random;
    for (int i = 0; i < 200; ++i) probe.inputs.push_back({random.uniform(0, 3), random.uniform(0, 4)});
    check.probe(probe);
}
"""
SHOTS = """{"shots": [
\t{
\t\t"name": "corners",
\t\t"caption": "A colonnade, darker towards the corners of the picture.",
\t\t"scene": "assets/scenes/colonnade.json",
\t\t"exercises": ["NN.vignette"],
\t\t"rejects": [{"set": {"strength": 0}}, {"chapter": "05_shadow_maps"}]
\t}
]}
"""
LESSON = """# NN TITLE

The picture, in one paragraph: what the reader wants to see, and why earlier chapters cannot draw it.

![The colonnade](../tests/05_shadow_maps/golden/columns.png)

    ./course run NN

This chapter builds on [chapter 05](05_shadow_maps.md) (shadows).

## What you will be able to do

- Three to six things, each one that a reader wants.

## The first ten minutes

1. Run `./course run NN` and move `strength` from 0 to 2. Look at the corners.
2. Solve [NN.vignette](#NNvignette-easy).

## What you will see

Which picture each method draws, and where they differ.

## The smallest program

The method in at most 60 lines, docs/minimal/FOLDER.frag or .cpp, quoted whole.

## The frame

<!-- quote: chapters/FOLDER/main.cpp#frame -->
```cpp
```

## Exercises

One exercise is GLSL, in `shaders/FOLDER/exercise`, and takes effect when you save.

    ./course run NN --use exercise
    ./course check NN --hint

### NN.vignette (easy)

File `vignette.glsl`: how much light reaches a pixel off the axis of the lens.

<!-- quote: shaders/FOLDER/exercise/vignette.glsl#vignette -->
```glsl
```

- **See:** `./course run NN --shot corners --use solution,NN.vignette=exercise`
- **Check:** `./course check NN.vignette`
- **Typical mistakes:** cos² instead of cos⁴.

## What goes wrong

Each failure with its picture and its figure.

## Speed against accuracy

The chart of `./course study NN` first, then what it shows.

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
FILES = {"chapters/FOLDER/main.cpp": MAIN, "chapters/FOLDER/truth.h": TRUTH, "shaders/FOLDER/darken.comp": DARKEN,
         "shaders/FOLDER/exercise/vignette.glsl": EXERCISE, "shaders/FOLDER/solution/vignette.glsl": SOLUTION,
         "tests/FOLDER/checks_exercises.cpp": CHECKS, "tests/FOLDER/shots.json": SHOTS, "docs/FOLDER.md": LESSON}


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
    taken = [path for path in written(name) if (ROOT / path).exists()]
    return f"{taken[0]} exists already; nothing was written" if taken else ""


def written(name: str) -> dict[str, str]:
    """The files of a chapter by path."""
    title = name[3:].replace("_", " ").capitalize()
    words = {"FOLDER": name, "STRUCT": title.title().replace(" ", "") + "Chapter", "TITLE": title, "NN": name[:2]}
    found = {}
    for path, text in FILES.items():
        for word, value in words.items():
            path, text = path.replace(word, value), text.replace(word, value)
        found[path] = text
    return found


def run(arguments, _rest) -> int:
    if why := refusal(arguments.name):
        raise UsageError(why)
    files, number = written(arguments.name), arguments.name[:2]
    for path, text in files.items():
        write_atomically(ROOT / path, text)
        say(path)
    check_quotes(f"docs/{arguments.name}.md", write=True)
    check_starters(write=True)
    say(f"\nLook at it:    ./course run {number}\n"
        f"Accept its picture, which no test has seen yet:    ./course accept {number}.corners\n"
        f"Test it:       ./course test '\\.{number}'\n"
        f"Then replace the example; .github/CONTRIBUTING.md says where a knob, a method and an exercise go.")
    return 0
