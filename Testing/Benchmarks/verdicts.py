#!/usr/bin/python3
"""Tells which runs of remesh_surface became better or worse, and which make other bytes.

    verdicts.py run PROGRAM TABLE       runs the program on surfaces of all kinds, each with several
                                        numbers of points and anisotropies; a row for each run. A
                                        table that is there in part is gone on with.
    verdicts.py compare BEFORE AFTER    two such tables, row by row
    verdicts.py wrong TABLE             the rows of a table that are not right

The verdict of a run is an ordered record: the first entry that differs decides which of two is
better. Distances, in units of the input, differ from two percent on.
Exit status: 1 if any row is worse (compare), or a run is interrupted; 2 if there is nothing to do.

Seconds are those of the processor, on all threads. Bytes are those of points and triangles. They are the same for any number of threads, but not for
any compiler and processor: compare tables of one machine.
"""
import argparse
import fnmatch
import hashlib
import json
import math
import os
import re
import resource
import subprocess
import sys
import tempfile
import time

import verdict_surfaces

POINTS = ["500", "2000", "10000"]
ANISOTROPY = ["0", "0.04", "0.1"]
MESHES = (".vtp", ".vtk", ".ply", ".stl", ".obj", ".off", ".vtu", ".glb", ".gltf")
OUTCOMES = ("done", "error", "timeout", "crash")  # from good to bad
PROOFS = ("proven", "none", "lost")  # none: the surface is no manifold, and there is none
# What is wrong, the worst first: the order of this list is the order of the verdict.
RECORD = ("outcome", "off", "topology", "faults", "inverted", "strays", "crossings", "rms",
          "largest")
DISTANCES = ("rms", "largest")
COLUMNS = ("surface", "n", "s", *RECORD, "bytes", "seconds", "warnings")
WIDTHS = (28, -6, -5, -8, -6, -9, -7, -9, -7, -10, -10, -10, 13, -8, 0)  # negative: to the right
# Entries of the report's output, by the names of all versions; not every version has all.
REPORTED = {"off": ("extra_points",), "inverted": ("inverted_triangles", "flipped_triangles"),
            "strays": ("stray_triangles",), "crossings": ("self_intersections", "crossings"),
            "rms": ("rms_distance",), "largest": ("maximum_distance",)}
ABSENT = "-"
TOLERANCE = 1.02  # of distances, whose last digits any other sum changes
ROUNDING = 1e-7  # of the diagonal: distances below are those of coordinates in single precision


class Unusable(Exception):
    """Tables or programs that cannot be used."""


# --- tables ---------------------------------------------------------------------------------------

def line_of(row):
    cells = (f"{row[name]:{'>' if width < 0 else '<'}{abs(width)}}"
             for name, width in zip(COLUMNS, WIDTHS))
    return " ".join(cells).rstrip()


def key_of(row):
    return row["surface"], int(row["n"]), float(row["s"])


def load(path):
    """The build and the rows {(surface, n, s): {column: text}} of a table."""
    build, rows = None, {}
    try:
        with open(path, encoding="utf-8") as file:
            lines = [line for line in file.read().splitlines() if line]
    except (OSError, UnicodeDecodeError) as error:
        raise Unusable(str(error)) from error
    if len(lines) < 2 or tuple(lines[1].split()) != COLUMNS:
        raise Unusable(f"{path} is no table of verdicts with the columns {' '.join(COLUMNS)}")
    build = lines[0].removeprefix("# ")
    for line in lines[2:]:
        row = dict(zip(COLUMNS, line.split(None, len(COLUMNS) - 1)))
        try:
            judge(row)
            rows[key_of(row)] = row
        except (KeyError, ValueError) as error:
            raise Unusable(f"{path}: not a row: {line}") from error
    return build, rows


def save(path, build, rows):
    """All rows or, if the writing is interrupted, those of before."""
    head = ["# " + build, line_of({name: name for name in COLUMNS})]
    with open(path + ".part", "w", encoding="utf-8") as file:
        file.write("\n".join(head + [line_of(rows[key]) for key in sorted(rows)]) + "\n")
    os.replace(path + ".part", path)


# --- one run --------------------------------------------------------------------------------------

