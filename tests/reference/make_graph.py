#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The cvo_slam authors
# SPDX-License-Identifier: BSD-3-Clause
"""Makes graph.g2o, a small pose graph, and graph_optima.txt, what it costs and where its optimum
is under several losses; tests/backend/reference_graph_test.cc compares the optimiser with it.

The optima are computed here from the residual's definition (core's pose-graph cost) alone: dense
normal equations, numeric Jacobians, reweighting.

Run by hand, never by the build: python3 make_graph.py. It needs numpy (Debian: python3-numpy),
which the project itself does not need. The seed is fixed: the graph comes out with the same bytes,
the optima with the same digits up to rounding.
"""
import numpy as np

from rigid_motions import (COMMENT, HERE, conjugate, expm, pose_text, quaternion_product, turned,
                           twist)


C = 4.1  # where the robust losses begin [standard deviations]
NODES, ROUND = 42, 21


class Graph:
    """Poses and edges; arrays with a row for each."""

    def __init__(self, p, q, ends, p_ab, q_ab, information):
        self.p, self.q = p, q
        self.ends, self.p_ab, self.q_ab, self.information = ends, p_ab, q_ab, information
        self.is_loop = ends[:, 1] != ends[:, 0] + 1

    def without(self, pairs):
        """The same graph, but for the edges between some nodes."""
        keep = [tuple(pair) not in pairs for pair in self.ends]
        return Graph(self.p, self.q, self.ends[keep], self.p_ab[keep], self.q_ab[keep],
                     self.information[keep])

    def moved(self, i, step):
        """Nodes i after a step: positions are added, orientations turned on the right."""
        turn = np.concatenate([step[:, 3:] / 2, np.ones((len(step), 1))], axis=1)
        q = quaternion_product(self.q[i], turn)
        return self.p[i] + step[:, :3], q / np.linalg.norm(q, axis=1)[:, None]

    def residuals(self, step=np.zeros(12)):
        """[R_a^T (p_b - p_a) - p_ab ; 2 vec(q_ab q_est^-1)] of each edge after one and the same
        step of its two ends."""
        steps = np.tile(step, (len(self.ends), 1))
        pa, qa = self.moved(self.ends[:, 0], steps[:, :6])
        pb, qb = self.moved(self.ends[:, 1], steps[:, 6:])
        e = quaternion_product(self.q_ab, conjugate(quaternion_product(conjugate(qa), qb)))
        e = np.where(e[:, 3:] >= 0, e, -e)
        return np.hstack([turned(conjugate(qa), pb - pa) - self.p_ab, 2 * e[:, :3]])

    def jacobians(self):
        """Central differences by the twelve values of a step."""
        h = 1e-5
        columns = [(self.residuals(u) - self.residuals(-u)) / (2 * h) for u in h * np.eye(12)]
        return np.stack(columns, axis=-1)

    def squared_errors(self):
        r = self.residuals()
        return np.einsum("ki,kij,kj->k", r, self.information, r)


def rho(s, loss):
    """The loss of a squared error s and its derivative."""
    if loss == "huber" and s > C * C:
        return 2 * C * np.sqrt(s) - C * C, C / np.sqrt(s)
    if loss == "cauchy":
        return C * C * np.log(1 + s / C**2), 1 / (1 + s / C**2)
    return s, 1.0


def losses(graph, loss):
    """A row for each edge: the loss and its derivative; loops alone are robust."""
    return np.array([rho(s, loss if is_loop else "none")
                     for s, is_loop in zip(graph.squared_errors(), graph.is_loop)])


def cost(graph, loss):
    return losses(graph, loss)[:, 0].sum() / 2


def minimise(graph, loss):
    """Levenberg-Marquardt on reweighted edges; node 0 is held."""
    damping, value = 1e-6, cost(graph, loss)
    for iteration in range(500):
        H, g = np.zeros((6 * NODES, 6 * NODES)), np.zeros(6 * NODES)
        weights = losses(graph, loss)[:, 1]
        for (a, b), w, r, J, information in zip(graph.ends, weights, graph.residuals(),
                                                graph.jacobians(), graph.information):
            at = np.r_[6 * a:6 * a + 6, 6 * b:6 * b + 6]
            H[np.ix_(at, at)] += J.T @ (w * information) @ J
            g[at] += J.T @ (w * information) @ r
        H, g = H[6:, 6:], g[6:]
        step = -np.linalg.solve(H + damping * np.diag(np.diag(H)), g)
        if np.abs(step).max() < 1e-10:
            break
        before = graph.p, graph.q
        graph.p, graph.q = graph.moved(np.arange(NODES),
                                       np.vstack([np.zeros(6), step.reshape(-1, 6)]))
        now = cost(graph, loss)
        if now <= value * (1 + 1e-13):
            value, damping = now, max(damping / 10, 1e-12)
        else:
            (graph.p, graph.q), damping = before, damping * 10
    print(f"{loss}: cost {value:.12g}, {iteration} iterations, last step {np.abs(step).max():.1e}")
    return value


