"""Classes are small: at most 25 functions and 8 members that are state. Knobs, modules and pipelines are declarations and
do not count, nor do records, which have at most one function. Larger ones are listed with a reason, and may hardly
grow."""
# Builds: nothing
import re
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
FUNCTIONS, MEMBERS, ROOM = 25, 8, 2
TARGETS = "one member for each target and table that its passes share"
COMPOSED = "a composition: one member for each module and drawing"
# Class: (functions, members, reason).
LARGER = {
    "Document": (39, 13, "the edits of a document: each is a step that can be undone"),
    "Frame": (35, 29, "what one command buffer records, and its pools"),
    "Window": (22, 38, "the loop of a window: the chapter's clock, its picture, its files"),
    "Scene": (32, 25, "what shaders and drawings ask of a scene"),
    "Editor": (27, 19, "a document and what it means for a chapter"),
    "Skin": (27, 18, TARGETS), "FilmWindow": (27, 9, "each key of a film's window"), "Shadow": (21, 14, TARGETS),
    "EditorWindow": (21, 12, "it places panels: one member each"), "Pass": (21, 15, "what a pass binds, and what it has bound"),
    "Mlaa": (20, 14, TARGETS), "Device": (19, 22, "Vulkan's handles and limits"), "Atmosphere": (19, 16, TARGETS),
    "Image": (17, 12, "an image and its views"), "Ground": (18, 10, TARGETS), "Water": (14, 13, TARGETS), "Volume": (15, 13, TARGETS),
    "Swapchain": (13, 14, "Vulkan's handles"), "Planets": (13, 13, TARGETS), "Terrain": (13, 10, TARGETS),
    "NeedPictures": (12, 21, "what one measurement has drawn"), "ImageLight": (11, 9, TARGETS), "Land": (14, 12, TARGETS),
    "GizmoDrag": (12, 13, "where a drag began, and where it is"),
    "SplitView": (11, 11, "the second chapter and its picture"), "City": (13, 9, TARGETS),
    "CameraPath": (11, 9, "a spline and its lengths"), "SceneRays": (10, 11, TARGETS),
    "SceneStore": (17, 9, "what is saved of a document, and beside it"), "LightVolumes": (3, 9, TARGETS),
    "Module": (27, 6, "the life of a module, which a chapter folds over"), "Canvas": (20, 10, "targets, and what has happened to them"),
    "Chapter": (9, 9, "the root: scene, camera, commands"), "TextureMap": (2, 12, "one member for each key of a scene file"),
    "Buffer": (7, 9, "Vulkan's handles"), "ReflectedRays": (3, 11, TARGETS), "Unwrapped": (3, 11, TARGETS),
    "BuiltPipeline": (3, 9, "Vulkan's handles"), "FileBrowser": (2, 10, "a list, its filter and its marks")}

HEAD = re.compile(r"\b(?:class|struct)\s+(\w+)(?:\s+final)?\s*(?::[^;{]*)?\{")
DECLARED = re.compile(r"^(?:static|constexpr)\b|^(?:(?:inline|mutable|const)\s+)*(?:Choice|Knob<[^>]*>|Pipeline|SurfacePipelines)(?!\w)")
NO_MEMBER = re.compile(r"(?:using|friend|typedef|enum|static_assert|class|struct|template\s*<[^>]*>\s*(?:class|struct))\b")
BRACES, OWNED = "\x01", "\x02"  # for all that stands between two; of a member that registers with its class


def bare(text: str) -> str:
    """Without comments, strings and directives."""
    text = re.sub(r"//[^\n]*|/\*.*?\*/", "", text, flags=re.S)
    text = re.sub(r"\"(?:\\.|[^\"\\])*\"|'(?:\\.|[^'\\])'", '""', text)
    return re.sub(r"(?m)^\s*#.*$", "", text)


def body(text: str, at: int) -> str:
    """From an opening brace to its closing one, without the contents of deeper braces."""
    out, depth = "", 1
    for letter in re.sub(r"\{\s*\*this\b", "{" + OWNED, text[at:]):
        depth += {"{": 1, "}": -1}.get(letter, 0)
        if not depth:
            break
        out += BRACES if letter == "}" else letter if depth == 1 or letter == OWNED else ""
    return re.sub(r"\b(?:public|private|protected)\s*:", "", out)


def measure(text: str) -> tuple[int, int]:
    """(functions, members) of a class's body."""
    functions = members = 0
    for statement in re.split(rf";|(?<={BRACES})(?=\s*(?:[A-Z~\w:<]|\[\[))", text):
        statement = statement.strip()
        if not statement or NO_MEMBER.match(statement):
            members += bool(re.match(rf"(?:struct|class)\b[^{BRACES}]*{BRACES}\s*\w", statement))
            continue
        head = statement if "operator" in statement else re.sub(r"=[^,]*", "", re.sub(r"\([^()]*\)", "()", statement), flags=re.S)
        while (plain := re.sub(r"<[^<>]*>", "", head)) != head:
            head = plain
        if "(" in plain:
            functions += 1
        elif OWNED not in statement and not DECLARED.match(statement):
            members += 1 + plain.count(",")
    return functions, members


def classes(paths) -> dict[str, tuple[int, int, str]]:
    found = {}
    for path in paths:
        text = bare(path.read_text())
        for head in HEAD.finditer(text):
            functions, members = measure(body(text, head.end()))
            if functions > 1 and (functions, members) > found.get(head[1], (0, 0))[:2]:
                found[head[1]] = functions, members, str(path.relative_to(ROOT))
    return found


class Classes(unittest.TestCase):
    def test_they_are_small(self):
        headers = sorted([*ROOT.glob("common/*/*.h"), *ROOT.glob("chapters/*/*.h"), *ROOT.glob("chapters/*/main.cpp")])
        for name, (functions, members, path) in classes(headers).items():
            most_functions, most_members, _ = LARGER.get(name, (FUNCTIONS, MEMBERS, ""))
            with self.subTest(name=name, path=path):
                room = ROOM if name in LARGER else 0
                self.assertLessEqual(functions, max(most_functions + room, FUNCTIONS), "functions: split it, or say why not")
                self.assertLessEqual(members, max(most_members + room, MEMBERS), "members: split it, or say why not")

    def test_what_is_listed_is_large(self):
        headers = [*ROOT.glob("common/*/*.h"), *ROOT.glob("chapters/*/*.h"), *ROOT.glob("chapters/*/main.cpp")]
        found = classes(headers)
        small = [name for name in LARGER if name in found and found[name][0] <= FUNCTIONS and found[name][1] <= MEMBERS]
        self.assertEqual(small, [], "they have become small: take them off the list")

    def test_what_counts(self):
        text = bare("""class One : Base {
          public:
            One(int a, float b = f(2)) : a_(a) { if (a) { g(); } }
            void h() const;  // not this();
            std::function<void(int)> told;
            Shadow shadow{*this, "shadow"};
            Choice method{*this, "method", {"a", "b"}, "a", "which"};
            static constexpr int most = 3;
          private:
            struct Two { int x, y; };
            int a_ = 0, b_ = 1;
            std::map<int, std::pair<int, int>> c_;
            bool operator==(const One&) const = default;
        };""")
        self.assertEqual(measure(body(text, HEAD.search(text).end())), (3, 4))


if __name__ == "__main__":
    unittest.main()
