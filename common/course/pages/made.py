"""The lessons' pictures that chapters draw beside their shots: docs/images/pictures.json (docs/images/make.py makes them)."""

import json

from tree import ROOT, Failure

LIST = ROOT / "docs" / "images" / "pictures.json"


def made() -> dict[str, dict]:
    try:
        return json.loads(LIST.read_text(encoding="utf-8")) if LIST.exists() else {}
    except ValueError as error:
        raise Failure(f"docs/images/{LIST.name} is not a list of pictures: {error}") from None


def cells(name: str) -> list[dict]:
    """The cells of a picture, each with all that holds for it: "chapter", "size" and "set", and "shot" or "scene" where
    it is not the chapter's own scene; "use", "samples", "crop" and "zoom" where they are not as usual."""
    picture = made()[name]
    common = {key: value for key, value in picture.items() if key not in ("cells", "columns", "set")}
    return [common | cell | {"set": picture.get("set", {}) | cell.get("set", {})} for cell in picture["cells"]]
