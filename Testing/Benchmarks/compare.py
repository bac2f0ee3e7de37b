#!/usr/bin/env python3
"""Compares the speed of two builds, and makes tables of one.

    compare.py OLD.json NEW.json          two results of remesh_benchmark
    compare.py --pairs N OLD NEW [-- OPTION...]
                                          two programs remesh_benchmark: runs both N times, by
                                          turns, with these options; medians of the ratios count
    compare.py --plain FILE.json          what a result's runs cost on top of plain ones: without
                                          features, placement and distances
    compare.py --markdown FILE.json       a table for a document

Ratios are new to old: below 1 is better. Seconds of files are compared relative to the calibration
beside them, which makes up for other machines (--raw: as they are); those of pairs as they are.
Exit status: 1 if `processor` or `memory` of any measurement is worse by more than the --threshold,
2 if there is nothing to compare.
"""
import argparse
import json
import statistics
import subprocess
import sys

JUDGED = ("processor", "memory")
PHASES = ("neighbors", "ownership", "clipping", "reduction", "optimizer")


class Unusable(Exception):
    """Results that cannot be compared."""


def load(text, name):
    """The figures {(case, triangles, points, d, threads, figure): figure} of a result."""
    figures = {}
    try:
        for case in json.loads(text)["cases"]:
            for one in case["measurements"]:
                key = (case["name"], one["triangles"], one["points"], one["dimension"],
                       one["threads"])
                for figure, content in one["figures"].items():
                    figures[(*key, figure)] = content
    except (KeyError, TypeError, ValueError) as error:
        raise Unusable(f"{name} is no result of remesh_benchmark: {error!r}") from error
    return figures


def read(path):
    try:
        with open(path, encoding="utf-8") as file:
            return file.read()
    except OSError as error:
        raise Unusable(str(error)) from error


def run(program, options):
    try:
        done = subprocess.run([program, *options], stdout=subprocess.PIPE, check=True)
    except (OSError, subprocess.CalledProcessError) as error:
        raise Unusable(str(error)) from error
    return load(done.stdout, program)


def ratios(old, new, raw):
    """{key: new / old} for what both measured, in seconds or memory."""
    found = {}
    for key in old.keys() & new.keys():
        if old[key]["unit"] in ("s", "MB"):
            part = "ratio" if "ratio" in old[key] and not raw else "value"
            before, after = old[key][part], new[key][part]
            found[key] = after / before if before else (1.0 if after == before else float("inf"))
    if not found:
        raise Unusable("the two have no measurement in common")
    return found


def compare_files(arguments):
    old, new = (load(read(path), path) for path in arguments.results)
    return old, new, {key: [ratio] for key, ratio in ratios(old, new, arguments.raw).items()}


def compare_programs(arguments):
    collected = {}
    for pair in range(arguments.pairs):
        order = (0, 1) if pair % 2 == 0 else (1, 0)  # neither is always the first
        result = {which: run(arguments.results[which], arguments.options) for which in order}
        for key, ratio in ratios(result[0], result[1], True).items():
            collected.setdefault(key, []).append(ratio)
    return result[0], result[1], collected


def compare_with_plain(arguments):
    figures = load(read(arguments.results[0]), arguments.results[0])
    plain, whole = ({("run" + key[0][len(kind):], *key[1:]): figure
                     for key, figure in figures.items()
                     if key[0].startswith(kind + "-") and key[-1] == "processor"}
                    for kind in ("plain", "run"))
    return plain, whole, {key: [ratio] for key, ratio in ratios(plain, whole, True).items()}


def report(old, new, collected, arguments):
    """Prints the comparison; True if something judged is worse than the threshold."""
    worse = False
    print(f"{'case':20} {'triangles':>9} {'points':>8} {'d':>4} {'thr':>3}  "
          f"{'figure':22} {'old':>11} {'new':>11}  ratio (lowest to highest)")
    order = {key: place for place, key in enumerate(old)}
    for key in sorted(collected, key=order.get):
        judged = key[-1] in JUDGED
        ratio = statistics.median(collected[key])
        slow = judged and arguments.threshold is not None and ratio > arguments.threshold
        worse = worse or slow
        if judged or arguments.all:
            spread = (f" ({min(collected[key]):.3f} to {max(collected[key]):.3f})"
                      if len(collected[key]) > 1 else "")
            print(f"{key[0]:20} {key[1]:9} {key[2]:8} {key[3]:4} {key[4]:3}  {key[5]:22} "
                  f"{old[key]['value']:11.5g} {new[key]['value']:11.5g}  {ratio:.3f}{spread}"
                  f"{'  WORSE' if slow else ''}")
    for key in sorted({k[:-1] for k in old.keys() ^ new.keys()}):
        print("only in one, or not alike:", *key)
    return worse


