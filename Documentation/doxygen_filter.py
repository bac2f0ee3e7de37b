#!/usr/bin/env python3
"""Prints a Markdown file as Doxygen wants it: doxygen_filter.py FILE.md

- Links name a heading by its words, within one file; Doxygen has one set of names for all files. So
  each heading gets a name with its file's before it, and links follow.
- Links to headers of Filters become links to their pages. Other files of the tree are not among the
  pages: their links become plain text.
- At signs are no commands outside of code.

What stands in code blocks stays as it is.
"""
import re
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
LINK = re.compile(r"(!?)\[([^\]]*)\]\(([^)\s]+)\)")


def anchor(heading):
    """As GitHub makes it of a heading."""
    return re.sub(r"[^\w\- ]", "", heading.lower()).replace(" ", "-")


def name(stem, of_heading):
    return f"{stem.lower()}-{of_heading}"


def link_in(path, link):
    """A link of the file at a path, as Doxygen follows it."""
    picture, text, target = link.groups()
    file, _, heading = target.partition("#")
    if picture or "://" in target:
        return link[0]
    if heading:
        return f"[{text}](#{name(Path(file or path).stem, heading)})"
    there = (path.parent / file).resolve()
    if there.suffix == ".h" and (ROOT / "Filters") in there.parents:
        return f"[{text}](@ref {there.relative_to(ROOT).as_posix()})"
    return link[0] if there.suffix == ".md" else text


def main(path):
    fenced = False
    lines = []
    for line in path.read_text(encoding="utf-8").splitlines():
        fence = line.lstrip().startswith("```")
        fenced ^= fence
        if not fenced and not fence:
            line = LINK.sub(lambda link: link_in(path, link), line.replace("@", r"\@"))
            heading = re.match(r"##+ (.+)$", line)
            if heading:
                line += f" {{#{name(path.stem, anchor(heading[1]))}}}"
        lines.append(line)
    sys.stdout.reconfigure(encoding="utf-8")
    print("\n".join(lines))


main(Path(sys.argv[1]).resolve())