def make_graph():
    """Two rounds of a bent figure of eight, odometry and loops with full information matrices and
    the noise that they tell, two false loops; the start is the odometry, chained."""
    rng = np.random.default_rng(12)
    angles = 2 * np.pi * np.arange(NODES) / ROUND
    truth = []
    for t, a in enumerate(angles):
        T = expm(twist(np.array([0, 0, 0, 0.2 * np.sin(a), 0.1 * np.cos(2 * a), a])))
        T[:3, 3] = [3 * np.sin(a), 1.5 * np.sin(2 * a), 0.3 * np.cos(a) + 0.01 * t]
        truth.append(T)

    def measure(a, b, error=np.zeros(6)):
        """A measurement whose residual at the true poses is the noise and the error."""
        basis = np.linalg.qr(rng.normal(size=(6, 6)))[0]
        sigmas = np.exp(rng.uniform(np.log(0.004), np.log(0.05), 6))
        noise = basis @ (sigmas * rng.normal(size=6))
        information = basis @ np.diag(sigmas**-2) @ basis.T
        T = np.linalg.inv(truth[a]) @ truth[b]
        T[:3, :3] = expm(twist(np.append(np.zeros(3), (noise + error)[3:])))[:3, :3] @ T[:3, :3]
        T[:3, 3] -= (noise + error)[:3]
        return a, b, T, (information + information.T) / 2

    edges = [measure(i, i + 1) for i in range(NODES - 1)]
    edges += [measure(i, i + ROUND) for i in range(0, ROUND, 2)]
    edges += [measure(i, j) for i, j in ((3, 25), (20, 1), (5, 15), (31, 6), (41, 18))]
    edges += [measure(8, 30, np.array([0.9, -0.4, 0.2, 0.1, 0.3, -0.6])),  # false
              measure(36, 12, np.array([-0.5, 0.8, 0.6, -0.4, 0, 0.5]))]
    start = [truth[0]]
    for edge in edges[:NODES - 1]:
        start.append(start[-1] @ edge[2])
    upper = np.triu_indices(6)
    lines = [f"VERTEX_SE3:QUAT {i} {pose_text(T, 12)}\n" for i, T in enumerate(start)]
    lines += [f"EDGE_SE3:QUAT {a} {b} {pose_text(T, 12)} "
              f"{' '.join(f'{v:.6f}' for v in information[upper])}\n"
              for a, b, T, information in edges]
    (HERE / "graph.g2o").write_text(COMMENT + "".join(lines))


def read_graph():
    rows = [line.split() for line in (HERE / "graph.g2o").read_text().splitlines()]
    vertices = np.array([row[2:] for row in rows if row[0] == "VERTEX_SE3:QUAT"], float)
    edges = np.array([row[1:] for row in rows if row[0] == "EDGE_SE3:QUAT"], float)
    information = np.zeros((len(edges), 6, 6))
    information[:, np.triu_indices(6)[0], np.triu_indices(6)[1]] = edges[:, 9:]
    information += np.transpose(np.triu(information, 1), (0, 2, 1))
    return Graph(vertices[:, :3], unit(vertices[:, 3:]), edges[:, :2].astype(int), edges[:, 2:5],
                 unit(edges[:, 5:9]), information)


def unit(q):
    return q / np.linalg.norm(q, axis=1)[:, None]


def minimise_truncated(graph):
    """The loss min(s, C^2): least squares without the false loops. The script stops if that is no
    optimum of the loss: a loop is on the wrong side, or leaving one more out costs less."""
    false = [(8, 30), (36, 12)]
    kept = graph.without(false)
    value = minimise(kept, "none") + len(false) * C * C / 2
    for pair in kept.ends[kept.is_loop]:
        fewer = kept.without([tuple(pair)])
        assert minimise(fewer, "none") + (len(false) + 1) * C * C / 2 > value + 0.5
    graph.p, graph.q = kept.p, kept.q
    assert max(kept.squared_errors()[kept.is_loop]) < 0.9 * C * C
    assert sum(graph.squared_errors() > 1.1 * C * C) == len(false)
    return value


def write_graph_optima():
    """Costs (half the sum of the losses) and every sixth pose."""
    lines = [COMMENT, "# cost loss value; pose loss node x y z qx qy qz qw\n",
             f"cost given {cost(read_graph(), 'none'):.15g}\n"]
    for loss in ("none", "huber", "cauchy", "truncated"):
        graph = read_graph()
        value = minimise_truncated(graph) if loss == "truncated" else minimise(graph, loss)
        lines.append(f"cost {loss} {value:.15g}\n")
        for i in range(0, NODES, 6):
            q = graph.q[i] if graph.q[i][3] >= 0 else -graph.q[i]
            numbers = " ".join(f"{v:.12f}" for v in (*graph.p[i], *q))
            lines.append(f"pose {loss} {i} {numbers}\n")
    (HERE / "graph_optima.txt").write_text("".join(lines))


if __name__ == "__main__":
    make_graph()
    write_graph_optima()
