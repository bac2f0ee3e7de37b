#!/usr/bin/env python3
"""Keeps functions short, and their parameters few.

    check_sizes.py          tells whether there are more large functions than there may be
    check_sizes.py --list   lists them all

Counts the functions that are defined in Filters: lines from the signature to the closing brace, and
parameters. Lower the limits when there are fewer; they are never raised.
"""
import re
import sys
from pathlib import Path

FILTERS = Path(__file__).resolve().parent.parent / "Filters"
LONG, LONGEST, MANY = 40, 60, 5  # lines, lines and parameters
MOST_LONG, MOST_LONGEST, MOST_MANY = 27, 0, 16  # functions with more

# Comments, literals and lines of the preprocessor, which hold braces that are none.
NO_CODE = re.compile(r'//[^\n]*|/\*.*?\*/|^[ \t]*#(?:[^\n\\]|\\.)*|"(?:[^"\\\n]|\\.)*"'
                     r"|(?<![0-9A-Fa-f])'(?:[^'\\\n]|\\.)+'", re.MULTILINE | re.DOTALL)
TYPE = re.compile(r"(?:^|[\s>])(?:class|struct|union|enum|namespace|extern)\b[^()]*$")
# What may stand before a signature.
PREFIX = re.compile(r"(?:\s|(?:public|protected|private):|\[\[.*?\]\]|template\s*<[^()]*?>(?=\s)"
                    r"|__attribute__\s*\(\(.*?\)\)+)*")


def parameters(head):
    """How many there are in the first parentheses of a signature."""
    count, depth, text = 1, 0, ""
    for sign in head[head.index("(") + 1:]:
        depth += (sign in "([{<") - (sign in ")]}>")
        if depth < 0:
            break
        count += sign == "," and depth == 0
        text += sign
    return count if text.strip() not in ("", "void") else 0


def functions(text):
    """The line, length, and number of parameters of each function that is defined."""
    text = NO_CODE.sub(lambda found: re.sub(r"[^\n]", " ", found.group()), text)
    inside, begin = [], 0  # whether each open brace is of a function or a value; where a head begins
    for brace in re.finditer(r"[{};]", text):
        sign, at = brace.group(), brace.start()
        hidden = any(kind for kind, *_ in inside)
        if sign == "{":
            head = re.sub(r"operator\s*\S+?(?=\s*\()", "operator", text[begin:at])
            is_value = (text[at - 1].isalnum() or text[at - 1] in "_>" or
                        head.rstrip()[-1:] == "=" or head.count("(") > head.count(")"))
            is_type = "(" not in head or bool(TYPE.search(head))
            begins = begin + PREFIX.match(text[begin:at]).end()
            inside.append((hidden or is_value or not is_type, begins, head,
                           not (hidden or is_value or is_type)))
            begin = begin if is_value or hidden else at + 1
        elif sign == "}" and inside:
            kind, first, head, is_function = inside.pop()
            if is_function:
                yield (text.count("\n", 0, first) + 1, text.count("\n", first, at) + 1,
                       parameters(PREFIX.sub("", head, 1)))
            begin = begin if kind and not is_function else at + 1
        elif not hidden:
            begin = at + 1


found = [(path.relative_to(FILTERS.parent), *function)
         for path in sorted(FILTERS.rglob("*")) if path.suffix in (".h", ".cxx")
         for function in functions(path.read_text(encoding="utf-8"))]
problems = []
for what, place, limit, most in (("lines", 2, LONG, MOST_LONG), ("lines", 2, LONGEST, MOST_LONGEST),
                                 ("parameters", 3, MANY, MOST_MANY)):
    large = sorted((f for f in found if f[place] > limit), key=lambda f: -f[place])
    if len(large) > most or "--list" in sys.argv:
        problems.append(f"{len(large)} functions of more than {limit} {what}; at most {most}:")
        problems += [f"  {f[0]}:{f[1]}: {f[place]}" for f in large]
print("\n".join(problems) if problems else f"{len(found)} functions, as short as they were.")
sys.exit(1 if problems and "--list" not in sys.argv else 0)
