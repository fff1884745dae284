"""A scene's figures in chapter 19's --benchmark, as text for tables."""


def cells_of(system: dict, name: str) -> list[str]:
    scene = next((one for one in system["scenes"] if one["name"] == name), None)
    if scene is None:
        return [""] * 5
    off, on = scene["gpu_sum"]["none"], scene["gpu_sum"]["mlaa"]
    cut = next((one for one in system.get("cuts", []) if one["to"] == scene["name"]), None)
    played = "mean_ms" in scene  # else measured by an earlier version, warm alone
    return [f"{scene['mean_ms']:.2f}" if played else "–", f"{cut['longest_ms'] / cut['mean_ms']:.2f}" if cut else "–",
            f"{(scene if played else on)['processor_ms']:.2f}", f"{on['mean_ms']:.2f}", f"{on['mean_ms'] - off['mean_ms']:.2f}"]
