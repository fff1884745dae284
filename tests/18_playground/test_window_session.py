"""A scene built from nothing by clicks and keys, saved, and opened by five other chapters. Under Xvfb, validated."""
import functools
import re
import subprocess

from editor_case import BUILD, EditorTest
from window_case import read_png

WIDTH, HEIGHT = 560, 840
# Chapters that open the built scene, and chapter 18's omissions to match their modules.
NO_TONES, NO_SHADOW = ("post.tone=off", "bloom.method=none"), ("shadow.method=none",)
PACKED = ("gbuffer.method=packed",)  # its rounded normals alone make up to 10 codes
OTHERS = {"04_surface_maps": NO_TONES + NO_SHADOW, "05_shadow_maps": NO_TONES,
          "06_deferred": NO_TONES + PACKED, "09_post_effects": PACKED, "14_environment": ()}
# Two shaders of one surface: chapter 18 adds light from all around as a cube, which is an even one here.
MOST_CODES = 6
EMPTY = {"camera": {"position": [0, 0.8, 4], "target": [0, 0, 0], "fov_deg": 40}, "ambient": [0.2, 0.2, 0.2],
         "lights": [{"type": "directional", "direction": [-0.4, -0.8, -0.5], "intensity": 1.5, "shadow": True}]}


class Building(EditorTest):
    built, size = EMPTY, (WIDTH, HEIGHT)

    def say(self, pattern, since):
        return self.session.wait_for_line(pattern, since)

    def add(self, name: str):
        """A model through the file browser, found by its filter."""
        since = self.session.said()
        self.session.tap("tool.open")
        self.session.tap("field.file filter")
        self.session.type(name.split(".")[0] + ".")
        first_row = 262  # it stands there once the filter has been read
        self.session.wait(lambda: self.session.areas.get("file." + name, (0, first_row))[1] < first_row, "the filtered list")
        self.session.tap("file." + name)
        self.say("added " + re.escape(name), since)
        self.session.settled(0, 0, WIDTH, HEIGHT)

    def type_into(self, field: str, text: str, end: str):
        self.scroll_to(field)
        session = self.session
        session.tap(field)
        session.wait(lambda: session.types, field)
        session.type(text)
        if end:
            return session.key(end)
        session.read_all()  # a click elsewhere implies a visible typed text
        session.tap("field.search")

    def set_knob(self, knob: str, option: str):
        """By the panel on the right, found by its filter."""
        session = self.session
        since = session.said()
        session.tap("filter")
        session.wait(lambda: session.types, "the filter")
        session.key("ctrl+a")
        session.type(knob)
        session.wait(lambda: f"knob.{knob}" in session.areas, knob)
        session.read_all()
        session.tap(f"knob.{knob}")
        session.tap(f"option.{knob}.{option}")
        self.say(f"knob {re.escape(knob)} {option}", since)

    def test_a_scene_is_built_saved_and_opened_by_others(self):
        session, left = self.session, self.left_px
        start = session.pixels(left, 0, WIDTH, HEIGHT)

        # Two models; the second is dragged along x by the gizmo's arrow.
        self.add("cube.obj")
        self.add("teapot.obj")
        self.assert_other(session.pixels(left, 0, WIDTH, HEIGHT), start)
        name = lambda: session.xdotool("getwindowname", session.window).strip()  # noqa: E731
        session.wait(lambda: name().endswith(f"{self.scene.name} *"), "a title that says what is not saved")
        cube, teapot = (one["position"] for one in self.saved()["objects"])
        session.wait(lambda: name().endswith(self.scene.name), "a title that says what is edited")
        self.assert_near(cube, [0, 0.5, 0])  # on the ground below the middle of the picture
        self.assert_near(teapot, [0, 0.1, 0.5 + 0.634921])  # before the cube's side that is in the middle
        x, y = self.in_window(EMPTY["camera"], teapot)
        words = session.drag((x + 60, y), (x + 150, y), says=r"dragged (.*) m along x")[1]
        self.assertGreater(float(words), 0.1)

        # A click on the teapot's new place picks it; one on the background nothing.
        since = session.said()
        session.move(*self.in_window(EMPTY["camera"], [float(words) - 0.4, *teapot[1:]]))
        session.press()
        session.release()
        self.say("picked teapot", since)

        # Who orbits has not clicked: the teapot stays selected.
        session.move(left + WIDTH - 60, HEIGHT - 60)
        session.press()
        session.move(left + WIDTH - 20, HEIGHT - 90)
        session.release()
        session.read_all()
        session.key("Home")
        session.read_all()
        self.assertEqual([line for line in session.lines[since:] if line.startswith("picked")], ["picked teapot"])
        since = session.said()
        session.move(left + WIDTH - 20, 20)
        session.xdotool("click", "1")  # down and up within a frame
        self.say("picked nothing", since)

        # A light over them, and the file.
        session.move(left + WIDTH - 60, 60)
        session.key("shift+2")
        session.read_all()
        session.park()
        scene = self.saved()
        self.assertEqual([o["name"] for o in scene["objects"]], ["cube", "teapot"])
        self.assertAlmostEqual(scene["objects"][1]["position"][0], float(words), places=3)
        self.assertEqual(len(scene["lights"]), 2)

        # Textures, typed: one with Return, pressed for less than a frame; the other left by a click elsewhere. And an effect.
        session.tap("entry.cube")
        self.type_number("numbers.position", "1.25")
        self.assertEqual(self.saved()["objects"][0]["position"][0], 1.25)
        self.undo()
        session.tap("section.Material")
        self.scroll_to("ball")
        since = session.said()
        self.type_into("field.diffuse map", "textures/checker.png", "Return")
        self.say("ball drawn", since)
        self.type_into("field.normal map", "textures/stone_tiles_normal.png", "")
        self.set_knob("bloom.method", "paired")
        scene = self.saved()
        maps = {"diffuse": "textures/checker.png", "normal": "textures/stone_tiles_normal.png"}
        self.assertEqual(scene["objects"][0]["material"]["maps"], maps)
        self.assertEqual(scene["knobs"], {"bloom.method": "paired"})

        # A texture that is not there is said, and changes nothing.
        since = session.said()
        self.type_into("field.specular map", "textures/none.png", "Return")
        self.say(r"notice .*textures/none\.png.*", since)
        self.assertEqual(self.saved(), scene)

        # Three steps back, the effect and both textures; three more, the light, the drag, the teapot; and forward again.
        self.undo(3)
        back = self.saved()
        self.assertNotIn("material", back["objects"][0])
        self.assertEqual((back["knobs"], len(back["lights"])), ({}, 2))
        self.undo(3)
        back = self.saved()
        self.assertEqual(len(back["lights"]), 1)
        self.assertEqual([o["name"] for o in back["objects"]], ["cube"])
        self.undo(6, "ctrl+y", "done again")
        self.assertEqual(self.saved(), scene)

        # Unsaved changes need a confirmation; then it ends, without a message.
        self.leave()

        for chapter, without in OTHERS.items():
            with self.subTest(chapter=chapter):
                theirs, ours = self.drawn(chapter), self.drawn("18_playground", without)
                self.assertGreater(len(set(theirs)), 16, "an empty picture")
                steps = [abs(a - b) for a, b in zip(theirs, ours)]
                self.assertLessEqual(max(steps), MOST_CODES)

    def assert_near(self, place: list, expected: list):
        for a, b in zip(place, expected):
            self.assertAlmostEqual(a, b, places=2)

    @functools.lru_cache(maxsize=None)
    def drawn(self, chapter: str, settings=()) -> bytes:
        if not (BUILD / "chapters" / chapter).exists():
            self.fail(f"{chapter} is not built")
        picture = self.folder / f"{chapter}_{'_'.join(settings)}.png"
        options = [word for one in settings for word in ("--set", one)]
        subprocess.run([BUILD / "chapters" / chapter, "--scene", self.scene, "--size", "160x120", *options, "--screenshot",
                        picture], check=True, env={**self.session.environment})
        return read_png(picture)[2]
