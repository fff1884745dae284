"""How the report shows a picture and its error: a slider between expected and actual, the heat map, the figures."""

import json
from html import escape
from pathlib import Path

from page import data_uri
from tree import ROOT

# Magma, as heat maps have it (common/measure/flip.h), for their scale.
MAGMA = "#000004,#0a0822,#1d1146,#36106a,#50127c,#691c81,#822681,#9c2e7f,#b63779,#cf4170,#e65164,#f5695c,#fb8761," \
        "#fea571,#fec387,#fde0a2,#fcfdbf"

STYLE = """
.pair { display: grid; grid-template-columns: 1fr 1fr; gap: 14px; margin: 10px 0 4px; }
@media (max-width: 820px) { .pair { grid-template-columns: 1fr; } }
figure { margin: 0; }
figcaption { font-size: 13.5px; color: var(--quiet); display: flex; justify-content: space-between; gap: 10px;
  margin-top: 4px; }
.slide { position: relative; --at: 50%; border-radius: 6px; overflow: hidden; }
.slide img { width: 100%; }
.slide img + img { position: absolute; inset: 0; height: 100%; clip-path: inset(0 0 0 var(--at)); }
.slide::after { content: ""; position: absolute; inset: 0 auto 0 var(--at); width: 2px; margin-left: -1px;
  background: #fff; box-shadow: 0 0 0 1px #0008; pointer-events: none; }
.slide input { position: absolute; inset: 0; width: 100%; height: 100%; margin: 0; opacity: 0; cursor: ew-resize; }
.slide:has(input:focus-visible) { outline: 3px solid var(--accent); outline-offset: 2px; }
.heat figcaption { justify-content: flex-start; }
.heat img { width: 100%; border-radius: 6px; }
.scale { flex: 1; max-width: 180px; height: 9px; margin-top: 6px; border-radius: 3px;
  background: linear-gradient(90deg, MAGMA); }
.same, .missing { display: grid; place-items: center; text-align: center; min-height: 160px; height: calc(100% - 26px);
  border: 1px dashed var(--line); border-radius: 6px; color: var(--quiet); padding: 10px; }
.paper { background: #fff; border-radius: 6px; padding: 8px; }
.figures { font-size: 14.5px; display: flex; flex-wrap: wrap; gap: 2px 22px; font-variant-numeric: tabular-nums; }
.figures .over { color: var(--bad); font-weight: 600; }
""".replace("MAGMA", MAGMA)

SCRIPT = """
for (const image of document.querySelectorAll("img[data-same]"))
  image.src = document.getElementById(image.dataset.same).src;
for (const slide of document.querySelectorAll(".slide")) {
  const range = slide.querySelector("input");
  const move = () => slide.style.setProperty("--at", range.value + "%");
  range.addEventListener("input", move);
  move();
}
"""

FIGURES = (("flip_mean", "FLIP mean", lambda m: m["flip"]["mean"]),
           ("flip_p99", "p99", lambda m: m["flip"]["p99"]),
           ("max_diff", "largest step", lambda m: m["max_diff"]["steps"]))


class Pictures:
    """Embeds pictures, each under an id of its own."""

    def __init__(self):
        self.count = 0

    def image(self, path: str | None, alt: str, lossless: bool) -> tuple[str, str]:
        """(an img element or a box that says what is missing, the image's id or "")."""
        try:
            if not path:
                raise OSError("there is none")
            uri = data_uri(ROOT / path, lossless)
        except OSError as error:
            return f'<div class="missing"><p>{escape(alt)}: {escape(str(error))}</p></div>', ""
        self.count += 1
        name = f"picture{self.count}"
        return f'<img id="{name}" src="{uri}" alt="{escape(alt)}">', name

    def comparison(self, picture: dict, lossless: bool) -> str:
        """Expected and actual under a slider, and the heat map beside them. Equal pictures are embedded once."""
        metrics, name = picture.get("metrics"), picture["name"]
        equal = bool(metrics) and metrics["max_diff"]["steps"] == 0
        expected, expected_id = self.image(picture.get("expected"), f"{name}, expected", lossless)
        if equal and expected_id:
            actual, actual_id = (f'<img data-same="{expected_id}" alt="{escape(name)}, actual">',
                                 expected_id)
        else:
            actual, actual_id = self.image(picture.get("actual"), f"{name}, actual", lossless)
        if not expected_id or not actual_id:
            return (f'<div class="pair"><figure>{expected}<figcaption>expected</figcaption></figure>'
                    f"<figure>{actual}<figcaption>actual</figcaption></figure></div>\n")
        label = f"{escape(name)}: expected left of the divider, actual right of it"
        slide = (f'<figure><div class="slide">{expected}{actual}<input type="range" min="0" max="100" value="50" '
                 f'aria-label="{label}"></div><figcaption><span>expected</span><span>drag, or arrow keys</span>'
                 "<span>actual</span></figcaption></figure>")
        return f'<div class="pair">{slide}{self.heat(picture, equal, lossless)}</div>\n'

    def heat(self, picture: dict, equal: bool, lossless: bool) -> str:
        if equal:
            return '<figure class="heat"><div class="same">no pixel differs</div></figure>'
        image, found = self.image(picture.get("heatmap"), f"{picture['name']}, FLIP error", lossless)
        scale = '<figcaption><span>FLIP error 0</span><span class="scale"></span><span>1</span></figcaption>'
        return f'<figure class="heat">{image}{scale if found else ""}</figure>'


def figures_line(metrics: dict | None, limits: dict, reject: bool = False) -> str:
    """The figures beside their limits. What is over a limit stands out, unless the picture is to be rejected."""
    if not metrics:
        return ""
    parts = []
    for key, label, value_of in FIGURES:
        value, limit = value_of(metrics), limits.get(key)
        over = limit is not None and not value <= limit and not reject
        most = "" if limit is None else f' <span class="quiet">(at most {limit:g})</span>'
        parts.append(f'<span{" class=over" if over else ""}>{label} {value:.4g}{most}</span>')
    for kind in ("nan", "inf"):
        if metrics[kind]["test"]:
            parts.append(f'<span class="over">{metrics[kind]["test"]} {kind} pixels</span>')
    return f'<div class="figures">{"".join(parts)}</div>\n'


def read_result(path: Path) -> dict:
    """A result file, or a failed result that says why it cannot be read: the report must not lose it."""
    try:
        result = json.loads(path.read_text(encoding="utf-8"))
        if not isinstance(result, dict) or "kind" not in result or "chapter" not in result:
            raise ValueError('it needs "kind" and "chapter"')
        return result
    except (OSError, ValueError) as error:
        return {"kind": "unreadable", "chapter": "tests", "name": path.name, "ok": False,
                "why": [f"{path.name} cannot be used: {error}"]}
