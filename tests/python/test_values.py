# SPDX-FileCopyrightText: 2026 The cvo_slam authors
# SPDX-License-Identifier: BSD-3-Clause
"""Cameras, options, trajectories, graphs, maps and pictures from Python."""

from pathlib import Path

import numpy as np
import pytest

import cvo_slam


def turned(angle: float, x: float = 0.0) -> np.ndarray:  # type: ignore[type-arg]
    c, s = np.cos(angle), np.sin(angle)
    return np.array([[c, -s, 0, x], [s, c, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]])


def test_camera(tmp_path: Path) -> None:
    camera = cvo_slam.Camera(640, 480, 500, 501, 320, 240, depth_scale=1000, name="mine")
    camera.write(tmp_path / "camera.yaml")
    again = cvo_slam.Camera.read(tmp_path / "camera.yaml")
    assert (again.fx, again.fy, again.depth_scale, again.name) == (500, 501, 1000, "mine")
    assert "tum_fr1" in cvo_slam.Camera.builtin_names()
    assert cvo_slam.Camera.read("tum_fr1").width == 640
    assert "640 x 480" in repr(camera)
    with pytest.raises(cvo_slam.OptionError, match="fx"):
        cvo_slam.Camera(640, 480, 5, 5, 320, 240, depth_scale=1000)
    with pytest.raises(TypeError, match="depth_scale"):
        cvo_slam.Camera(640, 480, 500, 500, 320, 240)  # type: ignore[call-arg]


def test_options(tmp_path: Path) -> None:
    options = cvo_slam.SlamOptions(tracker={"points": 1000, "keyframe.min_overlap": 0.7})
    assert options["tracker.points"] == 1000
    options["loops.enabled"] = False
    options["tracker.registration.length_scales"] = [0.1, 0.05]
    assert options["loops.enabled"] is False
    assert options["tracker.registration.length_scales"] == [0.1, 0.05]
    (tmp_path / "options.yaml").write_text(options.to_yaml())
    again = cvo_slam.SlamOptions()
    again.read_yaml(tmp_path / "options.yaml")
    assert repr(again) == repr(options)
    assert "tracker.points=1000" in repr(options)
    assert "Number of points" in options.describe("tracker.points")
    assert "tracker.points" in options and len(options.keys()) > 40
    with pytest.raises(cvo_slam.OptionError, match="did you mean 'tracker.points'"):
        cvo_slam.SlamOptions(tracker={"pionts": 1})
    with pytest.raises(cvo_slam.OptionError, match="points"):
        options["tracker.points"] = -1
    with pytest.raises(TypeError, match="bool, number"):
        options["tracker.points"] = object()  # type: ignore[assignment]


def test_datasets(data: cvo_slam.Dataset, tmp_path: Path) -> None:
    assert len(data) == 24 and len(list(data)) == 24
    assert data[-1].index == 23
    assert data.camera_origin and data.kind
    assert np.allclose(data.stamps, [frame.stamp for frame in data])
    with pytest.raises(IndexError, match="24 frames"):
        data.read(24)
    with pytest.raises(cvo_slam.InputError, match="no such folder"):
        cvo_slam.open_dataset(tmp_path / "none")


def test_errors_of_a_known_trajectory(tmp_path: Path) -> None:
    stamps = 100 + 0.1 * np.arange(30)
    poses = np.stack([turned(0.05 * i, 0.1 * i * i) for i in range(30)])
    reference = cvo_slam.Trajectory(stamps, poses)
    moved = cvo_slam.Trajectory(stamps, turned(1.0, 3.0) @ poses)
    ate = cvo_slam.ate(reference, moved, align="none")
    assert ate.translation.rmse > 1 and ate.rotation.median == pytest.approx(1.0)
    with pytest.raises(cvo_slam.DataError, match="line"):
        cvo_slam.ate(reference, moved)  # positions on one line: more than one answer
    rpe = cvo_slam.rpe(reference, moved, delta=5, unit="frames")
    assert rpe.translation.max < 1e-9 and len(rpe.translations) == 25
    with pytest.raises(cvo_slam.OptionError, match="'frames'"):
        cvo_slam.rpe(reference, moved, unit="mm")  # type: ignore[arg-type]
    moved.write(tmp_path / "moved.txt")
    assert np.allclose(cvo_slam.Trajectory.read(tmp_path / "moved.txt").poses, moved.poses)


