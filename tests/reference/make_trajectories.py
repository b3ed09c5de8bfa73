#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The cvo_slam authors
# SPDX-License-Identifier: BSD-3-Clause
"""Makes reference.txt and estimate.txt, two trajectories, and trajectory_errors.txt, the errors
of the second one, which tests/core/reference_figures_test.cc compares with the evaluator's.

The figures are computed here from the definitions alone, dense and slow, by other methods than
those of the C++ code: matrix logarithms by repeated square roots, Horn's quaternion in place of
Umeyama's SVD, full distance matrices in place of searches.

Run by hand, never by the build: python3 make_trajectories.py. It needs numpy (Debian:
python3-numpy), which the project itself does not need. The seed is fixed: the trajectories come out
with the same bytes, the figures with the same digits up to rounding.
"""
import numpy as np

from rigid_motions import COMMENT, HERE, angle, expm, logm, pose, pose_text, rotation_of, twist


def make_trajectories():
    """A camera that wanders through a room, in the world of a motion capture system (reference,
    40 Hz, silent for 0.25 s) and as a tracker sees it (estimate, 30 Hz, two gaps): another world, a
    scale of 1.05, drift, noise, and stamps that jitter."""
    rng = np.random.default_rng(7)

    def truth(t):
        position = [1.5 * np.sin(0.9 * t), np.cos(1.3 * t), 0.4 * np.sin(2.1 * t) + 0.05 * t]
        turn = [0.5 * np.sin(1.1 * t), 0.4 * np.sin(0.7 * t), 0.6 * t]
        T = expm(twist(np.array([0, 0, 0, *turn])))
        T[:3, 3] = position
        return T

    def stamps(count, rate, jitter, gaps):
        t = np.arange(count) / rate + rng.uniform(-jitter, jitter, count)
        return [x for x in np.round(t, 6) if not any(a < x < b for a, b in gaps)]

    def write(name, rows):
        text = "".join(f"{1000 + t:.6f} {pose_text(T, 9)}\n" for t, T in rows)
        (HERE / name).write_text(COMMENT + "# stamp tx ty tz qx qy qz qw\n" + text)

    write("reference.txt", [(t, truth(t)) for t in stamps(250, 40, 0.002, [(2.6, 2.85)])])
    def noise(translation, rotation):
        return expm(twist(rng.normal(0, [translation] * 3 + [rotation] * 3)))

    last = truth(0.004)  # the clocks differ by 4 ms
    path = expm(twist(np.array([0.3, -0.2, 0.5, 0.2, -0.4, 0.9])))
    rows = []
    for t in stamps(190, 30, 0.006, [(1.5, 1.62), (4.0, 4.3)]):
        path = path @ np.linalg.inv(last) @ truth(t + 0.004) @ noise(0.002, 0.002)
        last = truth(t + 0.004)
        T = path @ noise(0.004, 0.003)
        T[:3, 3] *= 1.05
        rows.append((t, T))
    write("estimate.txt", rows)


def read_trajectory(name):
    """Stamps in integer nanoseconds, poses as 4x4 matrices."""
    rows = [line.split() for line in (HERE / name).read_text().splitlines() if line[0] != "#"]
    stamps = [int(row[0].replace(".", "")) * 1000 for row in rows]  # six decimals each
    return np.array(stamps), [pose(v[:3], v[3:]) for v in np.array(rows, float)[:, 1:]]


def match_nearest(reference, estimate, max_difference, offset=0.0):
    """Each pose of the shorter one with the nearest of the other: (stamp, reference, estimate)."""
    (tr, Tr), (te, Te) = reference, estimate
    te = te + round(offset * 1e9)
    distance = np.abs(te[:, None] - tr[None, :])
    if len(tr) < len(te):
        pairs = [(np.argmin(distance[:, j]), j) for j in range(len(tr))]
    else:
        pairs = [(i, np.argmin(distance[i])) for i in range(len(te))]
    assert all(abs(distance[i, j] - max_difference * 1e9) > 1000 for i, j in pairs)
    return [(te[i], Tr[j], Te[i]) for i, j in pairs if distance[i, j] <= max_difference * 1e9]


def match_interpolated(reference, estimate, max_gap):
    """The reference moved along the screw between the two poses around each stamp."""
    (tr, Tr), (te, Te) = reference, estimate
    matches = []
    for t, T in zip(te, Te):
        after = np.nonzero(tr >= t)[0]
        before = np.nonzero(tr < t)[0]
        if len(after) == 0 or (len(before) == 0 and tr[0] != t):
            continue
        j = after[0]
        if tr[j] == t:
            matches.append((t, Tr[j], T))
            continue
        gap = tr[j] - tr[j - 1]
        if gap <= max_gap * 1e9:
            step = logm(np.linalg.inv(Tr[j - 1]) @ Tr[j])
            matches.append((t, Tr[j - 1] @ expm((t - tr[j - 1]) / gap * step), T))
    return matches


