#!/usr/bin/env python3
"""make_help.py --headers DIR --xml FILE... --output DIR: writes the plugin's help pages.

One page a filter of the menu, named as ParaView's "?" button asks for it, `filters.<name>.html`,
`index.html`, and the project for Qt's qhelpgenerator. All text comes from the class comments and
setters' comments of the headers and from the properties' texts in the XML; see header_comments.py
for what a comment may hold.
"""
import argparse
import html
import re
import sys
from pathlib import Path

from header_comments import read_chain
from proxies import read_filters

# The "?" button looks into the folder of each namespace that has the namespace's name up to a dot.
NAME = "AnisotropicRemeshing"
# A page's sections after "What it does" and "Properties", by the titles used in the headers.
USE, OUTPUTS, INPUT = "When to use it", "Outputs and arrays", "Input and embedding"
GUARANTEES, LIMITS, REFERENCE = "What is guaranteed", "Limits", "Reference"
TITLES = (USE, INPUT, OUTPUTS, GUARANTEES, LIMITS, REFERENCE)
# What a base class says without a title belongs there.
UNTITLED = {"vtkEmbeddedSurfaceAlgorithm": INPUT, "vtkRestrictedVoronoiAlgorithm": OUTPUTS}
# Sections and sentences for those who call C++, which a page leaves out.
SECTIONS_FOR_PROGRAMMERS = ("Aborting",)
FOR_PROGRAMMERS = re.compile(r"^(nullptr|Input array to process|Setters )")
# VTK's classes in the words of the window.
KINDS = {"vtkPolyData": "polygonal data", "vtkTable": "table"}
STYLE = """
body { margin: 12px; }
h1 { font-size: x-large; }
h2 { font-size: large; margin-top: 18px; }
h3 { font-size: medium; margin-top: 12px; }
p { margin-top: 4px; margin-bottom: 6px; }
code { font-family: monospace; }
table { margin-top: 4px; margin-bottom: 8px; }
"""


def anchor_of(title):
    return title.lower().replace(" ", "-")


class Writer:
    """Turns texts of one filter's comments into HTML, with links to what they speak of."""

    def __init__(self, owner, chain, filters):
        self.owner = owner
        self.chain = chain
        self.choices = {name: f"<i>{html.escape(text)}</i>"
                        for name, text in words_of_enumerators(owner, chain).items()}
        self.told = {}  # properties by the comment on what sets them
        self.pages = {other.class_name: other for other in filters}
        self.section = ""  # the title of the one being written

    def link_of_class(self, name):
        """A filter's label and page, or the section of this page that a base class makes."""
        if name == self.owner.class_name:
            return html.escape(self.owner.label)
        if name in self.pages:
            other = self.pages[name]
            return f'<a href="filters.{other.name}.html">{html.escape(other.label)}</a>'
        if name in UNTITLED and name in [one.name for one in self.chain]:
            title = UNTITLED[name]
            return f'<a href="#{anchor_of(title)}">{title}</a>'
        return KINDS.get(name, name)

    def code(self, word):
        """What stands in backticks: a property's label, or the word as it is."""
        if word in self.choices:
            return self.choices[word]
        target = self.owner.properties.get(word)
        if target and self.section != OUTPUTS:  # where a word means an array before a property
            return f'<a href="#{target.name}">{html.escape(target.label)}</a>'
        text = f"<code>{html.escape(word, quote=False)}</code>"
        return f'<a href="#{target.name}">{text}</a>' if target else text

    def inline(self, text):
        parts = re.split(r"`([^`]+)`", text)
        for index, part in enumerate(parts):
            if index % 2:
                parts[index] = self.code(part)
                continue
            part = re.sub(r"\b[A-Z][A-Z_]+\b",
                          lambda m: self.choices.get(m[0], m[0]), html.escape(part, quote=False))
            part = re.sub(r"\^\(([^)]*)\)|\^(\w)", lambda m: f"<sup>{m[1] or m[2]}</sup>", part)
            if self.section != REFERENCE:
                part = part.replace("[Levy12]", f'<a href="#{anchor_of(REFERENCE)}">[Levy12]</a>')
            parts[index] = re.sub(r"\bvtk[A-Z]\w+", lambda m: self.link_of_class(m[0]), part)
        return "".join(parts)

    def paragraph(self, text):
        """A paragraph; what it says of the field data becomes a list."""
        text = re.sub(r": input array to process \d+", "", text)
        kept = " ".join(one for one in sentences_of(text) if not FOR_PROGRAMMERS.match(one))
        kept, field_data, arrays = kept.partition("Field data of port 0:")
        result = f"<p>{self.inline(kept)}</p>\n" if kept else ""
        if field_data:
            items = "".join(f"<li>{self.inline(one)}</li>\n" for one in arrays_of(arrays))
            result += f"<p>{field_data}</p>\n<ul>\n{items}</ul>\n"
        return result

    def blocks(self, blocks):
        result = ""
        for block in blocks:
            if isinstance(block, str):
                result += self.paragraph(block)
            elif is_list_of_outputs(block):
                result += self.table_of_outputs(block)
            else:
                items = "".join(f"<li>{self.item(item)}</li>\n" for item in block)
                result += f"<ul>\n{items}</ul>\n"
        return result

    def item(self, blocks):
        """A list's item: a lone paragraph needs no <p>."""
        if len(blocks) == 1 and isinstance(blocks[0], str):
            return self.inline(blocks[0])
        return self.blocks(blocks)

    def table_of_outputs(self, items):
        """Rows of a port and what it holds, each kind of array on a line of its own."""
        rows = ""
        for item in items:
            port, name, text = OUTPUT.match(item[0]).groups()
            lines = re.sub(r"[;.] (?=(?:[Pp]oint|[Cc]ell) arrays?:|With a reference[:,]|Always:)",
                           ".\n", text).split("\n")
            cell = "".join(f"<p>{capitalized(self.inline(line))}</p>\n" for line in lines)
            cell += self.blocks(item[1:])
            rows += f"<tr><td><b>{name}</b><br/>port {port}</td><td>{cell}</td></tr>\n"
        return table("Output", "What it holds", rows)