def test_wrong_trajectories(tmp_path: Path) -> None:
    with pytest.raises(ValueError, match="2 stamps and 1 poses"):
        cvo_slam.Trajectory([0, 1], [np.eye(4)])
    with pytest.raises(ValueError, match=r"poses\[0\].*rigid"):
        cvo_slam.Trajectory([0], [np.zeros((4, 4))])
    with pytest.raises(ValueError, match=r"stamps\[1\]"):
        cvo_slam.Trajectory([1, 1], [np.eye(4), np.eye(4)])
    with pytest.raises(ValueError, match=r"\(N, 4, 4\)"):
        cvo_slam.Trajectory([1], np.eye(4))
    with pytest.raises(TypeError, match="numbers"):
        cvo_slam.Trajectory(["a"], [np.eye(4)])
    (tmp_path / "nan.txt").write_text("0 0 0 0 0 0 0 1\n1 nan 0 0 0 0 0 1\n2 0 0 0 0 0 0 1\n")
    with pytest.warns(UserWarning, match="nan.txt"):
        assert len(cvo_slam.Trajectory.read(tmp_path / "nan.txt")) == 2


def test_stamps_keep_their_digits(tmp_path: Path) -> None:
    lines = "1305031229.528748 0 0 0 0 0 0 1\n1305031230.500000 0 0 0 0 0 0 1\n"
    (tmp_path / "in.txt").write_text(lines)
    read = cvo_slam.Trajectory.read(tmp_path / "in.txt")
    cvo_slam.Trajectory(read.stamps, read.poses).write(tmp_path / "out.txt")
    stamps = [line.split()[0] for line in (tmp_path / "out.txt").read_text().splitlines()]
    assert [stamp for stamp in stamps if stamp[0] != "#"] == [
        "1305031229.528748",
        "1305031230.500000",
    ]


def test_pose_graph(tmp_path: Path) -> None:
    graph = cvo_slam.PoseGraph()
    for node in range(4):
        graph.add_node(node, turned(0.1 * node, 0.9 * node))
    for node in range(3):
        graph.add_edge(node, node + 1, turned(0.0, 1.0), 100 * np.eye(6))
    graph.add_edge(0, 3, turned(0.0, 3.0), kind="loop", robust=True)
    before = graph.cost
    summary = cvo_slam.optimize(graph)
    assert summary.converged and summary.final_cost < 1e-6 < before
    assert np.allclose(graph.pose(3), turned(0.0, 3.0), atol=1e-4)
    assert graph.edges[3].kind == "loop" and graph.edges[3].robust
    graph.write(tmp_path / "graph.g2o")
    again = cvo_slam.PoseGraph.read(tmp_path / "graph.g2o")
    assert again.ids == [0, 1, 2, 3] and np.allclose(again.poses, graph.poses)
    with pytest.raises(cvo_slam.DataError):
        graph.add_node(0, np.eye(4))
    with pytest.raises(ValueError, match=r"\(6, 6\)"):
        graph.add_edge(0, 1, np.eye(4), np.eye(5))
    with pytest.raises(cvo_slam.InputError, match="none.g2o"):
        cvo_slam.PoseGraph.read(tmp_path / "none.g2o")


def test_results_of_slam(slam: cvo_slam.Slam) -> None:
    keyframes = slam.keyframes()
    graph = slam.pose_graph()
    assert [keyframe.number for keyframe in keyframes] == graph.ids
    assert len(slam.trajectory("online")) == 24
    assert all(candidate.from_number < candidate.to_number for candidate in slam.loop_candidates())
    with pytest.raises(cvo_slam.OptionError, match="'final'"):
        slam.trajectory("last")  # type: ignore[arg-type]


