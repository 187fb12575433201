#!/usr/bin/python3
"""Writes one self-contained HTML page of an experiment: its figures, the workspaces, the machine, and the paper's
conclusions beside what was measured.

    make_report.py RESULTS TABLES FIGURES REPORT.html
"""

import argparse
import base64
import html
from pathlib import Path

import pandas as pd

import trials

STYLE = """body { font: 16px/1.5 sans-serif; color: #222; max-width: 1150px; margin: 2em auto; padding: 0 1em }
img, svg { max-width: 100%; height: auto } figure { margin: 1.5em 0 } figcaption { color: #555 }
.workspace svg { max-width: 420px }
table { border-collapse: collapse; margin: 1em 0 } th, td { border-bottom: 1px solid #ddd; padding: .3em .7em;
text-align: right; vertical-align: top } th { background: #f4f4f4 } td.text, th.text { text-align: left }
pre { background: #f6f6f6; padding: 1em; overflow-x: auto }"""

FROM = 1000  # iterations from which on relative times are judged: before, a run takes milliseconds


def percent(value):
    return "–" if pd.isna(value) else f"{100 * value:.2f} %"


def times(value):
    return "–" if pd.isna(value) else f"{value:.3f}"


def span(values, form):
    values = values.dropna()
    if values.empty:
        return "not measured"
    low, high = form(values.min()), form(values.max())
    return low if low == high else f"{low} to {high}"


def table(rows, header, text=()):
    def line(cells, tag):
        return "<tr>" + "".join(f"<{tag}{' class=text' if i in text else ''}>{cell}</{tag}>"
                                for i, cell in enumerate(cells)) + "</tr>"
    return "<table>" + line(header, "th") + "".join(line(row, "td") for row in rows) + "</table>"


def judged(cells, method):
    """The cells of a method from FROM iterations on that have a relative time"""
    return cells[(cells["method"] == method) & (cells["iterations"] >= FROM)].dropna(subset=["relative_1_median"])


def crossovers(cells, method):
    """Where the median relative time of a method is above 1: strings like 'RRT, 3 robots, from 20000 iterations'"""
    found = []
    for (scene, planner, robots), part in judged(cells, method).groupby(["scene", "planner", "robots"]):
        above = part[part["relative_1_median"] > 1.0]
        if not above.empty:
            last = part.loc[part["iterations"].idxmax()]
            found.append(f"{planner} in {scene} with R = {robots}: first at {above['iterations'].min()} iterations, "
                         f"largest median {above['relative_1_median'].max():.3f}, at {last['iterations']} iterations "
                         f"{last['relative_1_median']:.3f}")
    return found


def crossover_of_shared(cells):
    if judged(cells, "shared").empty:
        return f"Whether there is a crossover was not measured: no relative runtime from {FROM} iterations on."
    crossing = crossovers(cells, "shared")
    if not crossing:
        return f"No crossover: the median is not above 1 at any record from {FROM} iterations on."
    return f"Above 1: {'; '.join(crossing)}."


def conclusions(cells, end):
    def at(method, sizes, column):
        return end[(end["method"] == method) & sizes(end["robots"])][column]

    def many(robots):
        return robots > 2

    def few(robots):
        return robots <= 2

    def any_size(robots):
        return robots > 0

    rows = [(
        "Basic suffers from a curse of dimensionality that limits its usefulness for team sizes greater than 2; either "
        "Partial or Shared should be used instead of it.",
        "Proportion of nodes that need a check at the end, R ≤ 2: Basic "
        f"{span(at('basic', few, 'fraction_nodes_mean'), percent)}, Partial "
        f"{span(at('partial', few, 'fraction_nodes_mean'), percent)}, Shared "
        f"{span(at('shared', few, 'fraction_nodes_mean'), percent)}; R &gt; 2: Basic "
        f"{span(at('basic', many, 'fraction_nodes_mean'), percent)}, Partial "
        f"{span(at('partial', many, 'fraction_nodes_mean'), percent)}, Shared "
        f"{span(at('shared', many, 'fraction_nodes_mean'), percent)}.",
    )]
    rows.append((
        "Shared gives significant reductions for all team sizes and difficulties, but there is a graph size past which "
        "certificates cost more than standard checks. It should be used for R &gt; 2 while the tree is small enough.",
        "Median relative runtime of Shared at the end: "
        + ", ".join(f"{span(at('shared', any_size, f'relative_{d}_median'), times)} at difficulty {d}"
                    for d in trials.DIFFICULTIES)
        + f". {crossover_of_shared(cells)} All that certificates change is the time in checks, lookups included: "
        f"{span(at('shared', any_size, 'relative_checking_median'), times)} of the standard's.",
    ))
    partial = crossovers(cells, "partial")
    rows.append((
        "Partial gives moderate improvements when the team is small (R ≤ 2) and checking is cheap.",
        "Median relative runtime of Partial at difficulty 1, R ≤ 2, at the end: "
        f"{span(at('partial', few, 'relative_1_median'), times)}; of Shared "
        f"{span(at('shared', few, 'relative_1_median'), times)}; R &gt; 2: Partial "
        f"{span(at('partial', many, 'relative_1_median'), times)}, Shared "
        f"{span(at('shared', many, 'relative_1_median'), times)}."
        + (" Partial above 1: " + "; ".join(partial) + "." if partial else ""),
    ))
    return table(rows, ["The paper says", "Measured here"], text=(0, 1))


