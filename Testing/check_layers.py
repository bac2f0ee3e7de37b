#!/usr/bin/env python3
"""Keeps the tree in layers: who may include whom, and that every source is in a list.

1. Includes go Filters -> Adaptors -> Core/Pipeline -> Core/Remesh -> Core/Repair -> Core/Run ->
   stages -> Support; stages form no cycle.
2. One seam for each outside library: in the core only Support/Parallel includes VTK headers,
   nanoflann is included by the neighbour search alone, and vtkSMPTools is used by Parallel and
   one adaptor alone.
3. Every .cxx, and every test script, is named in its CMakeLists.txt.
"""
import re
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
FILTERS = ROOT / "Filters"
CORE = FILTERS / "Core"
INCLUDE = re.compile(r'^\s*#\s*include\s*([<"])([^>"]+)[>"]', re.MULTILINE)
RANK = {"Support": 0, "stage": 1, "Run": 2, "Repair": 3, "Remesh": 4, "Pipeline": 5, "Adaptors": 6,
        "Filters": 7}

problems = []


def room(path):
    """The folder (or, at the top of Core, the file's stem) that a file of Filters/ belongs to."""
    parts = path.relative_to(FILTERS).parts
    if parts[0] == "Core":
        return parts[1] if len(parts) > 2 else "Remesh"
    return "Adaptors" if parts[0] == "Adaptors" else "Filters"


def rank(name):
    return RANK.get(name, RANK["stage"])


def resolve(source, header):
    """The project's file that an #include means, or None for an outside one."""
    for folder in (source.parent, CORE, FILTERS):
        candidate = (folder / header).resolve()
        if candidate.is_file():
            return candidate
    return None


def sources(folder):
    return sorted(p for p in folder.rglob("*") if p.suffix in (".h", ".cxx", ".txx"))


def check_includes():
    stage_uses = {}
    for source in sources(FILTERS):
        here = room(source)
        in_core = CORE in source.parents
        name = source.relative_to(ROOT)
        text = source.read_text(encoding="utf-8")
        for _, header in INCLUDE.findall(text):
            target = resolve(source, header)
            if target is not None:
                there = room(target)
                if rank(there) > rank(here):
                    problems.append(f"{name}: {here} may not include {there} ({header})")
                if rank(there) == rank(here) == RANK["stage"] and there != here:
                    stage_uses.setdefault(here, set()).add(there)
            elif header.startswith("vtk") and in_core and source.stem != "Parallel":
                problems.append(f"{name}: a VTK header in the core ({header})")
            elif header.startswith("nanoflann") and here != "Voronoi":
                problems.append(f"{name}: nanoflann outside Core/Voronoi")
    return stage_uses


def check_cycles(uses):
    finished = set()

    def visit(stage, path):
        if stage in path:
            cycle = path[path.index(stage):] + [stage]
            problems.append("stages include each other: " + " -> ".join(cycle))
        elif stage not in finished:
            for other in sorted(uses.get(stage, ())):
                visit(other, path + [stage])
            finished.add(stage)

    for stage in sorted(uses):
        visit(stage, [])


def check_seams():
    for word, most in (("nanoflann.hpp", 1), ("vtkSMPTools.h", 3)):
        users = [p for p in sources(FILTERS) if word in
                 (header for _, header in INCLUDE.findall(p.read_text(encoding="utf-8")))]
        outside = [p for p in users if p.stem != "Parallel"] if most == 3 else users
        if len(users) > most or len(outside) > 1:
            problems.append(f"{word} is included by " +
                            ", ".join(str(p.relative_to(ROOT)) for p in users))


def check_lists():
    for folder, pattern in ((FILTERS, "*.cxx"), (FILTERS, "Adaptors/*.cxx"),
                            (FILTERS, "Core/**/*.cxx"), (FILTERS / "Python", "*.cxx"),
                            (FILTERS / "Python", "*.py"), (ROOT / "Testing/Core", "*.cxx"),
                            (ROOT / "Testing/Cxx", "*.cxx"),
                            (ROOT / "Testing/Benchmarks", "*.cxx"),
                            (ROOT / "Testing/Benchmarks", "Test*.py"),
                            (ROOT / "Testing/Python", "Test*.py"),
                            (ROOT / "Testing/ParaView", "Test*.py")):
        listed = (folder / "CMakeLists.txt").read_text(encoding="utf-8")
        words = set(re.findall(r"[\w./]+", re.sub(r"#.*", "", listed)))
        for source in sorted(folder.glob(pattern)):
            name = source.relative_to(folder)
            if str(name) not in words and str(name.with_suffix("")) not in words:
                problems.append(f"{source.relative_to(ROOT)}: not in {folder.name}/CMakeLists.txt")


check_cycles(check_includes())
check_seams()
check_lists()
print("\n".join(problems) if problems else "The layers are kept.")
sys.exit(1 if problems else 0)
