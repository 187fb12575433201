#!/usr/bin/python3
"""Writes every trial as a benchmark log of OMPL, which ompl_benchmark_statistics merges into a database for Planner Arena:

    make_ompl_logs.py RESULTS LOGS
    ompl_benchmark_statistics LOGS/*.log -d experiment.db
"""

import argparse
from pathlib import Path

import trials


def is_count(trial, column):
    return column not in trial["measured"] or column == "memory_bytes"


def number(value):
    if value is None:
        return "nan"
    return repr(value) if isinstance(value, int) else f"{value:.9g}"


def log_of(trial, grid):
    end = dict(zip(trial["columns"], trial["records"][-1]))
    properties = [
        ("graph states INTEGER", trial["tree"]["states"]),
        ("graph motions INTEGER", trial["tree"]["edges"]),
        ("solved BOOLEAN", int(trial["solved"])),
        ("solution length REAL", trial["cost"]),
        ("time REAL", end["processor_seconds"]),
        ("memory REAL", end["memory_bytes"] / 2**20),
    ]
    for column in trial["columns"]:
        properties.append((f"{column} {'INTEGER' if is_count(trial, column) else 'REAL'}", end[column]))
    settings = dict(trial["parameters"], method=trial["method"])
    # The time stands for a curve's place: no two records may have the same.
    series, last = [], -1.0
    for record in trial["records"]:
        row = dict(zip(trial["columns"], record))
        time = max(row["processor_seconds"], last + 1e-6)
        last = time
        series.append([time] + [row[column] for column in trial["columns"]])
    progress = ["time REAL"] + [f"{column} {'INTEGER' if is_count(trial, column) else 'REAL'}"
                                for column in trial["columns"]]
    lines = [
        f"OMPL version {trial['versions']['OMPL']}",
        f"Experiment {grid['name']}_{trial['scene']}_r{trial['robots']}",
        "2 experiment properties",
        f"robots INTEGER = {trial['robots']}",
        f"trial INTEGER = {trial['number']}",
        f"Running on {trial['machine']['host']}",
        f"Starting at {trial['date']}",
        "<<<|",
        f"{trial['trial']} of the grid {grid['name']}, {grid['grid']}",
        "|>>>",
        "<<<|",
        trial["machine"]["processor"],
        "|>>>",
        f"{trial['seed']} is the random seed",
        "0 seconds per run",
        "0 MB per run",
        "1 runs per planner",
        f"{trial['wall_seconds']:.9g} seconds spent to collect the data",
        "0 enum types",
        "1 planners",
        f"geometric_{trial['planner']}[{trial['method']}]",
        f"{len(settings)} common properties",
        *(f"{key} = {value}" for key, value in settings.items()),
        f"{len(properties)} properties for each run",
        *(name for name, _ in properties),
        "1 runs",
        "".join(number(value) + "; " for _, value in properties),
        f"{len(progress)} progress properties for each run",
        *progress,
        "1 runs",
        "".join("".join(number(value) + "," for value in point) + ";" for point in series),
        ".",
    ]
    return "\n".join(lines) + "\n"


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n\n")[0])
    parser.add_argument("results", help="the folder that certificates experiment has filled")
    parser.add_argument("logs", help="the folder for the logs")
    arguments = parser.parse_args()
    grid = trials.read_grid(arguments.results)
    done = trials.read_trials(arguments.results)
    folder = Path(arguments.logs)
    folder.mkdir(parents=True, exist_ok=True)
    for trial in done:
        (folder / f"{trial['trial']}.log").write_text(log_of(trial, grid))
    print(f"{len(done)} logs in {folder}")


if __name__ == "__main__":
    trials.run_tool(main)
