# SPDX-FileCopyrightText: 2026 The cvo_slam authors
# SPDX-License-Identifier: BSD-3-Clause
"""Tracking from Python: the results of the program, arrays in and out, and wrong ones."""

import gc
import resource
import threading
from pathlib import Path

import numpy as np
import pytest
from numpy.typing import NDArray

import cvo_slam
from conftest import run_program


def test_the_same_bytes_as_the_program(
    recording: Path, slam: cvo_slam.Slam, tmp_path: Path
) -> None:
    run_program("run", str(recording), "--out", str(tmp_path / "run"), "--no-map", "--quiet")
    slam.trajectory().write(tmp_path / "trajectory.txt")
    expected = (tmp_path / "run" / "trajectory.txt").read_bytes()
    assert (tmp_path / "trajectory.txt").read_bytes() == expected


def test_arrays_give_what_frames_give(
    data: cvo_slam.Dataset, slam: cvo_slam.Slam, tmp_path: Path
) -> None:
    other = cvo_slam.Slam(data.camera)
    for frame in data:
        rgb = np.ascontiguousarray(frame.rgb)
        record = other.track(rgb, frame.depth.copy(), frame.stamp, frame.depth_stamp)
        assert record.index == frame.index
    other.finish()
    slam.trajectory().write(tmp_path / "frames.txt")
    other.trajectory().write(tmp_path / "arrays.txt")
    assert (tmp_path / "frames.txt").read_bytes() == (tmp_path / "arrays.txt").read_bytes()


def test_layouts_of_images(data: cvo_slam.Dataset) -> None:
    frame = data.read(0)
    rgb = np.ascontiguousarray(frame.rgb)
    wide = np.zeros((rgb.shape[0], rgb.shape[1] + 8, 3), np.uint8)
    wide[:, :-8] = rgb
    for image in [rgb, wide[:, :-8], np.asfortranarray(rgb), frame.rgb, rgb[:, :, ::-1][:, :, ::-1]]:
        copy = cvo_slam.RgbdFrame(image, frame.depth, frame.stamp)
        assert np.array_equal(copy.rgb, rgb)
    for depth in [frame.depth, np.asfortranarray(frame.depth)]:
        copy = cvo_slam.RgbdFrame(rgb, depth, frame.stamp)
        assert np.array_equal(copy.depth, frame.depth)
    grey = rgb[:, :, 1]
    assert np.array_equal(cvo_slam.RgbdFrame(grey, frame.depth, 0).rgb, grey)
    assert not frame.rgb.flags.writeable


def test_a_view_outlives_its_frame(data: cvo_slam.Dataset) -> None:
    rgb = data.read(0).rgb
    gc.collect()
    assert np.array_equal(rgb, data.read(0).rgb)


def test_records(data: cvo_slam.Dataset) -> None:
    tracker = cvo_slam.Tracker(data.camera)
    first = tracker.track(data.read(0))
    assert first.T_world_camera is not None
    assert first.tracked and np.array_equal(first.T_world_camera, np.eye(4))
    second = tracker.track(data.read(1))
    assert second.registration.status == "converged"
    assert 0.5 < second.registration.overlap <= 1
    assert np.all(np.linalg.eigvalsh(second.registration.covariance) > 0)
    record = tracker.track(np.zeros((10, 10, 3), np.uint8), data.read(2).depth, 1e9)
    assert not record.tracked and record.T_world_camera is None
    assert "10x10" in record.reason and record.index == 2


def test_observer(data: cvo_slam.Dataset) -> None:
    slam = cvo_slam.Slam(data.camera)
    records: list[cvo_slam.FrameRecord] = []
    poses: dict[int, NDArray[np.float64]] = {}

    def correction(keyframes: list[cvo_slam.Keyframe]) -> None:
        poses.update({keyframe.number: keyframe.T_world_camera for keyframe in keyframes})

    slam.observe(records.append, correction)
    for frame in data:
        slam.track(frame)
    slam.finish()
    assert [record.index for record in records] == list(range(len(data)))
    assert slam.statistics()["keyframe_bytes"] > 20_000 * len(slam.keyframes())
    for keyframe in slam.keyframes():
        assert np.array_equal(poses[keyframe.number], keyframe.T_world_camera)


def test_what_an_observer_raises(data: cvo_slam.Dataset) -> None:
    slam = cvo_slam.Slam(data.camera)

    def interrupt(record: cvo_slam.FrameRecord) -> None:
        raise KeyboardInterrupt

    slam.observe(interrupt)
    with pytest.raises(KeyboardInterrupt):
        slam.track(data.read(0))
    slam.observe(lambda record: slam.finish())
    frame = data.read(1)
    with pytest.raises(cvo_slam.UsageError):
        slam.track(frame.rgb, frame.depth, frame.stamp)
    slam.observe()
    frame = data.read(2)
    assert slam.track(frame.rgb, frame.depth, frame.stamp).tracked
    assert len(slam.trajectory().poses) == 3


