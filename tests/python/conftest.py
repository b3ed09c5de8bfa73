# SPDX-FileCopyrightText: 2026 The cvo_slam authors
# SPDX-License-Identifier: BSD-3-Clause
"""A short recording, made once by the program whose path is in CVO_SLAM_PROGRAM."""

import os
import subprocess
from pathlib import Path

import pytest

import cvo_slam


def run_program(*arguments: str) -> None:
    subprocess.run([os.environ["CVO_SLAM_PROGRAM"], *arguments], check=True, capture_output=True)


@pytest.fixture(scope="session")
def recording(tmp_path_factory: pytest.TempPathFactory) -> Path:
    folder = tmp_path_factory.mktemp("recording") / "room"
    run_program("synth", "room", str(folder), "--frames", "24", "--seed", "7")
    return folder


@pytest.fixture(scope="session")
def data(recording: Path) -> cvo_slam.Dataset:
    return cvo_slam.open_dataset(recording)


@pytest.fixture(scope="session")
def slam(data: cvo_slam.Dataset) -> cvo_slam.Slam:
    """All frames tracked, and finished."""
    slam = cvo_slam.Slam(data.camera)
    for frame in data:
        slam.track(frame)
    slam.finish()
    return slam
