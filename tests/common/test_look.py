"""--look: a pass's output, without a window."""
# Builds: 06_deferred
import unittest

from PIL import Image

from bad_input import BUILD, BadInput

DEFERRED = BUILD / "chapters" / "06_deferred"


@unittest.skipUnless(DEFERRED.exists(), "chapter 06 is not built")
class LookedAt(BadInput):
    def draw(self, *options) -> Image.Image:
        done = self.run_program(DEFERRED, "--size", "96x54", "--method", "fat", *options, "--validate", "on", "--screenshot", self.picture)
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        return Image.open(self.picture).convert("RGB")

    def test_a_pass_an_image_of_it_and_the_picture_itself(self):
        picture = self.draw()
        self.assertEqual(self.draw("--look", "encode_srgb").tobytes(), picture.tobytes())
        first, second = self.draw("--look", "gbuffer"), self.draw("--look", "gbuffer: gbuffer diffuse")
        self.assertEqual(self.draw("--look", "gbuffer: gbuffer normal").tobytes(), first.tobytes())
        depth = self.draw("--look", "gbuffer depth")
        self.assertEqual(len({image.tobytes() for image in (picture, first, second, depth)}), 4)
        for image in (first, second, depth):
            self.assertGreater(len(image.getcolors(96 * 54)), 20)

    def test_a_pass_that_there_is_not(self):
        self.refuse(DEFERRED, "--size", "96x54", "--screenshot", self.picture, "--look", "gbufer",
                    says="gbufer.*'gbuffer', 'gbuffer depth'")