@pytest.mark.parametrize(
    ("rgb", "depth", "error", "text"),
    [
        (np.zeros((4, 4, 4), np.uint8), np.zeros((4, 4), np.uint16), ValueError, r"\(4, 4, 4\)"),
        (np.zeros((4, 4, 3)), np.zeros((4, 4), np.uint16), TypeError, "float64"),
        (np.zeros((4, 4, 3), np.uint8), np.zeros((4, 4)), TypeError, "depth_scale"),
        (np.zeros((4, 4, 3), np.uint8), np.zeros((4, 4, 1), np.uint16), ValueError, r"\(H, W\)"),
        (np.zeros((4, 4, 3), np.uint8), np.zeros((4, 4), ">u2"), TypeError, "uint16"),
        (np.zeros(4, np.uint8), np.zeros((4, 4), np.uint16), ValueError, r"\(4\)"),
    ],
)
def test_wrong_arrays(
    data: cvo_slam.Dataset,
    rgb: np.ndarray,  # type: ignore[type-arg]
    depth: np.ndarray,  # type: ignore[type-arg]
    error: type[Exception],
    text: str,
) -> None:
    with pytest.raises(error, match=text):
        cvo_slam.Slam(data.camera).track(rgb, depth, 0)


def test_wrong_stamps_and_indices(data: cvo_slam.Dataset) -> None:
    slam = cvo_slam.Slam(data.camera)
    frame = data.read(1)
    with pytest.raises(ValueError, match="nanoseconds"):
        slam.track(frame.rgb, frame.depth, 1305031229528748000.0)
    slam.track(frame)
    with pytest.raises(cvo_slam.DataError, match="ascending order"):
        slam.track(data.read(0))


def test_two_threads_in_one_object(data: cvo_slam.Dataset) -> None:
    """One of them gets an error; nothing breaks."""
    for make in (cvo_slam.Slam, cvo_slam.Tracker):
        tracks = make(data.camera)
        errors: list[Exception] = []
        barrier = threading.Barrier(2)
        frames = [data.read(0), data.read(1)]

        def work(tracks: cvo_slam.Slam | cvo_slam.Tracker = tracks) -> None:
            barrier.wait()
            for index in range(50):
                frame = frames[index % 2]
                try:
                    tracks.track(frame.rgb, frame.depth, frame.stamp)
                except (cvo_slam.UsageError, cvo_slam.DataError) as error:
                    errors.append(error)

        threads = [threading.Thread(target=work) for _ in range(2)]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        assert any(isinstance(error, cvo_slam.UsageError) for error in errors)


def test_two_objects_in_two_threads(data: cvo_slam.Dataset, slam: cvo_slam.Slam) -> None:
    poses: list[np.ndarray] = []  # type: ignore[type-arg]

    def work() -> None:
        mine = cvo_slam.Slam(data.camera)
        for frame in data:
            mine.track(frame)
        mine.finish()
        poses.append(mine.trajectory().poses)

    threads = [threading.Thread(target=work) for _ in range(2)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    for each in poses:
        assert np.array_equal(each, slam.trajectory().poses)


def test_no_leak_over_two_thousand_frames(data: cvo_slam.Dataset) -> None:
    def use(count: int) -> None:
        for index in range(count):
            frame = data.read(index % 4)
            copy = cvo_slam.RgbdFrame(np.ascontiguousarray(frame.rgb), frame.depth, frame.stamp)
            assert copy.rgb is not None

    use(50)
    before = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss
    use(2000)
    grown = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss - before
    assert grown < 20_000  # kB; a leak of every frame would be 3 GB


def test_registration(data: cvo_slam.Dataset) -> None:
    first, second = (cvo_slam.select_points(data[i], data.camera, 2000) for i in (0, 2))
    result = cvo_slam.align(first, second)
    assert result.status == "converged"
    reference = data.reference
    start, end = (np.abs(reference.stamps - data.stamps[i]).argmin() for i in (0, 2))
    truth = np.linalg.inv(reference.poses[start]) @ reference.poses[end]
    assert np.linalg.norm(result.T_fixed_moving[:3, 3] - truth[:3, 3]) < 0.002
    copy = cvo_slam.PointCloud(second.positions, second.features)
    assert len(copy) == len(second)
    with pytest.raises(ValueError, match="rigid"):
        cvo_slam.align(first, second, 2 * np.eye(4))
    with pytest.raises(ValueError, match=r"features.*\(1, 5\)"):
        cvo_slam.PointCloud(np.zeros((1, 3)), np.zeros((2, 5)))
    nothing = cvo_slam.PointCloud(np.zeros((0, 3)), np.zeros((0, 5)))
    assert cvo_slam.align(first, nothing).status == "failed"
