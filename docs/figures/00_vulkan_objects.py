"""Vulkan's objects and what each is made from.

python3 docs/figures/00_vulkan_objects.py writes docs/images/00_vulkan_objects.svg.
"""

from drawing import BLUE, GREEN, GREY, INK, ORANGE, PALE_BLUE, PALE_GREEN, PALE_GREY, PALE_ORANGE, PURPLE, SMALL, THIN, Drawing

BOXES = {  # name: (left, bottom, width, colour, fill)
    "instance": (20, 330, 130, INK, PALE_GREY), "physical device": (190, 330, 170, INK, PALE_GREY), "device": (400, 330, 110, INK, PALE_GREY),
    "queue": (800, 330, 100, INK, PALE_GREY),
    "buffer": (20, 220, 110, BLUE, PALE_BLUE), "memory": (160, 220, 110, BLUE, PALE_BLUE), "image": (300, 220, 100, BLUE, PALE_BLUE),
    "image view": (430, 220, 130, BLUE, PALE_BLUE),
    "command pool": (600, 220, 160, ORANGE, PALE_ORANGE), "semaphore, fence": (790, 220, 190, PURPLE, PALE_GREY),
    "shader modules": (20, 110, 160, GREEN, PALE_GREEN), "pipeline layout": (210, 110, 160, GREEN, PALE_GREEN),
    "pipeline": (400, 110, 110, GREEN, PALE_GREEN),
    "command buffer": (590, 110, 180, ORANGE, PALE_ORANGE), "submission": (820, 110, 130, ORANGE, PALE_ORANGE),
}
ARROWS = [("instance", "physical device"), ("physical device", "device"), ("device", "queue"), ("memory", "buffer"), ("memory", "image"),
          ("image", "image view"), ("shader modules", "pipeline layout"), ("pipeline layout", "pipeline"), ("command pool", "command buffer"),
          ("pipeline", "command buffer"), ("command buffer", "submission"), ("semaphore, fence", "submission"), ("image view", "command buffer")]
HIGH = 44


def draw() -> Drawing:
    drawing = Drawing(1000, 410, "Instance, physical device, device and queue; memory, buffers, images and views; shaders, layout and pipeline; a pool, "
                                 "its command buffer, and a submission with semaphores and a fence")
    p = drawing.panel((0, 0), 1)
    for name, (left, bottom, width, color, fill) in BOXES.items():
        p.box((left, bottom), (left + width, bottom + HIGH), color, THIN, fill=fill)
        p.text((left + width / 2, bottom + HIGH / 2), name, color, SMALL, rim=False)

    def side(name: str, other: str):
        left, bottom, width, *_ = BOXES[name]
        x, y = BOXES[other][0] + BOXES[other][2] / 2, BOXES[other][1]
        if y == bottom:
            return (left if x < left else left + width), bottom + HIGH / 2
        return min(max(x, left + 14), left + width - 14), bottom if y < bottom else bottom + HIGH

    for a, b in ARROWS:
        p.arrow(side(a, b), side(b, a), GREY, width=THIN)
    p.text((500, 50), "The device makes everything below the first row. An arrow: is made from, or uses.", INK, SMALL)
    return drawing


if __name__ == "__main__":
    draw().write(__file__)