def alignment(matches, kind):
    """(R, t, scale) of least squares; the rotation is Horn's quaternion (JOSA A 1987)."""
    if kind == "none":
        return np.eye(3), np.zeros(3), 1.0
    y = np.array([T[:3, 3] for _, T, _ in matches])
    x = np.array([T[:3, 3] for _, _, T in matches])
    yc, xc = y - y.mean(0), x - x.mean(0)
    s = xc.T @ yc
    n = np.zeros((4, 4))  # in the order (w, x, y, z)
    n[0, 0] = np.trace(s)
    n[0, 1:] = n[1:, 0] = [s[1, 2] - s[2, 1], s[2, 0] - s[0, 2], s[0, 1] - s[1, 0]]
    n[1:, 1:] = s + s.T - np.trace(s) * np.eye(3)
    w, *v = np.linalg.eigh(n)[1][:, -1]
    R = rotation_of(np.array([*v, w]))
    scale = np.sum(yc * (xc @ R.T)) / np.sum(xc * xc) if kind == "sim3" else 1.0
    return R, y.mean(0) - scale * R @ x.mean(0), scale


def statistics(errors):
    e = np.array(errors)
    return [f"{v:.15g}" for v in
            (np.sqrt(np.mean(e * e)), np.mean(e), np.median(e), np.std(e), np.min(e), np.max(e))]


def figures(translations, rotations):
    return [str(len(translations)), *statistics(translations), *statistics(rotations)]


def absolute_error(matches, kind):
    """Translation and angle of T_reference^-1 T_estimate after alignment."""
    R, t, scale = alignment(matches, kind)
    translations, rotations = [], []
    for _, reference, estimate in matches:
        moved = np.eye(4)
        moved[:3, :3] = R @ estimate[:3, :3]
        moved[:3, 3] = scale * R @ estimate[:3, 3] + t
        error = np.linalg.inv(reference) @ moved
        translations.append(np.linalg.norm(error[:3, 3]))
        rotations.append(angle(error[:3, :3]))
    return [f"{scale:.15g}", *figures(translations, rotations)]


def pairs_of(matches, delta, unit, all_pairs):
    """The pairs (i, j) as core's select_pairs() documents them."""
    n = len(matches)
    if unit == "frames":
        return [(i, i + delta) for i in range(0, n - delta, 1 if all_pairs else delta)]
    if unit == "s":
        t = np.array([stamp for stamp, _, _ in matches])
        result, i = [], 0
        while i < n:
            late = np.nonzero(t - t[i] >= delta * 10**9)[0]
            found = len(late) > 0 and t[late[0]] - t[i] <= delta * 10**9 + 50_000_000
            if found:
                result.append((i, late[0]))
            i = late[0] if found and not all_pairs else i + 1
        return result
    steps = [np.linalg.norm(b[2][:3, 3] - a[2][:3, 3]) for a, b in zip(matches, matches[1:])]
    path = np.concatenate([[0], np.cumsum(steps)])
    if all_pairs:
        nearest = [(i, i + 1 + np.argmin(np.abs(path[i + 1:] - path[i] - delta)))
                   for i in range(n - 1)]
        return [(i, j) for i, j in nearest if abs(path[j] - path[i] - delta) <= 0.1 * delta]
    cuts, start = [], 0.0
    for i in range(n):
        if path[i] - start >= delta:
            cuts.append(i)
            start = path[i]
    return list(zip(cuts, cuts[1:]))


def relative_error(matches, delta, unit, all_pairs, kind):
    """Q of the reference and P of the estimate: Q^-1 P, or P Q^-1 for the measure of CVO's paper,
    whose rotation is the Frobenius norm of the logarithm."""
    translations, rotations = [], []
    for i, j in pairs_of(matches, delta, unit, all_pairs):
        Q = np.linalg.inv(matches[i][1]) @ matches[j][1]
        P = np.linalg.inv(matches[i][2]) @ matches[j][2]
        error = P @ np.linalg.inv(Q) if kind == "paper" else np.linalg.inv(Q) @ P
        translations.append(np.linalg.norm(error[:3, 3]))
        rotations.append(np.linalg.norm(logm(error[:3, :3])) if kind == "paper"
                         else angle(error[:3, :3]))
    return figures(translations, rotations)


def write_trajectory_errors():
    reference, estimate = read_trajectory("reference.txt"), read_trajectory("estimate.txt")
    nearest = match_nearest(reference, estimate, 0.02)
    associations = {
        "nearest": nearest,
        "tight": match_nearest(reference, estimate, 0.007),  # half of a period and less
        "offset": match_nearest(reference, estimate, 0.02, 0.004),
        "swapped": match_nearest(estimate, reference, 0.02),  # the reference is the shorter one
        "interpolated": match_interpolated(reference, estimate, 0.1),
    }
    lines = [COMMENT, "# columns: measure ... count, then rmse mean median std min max of the "
             "translation [m], then of the rotation [rad]\n",
             "# ate: association alignment scale; rpe: association delta unit pairs kind\n"]
    for name, matches in associations.items():
        for kind in ("none", "se3", "sim3"):
            lines.append(f"ate {name} {kind} {' '.join(absolute_error(matches, kind))}\n")
    for name in ("nearest", "interpolated"):
        for delta, unit in ((1, "frames"), (10, "frames"), (1, "s"), (0.5, "m")):
            for all_pairs in (True, False):
                for kind in ("relative", "paper"):
                    error = relative_error(associations[name], delta, unit, all_pairs, kind)
                    lines.append(f"rpe {name} {delta} {unit} "
                                 f"{'all' if all_pairs else 'consecutive'} {kind} "
                                 f"{' '.join(error)}\n")
    (HERE / "trajectory_errors.txt").write_text("".join(lines))
    print("matches:", {name: len(matches) for name, matches in associations.items()})


if __name__ == "__main__":
    make_trajectories()
    write_trajectory_errors()