def summary(end):
    rows = []
    for (scene, planner, robots), part in end.groupby(["scene", "planner", "robots"]):
        for method in trials.METHODS[1:]:
            for _, cell in part[part["method"] == method].iterrows():
                rows.append([scene, planner, robots, trials.METHOD_LABELS[method],
                             span(pd.Series([cell["fewest"], cell["most"]]), str), cell["trials"],
                             percent(cell["fraction_nodes_mean"]), percent(cell["fraction_samples_mean"]),
                             percent(cell["fraction_motions_mean"])]
                            + [times(cell[f"relative_{d}_median"]) for d in trials.DIFFICULTIES]
                            + [f"{cell['certificates_mean']:.0f}", f"{cell['memory_bytes_mean'] / 2**20:.0f}"])
    header = ["scene", "planner", "R", "method", "iterations", "trials", "checks, of nodes", "of samples",
              "of samples of motions", "relative runtime", "× 10²", "× 10⁴", "certificates", "memory, MB"]
    return table(rows, header, text=(0, 1, 3))


def machines(done):
    kinds = {}
    for trial in done:
        kind = (trial["machine"]["processor"], trial["machine"]["processors"]) + tuple(trial["versions"].items())
        kinds.setdefault(kind, []).append(trial["date"])
    lines = []
    for (processor, processors, *versions), dates in kinds.items():
        text = ", ".join(f"{name} {value}" for name, value in versions if name != "optimized")
        lines.append(f"<p>{html.escape(processor)}, {processors} processors; {html.escape(text)}; {len(dates)} trials from "
                     f"{min(dates)} to {max(dates)}.</p>")
    return "".join(lines)


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n\n")[0])
    parser.add_argument("results", help="the folder that certificates experiment has filled")
    parser.add_argument("tables", help="the folder that make_tables.py has filled")
    parser.add_argument("figures", help="the folder that make_figures.py has filled")
    parser.add_argument("report", help="the page to write")
    arguments = parser.parse_args()
    grid, done = trials.read_grid(arguments.results), trials.read_trials(arguments.results)
    cells = pd.read_csv(Path(arguments.tables) / "cells.csv")
    end = trials.ends_of(pd.read_csv(Path(arguments.tables) / "records.csv"))
    name = html.escape(grid["name"])
    parts = [f"<!DOCTYPE html><html lang=en><head><meta charset=utf-8><title>{name}</title><style>{STYLE}</style></head>",
             f"<body><h1>Experiment {name}</h1>",
             f"<p>{len(done)} of {len(grid['trials'])} trials.</p>", machines(done),
             "<h2>The paper's conclusions</h2>", conclusions(cells, end), "<h2>Workspaces</h2>"]
    for picture in sorted((Path(arguments.results) / "scenes").glob("*.svg")):
        svg = picture.read_text()
        parts.append(f"<figure class=workspace>{svg[svg.index('<svg'):]}<figcaption>{html.escape(picture.stem)}"
                     "</figcaption></figure>")
    parts.append("<h2>Figures</h2><p>Numbered as in the paper. Checks are those of single robots; relative runtimes are "
                 "ratios to the standard method in the same trial, and at difficulties 10² and 10⁴ the time in the "
                 "checks is scaled and the rest is not.</p>")
    for picture in sorted(Path(arguments.figures).glob("*.png")):
        data = base64.b64encode(picture.read_bytes()).decode()
        parts.append(f"<figure><img alt='{picture.stem}' src='data:image/png;base64,{data}'>"
                     f"<figcaption>{picture.stem}</figcaption></figure>")
    parts += ["<h2>At the end of the runs</h2><p>Proportions are means over trials, relative runtimes medians.</p>",
              summary(end), "<h2>The grid</h2>", f"<pre>{html.escape(grid['text'])}</pre>", "</body></html>"]
    Path(arguments.report).write_text("\n".join(parts) + "\n")
    print(arguments.report)


if __name__ == "__main__":
    trials.run_tool(main)
