"""Reads the trials that certificates experiment has written."""

import json
import sys
from pathlib import Path

import pandas as pd

METHODS = ["fcl", "standard", "basic", "partial", "shared"]
METHOD_LABELS = {
    "fcl": "FCL alone",
    "standard": "Standard",
    "basic": "Basic Certificate",
    "partial": "Partial Certificate",
    "shared": "Shared Projection",
}
CELL = ["scene", "robots", "planner", "method"]
DIFFICULTIES = [1, 100, 10000]


class BadResults(Exception):
    """What is wrong with a folder of results, with the file's name"""


def run_tool(work):
    """Run a tool's main function; bad input ends it with one line and exit code 2."""
    try:
        work()
    except (BadResults, OSError) as error:
        print(f"{Path(sys.argv[0]).name}: {error}", file=sys.stderr)
        sys.exit(2)


def read_grid(folder):
    """The mark of a folder of results: the grid's name, hash, text and trials"""
    file = Path(folder) / "experiment.json"
    try:
        return json.loads(file.read_text())
    except FileNotFoundError:
        raise BadResults(f"{folder}: no results of certificates experiment, which has experiment.json") from None
    except ValueError as error:
        raise BadResults(f"{file}: damaged ({error})") from None


def read_trials(folder):
    """All trials of a folder that are done, as they are in their files, in the order of their names"""
    grid = read_grid(folder)
    trials = []
    for file in sorted((Path(folder) / "trials").glob("*.json")):
        try:
            trial = json.loads(file.read_text())
        except ValueError as error:
            raise BadResults(f"{file}: damaged ({error}); certificates experiment repairs it") from None
        if trial.get("grid") != grid["grid"]:
            raise BadResults(f"{file}: is of another grid")
        trials.append(trial)
    if not trials:
        raise BadResults(f"{folder}: no trial is done")
    return trials


def ratio(part, whole):
    """part / whole, nothing where whole is 0"""
    return part / whole.where(whole > 0)


def records_of(trials):
    """One row for each record of each trial, with what the trial is, the fractions and the relative times"""
    frames = []
    for trial in trials:
        frame = pd.DataFrame(trial["records"], columns=trial["columns"]).astype(float)
        for key in reversed(CELL + ["number", "seed"]):
            frame.insert(0, key, trial[key])
        frames.append(frame)
    records = pd.concat(frames, ignore_index=True)
    records["iterations"] = records["iterations"].astype(int)
    # The methods without certificates ask for every pose and count none of samples and nodes.
    without = records["method"].isin(["fcl", "standard"])
    records["fraction_nodes"] = ratio(records["node_asked"], records["node_poses"]).mask(without, 1.0)
    records["fraction_samples"] = ratio(records["sample_asked"], records["sample_poses"]).mask(without, 1.0)
    records["fraction_motions"] = ratio(records["asked"], records["motion_samples"])
    return add_relative_times(records)


def add_relative_times(records):
    """The paper's arithmetic: the time in checks is scaled, what is left of the total is not; relative to the standard
    method in the same trial. And the part of it that certificates change, the time in checks."""
    rest = (records["processor_seconds"] - records["obstacle_seconds"]).clip(lower=0.0)
    for difficulty in DIFFICULTIES:
        # What was measured stays as it was measured.
        records[f"time_{difficulty}"] = (records["processor_seconds"] if difficulty == 1 else
                                         rest + difficulty * records["obstacle_seconds"])
    key = ["scene", "robots", "planner", "number", "iterations"]
    times = [f"time_{difficulty}" for difficulty in DIFFICULTIES]
    standard = records.loc[records["method"] == "fcl", key + times + ["obstacle_seconds", "checking_seconds"]]
    standard = standard.rename(columns={"obstacle_seconds": "standard_obstacle_seconds",
                                        "checking_seconds": "standard_checking_seconds"})
    records = records.merge(standard, on=key, how="left", suffixes=("", "_standard"))
    for time in times:
        records[time.replace("time", "relative")] = ratio(records[time], records[time + "_standard"])
    records["relative_checking"] = ratio(records["checking_seconds"], records["standard_checking_seconds"])
    records["share_of_checking"] = ratio(records["standard_obstacle_seconds"], records["time_1_standard"])
    return records.drop(columns=[time + "_standard" for time in times])


def statistics_of(groups):
    """Mean, median, and 10th and 90th percentile of what figures and report show, and how many trials these are of"""
    shown = ["fraction_nodes", "fraction_samples", "fraction_motions", "relative_1", "relative_100", "relative_10000",
             "relative_checking", "share_of_checking", "certificates", "memory_bytes", "processor_seconds", "nodes"]
    statistics = {"mean": groups[shown].mean(), "median": groups[shown].median(), "p10": groups[shown].quantile(0.1),
                  "p90": groups[shown].quantile(0.9)}
    cells = pd.concat([table.add_suffix(f"_{name}") for name, table in statistics.items()], axis=1)
    cells = cells[[f"{column}_{name}" for column in shown for name in statistics]]
    cells.insert(0, "trials", groups.size())
    return cells


def cells_of(records):
    """The statistics over trials of each cell at each number of iterations"""
    return statistics_of(records.groupby(CELL + ["iterations"])).reset_index()


def ends_of(records):
    """The statistics of each cell over the last records of its trials, which may end after different numbers of
    iterations; these are fewest and most"""
    last = records.loc[records.groupby(CELL + ["number"])["iterations"].idxmax()]
    groups = last.groupby(CELL)
    ends = statistics_of(groups)
    ends.insert(0, "fewest", groups["iterations"].min())
    ends.insert(1, "most", groups["iterations"].max())
    return ends.reset_index()
