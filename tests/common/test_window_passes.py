"""The frame as a graph of its passes: opened by a key and by a button, an image of each target, a click that shows one large.
Messages stand below the picture. Under Xvfb, validated."""
# Builds: 05_shadow_maps

from window_case import StartedTest
from window_session import BUILD, ROOT

WIDTH, HEIGHT = 500, 700
SCENE = {"camera": {"position": [0, 2, 5], "target": [0, 0.5, 0], "fov_deg": 40}, "ambient": [0.2, 0.2, 0.2],
         "lights": [{"type": "directional", "direction": [-0.4, -0.8, -0.5], "shadow": True}],
         "objects": [{"name": "ground", "model": "models/ground.obj"},
                     {"name": "box", "model": "models/cube.obj", "position": [0, 0.5, 0]}]}


class Passes(StartedTest):
    def setUp(self):
        self.session = self.start(BUILD / "chapters" / "05_shadow_maps", "--validate", "on", "--size", f"{WIDTH}x{HEIGHT}", "--set", "shadow.cascades=1",
                                  screen=(1600, 1200), scene=SCENE, LIGHTWALK_ROOT=str(ROOT))
        self.session.read_all()

    def picture(self, height: int) -> bytes:
        return self.session.settled(0, 0, WIDTH, height)

    def image(self, place: str) -> bytes:
        """Of a target, in the graph."""
        left, top, right, bottom = self.session.areas[place]
        return self.session.settled(left + 2, top + 2, right - left - 4, bottom - top - 4)

    def passes(self, since: int) -> set:
        said = self.session.wait_for_line(r"passes(; .*)", since)[1]
        return {tuple(edge.split(" > ")) for edge in said[2:].split("; ")}

    def test_what_is_prepared_is_named_until_the_first_picture(self):
        self.assertIn("preparing shadow", self.session.lines[:self.session.lines.index("first picture")])
        self.assertNotIn("preparing", self.session.xdotool("getwindowname", self.session.window))
        self.end(self.session)

    def test_passes_are_shown_with_their_images_and_a_click_shows_one_large(self):
        session = self.session
        whole = self.picture(HEIGHT)
        since = session.said()
        session.key("F6")
        edges = self.passes(since)
        self.assertIn(("shade", "encode_srgb"), edges)
        # The shadow map is kept: an earlier frame has drawn it.
        self.assertIn(("shadow_map depth", "shade"), edges)
        kept = next(name for name in session.areas if name.startswith("pass.shadow_map depth"))
        self.assertLess({"pass.shade: hdr", "pass.encode_srgb: output"}, set(session.areas))
        images = [self.image(name) for name in (kept, "pass.shade: hdr")]
        for image in images:
            self.assertGreater(len({image[i:i + 3] for i in range(0, len(image), 3)}), 1, "an image is empty")
        self.assertNotEqual(*images)
        smaller = session.areas[kept][1] - 60  # above the graph
        picture = self.picture(smaller)
        session.click(kept, says="look " + kept.removeprefix("pass."))
        self.assertNotEqual(self.picture(smaller), picture)
        session.click(kept, says="look the picture")
        self.assertEqual(self.picture(smaller), picture)
        session.key("F6")
        session.wait(lambda: session.pixels(0, 0, WIDTH, HEIGHT) == whole, "the whole picture")
        self.end(session)