def test_maps_outlive_slam(
    data: cvo_slam.Dataset, slam: cvo_slam.Slam, tmp_path: Path
) -> None:
    slam.map().write(tmp_path / "map")
    saved = cvo_slam.Map.read(tmp_path / "map")
    assert saved.has_memory and len(saved.keyframes) == len(slam.keyframes())
    other = cvo_slam.Slam(saved, localize=True)
    records = [other.track(frame) for frame in data]
    assert all(record.tracked for record in records) and records[-1].localized
    last = records[-1].T_world_camera
    assert last is not None and np.allclose(last, slam.trajectory().poses[-1], atol=0.01)
    assert other.map().graph.ids == saved.graph.ids
    (tmp_path / "pictures").mkdir()
    slam.pose_graph().write(tmp_path / "pictures" / "graph.g2o")
    picture_map = cvo_slam.Map.read(tmp_path / "pictures")
    with pytest.raises(cvo_slam.DataError, match="pictures"):
        cvo_slam.Slam(picture_map)


def test_a_session_goes_on(data: cvo_slam.Dataset, tmp_path: Path) -> None:
    whole, first = cvo_slam.Slam(data.camera), cvo_slam.Slam(data.camera)
    for frame in data:
        whole.track(frame)
    for i in range(10):
        first.track(data[i])
    first.map(session=True).write(tmp_path / "map")
    with pytest.raises(cvo_slam.DataError, match="session"):
        cvo_slam.Slam(first.map(), resume=True)
    with pytest.raises(cvo_slam.OptionError, match="localize or resume"):
        cvo_slam.Slam(first.map(), localize=True, resume=True)
    slam = cvo_slam.Slam(cvo_slam.Map.read(tmp_path / "map"), resume=True)
    assert slam.next_index == 10
    for i in range(10, len(data)):
        frame = data[i]
        assert frame.rgb is not None
        slam.track(frame.rgb, frame.depth, frame.stamp, frame.depth_stamp)
    for done in (whole, slam):
        done.finish()
    assert (slam.trajectory().poses == whole.trajectory().poses).all()


def test_the_nearest_depth_image_is_taken(data: cvo_slam.Dataset) -> None:
    slam, other = cvo_slam.Slam(data.camera), cvo_slam.Slam(data.camera)
    far = np.zeros_like(data[0].depth)
    for frame in (data[0], data[1], data[2]):
        assert frame.rgb is not None
        expected = slam.track(frame)
        depths = [(far, frame.stamp - 0.02), (frame.depth, frame.depth_stamp)]
        record = other.track(frame.rgb, depths, frame.stamp)
        assert record.tracked and record.index == expected.index
        assert record.T_world_camera is not None and expected.T_world_camera is not None
        assert (record.T_world_camera == expected.T_world_camera).all()
    with pytest.raises(cvo_slam.DataError, match="depth image"):
        other.track(frame.rgb, [], 9.0)


def test_a_folder_is_followed(data: cvo_slam.Dataset, recording: Path) -> None:
    frames = cvo_slam.follow_dataset(recording, end_after=0.2)
    first = next(frames)
    assert first.index == 0 and len(frames) == 1
    assert [frame.stamp for frame in frames] == list(data.stamps[1:])
    assert len(frames) == len(data) and frames.camera.name == data.camera.name
    with pytest.raises(StopIteration):
        next(frames)
    with pytest.raises(cvo_slam.InputError, match="nothing"):
        cvo_slam.follow_dataset(recording / "nothing", end_after=0.1)


def test_vocabulary(tmp_path: Path) -> None:
    assert cvo_slam.Vocabulary.builtin().words > 10_000
    (tmp_path / "words").write_text("none")
    with pytest.raises(cvo_slam.InputError, match="words"):
        cvo_slam.Vocabulary.read(tmp_path / "words")


def test_pictures(slam: cvo_slam.Slam) -> None:
    picture = cvo_slam.render(slam.trajectory(), width=320, height=200, renderer="splat")
    assert picture.shape == (200, 320, 3) and picture.std() > 5
    with pytest.raises(cvo_slam.OptionError, match="did you mean 'top'"):
        cvo_slam.render(slam.trajectory(), view="to")  # type: ignore[call-overload]


def test_help_says_what_is_where() -> None:
    for name in cvo_slam.__all__:
        if not name.startswith("_"):
            assert getattr(cvo_slam, name).__doc__, name
    assert cvo_slam.Slam.__module__ == "cvo_slam"
