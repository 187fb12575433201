#!/usr/bin/python3
"""Merges the trials of a folder of results into tables: records.csv, with a row for each record of each trial, and
cells.csv, with their mean, median and spread over trials. docs/experiments.md explains the columns.

    make_tables.py RESULTS TABLES
"""

import argparse
from pathlib import Path

import trials


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n\n")[0])
    parser.add_argument("results", help="the folder that certificates experiment has filled")
    parser.add_argument("tables", help="the folder for the tables")
    parser.add_argument("--complete", action="store_true", help="fail unless every trial of the grid is there")
    arguments = parser.parse_args()
    done = trials.read_trials(arguments.results)
    missing = len(trials.read_grid(arguments.results)["trials"]) - len(done)
    if arguments.complete and missing:
        raise trials.BadResults(f"{arguments.results}: {missing} trials are missing")
    records = trials.records_of(done)
    folder = Path(arguments.tables)
    folder.mkdir(parents=True, exist_ok=True)
    records.to_csv(folder / "records.csv", index=False, float_format="%.9g")
    trials.cells_of(records).to_csv(folder / "cells.csv", index=False, float_format="%.5g")
    print(f"{len(done)} trials, {missing} missing, {len(records)} records in {folder}")


if __name__ == "__main__":
    trials.run_tool(main)
