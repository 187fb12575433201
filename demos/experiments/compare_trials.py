#!/usr/bin/python3
"""Compares two folders of results trial by trial: trees and all counts must be equal, times and memory need not.

    compare_trials.py RESULTS OTHER_RESULTS

Returns 1 if they differ.
"""

import argparse
import sys

import trials


def repeatable(trial):
    kept = [i for i, column in enumerate(trial["columns"]) if column not in trial["measured"]]
    return {
        "seed": trial["seed"],
        "tree": trial["tree"],
        "columns": [trial["columns"][i] for i in kept],
        "records": [[record[i] for i in kept] for record in trial["records"]],
    }


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n\n")[0])
    parser.add_argument("results")
    parser.add_argument("other")
    arguments = parser.parse_args()
    first, second = ({trial["trial"]: repeatable(trial) for trial in trials.read_trials(folder)}
                     for folder in (arguments.results, arguments.other))
    different = 0
    for name in sorted(first.keys() | second.keys()):
        if name not in first or name not in second:
            print(f"{name}: only in {arguments.results if name in first else arguments.other}")
        elif first[name] != second[name]:
            what = [key for key in first[name] if first[name][key] != second[name][key]]
            print(f"{name}: differs in {', '.join(what)}")
        else:
            continue
        different += 1
    print(f"{len(first.keys() | second.keys())} trials, {different} different")
    sys.exit(1 if different else 0)


if __name__ == "__main__":
    trials.run_tool(main)
