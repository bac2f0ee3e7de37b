"""Writes the types of a module of wrapped VTK classes, from what VTK's wrappers tell of them.

    make_stubs.py FOLDER PACKAGE MODULE OUTPUT.pyi

The package is in FOLDER, and is not imported: its module is.
"""
import importlib.util
import inspect
import os
import re
import sys

# name(self, size:int, at:(float, float)) -> str
SIGNATURE = re.compile(r"^(\w+)\((.*)\) -> (.+)$")
TUPLE = re.compile(r"\(([^()]*)\)")
BUILT_IN = {"int", "float", "str", "bool", "bytes", "None", "object"}


def load(folder, package, module):
    """The module, without what its package's __init__ imports."""
    path = os.path.join(folder, package, module + ".so")
    specification = importlib.util.spec_from_file_location(f"{package}.{module}", path)
    found = importlib.util.module_from_spec(specification)
    specification.loader.exec_module(found)
    return found


class Types:
    """Python's spelling of the wrappers' types, and the modules that these come from."""

    def __init__(self, own):
        self.own = own
        self.modules = set()

    def spell(self, text):
        text = text.strip()
        if text.startswith("(") and text.endswith(")"):
            return f"Tuple[{', '.join(self.spell(part) for part in text[1:-1].split(','))}]"
        if text.startswith("["):
            return "Sequence[Any]"
        if text in BUILT_IN:
            return text
        if text in self.own:
            return text
        module = vtk_module_of(text)
        if module is None:
            return "Any"
        self.modules.add(module)
        return f"{module}.{text}"


def vtk_module_of(name):
    """The vtkmodules module that is loaded and has a class, as its class tells."""
    for module in list(sys.modules.values()):
        kind = getattr(module, name, None) if module.__name__.startswith("vtkmodules.") else None
        if inspect.isclass(kind):
            return kind.__module__
    return None


def split(arguments):
    """At commas that are in no brackets."""
    parts, depth = [""], 0
    for letter in arguments:
        depth += (letter in "([") - (letter in ")]")
        if letter == "," and depth == 0:
            parts.append("")
        else:
            parts[-1] += letter
    return [part.strip() for part in parts if part.strip()]


def signatures(method):
    """[(arguments, result)] by its document; a line may go on in the next."""
    text = re.sub(r"\n {4,}", " ", method.__doc__ or "")
    found = [SIGNATURE.match(line) for line in text.splitlines()]
    return [(split(match[2]), match[3]) for match in found if match]


def argument_text(argument, index, types):
    name, _, kind = argument.partition(":")
    kind, _, default = kind.partition("=")
    name = name.strip() or f"argument{index}"
    text = f"{name}: {types.spell(kind)}" if kind else f"{name}: Any"
    return text + (" = ..." if default else "")


def method_lines(name, method, types):
    found = signatures(method)
    for arguments, result in found:
        is_static = not arguments or arguments[0] != "self"
        rest = arguments if is_static else arguments[1:]
        texts = [argument_text(text, k, types) for k, text in enumerate(rest)]
        if len(found) > 1:
            yield "    @overload"
        if is_static:
            yield "    @staticmethod"
        texts = texts if is_static else ["self"] + texts
        yield f"    def {name}({', '.join(texts)}) -> {types.spell(result)}: ..."


def class_lines(kind, types):
    bases = [types.spell(base.__name__) for base in kind.__bases__ if base is not object]
    yield f"class {kind.__name__}({', '.join(bases)}):"
    if not kind.__name__.endswith("Algorithm"):
        yield "    def __init__(self) -> None: ..."
    for name, value in sorted(vars(kind).items()):
        if name.startswith("_"):
            continue
        if inspect.isclass(value):
            yield f"    class {name}(int): ..."
        elif isinstance(value, int):
            yield f"    {name}: int"
        elif callable(value):
            yield from method_lines(name, value, types)
    yield ""


def main(folder, package, module, output):
    import vtkmodules.vtkCommonDataModel  # noqa: F401
    import vtkmodules.vtkCommonExecutionModel  # noqa: F401

    found = load(folder, package, module)
    kinds = [kind for _, kind in sorted(vars(found).items()) if inspect.isclass(kind)]
    kinds.sort(key=lambda kind: (len(kind.__mro__), kind.__name__))
    types = Types({kind.__name__ for kind in kinds})
    lines = [line for kind in kinds for line in class_lines(kind, types)]
    head = ["from typing import Any, Sequence, Tuple, overload", ""]
    head += [f"import {name}" for name in sorted(types.modules)] + [""]
    with open(output, "w", encoding="utf-8") as file:
        file.write("\n".join(head + lines))


if __name__ == "__main__":
    main(*sys.argv[1:])