def faults_of(sentence):
    """The sum of what a sentence counts: "... topology: 1 cell is no disk, 2 pairs of ..." is 3."""
    return sum(int(count) for count in re.findall(r"[:,] (\d+) ", sentence))


def first_words(warnings):
    """What kinds of warnings there are, without their numbers."""
    kinds = {" ".join(re.sub(r"\d[^\s,]*", "N", text).split()[:5]).rstrip(".,:")
             for text in warnings}
    return "; ".join(sorted(kinds)) or ABSENT


def verdict_of(report, diagonal):
    """The record of a run that has a result."""
    def number(name):
        found = (report["output"].get(key) for key in REPORTED[name])
        return next((value for value in found if value is not None), None)

    verdict = {"outcome": "done", "warnings": first_words(report["warnings"])}
    for name in REPORTED:
        value = number(name)
        if value is None:
            verdict[name] = ABSENT
        elif name in DISTANCES:
            verdict[name] = f"{value:.3g}" if value > ROUNDING * diagonal else "0"
        else:
            verdict[name] = str(round(value))
    sentence = report["topology"]["report"]
    proof = 0 if report["topology"]["preserved"] == 1 else 1 if "no manifold" in sentence else 2
    verdict["topology"] = PROOFS[proof]
    verdict["faults"] = "0" if proof == 1 else str(faults_of(sentence))
    return verdict


def processor_seconds():
    """Of all programs run so far that have ended."""
    used = resource.getrusage(resource.RUSAGE_CHILDREN)
    return used.ru_utime + used.ru_stime


def run_case(program, surface, key, timeout, times=False):
    """The row of one run. It fails where the program does, with the error as its warning."""
    row = dict.fromkeys(COLUMNS, ABSENT)
    row.update(zip(COLUMNS, key))
    with tempfile.TemporaryDirectory() as folder:
        mesh, report = os.path.join(folder, "mesh.vtp"), os.path.join(folder, "report.json")
        command = [program, surface, mesh, "--points", key[1], "--anisotropy", key[2], "--quiet",
                   "--report", report]
        before = processor_seconds()
        try:
            done = subprocess.run(command, capture_output=True, encoding="utf-8", check=False,
                                  errors="replace", timeout=timeout)
        except subprocess.TimeoutExpired:
            return {**row, "outcome": "timeout"}
        except OSError as error:
            raise Unusable(str(error)) from error
        if times:
            row["seconds"] = f"{processor_seconds() - before:.2f}"
        if done.returncode != 0:
            failed = "error" if done.returncode > 0 else "crash"  # of a signal
            sentence = done.stderr.strip().removeprefix("remesh_surface: ")
            return {**row, "outcome": failed, "warnings": first_words([sentence])}
        row["bytes"], diagonal = verdict_surfaces.measure(mesh)
        with open(report, encoding="utf-8") as file:
            return {**row, **verdict_of(json.load(file), diagonal)}


# --- run ------------------------------------------------------------------------------------------

def build_of(program):
    """A name for what is run: the program and the project's library that it loads."""
    files = [program]
    try:
        loaded = subprocess.run(["ldd", program], capture_output=True, text=True, check=False)
        files += re.findall(r"=> (\S*AnisotropicRemeshing\S*)", loaded.stdout)
    except OSError:
        pass  # no such tool: the program alone
    digest = hashlib.sha256()
    try:
        for name in files:
            with open(name, "rb") as file:
                digest.update(file.read())
        version = subprocess.run([program, "--version"], capture_output=True, text=True, check=True)
    except (OSError, subprocess.CalledProcessError) as error:
        raise Unusable(str(error)) from error
    return f"{version.stdout.strip()}, build {digest.hexdigest()[:12]}"


def surfaces_of(arguments):
    """{name: path of the mesh, or None for what has to be made}."""
    found = {} if arguments.no_generated else dict.fromkeys(verdict_surfaces.SURFACES)
    if arguments.data:
        try:
            for name in sorted(os.listdir(arguments.data)):
                if name.lower().removesuffix(".gz").endswith(MESHES):
                    found[name.replace(" ", "_")] = os.path.join(arguments.data, name)
        except OSError as error:
            raise Unusable(str(error)) from error
    return {name: path for name, path in found.items() if not arguments.only or
            any(fnmatch.fnmatchcase(name, pattern) for pattern in arguments.only)}


