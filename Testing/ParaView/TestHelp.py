#!/usr/bin/env python3
"""TestHelp.py PLUGIN.so TEMPORARY_DIR BUILD_DIR SOURCE_DIR: the plugin's help pages and icons.

Each filter of the menu has a page in the compiled help, at the address that the "?" button asks
for. The page names every property of the XML and every output and array that the headers list, has
no rest of markup, and no link into nothing. Every setter of the headers is the command of a
property with a text. The icons that the XML names are in the plugin's resources.
"""
import re
import sqlite3
import sys
import xml.etree.ElementTree as ElementTree
import zlib
from pathlib import Path

plugin, build, source = Path(sys.argv[1]), Path(sys.argv[3]), Path(sys.argv[4])
compiled_help = build / "Plugin" / "help" / "AnisotropicRemeshing.qch"
problems = []

SECTIONS = ("What it does", "When to use it", "Properties", "Outputs and arrays",
            "What is guaranteed", "Limits")
LEFTOVER = re.compile(r"`|@\w|///|/\*|\*/|\bvtk\w*Macro|\bnullptr\b|^\s*\* ",
                      re.MULTILINE)
SETTER = re.compile(r"vtkSet\w*Macro\(\s*(\w+)|void\s+((?:Set|Add|Clear)\w+)\(")
INPUT_SETTER = re.compile(r"Set(\w+?)(Connection|Data)$")


def check(condition, text):
    if not condition:
        problems.append(text)


class Page:
    """Text, links and anchors of a page, which has to be well-formed."""

    def __init__(self, html):
        root = ElementTree.fromstring(html)
        self.text = " ".join(" ".join(root.find("body").itertext()).split())
        self.links = [one.get("href") for one in root.iter("a") if one.get("href")]
        self.anchors = {one.get("name") for one in root.iter("a") if one.get("name")}
        self.headings = ["".join(one.itertext()) for one in root.iter("h2")]


def read_help(path):
    """Namespace, virtual folder and files by name of a compiled Qt help file, and its contents."""
    database = sqlite3.connect(f"file:{path}?mode=ro", uri=True)
    namespace, = database.execute("SELECT Name FROM NamespaceTable").fetchone()
    folder, = database.execute("SELECT Name FROM FolderTable").fetchone()
    rows = database.execute("SELECT n.Name, d.Data FROM FileNameTable n JOIN FileDataTable d "
                            "ON n.FileId = d.Id WHERE d.Data IS NOT NULL").fetchall()
    files = {name: zlib.decompress(data[4:]).decode("utf-8") for name, data in rows}
    contents = database.execute("SELECT Data FROM ContentsTable").fetchone()[0]
    return namespace, folder, files, contents


def read_proxies():
    """All proxy elements of the plugin's XML by (group, name)."""
    result = {}
    for path in [*(source / "Plugin").glob("*.xml"), *(build / "Plugin").glob("*.xml")]:
        for group in ElementTree.parse(path).getroot().findall("ProxyGroup"):
            for proxy in group.findall("SourceProxy"):
                result[(group.get("name"), proxy.get("name"))] = proxy
    return result


def levels_of(proxy):
    """A proxy and its bases."""
    while proxy is not None:
        yield proxy
        proxy = proxies.get((proxy.get("base_proxygroup"), proxy.get("base_proxyname")))


def headers_of(class_name):
    """The texts of a class's header and of those of its bases, as far as they are here."""
    while (source / "Filters" / f"{class_name}.h").is_file():
        text = (source / "Filters" / f"{class_name}.h").read_text(encoding="utf-8")
        yield class_name, text
        class_name = re.search(rf"{class_name}\s*:\s*public (\w+)", text).group(1)


def class_comment(header):
    return re.sub(r"^ \* ?", "", re.match(r"/\*\*(.*?)\*/", header, re.DOTALL).group(1),
                  flags=re.MULTILINE)


def arrays_and_outputs(comment):
    """The words in backticks of a comment's list of ports, and after "Field data"."""
    words = set()
    for item in re.findall(r"^- (?:Port )?\d+ `.*?(?=\n- |\n\n|\Z)", comment, re.DOTALL | re.M):
        words.update(re.findall(r"`(\w+)`", item))
    for text in re.findall(r"Field data of .*?(?=\n\n)", comment, re.DOTALL):
        words.update(re.findall(r"`(\w+)`", text))
    return words


def label_of(prop):
    words = re.sub(r"(?<=[a-z0-9])(?=[A-Z])|(?<=[A-Z])(?=[A-Z][a-z])", " ", prop.get("name"))
    return prop.get("label") or words


