# SPDX-FileCopyrightText: 2026 The cvo_slam authors
# SPDX-License-Identifier: BSD-3-Clause
"""Rigid motions for the scripts of this folder, computed from the definitions: 4x4 matrices with
power series for exp and log, unit quaternions (x, y, z, w) with Hamilton's product."""
import pathlib

import numpy as np

HERE = pathlib.Path(__file__).resolve().parent
COMMENT = "# SPDX-License-Identifier: BSD-3-Clause; made by a script beside it\n"


def expm(a):
    """Matrix exponential: the power series of a / 2^10, squared ten times."""
    total = term = np.eye(len(a))
    for k in range(1, 20):
        term = term @ (a / 1024) / k
        total = total + term
    for _ in range(10):
        total = total @ total
    return total


def logm(a):
    """Matrix logarithm: six square roots (Denman and Beavers), then the series of log(1 + x)."""
    for _ in range(6):
        y, z = a, np.eye(len(a))
        for _ in range(15):
            y, z = (y + np.linalg.inv(z)) / 2, (z + np.linalg.inv(y)) / 2
        a = y
    x = a - np.eye(len(a))
    total, power = np.zeros_like(a), np.eye(len(a))
    for k in range(1, 40):
        power = power @ x
        total = total + (power / k if k % 2 else -power / k)
    return 64 * total


def twist(xi):
    """The 4x4 matrix of [translation; rotation]."""
    x, y, z = xi[3:]
    a = np.zeros((4, 4))
    a[:3, :3] = [[0, -z, y], [z, 0, -x], [-y, x, 0]]
    a[:3, 3] = xi[:3]
    return a


def quaternion_product(p, q):
    """Hamilton's product of (x, y, z, w), the last axis of each array."""
    (a, b, c, d), (e, f, g, h) = np.moveaxis(p, -1, 0), np.moveaxis(q, -1, 0)
    return np.stack([d * e + a * h + b * g - c * f, d * f - a * g + b * h + c * e,
                     d * g + a * f - b * e + c * h, d * h - a * e - b * f - c * g], axis=-1)


def conjugate(q):
    return q * np.array([-1, -1, -1, 1])


def turned(q, p):
    """R p = q p q^-1 of unit quaternions and points, the last axis of each array."""
    p = np.concatenate([p, np.zeros(p.shape[:-1] + (1,))], axis=-1)
    return quaternion_product(quaternion_product(q, p), conjugate(q))[..., :3]


def quaternion_of(rotation):
    """(x, y, z, w) with w >= 0: the eigenvector of eigenvalue 3 of Bar-Itzhack's matrix."""
    r = rotation
    k = np.array([[r[0, 0] - r[1, 1] - r[2, 2], 0, 0, 0],
                  [r[1, 0] + r[0, 1], r[1, 1] - r[0, 0] - r[2, 2], 0, 0],
                  [r[2, 0] + r[0, 2], r[2, 1] + r[1, 2], r[2, 2] - r[0, 0] - r[1, 1], 0],
                  [r[2, 1] - r[1, 2], r[0, 2] - r[2, 0], r[1, 0] - r[0, 1], np.trace(r)]])
    q = np.linalg.eigh(k)[1][:, -1]
    return q if q[3] >= 0 else -q


def rotation_of(q):
    q = q / np.linalg.norm(q)
    return np.array([turned(q, e) for e in np.eye(3)]).T


def pose(position, quaternion):
    T = np.eye(4)
    T[:3, :3] = rotation_of(np.array(quaternion))
    T[:3, 3] = position
    return T


def pose_text(T, digits):
    return " ".join(f"{v:.{digits}f}" for v in (*T[:3, 3], *quaternion_of(T[:3, :3])))


def angle(rotation):
    """|log R|_F is sqrt(2) times the angle."""
    return np.linalg.norm(logm(rotation)) / np.sqrt(2)