def tell(text, end="\n"):
    """Progress, on a terminal only."""
    if sys.stderr.isatty():
        print(f"\r\033[K{text}", end=end, file=sys.stderr, flush=True)


def run_missing(arguments, rows, build, folder):
    """Runs what is not in the table, and saves it after each run."""
    surfaces = surfaces_of(arguments)
    keys = [(name, n, s) for name in sorted(surfaces) for n in arguments.points
            for s in arguments.anisotropy]
    if not keys:
        raise Unusable("there is no such surface")
    for place, key in enumerate(keys):
        if (key[0], int(key[1]), float(key[2])) in rows:
            continue
        name = f"{place + 1}/{len(keys)} {' '.join(key)}"
        tell(name + " ...", end="")
        if surfaces[key[0]] is None:
            surfaces[key[0]] = os.path.join(folder, key[0] + ".vtp")
            verdict_surfaces.write(key[0], surfaces[key[0]])
        start = time.monotonic()
        row = run_case(arguments.program, surfaces[key[0]], key, arguments.timeout,
                       arguments.seconds)
        rows[key_of(row)] = row
        save(arguments.table, build, rows)
        tell(f"{name}: {summary(row)}, {time.monotonic() - start:.1f} s")
    print(f"{arguments.table}: {len(rows)} rows, {sum(is_wrong(r) for r in rows.values())} of them "
          "not right")


def run(arguments):
    build, rows = build_of(arguments.program), {}
    if os.path.exists(arguments.table):
        before, rows = load(arguments.table)
        if rows and before != build:
            raise Unusable(f"{arguments.table} is of another build ({before}, not {build}): "
                           "remove it, or name another table")
    try:
        with tempfile.TemporaryDirectory() as folder:
            run_missing(arguments, rows, build, folder)
    except KeyboardInterrupt:
        print(f"\ninterrupted: {len(rows)} rows are in {arguments.table}, and the same command "
              "goes on", file=sys.stderr)
        return 1
    return 0


# --- compare --------------------------------------------------------------------------------------

def entry_of(name, text):
    """A number that is larger where it is worse; None where there is none."""
    if text == ABSENT:
        return None
    ranks = {"outcome": OUTCOMES, "topology": PROOFS}.get(name)
    return ranks.index(text) if ranks else abs(float(text))


def judge(row):
    """The verdict as numbers, in its order."""
    return [entry_of(name, row[name]) for name in RECORD]


def is_worse(name, before, after):
    return after > before * (TOLERANCE if name in DISTANCES else 1.0)


def compare_rows(before, after):
    """-1, 0 or 1 for better, same or worse, and the name of the entry that decides."""
    for name, old, new in zip(RECORD, judge(before), judge(after)):
        if old is not None and new is not None:
            if is_worse(name, old, new):
                return 1, name
            if is_worse(name, new, old):
                return -1, name
    return 0, None


def is_wrong(row):
    """A run that failed, or a mesh with faults; not one that is far from its surface."""
    return any(entry_of(name, row[name]) for name in RECORD
               if name not in DISTANCES and row[name] != "none")


def summary(row):
    """What is wrong with a row, in words."""
    if not is_wrong(row):
        return "right"
    wrong = [row[name] if name in ("outcome", "topology") else f"{row[name]} {name}"
             for name in RECORD if name not in DISTANCES and entry_of(name, row[name])
             and row[name] != "none"]
    return ", ".join(wrong)


def mean_ratio(pairs):
    """The geometric mean of the RMS distances, after to before; None where there are none."""
    logs = [math.log(float(after["rms"]) / float(before["rms"])) for before, after in pairs
            if (entry_of("rms", before["rms"]) or 0.0) > 0.0
            and (entry_of("rms", after["rms"]) or 0.0) > 0.0]
    return math.exp(sum(logs) / len(logs)) if logs else None


def time_ratio(pairs):
    """The ratio of the sums of seconds, after to before; None where there are none."""
    sums = [sum(float(row["seconds"]) for row in rows if row["seconds"] != ABSENT)
            for rows in zip(*pairs)]
    return sums[1] / sums[0] if pairs and sums[0] > 0.0 else None


