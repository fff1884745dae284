"""States of a page's pictures: the knobs and values that a text means, and the pictures that show them."""
# Builds: nothing

import unittest
from unittest import mock

from pages import drawn_pictures, knob_links, states

KNOBS = [
    {"name": "shadow.method", "type": "choice", "options": ["none", "hard", "pcf"], "default": "pcf", "help": "Filter", "alone": True},
    {"name": "maps.method", "type": "choice", "options": ["flat", "relief", "none"], "default": "relief", "help": "Bumps"},
    {"name": "shadow.bias_m", "type": "number", "range": [0, 1], "default": 0.01, "help": "Bias"},
    {"name": "shadow.snap", "type": "switch", "default": "on", "help": "Snap"},
]


def image(shot: str) -> str:
    return f'<p><img alt="" src="tree/tests/05_shadow_maps/golden/{shot}.png"></p>'


def found(page: str) -> list[tuple]:
    return [(knob["name"], value) for _, knob, value in knob_links.Marks(f"<article>{page}</article>", KNOBS).found]


class Names(unittest.TestCase):
    def test_a_name_means_the_knob_that_set_takes(self):
        self.assertEqual(found("<p><code>method</code> <code>bias_m</code> <code>maps.method</code></p>"),
                         [("shadow.method", None), ("shadow.bias_m", None), ("maps.method", None)])

    def test_a_value_belongs_to_the_knob_before_it_in_its_block(self):
        self.assertEqual(found("<p><code>maps.method</code> is <code>none</code></p><p><code>none</code></p>"),
                         [("maps.method", None), ("maps.method", "none")])
        self.assertEqual(found("<p>With <code>bias_m</code> at <code>0.5</code></p>"), [("shadow.bias_m", None), ("shadow.bias_m", "0.5")])

    def test_an_option_of_one_knob_alone_needs_no_name(self):
        self.assertEqual(found("<li><code>hard</code> and <code>flat</code></li>"), [("shadow.method", "hard"), ("maps.method", "flat")])

    def test_a_value_is_given_as_on_the_command_line(self):
        self.assertEqual(found("<p><code>--set bias_m=0.2</code> <code>snap = off</code></p>"), [("shadow.bias_m", "0.2"), ("shadow.snap", "off")])

    def test_code_links_and_headings_are_left_alone(self):
        self.assertEqual(found("<h2><code>method</code></h2><p><a href=''><code>method</code></a></p><pre><code>method</code></pre><code>method</code>"), [])

    def test_a_mark_is_in_the_page(self):
        page = knob_links.marked("<article><p>a &amp; <code>hard</code> <b><code>x</code></b></p></article>", KNOBS)
        self.assertEqual(page, '<article><p>a &amp; <code data-knob="shadow.method" data-value="hard">hard</code> <b><code>x</code></b></p></article>')


class Plans(unittest.TestCase):
    def planned(self, page: str) -> dict:
        with mock.patch.object(states, "shot_of", lambda chapter, shot: {"set": {"method": "hard"}} if shot == "acne" else {}):
            plan = {}
            for shot, knob, value in states.planned(f"<article>{page}</article>", "05_shadow_maps", KNOBS):
                plan.setdefault(shot, {}).setdefault(knob, []).append(value)
            return plan

    def test_a_value_goes_to_the_picture_above_it(self):
        page = image("a") + "<p><code>hard</code></p>" + image("b") + "<p><code>flat</code></p>"
        plan = self.planned(page)
        self.assertEqual(list(plan["a"])[0], "shadow.method")
        self.assertEqual(list(plan["b"])[0], "maps.method")

    def test_a_picture_is_no_state_of_its_own(self):
        self.assertEqual(self.planned(image("acne") + "<p><code>hard</code> <code>pcf</code></p>"), {"acne": {"shadow.method": ["pcf"]}})

    def test_a_name_alone_brings_all_options_and_numbers_around(self):
        plan = self.planned(image("a") + "<p><code>method</code> and <code>bias_m</code></p>")
        self.assertEqual(plan["a"], {"shadow.method": ["none", "hard"], "shadow.bias_m": ["0.0025", "0.04"]})

    def test_at_most_eight(self):
        text = "".join(f"<p><code>bias_m={number / 100}</code></p>" for number in range(2, 30))
        for values in self.planned(image("a") + image("b") + text).values():
            self.assertEqual(sum(map(len, values.values())), 8)

    def test_another_place_counts_as_the_same_shot(self):
        plan = self.planned(image("a") + "<p><code>hard</code></p>" + image("a") + "<p><code>method=none</code></p>")
        self.assertEqual(plan, {"a": {"shadow.method": ["hard", "none"]}})


class Kept(unittest.TestCase):
    def test_a_file_is_named_for_all_that_decides_it(self):
        one = states.state("02_lambert_phong", "teapot", "method", "phong")
        self.assertEqual(one.words[-2:], ("--set", "method=phong"))
        self.assertNotEqual(one.file(), states.state("02_lambert_phong", "teapot", "method", "gouraud").file())
        with mock.patch.object(drawn_pictures, "version", lambda chapter: "another source"):
            again = drawn_pictures.Picture(one.chapter, one.name, one.words)
            self.assertEqual(again, one)
            self.assertNotEqual(drawn_pictures.Picture.file.__wrapped__(again), one.file())

    def test_lessons_have_sixteen_samples_but_where_one_is_the_subject(self):
        self.assertIn("16", drawn_pictures.fine("02_lambert_phong", "teapot").words)
        self.assertIn("1", drawn_pictures.fine("13_mlaa", "city").words)
