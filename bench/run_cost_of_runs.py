#!/usr/bin/python3
# SPDX-FileCopyrightText: 2026 The cvo_slam authors
# SPDX-License-Identifier: BSD-3-Clause
"""Measures the CPU time of whole runs beside that of reading the same files with OpenCV's imread, and
writes docs/results/cost-of-runs.md.

usage: run_cost_of_runs.py <build folder> [page]      (make cost-of-runs)

All that `cvo_slam run --no-map` does counts: reading, tracking, the graph, plots and the page. The two
programs take turns, so that a busy machine slows both. Sequences below CVO_SLAM_DATA (default
../shared/data) that are not there are left out, with a line."""
import os
import pathlib
import resource
import statistics
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parent.parent
BUILD = pathlib.Path(sys.argv[1])
PAGE = pathlib.Path(sys.argv[2] if len(sys.argv) > 2 else ROOT / "docs/results/cost-of-runs.md")
DATA = pathlib.Path(os.environ.get("CVO_SLAM_DATA", ROOT.parent / "shared/data"))
SEQUENCES = {"fr1/rpy": ("tum/rgbd_dataset_freiburg1_rpy", ["--depth-offset", "-0.0186"]),
             "7-Scenes": ("7scenes/seq-01", [])}
TURNS = 5


def cpu_seconds(*command):
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    subprocess.run([str(word) for word in command], check=True, capture_output=True)
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    return after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime


def rows():
    for name, (folder, arguments) in SEQUENCES.items():
        recording = DATA / folder
        if not recording.is_dir():
            print(f"{name} is left out: {recording} is not here", file=sys.stderr)
            continue
        times = {"imread": [], "odometry": [], "slam": []}
        with tempfile.TemporaryDirectory() as out:
            for _ in range(TURNS):
                times["imread"].append(cpu_seconds(BUILD / "bench/read_images", recording))
                for mode in ("odometry", "slam"):
                    times[mode].append(cpu_seconds(BUILD / "cvo_slam", "run", recording, "--mode", mode,
                                                   "--no-map", "--quiet", "--overwrite", "--out", out,
                                                   *arguments))
        median = {key: statistics.median(values) for key, values in times.items()}
        for mode in ("odometry", "slam"):
            ratios = [run / read for run, read in zip(times[mode], times["imread"])]
            yield (f"| {name} | {mode} | {median['imread']:.1f} | {median[mode]:.1f} | "
                   f"{statistics.median(ratios):.2f} [{min(ratios):.2f}, {max(ratios):.2f}] |")


def main():
    head = subprocess.run(["sh", "-c", '. bench/results_page.sh; begin_page "$@"', "run_cost_of_runs.py",
                           "What a whole run costs", "make cost-of-runs",
                           "CPU seconds of `cvo_slam run --no-map`, and of reading the same images with "
                           "OpenCV's `imread`\nin one thread and doing nothing with them; medians "
                           f"[lowest, highest] of {TURNS} turns."],
                          cwd=ROOT, check=True, capture_output=True, text=True).stdout
    table = ["| recording | mode | reading [s] | run [s] | ratio |", "|---|---|---:|---:|---:|", *rows()]
    PAGE.write_text(head + "\n" + "\n".join(table) + "\n", encoding="utf-8")
    print(f"run_cost_of_runs.py: wrote {PAGE}", file=sys.stderr)


if __name__ == "__main__":
    main()
