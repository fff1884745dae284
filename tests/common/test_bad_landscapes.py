"""Height maps, waves, sounds and environments that are wrong: one line that says so, exit code 2, nothing left behind."""
import json
import re
import struct
import unittest
import zlib

from bad_input import ROOT, BadInput, png, radiance


def png_header(width, height) -> bytes:
    """A grey PNG of 16 bits that promises so many samples and holds a few."""
    def chunk(kind, data):
        return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))
    return b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", struct.pack(">IIBBBBB", width, height, 16, 0, 0, 0, 0)) + \
        chunk(b"IDAT", zlib.compress(bytes(64))) + chunk(b"IEND", b"")


class Landscapes(BadInput):
    def test_height_maps_that_are_none(self):
        maps = {"colour": (png(), "3 channels"), "pixel": (png((1, 1), "L"), "at least 2x2"),
                "line": (png((64, 1), "L"), "at least 2x2"), "huge": (png_header(100000, 100000), ""),
                "cut": (png(mode="L")[:900], ""), "short": (png_header(64, 64), ""), "empty": (b"", ""),
                "text": (b"heights\n", "")}
        for name, (content, why) in maps.items():
            file = self.write(f"{name}.png", content)
            self.draw("15", "--scene", file, says=rf"{name}\.png: .*{why}")
            scene = self.scene(f"{name}.json", objects=[{"name": "ground", "model": str(file)}])
            self.draw("15", "--scene", scene, says=rf"{name}\.png: .*{why}")

    def test_what_stands_beside_a_height_map(self):
        file = self.write("hills.png", png(mode="L"))
        for text in ("metres", "[]", '{"max_elevation_m": "high"}', '{"metres_per_sample_x": 0}',
                     '{"min_elevation_m": 9, "max_elevation_m": 3}', '{"metres_per_sample_y": 1e400}'):
            self.write("hills.json", text)
            self.draw("15", "--scene", file, says=r"hills\.json: ")

    def test_waves_of_no_length(self):
        for name, value in (("longest_m", 0), ("shortest_m", 0), ("longest_m", -3), ("longest_m", "nan"),
                            ("shortest_m", "inf"), ("waves", 1), ("waves", 17), ("slope", -1)):
            self.draw("15", "--set", f"water.{name}={value}", says=rf"water\.{name}")
        self.draw("15", "--scene", "scenes/open_sea.json", "--set", "water.shortest_m=30", says=r"water\.shortest_m: 30 m")
        scene = self.scene("still.json", knobs={"water.longest_m": 0})
        self.draw("15", "--scene", scene, says=r"water\.longest_m=0")

    def test_a_sound_that_is_none_or_ends_in_its_middle(self):
        whole = (ROOT / "assets/audio/beat.ogg").read_bytes()
        beat = json.loads((ROOT / "assets/scenes/beat.json").read_text())
        for name, content, why in (("cut", whole[:len(whole) // 2], "ends in the middle"), ("head", whole[:60], ""),
                                   ("none", b"", ""), ("picture", png(), "expected Ogg Vorbis")):
            file = self.write(f"{name}.ogg", content)
            self.draw("14", "--scene", self.scene(f"{name}.json", **{**beat, "music": str(file)}),
                      says=rf"{name}\.ogg.*{why}")

    def test_an_environment_of_the_wrong_shape(self):
        for name, size in (("square", (64, 64)), ("tall", (32, 64)), ("column", (1, 64))):
            file = self.write(f"{name}.hdr", radiance(*size) if size[0] > 8 else png(size))
            self.draw("14", "--scene", self.scene(f"{name}.json", environment={"image": str(file)}),
                      says=re.escape(f"{name}.hdr"))


if __name__ == "__main__":
    unittest.main()