def check_properties(name, proxy, page):
    """Each property is on the page, and each setter is the command of one that has a text."""
    commands, inputs, seen = set(), set(), set()
    for level in levels_of(proxy):
        for prop in level:
            if not re.search("(Vector|Input)Property$", prop.tag) or prop.get("name") in seen:
                continue
            seen.add(prop.get("name"))
            text = " ".join((prop.findtext("Documentation") or "").split())
            check(label_of(prop) in page.text, f"{name}: {prop.get('name')} is not on the page")
            check(prop.get("name") in page.anchors, f"{name}: no anchor {prop.get('name')}")
            check(text, f"{name}: {prop.get('name')} has no text")
            if text:
                commands.update((prop.get("command"), prop.get("clean_command")))
                inputs.add(prop.get("name") if prop.tag == "InputProperty" else "")
    for class_name, header in headers_of(proxy.get("class")):
        public = header[header.index("public:"):header.index("protected:")]
        public = re.sub("#ifndef __VTK_WRAP__.*?#endif", "", public, flags=re.S)  # for C++ alone
        for macro, method in SETTER.findall(public):
            setter = method or "Set" + macro
            as_input = INPUT_SETTER.match(setter)
            check(setter in commands or (as_input and as_input.group(1) in inputs),
                  f"{name}: {class_name}::{setter} has no property text")


def check_page(name, proxy, html):
    page = Page(html)
    check(set(SECTIONS) <= set(page.headings), f"{name}: has {page.headings}, not all {SECTIONS}")
    body = html.split("</style>")[1]
    for leftover in LEFTOVER.finditer(body):
        at = leftover.start()
        problems.append(f"{name}: rest of markup in {body[max(0, at - 40):at + 40]!r}")
    for class_name, header in headers_of(proxy.get("class")):
        for word in arrays_and_outputs(class_comment(header)):
            check(re.search(rf"\b{word}\b", page.text), f"{name}: {word} is not on the page")
    for level in levels_of(proxy):
        for port in level.findall("OutputPort"):
            check(port.get("name") in page.text, f"{name}: no output {port.get('name')}")
    check_properties(name, proxy, page)
    for link in page.links:
        file, _, anchor = link.partition("#")
        check(not file or file in files, f"{name}: a link to {file}, which is not there")
        check(not anchor or anchor in page.anchors, f"{name}: a link to {link} into nothing")
    header = next(headers_of(proxy.get("class")))[1]
    brief = re.search(r"@brief +(.*)", header).group(1).replace("`", "")
    short_help = proxy.find("Documentation").get("short_help")
    check(short_help == brief, f"{name}: short_help {short_help!r} is not the header's {brief!r}")


def check_icons(name, proxy, resources):
    for element, attribute in (("ShowInMenu", "icon"), ("PipelineIcon", "name")):
        icon = proxy.find(f"Hints/{element}").get(attribute)
        check(icon in resources, f"{name}: {element} has {icon}, the plugin {sorted(resources)}")


def read_resources():
    """The paths of the icons in the plugin; each is a picture."""
    result = set()
    folder = source / "Plugin" / "icons"
    for group in ElementTree.parse(folder / "icons.qrc").getroot():
        for file in group.findall("file"):
            picture = ElementTree.parse(folder / file.text).getroot()
            check(picture.tag.endswith("svg"), f"{file.text} is no SVG")
            check(file.text.encode("utf-16-be") in library, f"{file.text} is not in the plugin")
            result.add(f":{group.get('prefix')}/{file.text}")
    return result


library = plugin.read_bytes()
namespace, folder, files, contents = read_help(compiled_help)
proxies = read_proxies()
resources = read_resources()
# The "?" button asks for this folder in each namespace.
check(folder == namespace.split(".")[0], f"folder {folder} of {namespace} is not asked for")
check(compiled_help.read_bytes() in library, "the compiled help is not in the plugin")

wanted = {"index.html"}
for (group, name), proxy in proxies.items():
    if group == "filters" and proxy.find("Hints/ShowInMenu") is not None:
        file = f"{group}.{name}.html"
        wanted.add(file)
        check(file.encode("utf-16-be") in contents, f"{name} is not in the table of contents")
        if file in files:
            check_page(name, proxy, files[file])
        check_icons(name, proxy, resources)
check(len(wanted) == 8, f"{len(wanted) - 1} filters instead of 7")
check(set(files) == wanted, f"pages {sorted(files)} instead of {sorted(wanted)}")

for problem in problems:
    print(problem)
print(f"{len(problems)} problems in {len(files)} pages of {namespace}")
sys.exit(1 if problems else 0)