def print_difference(before, after):
    """A line for a row that is better; all of one that is worse. -1, 0 or 1, as compare_rows."""
    sign, name = compare_rows(before, after)
    if sign != 0:
        print(f"{'better' if sign < 0 else 'WORSE'}: {before['surface']} {before['n']} "
              f"{before['s']}: {name} {before[name]} -> {after[name]}")
    if sign > 0:
        print("  " + line_of({name: name for name in COLUMNS}))
        print("- " + line_of(before) + "\n+ " + line_of(after))
    return sign


def compare(arguments):
    (_, before), (_, after) = (load(path) for path in (arguments.before, arguments.after))
    keys = sorted(before.keys() & after.keys())
    if not keys:
        raise Unusable("the two have no row in common")
    pairs = [(before[key], after[key]) for key in keys]
    signs = [print_difference(*pair) for pair in pairs]
    bytes_, warnings = (sum(old[name] != new[name] for old, new in pairs)
                        for name in ("bytes", "warnings"))
    print(f"{signs.count(-1)} better, {signs.count(0)} same, {signs.count(1)} worse; "
          f"{bytes_} with other bytes, {warnings} with other warnings")
    ratio = mean_ratio(pairs)
    if ratio is not None:
        print(f"RMS distance, geometric mean of the ratios: {ratio:.4f}")
    for name, some in (("all rows", pairs),
                       ("rows that were not right", [pair for pair in pairs if is_wrong(pair[0])])):
        ratio = time_ratio(some)
        if ratio is not None:
            print(f"seconds of {name}, ratio of the sums: {ratio:.3f}")
    for path, lone in ((arguments.before, before.keys() - after.keys()),
                       (arguments.after, after.keys() - before.keys())):
        if lone:
            print(f"not compared: {len(lone)} rows that are in {path} alone")
    return 1 if 1 in signs else 0


def list_wrong(arguments):
    rows = load(arguments.table)[1]
    wrong = [rows[key] for key in sorted(rows) if is_wrong(rows[key])]
    for row in wrong:
        print(f"{row['surface']} {row['n']} {row['s']}: {summary(row)} ({row['warnings']})")
    print(f"{len(wrong)} of {len(rows)} rows are not right")
    return 0


# --- command line ---------------------------------------------------------------------------------

def parse(words):
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    commands = parser.add_subparsers(required=True, metavar="COMMAND")
    one = commands.add_parser("run", help="run the program on surfaces, into a table")
    one.add_argument("program", metavar="PROGRAM", help="remesh_surface")
    one.add_argument("table", metavar="TABLE")
    one.add_argument("--data", metavar="DIR", help="a folder whose meshes are run, too")
    one.add_argument("--no-generated", action="store_true", help="the folder's meshes alone")
    one.add_argument("--points", nargs="+", default=POINTS, metavar="N",
                     help=f"default {' '.join(POINTS)}")
    one.add_argument("--anisotropy", nargs="+", default=ANISOTROPY, metavar="S",
                     help=f"default {' '.join(ANISOTROPY)}")
    one.add_argument("--only", action="append", metavar="NAME",
                     help="surfaces of this name, or pattern as 'cad_*'; may be repeated")
    one.add_argument("--timeout", type=float, default=3600.0, metavar="SECONDS",
                     help="after which a run has failed; default 3600")
    one.add_argument("--seconds", action="store_true", help="note the processor time of each run")
    one.set_defaults(call=run)
    two = commands.add_parser("compare", help="compare two tables")
    two.add_argument("before", metavar="BEFORE")
    two.add_argument("after", metavar="AFTER")
    two.set_defaults(call=compare)
    three = commands.add_parser("wrong", help="list the rows that are not right")
    three.add_argument("table", metavar="TABLE")
    three.set_defaults(call=list_wrong)
    arguments = parser.parse_args(words)
    for name, kind in (("points", int), ("anisotropy", float)):
        for text in getattr(arguments, name, ()):
            try:
                kind(text)
            except ValueError:
                parser.error(f"--{name}: {text} is no number")
    return arguments


def main(words=None):
    arguments = parse(words)
    try:
        return arguments.call(arguments)
    except Unusable as error:
        print("verdicts.py:", error, file=sys.stderr)
        return 2


if __name__ == "__main__":
    sys.exit(main())
