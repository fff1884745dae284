"""Scene files that are wrong: one line with file, line and key, exit code 2, and nothing left behind."""
import json
import re
import unittest

from bad_input import CHAPTERS, BadInput, radiance


class Scenes(BadInput):
    def test_scene_files(self):
        cube = {"name": "cube", "model": "models/cube.obj"}
        scenes = {
            "syntax.json": ('{\n "objects": [\n  {"model": }\n ]\n}', r"syntax\.json:3"),
            "cut.json": ('{"objects": [{"model": "models/cube', r"cut\.json:1"),
            "empty.json": ("", r"empty\.json"),
            "binary.json": (bytes(range(256)), r"binary\.json"),
            "list.json": ("[]", "object"), "number.json": ("7", "object"),
            "deep.json": ('{"objects": ' + "[" * 100000, r"deep\.json"),
            "key.json": ({"objects": [cube], "camra": {}}, "camra.*known.*camera"),
            "inner_key.json": ({"objects": [cube | {"modle": 1}]}, "modle.*known.*model"),
            "type.json": ({"camera": {"position": "here"}}, "position.*three numbers"),
            "type_of_list.json": ({"objects": {}}, "objects.*list"),
            "type_of_name.json": ({"objects": [{"model": 7}]}, "model.*text"),
            "type_of_light.json": ({"objects": [cube], "lights": [{"type": "laser"}]}, "laser.*directional"),
            "type_of_maps.json": ({"objects": [cube | {"material": {"maps": {"diffuse": 7}}}]}, "diffuse"),
            "range.json": ({"objects": [cube], "camera": {"fov_deg": 200}}, "fov_deg.*170"),
            "huge.json": ('{"camera": {"far_m": 1e999}}', r"huge\.json"),
            "nan.json": ('{"camera": {"far_m": NaN}}', r"nan\.json:1"),
            "blind.json": ({"objects": [cube], "camera": {"position": [0, 0, 0], "target": [0, 0, 0]}}, "target"),
            "flat.json": ({"objects": [cube | {"scale": 0}]}, "scale"),
            "no_model.json": ({"objects": [{"model": "models/missing.obj"}]}, r"no_model\.json:1.*missing\.obj"),
            "no_map.json": ({"objects": [cube | {"material": {"maps": {"diffuse": "no.png"}}}]}, r"no\.png"),
            "slot.json": ({"objects": [cube | {"material": {"maps": {"colour": "models/smart_car_albedo.png"}}}]},
                          "colour.*diffuse"),
            "no_include.json": ({"include": ["missing.json"]}, r"missing\.json"),
            "cycle.json": ({"include": ["back.json"]}, "cycle"), "back.json": ({"include": ["cycle.json"]}, "cycle"),
            "self.json": ({"include": ["self.json"]}, "cycle"),
            "no_parent.json": ({"objects": [cube | {"parent": "nobody"}]}, "nobody"),
            "own_parent.json": ({"objects": [cube | {"parent": "cube"}]}, "cycle"),
            "parents.json": ({"objects": [cube | {"parent": "b"}, cube | {"name": "b", "parent": "cube"}]}, "cycle"),
            "twins.json": ({"objects": [cube, cube]}, "two objects"),
            "knob.json": ({"objects": [cube], "knobs": {"speed": 1}}, r"knob\.json: key 'knobs': unknown knob 'speed'; the nearest are"),
            "knob_value.json": ({"objects": [cube], "knobs": {"wrap": "much"}}, r"knob_value\.json: key 'knobs': wrap.*expected"),
            "knob_type.json": ({"objects": [cube], "knobs": {"wrap": [1]}}, "wrap.*expected"),
            "rough.json": ({"objects": [cube | {"material": {"roughness": 1.5}}]}, "roughness.*1.5.*0.*1"),
            "role.json": ({"objects": [cube | {"role": "moon"}]}, r"role\.json:1: key 'role' is 'moon', expected planet, ring"),
            "role_type.json": ({"objects": [cube | {"role": ["planet"]}]}, "key 'role' must be.*planet"),
            "role_group.json": ({"objects": [{"role": "ring"}]}, "key 'role'.*without a model"),
            "role_part.json": ({"objects": [cube | {"role": {"nose": "skin"}}]}, "key 'role' names 'nose'.*models/cube.obj"),
            "shows.json": ({"objects": [cube | {"role": "screen"}]}, "key 'shows' is missing"),
            "shows_none.json": ({"objects": [cube | {"role": "screen", "shows": "nobody"}]}, "'nobody'.*no object"),
            "metal.json": ({"objects": [cube | {"material": {"metalness": "much"}}]}, "metalness.*number"),
        }
        for name, (content, _) in scenes.items():
            self.write(name, json.dumps(content) if isinstance(content, dict) else content)
        for name, (_, says) in scenes.items():
            self.draw("02", "--scene", self.folder / name, says=says)

    def test_environments(self):
        """Some of these are found only when the image is read; the scene's line and key are named all the same."""
        cube = {"model": "models/cube.obj"}
        images = {"cut.hdr": radiance(64, 32)[:900], "zero.hdr": b"#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 0 +X 0\n",
                  "text.hdr": "no picture", "empty.hdr": b"", "square.hdr": radiance(64, 64), "wide.hdr": radiance(64, 8),
                  "cut.pfm": b"PF\n4 2\n-1.0\n"}
        for name, content in images.items():
            image = self.write(name, content)
            says = {"square.hdr": "64x64.*twice as wide", "wide.hdr": "64x8.*twice as wide"}.get(name, re.escape(name))
            for given, key in ((str(image), "environment"), ({"image": str(image)}, "image")):
                text = '{"objects": [%s],\n"environment": %s}' % (json.dumps(cube), json.dumps(given))
                self.draw("02", "--scene", self.write("scene.json", text), says=rf"scene\.json:2: key '{key}': .*" + says)
        self.write("folder.hdr/x", "")
        good = self.write("good.hdr", radiance(64, 32))
        for given, says in ((str(self.folder / "none.hdr"), r"key 'environment'.*none\.hdr"),
                            (str(self.folder / "folder.hdr"), r"key 'environment'.*folder\.hdr"),
                            ("models/cube.obj", r"key 'environment'.*\.hdr"), ("", r"key 'environment'.*\.hdr"),
                            (7, "key 'environment'.*object"), ({}, "key 'image' is missing"),
                            ({"image": 7}, "key 'image'.*text"),
                            ({"image": str(good), "intensity": -1}, "key 'intensity' is -1"),
                            ({"image": str(good), "turn": 1}, "key 'turn' is unknown")):
            self.draw("02", "--scene", self.scene("scene.json", objects=[cube], environment=given), says=says)
        for given in (str(good), {"image": str(good), "intensity": 0, "rotation_deg": 720}):
            scene = self.scene("scene.json", objects=[cube], environment=given)
            done = self.run_program(CHAPTERS["02"], "--size", "64x48", "--scene", scene, "--screenshot", self.picture)
            self.assertEqual((done.returncode, done.stderr), (0, ""))
            self.picture.unlink()

    def test_motions(self):
        wrong = {"{}": "key 'motion'", "7": "key 'motion'", '{"spin_deg_per_s": NaN}': r"scene\.json:1",
                 '{"spin_deg_per_s": 1e999}': r"scene\.json:1", '{"spin_deg_per_s": [1]}': "key 'spin_deg_per_s'",
                 '{"path": []}': "key 'path'", '{"path": [{"time_s": 1}, {"time_s": 1}]}': "key 'time_s'",
                 '{"path": [{"time_s": 1, "positon": [0, 0, 0]}]}': "positon.*known.*position"}
        for motion, says in wrong.items():
            scene = self.write("scene.json", '{"objects": [{"model": "models/cube.obj", "motion": %s}]}' % motion)
            self.draw("02", "--scene", scene, says=says)

    def test_lights(self):
        """Wrong values of a light, by the key that the error must name. NaN and infinities are no JSON."""
        wrong = {"intensity": ["-1", "-1e-9", "1000001", "1e300", "1e999", "-1e999", "NaN", "Infinity", '"bright"', "[1]"],
                 "range_m": ["-1", "1e7", "1e999", "NaN", "-Infinity"], "shadow": ["1", '"on"'],
                 "size_m": ["-1", "1e7", "NaN"], "softness": ["-0.1", "1.1", "NaN"],
                 "inner_deg": ["-1", "31", "181"], "outer_deg": ["-1", "19", "181", "1e999"],
                 "color": ["[1, 1]", "[1, 1, 2]", "[-1, 0, 0]", "[NaN, 0, 0]", "1"],
                 "position": ["[0, 0, 1e999]", "[0, Infinity, 0]", "0"], "direction": ["[0, 0, 0]", "[0, NaN, 1]"]}
        right = {"type": '"spot"', "inner_deg": "20", "outer_deg": "30"}
        for key, values in wrong.items():
            for number, value in enumerate(values):
                keys = ", ".join(f'"{name}": {text}' for name, text in (right | {key: value}).items())
                number_is_no_json = value.strip("[]-0, 1").startswith(("NaN", "Inf")) or "999" in value
                scene = self.write(f"{key}{number}.json", f'{{"lights": [\n{{{keys}}}]}}')
                self.draw("02", "--scene", scene,
                          says=rf"{key}{number}\.json:2" + ("" if number_is_no_json else ".*(inner_deg|" + key + ")"))
        for light in ('"type": "point", "softness": 1', '"type": "directional", "range_m": 3', '"type": "laser"',
                      '"type": "directional", "size_m": 1', '"type": "point", "size_deg": 1',
                      '"type": "spot", "tube_m": [1, 0, 0]', '"type": "point", "tube_m": 1', '"type": "point", "tube_m": [0, 0, 1e9]'):
            self.draw("02", "--scene", self.write("key.json", f'{{"lights": [\n{{{light}}}]}}'), says=r"key\.json:2")


if __name__ == "__main__":
    unittest.main()
