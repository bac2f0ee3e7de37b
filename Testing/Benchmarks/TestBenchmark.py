"""remesh_benchmark on small surfaces: it runs, its JSON has the shape that Results.h tells and
values that fit together; compare.py sees what is slower.

    TestBenchmark.py BENCHMARK WORK [--program REMESH_SURFACE]
"""
import copy
import json
import math
import os
import subprocess
import sys

HERE = os.path.dirname(os.path.abspath(__file__))
PHASES = ("neighbors", "ownership", "clipping", "reduction", "optimizer")
failures = 0


def check(condition, *what):
    global failures
    if not condition:
        failures += 1
        print("FAILED:", *what)


def call(*words):
    done = subprocess.run(words, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True,
                          check=False)
    return done.returncode, done.stdout, done.stderr


def compare(*words):
    return call(sys.executable, os.path.join(HERE, "compare.py"), *words)


def check_figures(figures, calibration, where):
    check(isinstance(figures, dict), where, "has no figures")
    for name, figure in figures.items():
        value = figure["value"]
        check(isinstance(value, (int, float)) and math.isfinite(value), where, name, value)
        check(figure["unit"] in ("s", "us", "MB", "%", "1"), where, name, figure["unit"])
        check(("ratio" in figure) == (figure["unit"] == "s"), where, name, "ratio")
        if "ratio" in figure:
            check(abs(figure["ratio"] * calibration - value) <= 1e-9 * abs(value), where, name)
            # What is left for the optimiser is a difference.
            check(value >= (-1e-4 if name.startswith("optimizer") else 0.0), where, name, value)


def check_measurement(case, one):
    where = (case["name"], one.get("points"))
    check(isinstance(one["surface"], str) and one["surface"], *where, "surface")
    for name, least in (("triangles", 200), ("points", 20), ("dimension", 3), ("threads", 1)):
        check(isinstance(one[name], int) and one[name] >= least, *where, name, one[name])
    figures = one["figures"]
    check(figures, *where, "no figures")
    check_figures(figures, case["calibration"], where)
    if "clipping_wall" in figures:
        for clock in ("processor", "wall"):
            total = figures[clock]["value"]
            parts = sum(figures[f"{phase}_{clock}"]["value"] for phase in PHASES)
            check(total > 0.0 and abs(parts - total) <= 1e-6 * total + 1e-9, *where, parts, total)
    if case["name"].startswith(("plain-", "run-", "metric_run-", "metric_unit-")):
        check(figures["wall"]["value"] > 0.0 and figures["processor"]["value"] > 0.0, *where)
        check(5.0 < figures["memory"]["value"] < 1000.0, *where, figures["memory"])
        # With unit edges the metric decides: here 110 where --complexity asks for 100.
        most = 0.2 if case["name"].startswith("metric_unit-") else 0.01
        share = figures["points_over_asked"]["value"]
        check(abs(share - 1.0) < most, *where, share)
    if case["name"].startswith("few-"):
        check(figures["processor"]["value"] > 0.0 and one["points"] == 20, *where)
    if case["name"].startswith("wide-"):
        check(figures["memory_multiple"]["value"] > 1.0 and one["dimension"] == 5000, *where)
    if case["name"].startswith(("metric-", "metric_bent-")):
        ratio = figures["processor"]["value"] / figures["remeshing_processor"]["value"]
        check(abs(figures["over_remeshing"]["value"] - ratio) <= 1e-9 * ratio, *where, ratio)
        check(figures["wall"]["value"] > 0.0 and figures["remeshing_wall"]["value"] > 0.0, *where)
        check(5.0 < figures["memory"]["value"] < 1000.0, *where, figures["memory"])
        kind = "square" if case["name"].startswith("metric_bent-") else "torus"
        check(one["surface"] == kind, *where, one["surface"])
    if case["name"].startswith("exact-"):
        check(figures["processor"]["value"] > 0.0, *where, figures)
        check(-90.0 < figures["exactness"]["value"] < 900.0, *where, figures)
    if case["name"] == "scaling-ranks":
        check_ranks(one["points"], one["triangles"], figures, where)
    if case["name"].startswith("energy-"):
        check(0.0 <= figures["energy_above_converged"]["value"] < 20.0, *where, figures)
        check(figures["steps_to_0.3_percent"]["value"] >= 0, *where, figures)


