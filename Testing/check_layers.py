#!/usr/bin/env python3
"""Keeps the tree in layers: who may include whom, and that every source is in a list.

    check_layers.py          tells what is wrong
    check_layers.py --draw   draws the rooms and their includes anew: Documentation/rooms.svg

1. Includes go Filters -> Adaptors -> Core/Pipeline -> Core/Remesh -> Core/Repair -> Core/Run ->
   stages -> Support; stages form no cycle.
2. One seam for each outside library: in the core only Support/Parallel includes VTK headers,
   nanoflann is included by the neighbour search alone, and vtkSMPTools is used by Parallel and
   one adaptor alone.
3. Every .cxx, and every test script, is named in its CMakeLists.txt.
4. The picture of the rooms is that of today.
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
    """Returns which rooms each room includes, and the same for stages alone."""
    uses, stage_uses = {}, {}
    for source in sources(FILTERS):
        here = room(source)
        in_core = CORE in source.parents
        name = source.relative_to(ROOT)
        text = source.read_text(encoding="utf-8")
        for _, header in INCLUDE.findall(text):
            target = resolve(source, header)
            if target is not None:
                there = room(target)
                uses.setdefault(here, set()).add(there)
                if rank(there) > rank(here):
                    problems.append(f"{name}: {here} may not include {there} ({header})")
                if rank(there) == rank(here) == RANK["stage"] and there != here:
                    stage_uses.setdefault(here, set()).add(there)
            elif header.startswith("vtk") and in_core and source.stem != "Parallel":
                problems.append(f"{name}: a VTK header in the core ({header})")
            elif header.startswith("nanoflann") and here != "Voronoi":
                problems.append(f"{name}: nanoflann outside Core/Voronoi")
    return uses, stage_uses


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


# --- The picture: a row for each level, lines to what is not included by way of others ------------
PICTURE = ROOT / "Documentation" / "rooms.svg"
WIDTH, BOX, ROW, MARGIN = 900, (124, 34), 78, 12


def levels_of(uses):
    """Each room's level: one above the highest that it includes."""
    levels = {}

    def level(name):
        if name not in levels:
            levels[name] = 1 + max((level(other) for other in uses.get(name, ())), default=-1)
        return levels[name]

    for name in sorted(uses):
        level(name)
    return levels


def reduced(uses):
    """Pairs of rooms, without those that follow from others."""
    reach = {}

    def below(name):
        if name not in reach:
            reach[name] = set(uses.get(name, ()))
            reach[name] |= {far for other in uses.get(name, ()) for far in below(other)}
        return reach[name]

    return sorted((name, other) for name, others in uses.items() for other in others
                  if not any(other in below(via) for via in others))


def draw(uses):
    uses = {name: others - {name} for name, others in uses.items()}
    levels = levels_of(uses)
    rows = {}
    for name in sorted(levels):
        rows.setdefault(levels[name], []).append(name)
    places = {}
    for level in sorted(rows):
        # As far as can be above what they include, so that few lines cross.
        def wish(name):
            found = [places[other][0] for other in uses.get(name, ()) if levels[other] > 0]
            return (sum(found) / len(found) if found else WIDTH / 2, name)
        row = sorted(rows[level], key=wish)
        for k, name in enumerate(row):
            places[name] = (WIDTH * (k + 0.5) / len(row), MARGIN + ROW * (max(rows) - level))
    height = 2 * MARGIN + ROW * max(rows) + BOX[1]
    lines = [f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {WIDTH} {height}" '
             'font-family="sans-serif" font-size="14" text-anchor="middle">',
             '<title>The rooms of Filters, each above those that it includes</title>',
             f'<rect width="{WIDTH}" height="{height}" fill="#ffffff"/>']
    for name, other in reduced(uses):
        (x, y), (u, v) = places[name], places[other]
        y += BOX[1]
        # To the side before the next row, then down.
        turn = ROW - BOX[1]
        lines.append(f'<path d="M{x:.0f} {y:.0f} C{x:.0f} {y + turn / 2:.0f} {u:.0f} '
                     f'{y + turn / 2:.0f} {u:.0f} {y + turn:.0f} V{v:.0f}" '
                     'fill="none" stroke="#8fa3b5" stroke-width="1.5"/>')
    for name, (x, y) in sorted(places.items()):
        fill = "#dcebf7" if rank(name) in (RANK["stage"], RANK["Support"]) else (
            "#fbe3c8" if rank(name) < RANK["Adaptors"] else "#e3efdb")
        lines.append(f'<rect x="{x - BOX[0] / 2:.0f}" y="{y:.0f}" width="{BOX[0]}" '
                     f'height="{BOX[1]}" rx="5" fill="{fill}" stroke="#5b6f80"/>')
        lines.append(f'<text x="{x:.0f}" y="{y + 22:.0f}" fill="#1c2833">{name}</text>')
    return "\n".join(lines) + "\n</svg>\n"


def check_picture(uses):
    if PICTURE.read_text(encoding="utf-8") != draw(uses):
        problems.append("Documentation/rooms.svg is of other rooms: check_layers.py --draw")


all_uses, stages = check_includes()
check_cycles(stages)
if problems:
    pass  # a cycle cannot be drawn
elif sys.argv[1:] == ["--draw"]:
    PICTURE.write_text(draw(all_uses), encoding="utf-8")
else:
    check_picture(all_uses)
check_seams()
check_lists()
print("\n".join(problems) if problems else "The layers are kept.")
sys.exit(1 if problems else 0)