def count(number):
    """86482 -> 86 482."""
    return f"{number:,}".replace(",", " ")


def short(number):
    """Two or three digits, never an exponent for what is large."""
    return f"{number:.0f}" if number >= 100 else f"{number:.2g}"


def shares(figures):
    """What a measurement's time went to, or how much memory it took."""
    if "memory" in figures:
        return f"peak memory {figures['memory']['value']:.0f} MB"
    total = figures["processor"]["value"]
    return ", ".join(f"{phase} {100 * figures[phase + '_processor']['value'] / total:.0f} %"
                     for phase in PHASES if phase + "_processor" in figures and total)


def row(name, one):
    figures = one["figures"]
    cells = (name, count(one["triangles"]), count(one["points"]),
             short(figures["processor"]["value"]), short(figures["processor"]["ratio"]),
             shares(figures))
    return "| " + " | ".join(cells) + " |"


def note(case):
    """The figures that are neither time nor memory."""
    figures = dict(case["figures"])
    for one in case["measurements"]:
        figures.update((name, figure) for name, figure in one["figures"].items()
                       if figure["unit"] not in ("s", "MB"))
    words = [f"{name} {figure['value']:.3g} {figure['unit']}".removesuffix(" 1")
             for name, figure in figures.items()]
    return [f"- {case['name']}: {', '.join(words)}"] if words else []


def markdown(path):
    """A row for each evaluation and run, then what else was found."""
    text = read(path)
    load(text, path)
    result = json.loads(text)
    lines = ["| | triangles | points | processor s | ratio | |", "|---|--:|--:|--:|--:|---|"]
    for case in result["cases"]:
        kind = case["name"].split("-")[0]
        if kind in ("evaluation", "plain", "run", "few", "wide", "metric", "metric_bent",
                    "metric_run", "metric_unit"):
            lines += [row(kind.replace("_", ", "), one) for one in case["measurements"]]
    calibration = result["calibration"]
    lines += ["", f"Ratio: to vtkQuadricDecimation of {calibration['surface']} "
              f"({count(calibration['triangles'])} triangles) to {count(calibration['points'])} "
              f"points, {calibration['seconds']:.2g} s.", ""]
    for case in result["cases"]:
        lines += note(case)
    print("\n".join(lines))


def main():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("results", nargs="+", metavar="FILE")
    what = parser.add_mutually_exclusive_group()
    what.add_argument("--pairs", type=int, metavar="N")
    what.add_argument("--plain", action="store_true")
    what.add_argument("--markdown", action="store_true")
    parser.add_argument("--raw", action="store_true", help="seconds of files as they are")
    parser.add_argument("--all", action="store_true", help="print the parts, too")
    parser.add_argument("--threshold", type=float, metavar="RATIO", help="as 1.05")
    words = sys.argv[1:]
    options = words[words.index("--") + 1:] if "--" in words else []
    arguments = parser.parse_args(words[:words.index("--")] if "--" in words else words)
    arguments.options = options
    if len(arguments.results) != (1 if arguments.markdown or arguments.plain else 2):
        parser.error("one file for a table or --plain, else two")
    if arguments.pairs is not None and arguments.pairs < 1:
        parser.error("--pairs needs at least 1")
    try:
        if arguments.markdown:
            markdown(arguments.results[0])
            return 0
        compared = (compare_with_plain if arguments.plain else
                    compare_programs if arguments.pairs else compare_files)(arguments)
        return 1 if report(*compared, arguments) else 0
    except Unusable as error:
        print("compare.py:", error, file=sys.stderr)
        return 2


if __name__ == "__main__":
    sys.exit(main())
