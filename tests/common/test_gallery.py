"""The gallery's order: one picture of what is built, before the compiler goes on with the other chapters."""
# Builds: nothing

import sys
import tempfile
import unittest
from pathlib import Path
from unittest import mock

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "common/course"))
import gallery  # noqa: E402
from tree import Failure  # noqa: E402

SHOTS = [{"chapter": "01_obj", "name": name, "image": f"01_obj/{name}.png", "error": None} for name in ("bunny", "car")]


class Built:
    """Programs of which one is ready at first, the others once the compiler ran."""

    def __init__(self, order: list[str]):
        self.order, self.states = order, {"01_obj": mock.Mock()}
        self.states["01_obj"].name = "ready"

    def start(self):
        self.order.append("the compiler")

    def ready(self) -> list[str]:
        return ["01_obj"]

    def are_building(self) -> bool:
        return False

    def stop(self):
        pass


class First(unittest.TestCase):
    def order(self, known: dict, wrong: str = "", starts: bool = True) -> list[str]:
        """What is drawn and compiled, one after the other."""
        found = []

        class Drawing:
            def __init__(self, _chapter, **_):
                self.program = mock.Mock() if starts else None

            def is_alive(self):
                return True

            def close(self):
                pass

            def draw(self, words, file):
                if not starts:
                    raise Failure("no such program")
                found.append(f"{words[1]}, {words[3]}")
                if not wrong:
                    file.write_text("")
                return (1 if wrong else 0), wrong, 0

        with tempfile.TemporaryDirectory() as folder, mock.patch.object(gallery, "Drawing", Drawing), \
                mock.patch.object(gallery, "key_of", lambda _: "now"), mock.patch.object(gallery, "cores", lambda: 1):
            (Path(folder) / "01_obj").mkdir()
            for image in known:
                (Path(folder) / image).write_text("")
            drawer = gallery.Drawer(Path(folder), [dict(shot) for shot in SHOTS], [], known)
            drawer.page_changed = lambda *_: None
            drawer.draw_all(Built(found))
        return found

    def test_the_best_picture_comes_before_the_compiler(self):
        found = self.order({})
        self.assertEqual(found[0], "bunny, 1")
        self.assertEqual(sorted(found[1:]), ["bunny, 4", "car, 4", "the compiler"])

    def test_one_that_cannot_be_drawn_stops_nothing(self):
        self.assertIn("the compiler", self.order({}, "no device"))
        self.assertEqual(self.order({}, starts=False), ["the compiler"])

    def test_what_is_drawn_already_is_not_waited_for(self):
        self.assertEqual(self.order({shot["image"]: "now" for shot in SHOTS}), ["the compiler"])


if __name__ == "__main__":
    unittest.main()
