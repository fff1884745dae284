"""The editor at its first start: a tour that follows what the person does, can be left, and does not come back.
Under Xvfb, validated."""
import json

from editor_case import EditorTest
from window_session import BUILD, ROOT, Session

CUBE = {"camera": {"position": [0, 1.2, 4], "target": [0, 0.3, 0], "fov_deg": 40}, "ambient": [0.3, 0.3, 0.3],
        "background": [0.5, 0.5, 0.5], "objects": [{"name": "cube", "model": "models/cube.obj", "position": [0, 0.3, 0]}]}


class Tour(EditorTest):
    built = CUBE

    @classmethod
    def start(cls, scene):
        session = Session(cls.server, BUILD / "chapters" / "18_playground",
                          ["--validate", "on", "--size", "{}x{}".format(*cls.size), "--scene", str(scene)], cls.folder,
                          tour=True, LIGHTWALK_ROOT=str(ROOT))
        cls.addClassCleanup(session.close)
        return session

    def test_1_steps_end_when_they_are_done(self):
        session, middle = self.session, self.middle()
        session.drag(middle, (middle[0] + 60, middle[1]), says="tour 2")
        session.tap("entry.cube", says="tour 3")
        session.tap("tool.next", says="tour 4")
        session.tap("tool.back", says="tour 3")
        session.key("ctrl+d", says="tour 4")  # a step of the document
        session.key("ctrl+z", says="tour 5")
        session.key("2", says="tour 6")
        session.key("shift+2", says="tour 7")
        session.tap("tool.leave the tour", says="tour left")
        remembered = json.loads((self.folder / "state/lightwalk/18_playground.tour.panel.json").read_text())
        self.assertEqual(remembered, {"left": True})

    def test_4_later_starts_have_none(self):
        session = self.session
        session.key("ctrl+s")
        self.leave()
        type(self).session = self.session = self.start(self.scene)
        self.session.read_all()
        self.assertNotIn("tool.leave the tour", self.session.areas)
