"""Reads the server-manager XML: the filters of the menu and their properties, bases resolved."""
import re
import xml.etree.ElementTree as ElementTree
from dataclasses import dataclass, field


@dataclass
class Property:
    """One property as the panel and scripts have it; `text` is its tooltip."""
    name: str
    label: str
    command: str = ""
    text: str = ""
    default: str = ""
    allowed: str = ""
    group: str = ""
    is_input: bool = False
    visibility: str = "default"
    choices: dict = field(default_factory=dict)  # texts of an enumeration by value

    @property
    def script_name(self):
        """Its name in paraview.simple, which is made from the label."""
        return re.sub(r"\W", "", self.label)


@dataclass
class Filter:
    """A filter of the menu. `outputs`: names by port; `properties`: derived before base."""
    name: str
    label: str
    class_name: str
    help_text: dict
    category: str
    icon: str
    properties: dict = field(default_factory=dict)
    outputs: dict = field(default_factory=dict)


def one_line(text):
    return " ".join((text or "").split())


def label_of(element):
    """The label, or as ParaView makes it from the name: a blank before each word."""
    name = element.get("name")
    return element.get("label") or re.sub(
        r"(?<=[a-z0-9])(?=[A-Z])|(?<=[A-Z])(?=[A-Z][a-z])", " ", name)


def short_number(text):
    return re.sub(r"\.0*$", "", text)


def range_in_words(low, high):
    """A domain with both ends is no limit, but makes a slider."""
    if low is not None and high is not None:
        return f"slider: {short_number(low)} to {short_number(high)}"
    if low is not None:
        return f"{short_number(low)} or more"
    return f"{short_number(high)} or less" if high is not None else "any number"


def allowed_values(element):
    """A range, choices or kind of array in words; "" where there is nothing to tell."""
    for domain in element:
        if domain.tag == "BooleanDomain":
            return "on or off"
        if domain.tag == "EnumerationDomain":
            return ", ".join(entry.get("text") for entry in domain.findall("Entry"))
        if domain.tag in ("IntRangeDomain", "DoubleRangeDomain"):
            return range_in_words(domain.get("min"), domain.get("max"))
        if domain.tag.endswith("ArrayListDomain"):
            return "an array of the input"
        if domain.tag == "DataTypeDomain":
            kinds = [value.get("value") for value in domain.findall("DataType")]
            return "data: " + ", ".join(re.sub("^vtk", "", kind) for kind in kinds)
    return ""


def default_value(element, choices):
    """The default in the words of the panel; "" for none."""
    value = element.get("default_values", "")
    if element.tag == "InputProperty" or element.get("repeat_command") == "1":
        return ""
    if element.find("BooleanDomain") is not None:
        return {"0": "off", "1": "on"}.get(value, value)
    if element.get("number_of_elements", "1") != "1":
        return ""  # an array's association and name
    value = short_number(value)
    return choices.get(value, value)


def read_property(element):
    choices = {entry.get("value"): entry.get("text")
               for entry in element.findall("EnumerationDomain/Entry")}
    return Property(
        name=element.get("name"), label=label_of(element), command=element.get("command", ""),
        text=one_line(element.findtext("Documentation")),
        default=default_value(element, choices), allowed=allowed_values(element),
        is_input=element.tag == "InputProperty",
        visibility=element.get("panel_visibility", "default"), choices=choices)


def add_level(target, element):
    """Adds what one proxy element says to a filter, unless a derived one said it before."""
    groups = {}
    for group in element.findall("PropertyGroup"):
        for member in group.findall("Property"):
            groups[member.get("name")] = group.get("label", "")
    for child in element:
        if child.tag == "InputProperty" or child.tag.endswith("VectorProperty"):
            if child.get("name") not in target.properties:
                target.properties[child.get("name")] = read_property(child)
        elif child.tag == "OutputPort":
            target.outputs.setdefault(int(child.get("index")), child.get("name"))
    for name, label in groups.items():
        found = target.properties.get(name)
        if found and not found.group:
            found.group = label


def read_filters(paths):
    """The filters that the XML files put into a menu, in the order of the files."""
    proxies = {}
    for path in paths:
        for group in ElementTree.parse(path).getroot().findall("ProxyGroup"):
            for element in group:
                if element.tag in ("SourceProxy", "Proxy"):
                    proxies[(group.get("name"), element.get("name"))] = element

    filters = []
    for (group, name), element in proxies.items():
        menu = element.find("Hints/ShowInMenu")
        if group != "filters" or menu is None:
            continue
        documentation = element.find("Documentation")
        help_text = dict(documentation.attrib) if documentation is not None else {}
        result = Filter(name, element.get("label", name), element.get("class"), help_text,
                        menu.get("category", ""), menu.get("icon", ""))
        while element is not None:
            add_level(result, element)
            element = proxies.get((element.get("base_proxygroup"), element.get("base_proxyname")))
        filters.append(result)
    return filters
