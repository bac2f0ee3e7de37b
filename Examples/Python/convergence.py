"""Plots how the energy falls: Lloyd's iterations alone, and with the quasi-Newton method.

    convergence.py [--points N] [--picture FILE.png]

The plot needs matplotlib (Debian: python3-matplotlib); the numbers do not.
"""
import sys

import anisotropic_remeshing as ar
import shapes


def main(options):
    surface = shapes.knot()
    steps = {"Lloyd alone": {"lloyd_iterations": 35, "newton_iterations": 0},
             "Lloyd, then quasi-Newton": {"lloyd_iterations": 5, "newton_iterations": 30}}
    energies = {}
    for name, numbers in steps.items():
        result = ar.remesh(surface, options.points, coarse_start=False, features=False, **numbers)
        energies[name] = result.convergence["Energy"]
        print(f"{name}: energy {energies[name][0]:.5g} at first, {energies[name][-1]:.5g} in the "
              f"end, {result.report['number_of_evaluations']} diagrams")
    if options.picture:
        plot(options.picture, energies)


def plot(picture, energies):
    try:
        from matplotlib.figure import Figure
    except ImportError:
        sys.exit("convergence.py: the plot needs matplotlib (Debian: python3-matplotlib).")
    figure = Figure(figsize=(7.0, 3.6), layout="constrained")
    axes = figure.add_subplot()
    for (name, energy), color in zip(energies.items(), ("tab:orange", "tab:blue")):
        axes.plot(energy, marker=".", label=name, color=color)
    axes.set_xlabel("iteration")
    axes.set_ylabel("energy")
    last = min(energy[-1] for energy in energies.values())
    axes.set_ylim(0.99 * last, 1.12 * last)
    axes.grid(True, alpha=0.3)
    axes.legend()
    figure.savefig(picture, dpi=110)


if __name__ == "__main__":
    main(shapes.options(__doc__, 3000))
