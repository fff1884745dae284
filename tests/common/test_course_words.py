"""The course's language, as far as a program can check it: help texts of knobs, headings, and phrases that no page may use."""
# Builds: nothing

import json
import pathlib
import re
import sys
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "common/course"))
from pages.reading import prose_words  # noqa: E402
from test.text_check import prose  # noqa: E402
from tree import lessons  # noqa: E402

DECLARED = re.compile(r"^\s*(Knob<[\w:]+>|Choice)\s+(\w+)\s*\{", re.M)
STRING = re.compile(r'"((?:[^"\\\n]|\\.)*)"')
# Where a declaration's help stands among its arguments.
HELP_AT = {"Knob<bool>": 3, "Choice": 4}

# A help text names the knob's subject: it neither continues the line above it, nor uses a clause instead of a noun.
BAD_START = re.compile(r"(of|and|or|its|the same|how|what|whether|where|who|by)\b", re.I)

# Regular expressions, each with a better wording. They apply to lessons, help texts and captions.
BANNED = {
    r"\bfor granted\b": "builds on",
    r"\bwhat lets light through\b": "transparent surfaces",
    r"\bby (what|how much) the\b": "a noun: factor, distance, amount",
    r"\b(is|are) asked (of|by|how)\b": "the field's verb: sample, compare, request",
    r"\bone can tell\b|\bone sees\b": "reveals, shows",
    r"\bwhere all is well\b": "if everything passed",
    r"\bstands? out of (its|their|the)\b": "outlier; differs from its neighbours",
    r"\bholds? out against\b": "robustness",
    r"\bmeans nothing here\b": "unrecognised",
    r"\bis no (ordinary|number|method|place|point|file|light)\b": "is not a ...",
    r"\b(made|written|drawn|composed|begun) anew\b": "rebuilt, recreated",
    r"\bstrays? from\b": "bleeds around",
    r"\berror of truth\b": "standard error of the reference",
    r"\bhalf shadow\b|\bfull shadow of\b": "penumbra, umbra",
    r"\bbe it (convex|\w+) or not\b": "whether ... or not",
    r"\botherwise turned\b|\bturned otherwise\b": "rotated differently",
    r"\bit takes its \w+ from the\b": "the subject first",
    r"\bnobody (has heard|thought) of\b": "unknown, unforeseen",
    r"\bswallows?\b": "absorption, extinction",
    r"\bas far as can be\b|\bas near as can be\b": "a figure",
    r"\bhow (soft|wide|deep|far|fast) \w+ (is|are|lies?|reach|reaches)\s*$": "width, depth, distance, speed",
    r"\bwhat (stands|lies|is) (behind|before|near|far) (is|are)\b": "a noun: background, foreground",
}
# On pages alone: phrases at which readers stumbled.
VOICE = {
    r"\bcodes? (that )?(a|the) screens? expects?\b": "sRGB",
    r"\bin place of\b": "instead of",
    r"\bwhole numbers?\b": "integer",
    r"\bin the mean\b": "on average",
    r"\bleast error\b": "the smallest error",
    r"\b(as handed out|as it stands|until you fill it in)\b": "the starter",
    r"\bwhoever\b": "anyone who",
    r"\bthose of (them|these|it) (that|which)\b": "a noun",
    r"\b(each|every|one) turn of (the|a) (loop|iteration)\b": "iteration",
    r"\bhas (looked|asked) who\b": "authenticated",
    r"\bstands? at its line\b": "appears on its line",
    r"\b(WSL|which) \w+ has and \w+( \d)? has not\b": "lacks it",
    r"\bgoes? without an end\b": "endless",
}
# A lesson speaks to its reader: at least so many words to a numeral, at most so many to a "you". Tables and folds hold figures.
WORDS_TO_A_NUMERAL, WORDS_TO_A_YOU = 28, 110
HEADINGS_THAT_STAY = {"What you will be able to do", "What you will see", "What goes wrong", "When to use which"}


