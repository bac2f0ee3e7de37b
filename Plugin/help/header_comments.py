"""Reads the documentation of the filters' C++ headers: class comments, setters, enumerations.

A comment is a list of blocks: a paragraph (a string) or a list (a Python list whose items are lists
of blocks). A class comment has sections: what comes before the first `@par Title:` is the section
"", every further one goes on to the next `@par`.
"""
import re
from dataclasses import dataclass, field
from pathlib import Path

COMMENT = re.compile(r"/\*\*(.*?)\*/", re.DOTALL)
CLASS = re.compile(r"^class\s+(?:\w+_EXPORT\s+)?(\w+)\s*:\s*public\s+(\w+)", re.MULTILINE)
ENUM = re.compile(r"\benum\s+\w+\s*\{([^}]*)\}")
ENUMERATOR = re.compile(r"(\w+)\s*=\s*(-?\d+)")
# What sets a parameter: a VTK macro, or a method of one's own.
SETTER = re.compile(
    r"^\s*(?:vtkSet\w*Macro\(\s*(?P<macro>\w+)|void\s+(?P<method>(?:Set|Add|Clear)\w+)\()",
    re.MULTILINE)


@dataclass
class HeaderClass:
    """What one header says. `setters`: blocks of the comment of each, by the method's name."""
    name: str
    base: str
    brief: str = ""
    sections: dict = field(default_factory=dict)
    setters: dict = field(default_factory=dict)
    enums: list = field(default_factory=list)


def stripped_lines(comment):
    """The lines of a comment without the stars in front; indentation after those is kept."""
    return [re.sub(r"^\s*\*( |$)", "", line).rstrip() for line in comment.strip("\n").split("\n")]


def paragraphs_of(lines):
    """Blocks of lines that are separated by blank ones or begin with "- "."""
    blocks, text = [], []

    def end_paragraph():
        if text:
            blocks.append(" ".join(text))
            text.clear()

    index = 0
    while index < len(lines):
        line = lines[index]
        if line.startswith("- "):
            end_paragraph()
            items, index = list_of(lines, index)
            blocks.append(items)
            continue
        if line.strip():
            text.append(line.strip())
        else:
            end_paragraph()
        index += 1
    end_paragraph()
    return blocks


def list_of(lines, index):
    """The items of the list that begins at a line, and where it ends.

    It ends at a blank line that no item follows, or where `@` begins a command. (Lines that go on
    without indentation are still the item's.)
    """
    items = []
    while index < len(lines) and lines[index].startswith("- "):
        item = [lines[index][2:]]
        index += 1
        while index < len(lines) and lines[index].strip() and not re.match(r"- |@", lines[index]):
            item.append(lines[index].strip())
            index += 1
        items.append(paragraphs_of(item))
        following = index
        while following < len(lines) and not lines[following].strip():
            following += 1
        if following < len(lines) and lines[following].startswith("- "):
            index = following
    return items, index


def read_class_comment(comment, result):
    """Fills brief and sections of a class from the comment above its header's include guard."""
    title, lines = "", []

    def end_section():
        blocks = paragraphs_of(lines)
        if blocks:
            result.sections.setdefault(title, []).extend(blocks)
        lines.clear()

    for line in stripped_lines(comment):
        if line.startswith("@class"):
            continue
        if line.startswith("@brief"):
            result.brief = line[len("@brief"):].strip()
        elif line.startswith("@par "):
            end_section()
            title = line[len("@par "):].strip().rstrip(":")
        elif line.startswith("@"):
            raise ValueError(f"{result.name}: the help pages know no {line.split()[0]}")
        else:
            lines.append(line)
    end_section()


def read_setters(text, result):
    """Fills the setters of a class from the public part of its body."""
    comment_at = [(match.end(), paragraphs_of(stripped_lines(match.group(1))))
                  for match in COMMENT.finditer(text)]
    for match in SETTER.finditer(text):
        name = match.group("method") or "Set" + match.group("macro")
        before = [blocks for end, blocks in comment_at if end <= match.start()]
        result.setters.setdefault(name, before[-1] if before else [])


def read_header(path):
    """The class that a header declares."""
    text = Path(path).read_text(encoding="utf-8")
    match = CLASS.search(text)
    if not match:
        raise ValueError(f"{path}: no class found")
    result = HeaderClass(match.group(1), match.group(2))
    first = COMMENT.search(text)
    if not first or "@class" not in first.group(1) or first.start() > match.start():
        raise ValueError(f"{path}: no class comment above the include guard")
    read_class_comment(first.group(1), result)
    public = re.split(r"^protected:", text[match.end():], maxsplit=1, flags=re.MULTILINE)[0]
    read_setters(public, result)
    for enum in ENUM.finditer(public):
        values = {name: int(value) for name, value in ENUMERATOR.findall(enum.group(1))}
        if values:
            result.enums.append(values)
    return result


def read_chain(folder, name):
    """A class and its bases as far as the folder has their headers, derived first."""
    chain = []
    while (Path(folder) / f"{name}.h").is_file():
        chain.append(read_header(Path(folder) / f"{name}.h"))
        name = chain[-1].base
    return chain
