"""Where the widgets of a frame stand, and what is wrong with that: cut texts, overlaps, texts too small to read."""
from dataclasses import dataclass

LEAST_TEXT_PX = 13  # beside a scale of 1
# Pixels beside a scale of 1 by which Dear ImGui lets headers and rows of lists reach over the ends of their panel.
OVERHANG_PX = dict.fromkeys(("section", "knobs"), 6) | dict.fromkeys(("entry", "file", "thumbnail", "step", "option", "menu", "recent"), 4)
# These lie on others on purpose: (what lies, on what).
ON_OTHERS = {("eye", "entry"), ("thumbnail", "file"), ("lesson", "chapter"), ("verdict", "exercise")}

HEADINGS = ("section", "knobs", "module")


@dataclass(frozen=True)
class Widget:
    """Pixels of the window. `room_left`, `room_right`: the part of its panel that widgets may fill."""
    name: str
    panel: str
    left: int
    top: int
    right: int
    bottom: int
    room_left: int
    room_right: int
    text_width: int
    text_px: int
    text: str

    @classmethod
    def read(cls, line: str) -> "Widget":
        name, panel, *numbers, text = line.rstrip("\n").split("\t")
        return cls(name, panel, *map(int, numbers), text)

    @property
    def kind(self) -> str:
        return self.name.split(".")[0]

    def overlaps(self, other: "Widget") -> bool:
        return (self.panel == other.panel and min(self.right, other.right) - max(self.left, other.left) > 1
                and min(self.bottom, other.bottom) - max(self.top, other.top) > 1)


def faults(layout: list[Widget], scale: float) -> list[str]:
    """One line each; panels that scroll sideways, as the graph of passes does, may reach beyond their ends."""
    found = []
    for one in layout:
        over = OVERHANG_PX.get(one.kind, 0) * scale + 1
        if one.panel != "passes" and (one.left < one.room_left - over or one.right > one.room_right + over):
            found.append(f"{one.name}: from {one.left} to {one.right}, its panel from {one.room_left} to {one.room_right}")
        if one.text_width > one.right - one.left + 1:  # both are rounded
            found.append(f"{one.name}: {one.text_width} pixels of text in {one.right - one.left}")
        if one.text_px < LEAST_TEXT_PX * scale:
            found.append(f"{one.name}: text of {one.text_px} pixels at a scale of {scale}")
    found += called_alike(layout)
    for i, one in enumerate(layout):
        for other in layout[:i]:
            if {one.kind, other.kind} == {"eye", "entry"} and one.overlaps(other):
                eye, entry = (one, other) if one.kind == "eye" else (other, one)
                if entry.left + entry.text_width > eye.left:
                    found.append(f"{entry.name}: {entry.text_width} pixels of text reach under {eye.name}")
            if one.overlaps(other) and not {(one.kind, other.kind), (other.kind, one.kind)} & ON_OTHERS:
                found.append(f"{one.name} lies on {other.name}")
    return found


def called_alike(layout: list[Widget]) -> list[str]:
    """Labels that occur twice under one heading of a panel, or anywhere below the fields before the first heading."""
    found, first, under = [], {}, {}
    for one in layout:
        if one.kind in HEADINGS:
            first.setdefault(one.panel, under.get(one.panel, set()))
            under[one.panel] = set()
        if one.kind == "label":
            before = under.setdefault(one.panel, set())
            if one.text in before | first.get(one.panel, set()):
                found.append(f"{one.name}: another field is called '{one.text}'")
            before.add(one.text)
    return found
