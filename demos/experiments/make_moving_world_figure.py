#!/usr/bin/python3
"""Draws what certificates moving-world measured, frame by frame: times, their sums, and how many poses were asked.

    make_moving_world_figure.py FRAMES.csv FIGURE.png
"""

import argparse

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import pandas as pd

import trials

WAYS = {
    "standard": ("standard check", "#555555"),
    "fresh": ("new certificates", "#d55e00"),
    "kept": ("kept, repaired certificates", "#009e73"),
}
PARTS = ("change", "path", "plan")
FRAME_MS = 100.0


def read_frames(file):
    """The frames with the time of each way in ms as a column of its name"""
    try:
        frames = pd.read_csv(file)
        for way in WAYS:
            frames[way] = 1e3 * sum(frames[f"{way}_{part}_seconds"] for part in PARTS)
    except (KeyError, ValueError) as error:
        raise trials.BadResults(f"{file}: not the frames of moving_world ({error})") from None
    if frames.empty:
        raise trials.BadResults(f"{file}: has no frames")
    return frames


def draw(frames):
    figure, (times, sums, asked) = plt.subplots(3, 1, figsize=(8.0, 8.0), sharex=True)
    for way, (label, color) in WAYS.items():
        times.plot(frames["frame"], frames[way], color=color, linewidth=1.2, marker=".", markersize=3, label=label)
        total = 1e-3 * frames[way].sum()
        sums.plot(frames["frame"], 1e-3 * frames[way].cumsum(), color=color, linewidth=1.5, label=f"{label}: {total:.1f} s")
        asked.plot(frames["frame"], frames[f"{way}_asked"], color=color, linewidth=1.2, marker=".", markersize=3)
    times.axhline(FRAME_MS, color="black", linestyle=":", linewidth=1.0)
    times.annotate("the time to the next frame", (frames["frame"].iloc[-1], FRAME_MS), (0, 4),
                   textcoords="offset points", ha="right", fontsize=8, bbox={"color": "white", "pad": 0.5})
    times.set_yscale("log")
    asked.set_yscale("symlog", linthresh=10)
    asked.set_ylim(bottom=0)
    times.set_ylabel("ms for the frame", fontsize=9)
    sums.set_ylabel("s since the first frame", fontsize=9)
    asked.set_ylabel("robot poses for which\nthe cloud was asked", fontsize=9)
    asked.set_xlabel("frame; those with a new plan are shaded", fontsize=9)
    for axis in (times, sums, asked):
        for frame in frames.loc[frames["result"] != "valid", "frame"]:
            axis.axvspan(frame - 0.5, frame + 0.5, color="#eeeeee", linewidth=0, zorder=0)
        axis.grid(True, axis="y", color="#dddddd", linewidth=0.6)
        axis.tick_params(labelsize=8)
        for side in ("top", "right"):
            axis.spines[side].set_visible(False)
    sums.legend(frameon=False, fontsize=9)
    figure.suptitle(f"{len(frames)} frames, each with {frames['points_come'].mean():.0f} new points of "
                    f"{frames['points'].mean():.0f}:\nchange of the obstacles, test of the path, and a new plan if need be",
                    fontsize=11)
    figure.tight_layout()
    return figure


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n\n")[0])
    parser.add_argument("frames", help="the file that certificates moving-world --csv has written")
    parser.add_argument("figure", help="the picture to write: PNG, PDF or SVG, by its name")
    arguments = parser.parse_args()
    figure = draw(read_frames(arguments.frames))
    try:
        figure.savefig(arguments.figure, dpi=90)
    except ValueError as error:
        raise trials.BadResults(f"{arguments.figure}: {error}") from None


if __name__ == "__main__":
    trials.run_tool(main)
