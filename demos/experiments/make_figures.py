#!/usr/bin/python3
"""Draws the paper's figures 6 to 9 from the tables, as PDF and PNG, and one of what the paper does not show.

    make_figures.py TABLES FIGURES
"""

import argparse
from pathlib import Path

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import pandas as pd
from matplotlib.ticker import FuncFormatter, LogLocator, NullFormatter

import trials

COLORS = {"fcl": "#999999", "standard": "#555555", "basic": "#d55e00", "partial": "#0072b2", "shared": "#009e73"}
STYLES = {"fcl": ":", "standard": ":", "basic": "-.", "partial": "--", "shared": "-"}

# The paper's figures of the proportion of checks and of relative runtime
PAPER = {"RRT": (6, 8), "RRTstar": (7, 9)}
PLANNER_LABELS = {"RRTstar": "RRT*"}


def label_of(planner):
    return PLANNER_LABELS.get(planner, planner)


def name_of(kind, scene, planner, scenes):
    """What a figure's file is called; the scene is named where there are several"""
    numbers = dict(zip(("checks", "runtime"), PAPER.get(planner, ())))
    parts = [f"figure{numbers[kind]}"] if kind in numbers else []
    return "_".join(parts + [planner, kind] + ([scene] if len(scenes) > 1 else []))


def plain(value, _):
    return f"{value:g}"


def style_axis(axis, low, high):
    axis.set_xscale("log")
    axis.set_yscale("log")
    axis.set_ylim(low, high)
    axis.grid(True, which="major", color="#dddddd", linewidth=0.6)
    axis.xaxis.set_minor_formatter(NullFormatter())
    axis.yaxis.set_major_formatter(FuncFormatter(plain))
    axis.yaxis.set_major_locator(LogLocator(base=10, subs=(1.0,) if high / low > 30 else (1.0, 2.0, 5.0)))
    axis.yaxis.set_minor_formatter(NullFormatter())
    for side in ("top", "right"):
        axis.spines[side].set_visible(False)


def limits(cells, column, low, high):
    """The range of the figure's curves, a little widened, and in any case from low to high"""
    values = cells[[f"{column}_p10", f"{column}_p90"]].stack()
    values = values[values > 0]
    if values.empty:
        return low, high
    return min(low, 0.85 * values.min()), max(high, 1.15 * values.max())


def draw_panels(cells, rows, first, title, methods):
    """A row for each (column, label, lowest, highest), a panel for each team size, a curve for each method"""
    sizes = sorted(cells["robots"].unique())
    figure, axes = plt.subplots(len(rows), len(sizes), figsize=(1.2 + 2.15 * len(sizes), 0.9 + 2.1 * len(rows)),
                                sharex=True, sharey="row", squeeze=False)
    for row, (column, label, low, high) in enumerate(rows):
        shown = cells[(cells["iterations"] >= first) & cells["method"].isin(methods)]
        bottom, top = limits(shown, column, low, high)
        for panel, robots in enumerate(sizes):
            axis = axes[row][panel]
            style_axis(axis, bottom, top)
            if not column.startswith(("certificates", "memory")):
                axis.axhline(1.0, color="black", linestyle=":", linewidth=1.0)
            for method in methods:
                curve = shown[(shown["robots"] == robots) & (shown["method"] == method)]
                axis.plot(curve["iterations"], curve[f"{column}_mean"], STYLES[method], color=COLORS[method],
                          linewidth=1.5, label=trials.METHOD_LABELS[method])
                axis.fill_between(curve["iterations"], curve[f"{column}_p10"], curve[f"{column}_p90"],
                                  color=COLORS[method], alpha=0.15, linewidth=0)
            if row == 0:
                axis.set_title("1 robot" if robots == 1 else f"{robots} robots", fontsize=10)
            if panel == 0:
                axis.set_ylabel(label, fontsize=9)
            axis.tick_params(labelsize=8)
    counts = cells.groupby("robots")["trials"].max()
    number = f"{counts.min()}" if counts.min() == counts.max() else f"{counts.min()} to {counts.max()}"
    axes[-1][len(sizes) // 2].set_xlabel("iteration", fontsize=9)
    handles, labels = axes[0][0].get_legend_handles_labels()
    spread = "one trial" if number == "1" else f"mean over {number} trials, band from 10th to 90th percentile"
    figure.suptitle(f"{title}: {spread}", fontsize=11)
    figure.legend(handles, labels, loc="lower center", ncol=len(labels), frameon=False, fontsize=9)
    figure.tight_layout(rect=(0, 0.3 / figure.get_figheight(), 1, 1))
    return figure


def save(figure, folder, name):
    figure.savefig(folder / f"{name}.pdf", metadata={"CreationDate": None})
    figure.savefig(folder / f"{name}.png", dpi=110)
    plt.close(figure)
    print(name)


def draw_all(cells, folder):
    scenes = sorted(cells["scene"].unique())
    methods = [method for method in trials.METHODS if method in set(cells["method"]) and method not in ("fcl", "standard")]
    for (scene, planner), part in cells.groupby(["scene", "planner"]):
        what = label_of(planner) + (f", {scene}" if len(scenes) > 1 else "")
        if part.loc[part["method"].isin(methods), "fraction_nodes_mean"].notna().any():
            rows = [("fraction_nodes", "proportion of nodes", 0.01, 1.2),
                    ("fraction_samples", "proportion of samples", 0.01, 1.2),
                    ("fraction_motions", "proportion of samples\nof motions", 0.001, 1.2)]
        else:
            rows = [("fraction_motions", "proportion of samples\nof motions", 0.001, 1.2)]
        save(draw_panels(part, rows, 10, f"{what}: robots that need a collision check", methods), folder,
             name_of("checks", scene, planner, scenes))
        if part["relative_1_mean"].notna().any():
            rows = [(f"relative_{difficulty}",
                     "relative runtime" if difficulty == 1 else
                     f"relative runtime,\ndifficulty $10^{len(str(difficulty)) - 1}$", 0.5, 1.5)
                    for difficulty in trials.DIFFICULTIES]
            save(draw_panels(part, rows, 100, f"{what}: runtime relative to standard collision checking", methods),
                 folder, name_of("runtime", scene, planner, scenes))
        stored = part.assign(**{f"memory_mb_{s}": part[f"memory_bytes_{s}"] / 2**20 for s in ("mean", "p10", "p90")})
        rows = [("certificates", "certificates stored", 50, 100), ("memory_mb", "memory grown by, MB", 0.5, 2.0)]
        save(draw_panels(stored, rows, 100, f"{what}: what is stored", methods + ["fcl"]), folder,
             name_of("stored", scene, planner, scenes))


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n\n")[0])
    parser.add_argument("tables", help="the folder that make_tables.py has filled")
    parser.add_argument("figures", help="the folder for the figures")
    arguments = parser.parse_args()
    folder = Path(arguments.figures)
    folder.mkdir(parents=True, exist_ok=True)
    draw_all(pd.read_csv(Path(arguments.tables) / "cells.csv"), folder)


if __name__ == "__main__":
    trials.run_tool(main)
