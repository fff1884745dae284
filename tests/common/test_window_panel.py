"""The panel's knobs: sections that fold and are remembered, a filter, resets, labels that are never cut. Under Xvfb."""
import json
import re

from window_case import StartedTest
from window_session import BUILD, ROOT, Session

CHAPTER = BUILD / "chapters" / "05_shadow_maps"


class Panel(StartedTest):
    def panel(self) -> Session:
        """Of a scene with little to draw: a frame is soon there."""
        return self.start(CHAPTER, "--size", "300x700", screen=(3840, 2160), scene={"objects": [{"model": str(ROOT / "assets/models/cube.obj")}]})

    def remember(self, **sections: bool):
        self.write("state/lightwalk/05_shadow_maps.panel.json", json.dumps(sections))

    def test_sections_fold_and_are_remembered(self):
        session = self.panel()
        session.wait(lambda: "knob.shadow.method" in session.areas, "the section of what the chapter teaches")
        self.assertIn("knob.visibility", session.areas)
        self.assertNotIn("knob.maps.method", session.areas)
        session.click("section.Exercises")
        session.click("knobs.shadow")
        session.click("knobs.maps")
        session.wait(lambda: "knob.maps.method" in session.areas, "maps' knobs")
        self.end(session)
        session = self.panel()
        session.wait(lambda: "knob.maps.method" in session.areas, "what was open")
        self.assertNotIn("knob.shadow.method", session.areas)
        self.end(session)

    def test_filter_changes_and_resets(self):
        session = self.panel()
        session.click("section.Exercises")
        session.click("filter")
        session.type("cutoff")
        session.wait(lambda: "knob.maps.cutoff" in session.areas, "a knob of a folded section")
        self.assertNotIn("reset.maps.cutoff", session.areas)
        session.click("knob.maps.cutoff")  # its middle is its default: to the left of it
        left, top, right, bottom = session.areas["knob.maps.cutoff"]
        to_the_left = ((left + right) // 2, (top + bottom) // 2), (left + 12, (top + bottom) // 2)
        session.drag(*to_the_left, says=r"knob maps\.cutoff 0(\.0\d*)?")
        session.click("reset.maps.cutoff", says=r"knob maps\.cutoff 0\.5")
        session.drag(*to_the_left)
        session.click("reset.maps", says="reset maps")
        session.key("Escape")  # leaves the field, not the program
        self.end(session)

    def choose(self, session: Session, knob: str) -> str:
        """By the entry "auto" of its menu: the message."""
        session.click("knob." + knob)
        said = session.click(f"option.{knob}.auto", says=r"auto (.*)")[1]
        session.settled(0, 0, *session.geometry()[2:])
        return said

    def test_auto_measures_the_picture_and_sets_a_method(self):
        self.remember(lights=True)
        session = self.panel()
        session.click("section.Exercises")
        for knob, methods in (("shadow.method", "none|hard|pcf|pcss|vsm|evsm|msm"),  # the chapter's own, and a borrowed one
                              ("lights.method", "every_light|per_object|tiled|clustered")):
            said = self.choose(session, knob)
            self.assertRegex(said, rf"{re.escape(knob)}: ({methods})\b.* is the fastest.*; .*\(FLIP .* ms at 300×700\)")
        since = session.said()
        session.click("filter")
        session.type("sphere_shadow.method")
        session.settled(0, 0, *session.geometry()[2:])
        session.click("knob.sphere_shadow.method")  # which nobody has compared
        session.wait(lambda: "option.sphere_shadow.method.none" in session.places, "its menu")
        self.assertNotIn("option.sphere_shadow.method.auto", session.places)
        self.assertFalse([line for line in session.lines[since:] if line.startswith("auto")])
        session.key("Escape")  # its menu
        session.read_all()
        self.end(session)