def check_ranks(points, triangles, figures, where):
    """What is sent for an evaluation: the sites, handed on, and back the sums of blocks."""
    def value(name):
        return figures[name]["value"]
    for stage in ("", "distance_"):
        for ranks in (1, 2, 4):
            check(value(f"{stage}wall_{ranks}") > 0.0 and value(f"{stage}first_{ranks}") > 0.0,
                  *where, stage, ranks)
        for ranks in (2, 4):
            check(value(f"{stage}other_{ranks}") > 0.0, *where, stage, ranks)
    for ranks in (2, 4):
        check(1.0 < value(f"memory_other_{ranks}") < value("memory_1"), *where, ranks)
        times = ranks // 2  # ranks that hear it from the first
        check(48 * points <= 1e6 * value(f"sent_{ranks}") / times <= 48 * points + 150, *where,
              value(f"sent_{ranks}"))
        check(value(f"back_{ranks}") > 0.5e-6 * 68 * points / ranks, *where)
        # The mesh of about so many points to each that hears it, and triangles of the surface.
        mesh = times * 48 * points
        check(0.9 * mesh <= 1e6 * value(f"distance_sent_{ranks}") <= 1.1 * mesh + 75 * triangles,
              *where, value(f"distance_sent_{ranks}"))
        check(0 < 1e6 * value(f"distance_back_{ranks}") < 32 * 1024 + 1000, *where)


def check_exponent(case):
    """The slope of log seconds over log triangles, of any load's times."""
    sizes = [math.log(one["triangles"]) for one in case["measurements"]]
    costs = [math.log(one["figures"]["processor"]["value"]) for one in case["measurements"]]
    check(len(sizes) == 5 and max(sizes) - min(sizes) > math.log(50), sizes)
    mean = sum(sizes) / len(sizes)
    slope = (sum((size - mean) * cost for size, cost in zip(sizes, costs)) /
             sum((size - mean) ** 2 for size in sizes))
    exponent = case["figures"]["exponent"]["value"]
    check(abs(exponent - slope) <= 1e-9, "exponent", exponent, slope)


def check_result(result, names):
    calibration = result["calibration"]
    check(calibration["surface"] == "bumpy torus" and calibration["triangles"] > 500 and
          calibration["seconds"] > 0.0, calibration)
    check(result["machine"]["threads"] >= 1 and result["machine"]["vtk"], result["machine"])
    check(result["settings"]["repetitions"] == 1 and result["settings"]["shrink"] == 100,
          result["settings"])
    cases = {case["name"]: case for case in result["cases"]}
    check(list(cases) == names, list(cases), names)
    for case in cases.values():
        check(case["calibration"] > 0.0 and case["measurements"], case["name"])
        check_figures(case["figures"], case["calibration"], case["name"])
        for one in case["measurements"]:
            check_measurement(case, one)
    dimensions = [one["dimension"] for one in cases["scaling-dimension"]["measurements"]]
    check(dimensions == [3, 6, 8, 10, 17, 100, 1000], dimensions)
    check(set(cases["scaling-size"]["figures"]) == {"per_triangle", "per_point", "deviation"})
    check_exponent(cases["scaling-ratio"])
    # Two triangles for each point, but at the border.
    for name, asked in (("metric-200k-10k", 2e3), ("metric-2M-10k", 2e4),
                        ("metric_bent-200k-4k", 2e3), ("metric_run-200k-10k", 2e3),
                        ("metric_unit-200k-10k", 2e3)):
        size = cases[name]["measurements"][0]["triangles"]
        check(0.9 < size / asked < 1.1, name, size)
    check({"processor_2", "processor_4", "distance_processor_2", "distance_processor_4"} <=
          set(cases["scaling-ranks"]["figures"]), "scaling-ranks")
    speedups = cases["scaling-threads"]["figures"]
    check(speedups and all(figure["value"] == 1.0 if name.endswith("_1") else figure["value"] > 0.0
                           for name, figure in speedups.items()), speedups)


def write(path, content):
    with open(path, "w", encoding="utf-8") as file:
        file.write(content if isinstance(content, str) else json.dumps(content))
    return path


def slowed(result, case, factor):
    """The same result, but one case takes `factor` times as long."""
    other = copy.deepcopy(result)
    for one in next(c for c in other["cases"] if c["name"] == case)["measurements"]:
        for figure in one["figures"].values():
            if figure["unit"] == "s":
                figure["value"] *= factor
                figure["ratio"] *= factor
    return other


def with_runs_over_plain(result, factor):
    """The same result, but runs take so many times the plain ones' time."""
    other = copy.deepcopy(result)
    cases = {case["name"]: case for case in other["cases"]}
    for name, case in cases.items():
        plain = cases.get(name.replace("run-", "plain-")) if name.startswith("run-") else None
        if plain:
            for one, base in zip(case["measurements"], plain["measurements"]):
                one["figures"]["processor"]["value"] = (
                    factor * base["figures"]["processor"]["value"])
    return other


def on_machine(result, factor):
    """The same result from a machine that takes `factor` times as long for anything."""
    other = copy.deepcopy(result)
    for case in other["cases"]:
        case["calibration"] *= factor
        for one in case["measurements"]:
            for figure in one["figures"].values():
                figure["value"] *= factor if figure["unit"] == "s" else 1.0
    return other


