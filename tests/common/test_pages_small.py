"""Tests of ./course docs on a small course: what it says is wrong, what a lesson may contain."""

import os
import shutil
import unittest

from browser import WHY_NONE, Browser
from PIL import Image
from small_course import Course
from test_pages import BROKEN, LEFT_OVER, UNSET

LESSON = """# 01 The first lesson

A paragraph with $x_1^2$ and `$code$`, and [the next](02_lambert.md#two), and [a source](../chapters/01_obj/main.cpp).

```math
\\frac{a}{b} = \\begin{cases} 1 & a > 0 \\\\ 0 \\end{cases}
```

<!-- compare -->
| flat | bumpy |
|---|---|
| ![A flat wall](images/a.png) | ![A bumpy wall](../tests/01_obj/b.png) |

*One wall twice.*

<!-- quote: chapters/01_obj/main.cpp#frame -->
```cpp
draw();
    twice();
```

<details>
<summary>What is `1 + 1`?</summary>

Two, and **not** $3$:

```glsl
vec3 two = vec3(2.0);
```

- so it is

</details>

1. A question
   of two lines?

   <details><summary>The "answer" to $x$</summary>

   - in a list,

     ```cpp
     int deep = 1;
     ```
   </details>
2. Another, without a line between.
   <details><summary>Folded</summary>

   too
   </details>

### 01.one (easy)

![A diagram](figure.svg)
"""


class SmallCourse(Course):
    def setUp(self):
        self.put("docs/01_obj.md", LESSON)
        self.put("README.md", "# The course\n\n[a folder](tests/01_obj)\n")
        self.put("docs/study_format.md", "# The format\n")
        self.put("docs/figure.svg", '<svg xmlns="http://www.w3.org/2000/svg" width="20" height="20"><circle r="9"/></svg>')
        for name, color in (("docs/images/a.png", "#775533"), ("tests/01_obj/b.png", "#335577")):
            self.put(name)
            Image.new("RGB", (320, 180), color).save(self.root / name)
        self.site = self.root / "build/docs"

    def test_it_says_how_many_and_what_is_wrong(self):
        self.assertRegex(self.course("docs"), r"\Abuild/docs/index.html: \d+ pages in \d+\.\d s\n\Z")
        whole = (self.site / "01_obj.html").read_bytes()
        for text, says in (("# One\n\n![x](none.png)\n", "docs/01_obj.md:3: there is no docs/none.png"),
                           ("# One\n\n<!-- compare -->\n| a | b |\n|---|---|\n| a | b |\n",
                            "docs/01_obj.md:3: after <!-- compare --> comes a table of two names over two pictures")):
            self.put("docs/01_obj.md", text)
            self.assertIn(says, self.course("docs", code=1))
            self.assertEqual((self.site / "01_obj.html").read_bytes(), whole, "what was there did not stay")
        self.assertEqual([path.name for path in (self.root / "build").glob(".docs*")], [])

    def test_open_says_what_is_missing(self):
        self.put("bin/xdg-open", "#!/bin/sh\ntest -f \"$1\" && echo $1 > $(dirname $0)/opened\n")
        opener = self.root / "bin/xdg-open"
        self.addCleanup(lambda: (self.root / "bin/opened").unlink(missing_ok=True))
        self.course("docs", "--open", PATH=f"{opener.parent}:{os.environ['PATH']}")
        self.assertEqual((self.root / "bin/opened").read_text().strip(), str(self.site / "index.html"))
        opener.write_text("#!/bin/sh\nexit 3\n")
        self.assertIn("xdg-open could not show", self.course("docs", "--open", code=1,
                                                             PATH=f"{opener.parent}:{os.environ['PATH']}"))

    def test_the_gallery_links_the_page(self):
        shutil.rmtree(self.site, ignore_errors=True)
        self.course("run")
        self.assertIn('href="../../docs/01_obj.md"', (self.root / "build/gallery/index.html").read_text())
        self.course("docs")
        self.course("run")
        self.assertIn('href="../docs/01_obj.html"', (self.root / "build/gallery/index.html").read_text())

    @unittest.skipIf(WHY_NONE, WHY_NONE)
    def test_what_a_lesson_may_contain(self):
        self.course("docs")
        with Browser(webgl=True) as browser:
            browser.open(self.site / "01_obj.html")
            self.assertEqual([browser.evaluate(BROKEN), browser.evaluate(UNSET), browser.evaluate(LEFT_OVER)], [[], [], []])
            count = "document.querySelectorAll('article %s').length"
            for what, expected in ((".katex", 4), (".katex-display", 1), ("details .katex", 2), ("details .highlight .kt", 3),
                                   ("details li", 2), ("details > summary code", 1),
                                   ("ol", 1), ("ol > li", 2), ("ol details", 2), ("ol details ul .highlight", 1), ("ol summary .katex", 1), ("span.filename", 1), (".grade.easy", 1),
                                   ("figure.compare img", 2), (".highlight .n", 4)):
                self.assertEqual(browser.evaluate(count % what), expected, what)
            self.assertEqual(browser.evaluate("document.querySelector('code').textContent"), "$code$")
            self.slide(browser)
            browser.evaluate("document.querySelector('img[src$=\".svg\"]').click()")
            self.assertTrue(browser.evaluate("document.querySelector('dialog.large').open"))
            self.assertEqual(browser.complaints, [])

    def slide(self, browser: Browser):
        shown = "getComputedStyle(document.querySelector('.slide img + img')).clipPath"
        self.assertIn("50%", browser.evaluate(shown))
        browser.evaluate("document.querySelector('.slide').scrollIntoView({block: 'center', behavior: 'instant'})")
        x, y, width = browser.evaluate("(r => [r.x, r.y + r.height / 2, r.width])"
                                       "(document.querySelector('.slide').getBoundingClientRect())")
        browser.drag((x + width / 2, y), (x + width / 4, y))
        self.assertLess(abs(browser.evaluate("+document.querySelector('.slide input').value") - 25), 4)
        self.assertNotIn("50%", browser.evaluate(shown))
