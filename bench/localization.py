#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The cvo_slam authors
# SPDX-License-Identifier: BSD-3-Clause
"""Locates recordings in maps of other recordings and writes docs/results/localization.md.

usage: localization.py <build folder> [page]      (make localization)

Maps are made of one recording, or the first half of one, and the other is located in them by
`run --localize`. The alignment with the reference is fixed on the map. Houses are recorded once, in
build/localization; that takes half an hour. Sequences below CVO_SLAM_DATA (default ../shared/data)
that are not there are left out, with a line.
"""
import csv
import datetime
import os
import pathlib
import subprocess
import sys

import numpy as np

ROOT = pathlib.Path(__file__).resolve().parent.parent
BUILD = pathlib.Path(sys.argv[1]).resolve()
PAGE = pathlib.Path(sys.argv[2] if len(sys.argv) > 2 else ROOT / "docs/results/localization.md")
DATA = pathlib.Path(os.environ.get("CVO_SLAM_DATA", ROOT.parent / "shared/data")).resolve()
WORK = ROOT / "build/localization"
PROGRAM = BUILD / "cvo_slam"
sys.path.insert(0, str(BUILD / "python"))
import cvo_slam  # noqa: E402

# A frame is near the map if one of the map's frames is within these of it, by the reference.
NEAR_M, NEAR_DEG = 0.3, 20
GOOD_M, GOOD_DEG = 0.1, 5
WRONG_M, WRONG_DEG = 0.3, 15


def program(*arguments):
    subprocess.run([PROGRAM, *map(str, arguments)], check=True, capture_output=True)


def revision():
    changes = subprocess.run(
        ["git", "status", "--porcelain", "--", ".", ":!docs/results"],
        cwd=ROOT, check=True, capture_output=True, text=True).stdout
    if changes:
        sys.exit("localization.py: the working tree has changes; commit them first: a page of "
                 "results names its revision")
    return subprocess.run(["git", "describe", "--always"], cwd=ROOT, check=True,
                          capture_output=True, text=True).stdout.strip()


def house(seed, walk):
    folder = WORK / f"house_{seed}_{walk}"
    if not (folder / "rgb.txt").exists():
        part = folder.with_suffix(".part")
        program("synth", "house", part, "--seed", seed, "--path-seed", walk, "--frames", 200,
                "--noise", "kinect", "--set", "sensor.exposure.time=0", "--image", "jpeg")
        part.rename(folder)
    return folder


def pose_error(a, b):
    """Metres and degrees between poses of shape (4, 4)."""
    motion = np.linalg.inv(a) @ b
    cosine = np.clip((np.trace(motion[:3, :3]) - 1) / 2, -1, 1)
    return np.linalg.norm(motion[:3, 3]), np.degrees(np.arccos(cosine))


class Reference:
    """Poses of the frames of a recording by its reference."""

    def __init__(self, folder):
        self.data = cvo_slam.open_dataset(folder)
        self.trajectory = self.data.reference

    def pose(self, frame):
        stamps = self.trajectory.stamps
        nearest = int(np.abs(stamps - self.data.stamps[frame]).argmin())
        return self.trajectory.poses[nearest]


def measure(name, first, first_frames, second, second_frames):
    """Returns a row of the table."""
    map_run, second_run = WORK / f"{name}_map", WORK / f"{name}_located"
    program("run", first, "--frames", first_frames, "--out", map_run, "--overwrite", "--save-map",
            "--quiet")
    program("run", second, "--frames", second_frames, "--out", second_run, "--overwrite",
            "--load-map", map_run / "map", "--localize", "--quiet")
    mapped, located = Reference(first), Reference(second)
    built = cvo_slam.Trajectory.read(map_run / "trajectory.txt")
    alignment = cvo_slam.ate(mapped.trajectory, built).T_reference_estimate
    estimate = cvo_slam.Trajectory.read(second_run / "trajectory.txt")
    pose_at = dict(zip(np.round(estimate.stamps, 4), estimate.poses))

    def rows(run):
        with open(run / "frames.csv") as file:
            return list(csv.DictReader(file))

    map_poses = [mapped.pose(int(row["index"])) for row in rows(map_run)]
    frames = rows(second_run)
    near = located_near = good = located_all = wrong = 0
    errors = []
    for row in frames:
        truth = located.pose(int(row["index"]))
        is_near = any(m <= NEAR_M and d <= NEAR_DEG
                      for m, d in (pose_error(pose, truth) for pose in map_poses))
        near += is_near
        if row["localized"] != "1":
            continue
        metres, degrees = pose_error(truth, alignment @ pose_at[round(float(row["stamp"]), 4)])
        located_all += 1
        wrong += metres > WRONG_M or degrees > WRONG_DEG
        if is_near:
            located_near += 1
            good += metres <= GOOD_M and degrees <= GOOD_DEG
            errors.append(metres)
    times = sorted(float(row["track_ms"]) for row in frames)
    keyframes = len(cvo_slam.Map.read(map_run / "map").keyframes)
    size = sum(file.stat().st_size for file in (map_run / "map").iterdir()
               if file.name != "map.ply")
    return (f"| {name} | {near} | {located_near} ({100 * located_near / near:.1f} %) | "
            f"{100 * good / max(1, located_near):.1f} % | {1e3 * np.median(errors):.0f}, "
            f"{1e3 * np.max(errors):.0f} | {located_all} of {len(frames)} | {wrong} | "
            f"{times[len(times) // 2]:.0f} | {keyframes} | {1e-3 * size / keyframes:.0f} |")


def main():
    label = revision()
    WORK.mkdir(parents=True, exist_ok=True)
    rows = []
    scenes = DATA / "7scenes/seq-01"
    if scenes.exists():
        rows.append(measure("7-Scenes seq-01", scenes, "0:500", scenes, "500:1000"))
    else:
        print(f"localization.py: {scenes} is not there; left out")
    for seed in (301, 302):
        rows.append(measure(f"house {seed}", house(seed, 1), "0:", house(seed, 2), "0:"))
    text = f"""# Locating a camera in a map

Written by `make localization`; do not edit. A map of one recording, or of the first half of one, and
another recording located in it ([how](../guide/maps.md)). The houses are walked through twice, the second time along
another path. The alignment with the reference is that of the map.

- date: {datetime.datetime.now(datetime.timezone.utc):%Y-%m-%d}
- revision: {label}

near: frames within {NEAR_M} m and {NEAR_DEG} deg of a frame of the map. right: of those located, within {GOOD_M} m and
{GOOD_DEG} deg. wrong: of all frames, off by more than {WRONG_M} m or {WRONG_DEG} deg.

| sequence | near | of these located | right | error [mm]: median, largest | located | wrong | ms a frame (median, wall) | keyframes | kB a keyframe on disk |
|---|---:|---:|---:|---:|---:|---:|---:|---:|---:|
"""
    PAGE.write_text(text + "\n".join(rows) + "\n")
    print(PAGE)


main()