OUTPUT = re.compile(r"(?:Port )?(\d+) `(\w+)`: (.*)", re.DOTALL)


def is_list_of_outputs(block):
    return all(item and isinstance(item[0], str) and OUTPUT.match(item[0]) for item in block)


def table(left, right, rows):
    return (f'<table border="1" cellspacing="0" cellpadding="4" width="100%">\n'
            f'<tr><th align="left" width="26%">{left}</th><th align="left">{right}</th></tr>\n'
            f"{rows}</table>\n")


def capitalized(text):
    return text[0].upper() + text[1:]


def arrays_of(text):
    """The parts of an enumeration of arrays: each begins with a name or a condition for it."""
    parts, depth, start = [], 0, 0
    for index, letter in enumerate(text):
        depth += (letter == "(") - (letter == ")")
        if letter in ",;" and depth == 0 and re.match(r"[,;] (`|with )", text[index:]):
            parts.append(text[start:index].strip())
            start = index + 1
    return parts + [text[start:].strip().rstrip(".")]


def sentences_of(text):
    return re.split(r"(?<=\.)\s+(?=[A-Z`\"]|nullptr)", text)


def words_of(text):
    """The words that say something; defaults and ranges are told elsewhere."""
    return [word for word in re.findall(r"[a-z]+", text.lower())
            if len(word) > 2 and word not in ("the", "and", "default", "least", "most", "from")]


def news_of(text, known):
    """The sentences of a text but for those at its beginning that `known` says almost as well."""
    told = set(words_of(known))
    sentences = sentences_of(text)
    while sentences:
        words = words_of(sentences[0])
        if words and sum(word in told for word in words) < 0.8 * len(words):
            break
        sentences.pop(0)
    return " ".join(sentences)


def setters_comment(target, chain):
    """The comment on the command that sets a property; [] for inputs, which have none."""
    for one in chain:
        if target.command in one.setters:
            return one.setters[target.command]
    return []


def words_of_enumerators(owner, chain):
    """The panel's words for the enumerators that the comments on its properties use."""
    result = {}
    for target in owner.properties.values():
        text = str(setters_comment(target, chain))
        for enum in (enum for one in chain for enum in one.enums):
            if ({str(value) for value in enum.values()} == set(target.choices)
                    and any(re.search(rf"\b{name}\b", text) for name in enum)):
                result.update((name, target.choices[str(value)]) for name, value in enum.items())
    return result


def facts_of(target):
    """Default, values, name in scripts and place, a line each."""
    facts = []
    if target.default != "":
        facts.append(f"default {html.escape(target.default, quote=False)}")
    if target.allowed:
        facts.append(html.escape(target.allowed, quote=False))
    facts.append(f"script: <code>{target.script_name}</code>")
    where = {"advanced": "behind the gear", "never": "in scripts only"}
    if target.visibility in where:
        facts.append(where[target.visibility])
    return "<br/>".join(f"<small>{fact}</small>" for fact in facts)


def long_text(target, chain, writer):
    """What the header says beyond the tooltip; of two properties with one comment, once."""
    blocks = list(setters_comment(target, chain))
    first = writer.told.setdefault(str(blocks), target)
    if blocks and first is not target:
        return f'<p>See <a href="#{first.name}">{html.escape(first.label)}</a>.</p>\n'
    if blocks and isinstance(blocks[0], str):
        blocks[0] = news_of(blocks[0], target.text)
    return writer.blocks(blocks)


def property_row(target, chain, writer):
    cell = f"<p>{writer.inline(target.text)}</p>\n" + long_text(target, chain, writer)
    return (f'<tr><td><a name="{target.name}"></a><b>{html.escape(target.label)}</b><br/>'
            f"{facts_of(target)}</td>\n<td>{cell}</td></tr>\n")