def arguments(text: str, start: int) -> list[str]:
    """The arguments between the brace that opens before `start` and the one that closes it."""
    found, depth, at = [""], 1, start
    while depth:
        string = STRING.match(text, at)
        piece = string[0] if string else text[at]
        at += len(piece)
        if not string:
            depth += (piece in "{(") - (piece in "})")
            if piece == "," and depth == 1:
                found.append("")
                continue
        if depth:
            found[-1] += piece
    return found


def helps_in(text: str) -> list[tuple[int, str, str]]:
    """(line, knob, help) of each knob that a C++ source declares. Without a help text that is empty."""
    found = []
    for match in DECLARED.finditer(text):
        given = arguments(text, match.end())
        at = HELP_AT.get(match[1], 4)
        words = "".join(STRING.findall(given[at])) if at < len(given) else ""
        found.append((text.count("\n", 0, match.start(2)) + 1, match[2], words))
    return found


def wrong_with_help(words: str) -> str:
    """Empty where nothing is."""
    if len(re.findall(r"[\w²³°–’'-]+", words)) < 3:
        return "fewer than three words"
    if start := BAD_START.match(words):
        return f"begins with '{start[0]}'"
    return ""


def banned_in(text: str, patterns: dict[str, str] | None = None) -> list[str]:
    return [f"'{match[0]}': rather {instead}" for pattern, instead in (patterns or BANNED).items()
            for match in re.finditer(pattern, text, re.I)]


def wrong_with_heading(title: str) -> bool:
    """A heading is a noun phrase or a question."""
    return bool(re.match(r"(what|how|whether|where|why|which)\b", title, re.I)) and not title.endswith("?") \
        and title not in HEADINGS_THAT_STAY


def wrong_with_voice(text: str) -> list[str]:
    """Of a lesson: too many numerals in its sentences, or too few words to the reader."""
    words = prose_words(text)
    numerals = sum(bool(re.search(r"\d", word)) for word in words)
    addressed = sum(bool(re.match(r"you(r|rs|rself)?\b", word, re.I)) for word in words)
    wrong = []
    if numerals * WORDS_TO_A_NUMERAL > len(words):
        wrong.append(f"a numeral every {len(words) / numerals:.0f} words, {WORDS_TO_A_NUMERAL} at least: figures belong in tables and folds")
    if addressed * WORDS_TO_A_YOU < len(words) > WORDS_TO_A_YOU:
        wrong.append(f"'you' {addressed} times in {len(words)} words, every {WORDS_TO_A_YOU} at least")
    return wrong


def sources() -> list[pathlib.Path]:
    return [path for folder in ("chapters", "common") for kind in ("*.h", "*.cpp")
            for path in sorted((ROOT / folder).rglob(kind)) if "exercise" not in path.parts]


def pages() -> list[pathlib.Path]:
    return [ROOT / "README.md", *sorted((ROOT / "docs").glob("*.md"))]


