"""One line of code, broken in each of the ways in which lines are broken: for mutate.py and mutate_host.py."""
import re

OPPOSITE = {" + ": " - ", " - ": " + ", " * ": " / ", " / ": " * ", " += ": " -= ", " > ": " < ", " < ": " > ",
            " && ": " || ", " || ": " && ", "dFdx": "dFdy", "dFdy": "dFdx", "exp2(": "exp(", "inversesqrt(": "sqrt(",
            ".x": ".y", ".y": ".x", "position_to_world(": "normal_to_world(", "diffuse": "specular",
            "specular": "diffuse"}
EDGE = {" > ": " >= ", " < ": " <= ", " += ": " = "}
DROPPED = ("max", "min", "clamp", "normalize", "abs")
SWAPPED = ("mix", "pow", "reflect")  # the operands of max, min and dot may change places

HOST = ({" + ": " - ", " - ": " + ", " * ": " / ", " += ": " -= ", " == ": " != ", " != ": " == ", " && ": " || ",
         " || ": " && ", "std::max": "std::min", "std::min": "std::max", ".x": ".y", ".y": ".x", "true": "false",
         "false": "true", "++": "--", "transpose(": "(", "inverse(": "("},
        {" < ": " <= ", " > ": " >= ", " <= ": " < ", " >= ": " > "})


def arguments_of(text: str, start: int):
    """(the arguments of the call with '(' at start, the index after its ')'); None if it ends on another line."""
    depth, parts, begin = 0, [], start + 1
    for at in range(start, len(text)):
        if text[at] in "([":
            depth += 1
        elif text[at] in ")]":
            depth -= 1
        if (text[at] == "," and depth == 1) or depth == 0:
            parts.append(text[begin:at].strip())
            begin = at + 1
        if depth == 0:
            return parts, at + 1
    return None


def changes(line: str):
    """(the change, the changed line), once each, for a line of GLSL."""
    code = line.split("//")[0].rstrip()
    if not code.strip() or code.lstrip().startswith(("#", "layout", "struct")):
        return
    for table in (OPPOSITE, EDGE):
        for old, new in table.items():
            for found in re.finditer(re.escape(old) + (r"(?!\w)" if old[0] == "." else ""), code):
                yield f"{old.strip()} becomes {new.strip()}", code[:found.start()] + new + code[found.end():]
    for found in re.finditer(r"(?<=[(,= ])-(?=[A-Za-z0-9(])", code):
        yield "a minus left out", code[:found.start()] + code[found.end():]
    for found in re.finditer(r"(?<![\w.])(\d+\.\d*(?:e-?\d+)?|\d+e-?\d+|\d+)(?![\w.])", code):
        old = found[1]
        number = float(old)
        whole = re.fullmatch(r"\d+", old)
        new = str(int(number) + 1) if whole else repr(number * 1.1 if number else 0.1)
        yield f"{old} becomes {new}", code[:found.start()] + new + code[found.end():]
    for name in DROPPED + SWAPPED:
        for found in re.finditer(rf"\b{name}\(", code):
            call = arguments_of(code, found.end() - 1)
            if not call:
                continue
            (first, *rest), end = call
            if name in DROPPED:
                yield f"{name} left out", f"{code[:found.start()]}({first}){code[end:]}"
            else:
                swapped = ", ".join([rest[0], first, *rest[1:]])
                yield f"{name}'s arguments swapped", f"{code[:found.start()]}{name}({swapped}){code[end:]}"
    found = re.fullmatch(r"(.*) \? (.*) : (.*);", code)
    if found:
        yield "both sides of ? : swapped", f"{found[1]} ? {found[3]} : {found[2]};"
    if re.match(r"\s+[\w.\[\]]+ [-+*]?= .*;$", code):
        yield "the statement left out", re.match(r"\s*", code)[0] + ";"
    found = re.match(r"(\s+)return (.*);$", code)
    if found:
        yield "twice the result", f"{found[1]}return 2 * ({found[2]});"


def host_changes(line: str):
    """(the change, the changed line), once each, for a line of C++."""
    code = line.split("//")[0].rstrip()
    if not code.strip() or re.match(r"\s*(#|using |namespace |template|static_assert|class |struct |enum |\*|/\*)", code):
        return
    bare = re.sub(r'"(?:[^"\\]|\\.)*"', lambda found: '"' + "_" * (len(found[0]) - 2) + '"', code)  # no change within text
    for table in HOST:
        for old, new in table.items():
            for found in re.finditer(re.escape(old) + (r"(?!\w)" if old[0] == "." else ""), bare):
                yield f"{old.strip()} becomes {new.strip() or 'nothing'}", code[:found.start()] + new + code[found.end():]
    for found in re.finditer(r"(?<![\w.])(\d+\.\d*(?:e-?\d+)?f?|\d+e-?\d+f?|\d+u?)(?![\w.])", bare):
        old, digits = found[1], found[1].rstrip("fu")
        kind = old[len(digits):]
        new = str(int(digits) + 1) if digits.isdigit() else repr(float(digits) * 1.1 or 0.1)
        yield f"{old} becomes {new + kind}", code[:found.start()] + new + kind + code[found.end():]
    for found in re.finditer(r" \| (?:VK|GLFW)_\w+", bare):
        yield f"{found[0].strip()} left out", code[:found.start()] + code[found.end():]
    if re.match(r"\s+(?!return|auto |const |if|for|while|throw|else|case)[\w.>\[\]():-]+(\(.*\)| [-+*|]?= .*);$", bare):
        yield "the statement left out", re.match(r"\s*", code)[0] + ";"
    found = re.match(r"(\s+)if \((.*)\)( \{)?$", bare) or re.match(r"(\s+)if \((.*?)\) (?:return|throw|continue|break)", bare)
    if found and not re.search(r";|const auto", found[2]):
        first, last = found.span(2)
        yield "the condition turned round", f"{code[:first]}!({code[first:last]}){code[last:]}"
