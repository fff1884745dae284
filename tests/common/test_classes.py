"""Classes are small: at most 25 functions and 8 members that are state. Knobs, modules and pipelines are declarations and do not
count, nor do names for another member's parts, nor records, which have at most one function. A larger class says so with its
reason in the last line above its head, and may hardly grow: /// Large (30 functions, 9 members): the reason."""
# Builds: nothing
import re
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
FUNCTIONS, MEMBERS, ROOM = 25, 8, 2

HEAD = re.compile(r"\b(?:class|struct)\s+(\w+)(?:\s+final)?\s*(?::[^;{]*)?\{")
DECLARED = re.compile(r"^(?:static|constexpr)\b|^(?:(?:inline|mutable|const)\s+)*(?:Choice|Knob<[^>]*>|Pipeline|SurfacePipelines)(?!\w)")
NO_MEMBER = re.compile(r"(?:using|friend|typedef|enum|static_assert|class|struct|template\s*<[^>]*>\s*(?:class|struct))\b")
ALIAS = re.compile(r"^(?:const\s+)?[\w:]+&\s*\w+\s*=")  # a name for a part of another member
LARGE = re.compile(r"/// Large \((\d+) functions, (\d+) members\): \w.*\.\n(?:template[^\n]*\n)?\s*$")
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
        elif OWNED not in statement and not DECLARED.match(statement) and not ALIAS.match(statement):
            members += 1 + plain.count(",")
    return functions, members


def classes(paths) -> dict[str, tuple[int, int, str, tuple[int, int] | None]]:
    """{name: its functions and members, its file, and as how large it is announced}"""
    found = {}
    for path in paths:
        source = path.read_text()
        announced = {head[1]: tuple(map(int, said.groups())) for head in re.finditer(r"\b(?:class|struct)\s+(\w+)", source)
                     if (said := LARGE.search(source[:head.start()][-300:]))}
        text = bare(source)
        for head in HEAD.finditer(text):
            functions, members = measure(body(text, head.end()))
            if functions > 1 and (functions, members) > found.get(head[1], (0, 0))[:2]:
                found[head[1]] = functions, members, str(path.relative_to(ROOT)), announced.get(head[1])
    return found


class Classes(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.found = classes(sorted([*ROOT.glob("common/*/*.h"), *ROOT.glob("chapters/*/*.h"), *ROOT.glob("chapters/*/main.cpp")]))

    def test_they_are_small(self):
        for name, (functions, members, path, announced) in self.found.items():
            most_functions, most_members = (count + ROOM for count in announced) if announced else (FUNCTIONS, MEMBERS)
            with self.subTest(name=name, path=path):
                self.assertLessEqual(functions, max(most_functions, FUNCTIONS), "functions: split it, or say why not")
                self.assertLessEqual(members, max(most_members, MEMBERS), "members: split it, or say why not")

    def test_a_class_that_is_announced_as_large_is_large(self):
        small = [name for name, (functions, members, _, announced) in self.found.items()
                 if announced and functions <= FUNCTIONS and members <= MEMBERS]
        self.assertEqual(small, [], "they have become small: take the line away")
        self.assertGreater(sum(1 for *_, announced in self.found.values() if announced), 20)  # the line is found

    def test_what_counts(self):
        text = bare("""class One : Base {
          public:
            One(int a, float b = f(2)) : a_(a) { if (a) { g(); } }
            void h() const;  // not this();
            std::function<void(int)> told;
            Shadow shadow{*this, "shadow"};
            Maps& maps = shadow.maps;
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
