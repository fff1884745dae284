"""The helper that draws the lessons' diagrams: its output is readable, and unreadable drawings are refused."""
# Builds: nothing
import pathlib
import sys
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "docs" / "figures"))
import drawing  # noqa: E402


class Figures(unittest.TestCase):
    def setUp(self):
        self.drawing = drawing.Drawing(400, 300, "a < b & c")
        self.panel = self.drawing.panel((200, 100), 50)

    def test_labels_that_cannot_be_read_are_refused(self):
        self.panel.text((0, 0), "here")
        self.drawing.svg()
        self.panel.text((0.2, 0.1), "there")
        self.assertRaisesRegex(ValueError, "'there' overlaps 'here'", self.drawing.svg)

    def test_labels_that_leave_the_picture_are_refused(self):
        self.panel.text((3.7, 0), "outside")
        self.assertRaisesRegex(ValueError, "'outside' leaves the picture", self.drawing.svg)