def properties_by_group(owner):
    """Titles and properties: inputs, then groups of which the panel shows some, then the rest."""
    inputs = [one for one in owner.properties.values() if one.is_input]
    groups = {"Inputs": sorted(inputs, key=lambda one: one.name != "Input")}
    for one in owner.properties.values():
        if not one.is_input:
            groups.setdefault(one.group, []).append(one)
    titles = list(groups)
    shown = {title for title in titles if title == "Inputs" or
             any(one.visibility == "default" for one in groups[title])}
    for title in sorted(titles, key=lambda one: (one != "Inputs", one not in shown, one != "")):
        yield title or "General", groups[title]


def document(title, body):
    return (f'<!DOCTYPE html>\n<html>\n<head>\n<meta charset="utf-8"/>\n<title>{title}</title>\n'
            f"<style>{STYLE}</style>\n</head>\n<body>\n{body}</body>\n</html>\n")


def page_of(owner, chain, filters):
    """The whole page of a filter."""
    writer = Writer(owner, chain, filters)
    sections = {title: "" for title in TITLES}
    for one in chain:
        for title, blocks in one.sections.items():
            if title in SECTIONS_FOR_PROGRAMMERS:
                continue
            title = title or UNTITLED.get(one.name, "")
            if title and title not in sections:
                raise ValueError(f"{one.name}: the help pages have no section {title!r}")
            writer.section = title
            sections[title] = sections.get(title, "") + writer.blocks(blocks)
    writer.section = ""

    properties = ""
    for title, members in properties_by_group(owner):
        rows = "".join(property_row(one, chain, writer) for one in members)
        properties += f"<h3>{html.escape(title)}</h3>\n" + table("Property", "What it does", rows)

    parts = {"What it does": sections[""], USE: sections[USE], "Properties": properties}
    parts.update((title, sections[title]) for title in TITLES if title != USE)
    parts = {title: content for title, content in parts.items() if content}
    links = " · ".join(f'<a href="#{anchor_of(title)}">{title}</a>' for title in parts)
    body = f"<h1>{html.escape(owner.label)}</h1>\n<p><b>{writer.inline(chain[0].brief)}</b></p>\n"
    body += f"<p>{links}</p>\n"
    body += "".join(f'<h2><a name="{anchor_of(title)}"></a>{title}</h2>\n{content}'
                    for title, content in parts.items())
    return document(html.escape(owner.label), body)


def index_of(filters, chains):
    rows = "".join(
        f'<tr><td><a href="filters.{one.name}.html">{html.escape(one.label)}</a></td>'
        f"<td>{html.escape(chain[0].brief)}</td></tr>\n" for one, chain in zip(filters, chains))
    title = filters[0].category
    return document(title, f"<h1>{title}</h1>\n" + table("Filter", "What it does", rows))


def project_of(filters):
    """What qhelpgenerator reads: namespace, contents, keywords and files."""
    pages = [(f"filters.{one.name}.html", html.escape(one.label)) for one in filters]
    contents = "".join(f'<section title="{label}" ref="{page}"/>\n' for page, label in pages)
    keywords = "".join(f'<keyword name="{label}" ref="{page}"/>\n' for page, label in pages)
    files = "".join(f"<file>{page}</file>\n" for page, _ in pages)
    return (f'<?xml version="1.0" encoding="UTF-8"?>\n<QtHelpProject version="1.0">\n'
            f"<namespace>{NAME}.org</namespace>\n<virtualFolder>{NAME}</virtualFolder>\n"
            f'<filterSection>\n<toc><section title="{filters[0].category}" ref="index.html">\n'
            f"{contents}</section></toc>\n<keywords>\n{keywords}</keywords>\n"
            f"<files>\n<file>index.html</file>\n{files}</files>\n"
            f"</filterSection>\n</QtHelpProject>\n")


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("--headers", required=True, help="folder of the filters' headers")
    parser.add_argument("--xml", required=True, nargs="+", help="server-manager XML files")
    parser.add_argument("--output", required=True, help="folder to write the pages to")
    arguments = parser.parse_args()

    filters = read_filters(arguments.xml)
    chains = [read_chain(arguments.headers, one.class_name) for one in filters]
    output = Path(arguments.output)
    output.mkdir(parents=True, exist_ok=True)
    for one, chain in zip(filters, chains):
        if not chain:
            return f"make_help.py: no header of {one.class_name} in {arguments.headers}"
        page = page_of(one, chain, filters)
        (output / f"filters.{one.name}.html").write_text(page, encoding="utf-8")
    (output / "index.html").write_text(index_of(filters, chains), encoding="utf-8")
    (output / f"{NAME}.qhp").write_text(project_of(filters), encoding="utf-8")
    return 0


if __name__ == "__main__":
    sys.exit(main())
