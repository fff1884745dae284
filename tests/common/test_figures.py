"""The helper that draws the lessons' diagrams: its output is readable, and unreadable drawings are refused."""
# Builds: nothing
import pathlib
import sys
import unittest
import xml.etree.ElementTree as xml

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "docs" / "figures"))
import drawing  # noqa: E402


def luminance(color: str) -> float:
    """WCAG 2.1's relative luminance of #rrggbb."""
    def linear(code):
        return code / 12.92 if code <= 0.04045 else ((code + 0.055) / 1.055) ** 2.4
    red, green, blue = (linear(int(color[i:i + 2], 16) / 255) for i in (1, 3, 5))
    return 0.2126 * red + 0.7152 * green + 0.0722 * blue


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

    def test_the_text_is_well_formed_and_says_what_it_shows(self):
        self.panel.arrow((0, 0), (1, 1), drawing.NORMAL, "*n*_{i} < 1^{2} & x_y")
        self.panel.arc((0, 0), 1, 0, 40, "θ", arrow=True)
        root = xml.fromstring(self.drawing.svg())
        self.assertEqual(root.find("{*}title").text, "a < b & c")
        labels = ["".join(text.itertext()).replace("\u200b", "") for text in root.iter("{http://www.w3.org/2000/svg}text")]
        self.assertEqual(labels, ["ni < 12 & x_y", "θ"])

    def test_y_is_up_and_the_scale_is_pixels_for_a_unit(self):
        self.assertEqual(self.panel.pixel((0, 0)), (200, 200))
        self.assertEqual(self.panel.pixel((1, 2)), (250, 100))
        x, y = drawing.polar(2, 90)
        self.assertAlmostEqual(x, 0)
        self.assertAlmostEqual(y, 2)

    def test_colours_of_text_stand_out_from_the_background(self):
        background = luminance(drawing.BACKGROUND)
        for name in ("INK", "GREY", "BLUE", "RED", "GREEN", "ORANGE", "PURPLE"):
            contrast = (background + 0.05) / (luminance(getattr(drawing, name)) + 0.05)
            self.assertGreater(contrast, 4.5, name)  # WCAG 2.1, 1.4.3
