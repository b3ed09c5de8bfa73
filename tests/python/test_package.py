# SPDX-FileCopyrightText: 2026 The cvo_slam authors
# SPDX-License-Identifier: BSD-3-Clause
"""The examples, and the package as pip installs it."""

import os
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest

import cvo_slam

ROOT = Path(__file__).resolve().parents[2]
EXAMPLES = ROOT / "python" / "examples"


def run_python(folder: Path, *arguments: str, python: str = sys.executable) -> str:
    done = subprocess.run([python, *arguments], cwd=folder, capture_output=True, text=True)
    assert done.returncode == 0, done.stderr
    return done.stdout


def test_example_of_a_recording(recording: Path, tmp_path: Path) -> None:
    printed = run_python(tmp_path, str(EXAMPLES / "track_sequence.py"), str(recording))
    assert "24 poses" in printed and "AbsoluteTrajectoryError" in printed
    assert len(cvo_slam.Trajectory.read(tmp_path / "trajectory.txt")) == 24


def test_example_of_own_images(tmp_path: Path) -> None:
    run_python(tmp_path, str(EXAMPLES / "own_images.py"))
    trajectory = cvo_slam.Trajectory.read(tmp_path / "own_images.txt")
    # 29 steps of 2 px at 2 m with a focal length of 260 px.
    np.testing.assert_allclose(trajectory.positions[-1], [29 * 2 * 2 / 260, 0, 0], atol=0.003)


def test_example_of_a_map(recording: Path, tmp_path: Path) -> None:
    printed = run_python(
        tmp_path, str(EXAMPLES / "save_and_localize.py"), str(recording), str(tmp_path / "map")
    )
    assert "22 of 24 frames located" in printed


FAKE_CV2 = """
import os, signal
import cvo_slam
CAP_OPENNI2, CAP_OPENNI_DEPTH_GENERATOR_REGISTRATION = 1600, 1
CAP_OPENNI_DEPTH_MAP, CAP_OPENNI_BGR_IMAGE = 0, 5

class VideoCapture:
    \"\"\"Plays a recording; the user ends it after ten frames.\"\"\"
    def __init__(self, api):
        self.frames = iter(cvo_slam.open_dataset(os.environ["RECORDING"]))
        self.count = 0
    def set(self, key, value): pass
    def release(self): pass
    def grab(self):
        self.frame = next(self.frames)
        self.count += 1
        if self.count == 10:
            os.kill(os.getpid(), signal.SIGINT)
        return True
    def retrieve(self, flag):
        image = self.frame.depth if flag == CAP_OPENNI_DEPTH_MAP else self.frame.rgb[:, :, ::-1]
        return True, image
"""


def test_example_of_a_camera(
    recording: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """With a module in place of OpenCV's; Ctrl-C ends the loop between two frames."""
    (tmp_path / "cv2.py").write_text(FAKE_CV2)
    monkeypatch.setenv("PYTHONPATH", f"{tmp_path}:{os.environ['PYTHONPATH']}")
    monkeypatch.setenv("RECORDING", str(recording))
    run_python(tmp_path, str(EXAMPLES / "capture.py"), str(recording / "camera.yaml"))
    assert len(cvo_slam.Trajectory.read(tmp_path / "trajectory.txt")) == 9


def test_the_wheel_in_a_clean_environment(tmp_path: Path) -> None:
    """numpy comes from Debian, everything else from the wheel."""
    pip = ["-m", "pip", "--quiet", "--disable-pip-version-check"]
    run_python(tmp_path, *pip, "wheel", "--no-build-isolation", "--no-index", "--no-deps", str(ROOT))
    (wheel,) = tmp_path.glob("*.whl")
    run_python(tmp_path, "-m", "venv", "--system-site-packages", "fresh")
    python = str(tmp_path / "fresh" / "bin" / "python")
    run_python(tmp_path, *pip, "install", "--no-index", "--no-deps", str(wheel), python=python)
    environment = {key: value for key, value in os.environ.items() if key != "PYTHONPATH"}
    printed = subprocess.run(
        [python, str(EXAMPLES / "own_images.py")],
        cwd=tmp_path,
        env=environment,
        capture_output=True,
        text=True,
        check=True,
    ).stdout
    assert "0.967 s: x = 0.4" in printed