class WordsTest(unittest.TestCase):
    def report(self, wrong: list[str]):
        self.assertFalse(wrong, "\n" + "\n".join(wrong))

    def test_help_texts_stand_alone(self):
        wrong, count = [], 0
        for path in sources():
            for line, knob, words in helps_in(path.read_text(encoding="utf-8")):
                count += 1
                here = f"{path.relative_to(ROOT)}:{line}: {knob}: {words!r}"
                if why := wrong_with_help(words):
                    wrong.append(f"{here}: {why}")
                wrong += [f"{here}: {phrase}" for phrase in banned_in(words)]
        self.assertGreater(count, 250)  # so the declarations are found
        self.report(wrong)

    def test_pages_use_no_banned_phrase(self):
        wrong, patterns = [], BANNED | VOICE
        for path in pages():
            name = path.relative_to(ROOT)
            lines = prose(name)
            # A phrase may go on in the next line.
            for (number, line), (_, following) in zip(lines, lines[1:] + [(0, "")]):
                first_words = " ".join(following.split()[:5])
                alone = set(banned_in(first_words, patterns))
                wrong += [f"{name}:{number}: {phrase}" for phrase in banned_in(f"{line} {first_words}", patterns)
                          if phrase not in alone]
        self.report(wrong)

    def test_lessons_speak_to_the_reader_and_leave_figures_to_tables(self):
        self.report([f"{page}: {why}" for page in lessons() for why in wrong_with_voice((ROOT / page).read_text(encoding="utf-8"))])

    def test_headings_are_nouns_or_questions(self):
        self.report([f"{path.relative_to(ROOT)}:{number}: {line}" for path in pages()
                     for number, line in prose(path.relative_to(ROOT))
                     if (title := re.match(r"#+ (.*)$", line)) and wrong_with_heading(title[1])])

    def test_captions_use_no_banned_phrase(self):
        self.report([f"{file.relative_to(ROOT)}: {shot['name']}: {phrase}"
                     for file in sorted((ROOT / "tests").glob("*/shots.json"))
                     for shot in json.loads(file.read_text(encoding="utf-8"))["shots"]
                     for phrase in banned_in(shot["caption"])])

    def test_specs_use_no_banned_phrase(self):
        wrong, count = [], 0
        for file in sorted(path for folder in ("shaders", "chapters") for path in (ROOT / folder).glob("*/exercise/*")):
            comments = re.findall(r"^ *// ?(.*)$", file.read_text(encoding="utf-8"), re.M)
            count += bool(comments)
            wrong += [f"{file.relative_to(ROOT)}: {phrase}" for phrase in banned_in(" ".join(comments), BANNED | VOICE)]
        self.assertGreater(count, 60)
        self.report(wrong)

    def test_numerals_and_you_are_counted_in_sentences_alone(self):
        plain = "A wall of stones that you look along. " * WORDS_TO_A_YOU
        hidden = ["| 1 | 2 |", "<details><summary>The figures</summary>\n\n3 4\n</details>", "```\n5\n```", "<!-- 6 -->", "# 7", "    8 9",
                  "1. One", "`10`", "[a](11.md)", "$x_{12}$"]
        further = ["## Further reading", *["- A. Author, 2013."] * WORDS_TO_A_YOU]
        for one in hidden:
            self.assertEqual(wrong_with_voice("\n\n".join([plain, *[one] * WORDS_TO_A_YOU, *further])), [], one)
        self.assertEqual([one.split()[0] for one in wrong_with_voice("It takes 0.5 ms at 85°. " * WORDS_TO_A_YOU)], ["a", "'you'"])

    def test_what_is_wrong_is_found(self):
        """The rules themselves, on declarations and sentences that break them."""
        source = '''
    Knob<int> blur{*this, "blur", 3, {0, 16}, "of moments: texels to each side", "texels"};
    Knob<bool> mips{*this, "mips", true, "Mip maps of moment maps, " "read where a texel is small"};
    Choice fetch{*this, "fetch", {"single", "gather, {all}"}, "gather", "Reads"};
'''
        self.assertEqual([(line, knob) for line, knob, _ in helps_in(source)], [(2, "blur"), (3, "mips"), (4, "fetch")])
        self.assertEqual([wrong_with_help(words) for _, _, words in helps_in(source)],
                         ["begins with 'of'", "", "fewer than three words"])
        for words in ("and swallows the rest", "its colour at noon", "the same along the normal", "how far it reaches"):
            self.assertTrue(wrong_with_help(words), words)
        self.assertFalse(wrong_with_help("Whole texels of the map"))
        self.assertTrue(banned_in("It takes chapter 04 for granted"))
        self.assertFalse(banned_in("This chapter builds on chapter 04"))
        self.assertTrue(wrong_with_heading("Why it runs backwards"))
        self.assertFalse(wrong_with_heading("Why does it run backwards?"))


if __name__ == "__main__":
    unittest.main()