def check_compare(result, work):
    same = write(os.path.join(work, "same.json"), result)
    slow = write(os.path.join(work, "slow.json"), slowed(result, "evaluation-86k-10k", 1.2))
    elsewhere = write(os.path.join(work, "elsewhere.json"), on_machine(result, 3.0))
    status, out, _ = compare(same, same, "--threshold", "1.0", "--all")
    check(status == 0 and "WORSE" not in out and " 1.000" in out, "same", status, out)
    status, out, _ = compare(same, slow, "--threshold", "1.1")
    worse = [line for line in out.splitlines() if line.endswith("WORSE")]
    check(status == 1 and len(worse) == 1 and worse[0].startswith("evaluation-86k-10k ") and
          " 1.200" in worse[0], "slow", status, out)
    check(compare(same, slow)[0] == 0, "no threshold, no judgement")
    check(compare(same, slow, "--threshold", "1.3")[0] == 0, "within the threshold")
    check(compare(slow, same, "--threshold", "1.1")[0] == 0, "faster is fine")
    check(compare(same, elsewhere, "--threshold", "1.01")[0] == 0, "another machine")
    check(compare(same, elsewhere, "--threshold", "1.01", "--raw")[0] == 1, "as it is")
    larger = copy.deepcopy(result)
    for case in larger["cases"]:
        for one in case["measurements"]:
            one["points"] += 1
    for wrong in (larger, "{}", "no JSON", {"cases": [{"name": "x"}]}):
        path = write(os.path.join(work, "wrong.json"), wrong)
        check(compare(same, path, "--threshold", "1.1")[0] == 2, "wrong:", str(wrong)[:40])
    check(compare(same, os.path.join(work, "none.json"))[0] == 2, "no file")
    check(compare(same)[0] == 2, "one file")
    doubled = write(os.path.join(work, "doubled.json"), with_runs_over_plain(result, 2.0))
    status, out, _ = compare("--plain", doubled, "--threshold", "1.5")
    check(status == 1 and out.count("  WORSE") == out.count("\nrun-") >= 1 and
          "  2.000" in out and "plain-" not in out, "plain", status, out)
    check(compare("--plain", doubled, "--threshold", "2.5")[0] == 0, "a cost within the threshold")
    status, out, _ = compare("--markdown", same)
    check(status == 0 and out.count("\n| evaluation |") == 5 and "exponent" in out, out)


def check_pairs(result, work):
    """Programs that give back results instead of measuring, and note that they were called."""
    def program(name, content):
        file = write(os.path.join(work, name + ".json"), content)
        path = write(os.path.join(work, name),
                     f"#!/bin/sh\necho {name} $* >>'{work}/calls'\ncat '{file}'\n")
        os.chmod(path, 0o755)
        return path
    calls = os.path.join(work, "calls")
    if os.path.exists(calls):
        os.remove(calls)
    old = program("old", result)
    new = program("new", slowed(result, "scaling-ratio", 1.5))
    status, out, _ = compare("--pairs", "3", old, new, "--threshold", "1.1", "--", "--quick")
    worse = [line for line in out.splitlines() if line.endswith("WORSE")]
    check(status == 1 and len(worse) == 5 and
          all("1.500 (1.500 to 1.500)" in line for line in worse), "pairs", status, out)
    with open(calls, encoding="utf-8") as file:
        called = file.read().splitlines()
    order = ("old", "new", "new", "old", "old", "new")
    check(called == [name + " --quick" for name in order], called)
    check(compare("--pairs", "1", old, "/bin/false")[0] == 2, "a program that fails")


def check_command_line(benchmark):
    for words in (["--case", "none"], ["--case"], ["--what"], ["--threads", "0"],
                  ["--repetitions", "1.5"], ["--shrink", "x"], ["--json"]):
        status, out, err = call(benchmark, *words)
        check(status == 2 and not out and err.startswith("remesh_benchmark: "), words, status, err)
    status, _, err = call(benchmark, "--quick", "--case", "run-86k-10k", "--program", "/bin/false")
    check(status == 1 and "/bin/false" in err, status, err)
    status, out, _ = call(benchmark, "--quick", "--case", "scaling-dim*", "--newton", "1")
    check(status == 0 and [case["name"] for case in json.loads(out)["cases"]] ==
          ["scaling-dimension"], status)
    check("--case" in call(benchmark, "--help")[1], "--help")


def main():
    benchmark, work = sys.argv[1:3]
    work = os.path.join(work, "Benchmark")
    os.makedirs(work, exist_ok=True)
    listed = call(benchmark, "--list")[1].splitlines()
    names = [line.split(":")[0] for line in listed]
    check(len(names) >= 14, names)
    path = os.path.join(work, "quick.json")
    status, _, err = call(benchmark, "--quick", "--json", path, *sys.argv[3:])
    check(status == 0, err)
    if status == 0:
        with open(path, encoding="utf-8") as file:
            result = json.load(file)
        check_result(result, names)
        check_compare(result, work)
        check_pairs(result, work)
    check_command_line(benchmark)
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
