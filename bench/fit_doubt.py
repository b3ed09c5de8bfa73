#!/usr/bin/python3
# SPDX-FileCopyrightText: 2026 The cvo_slam authors
# SPDX-License-Identifier: BSD-3-Clause
"""Fits the tracker's doubt to samples of bench/doubt_samples, and tests it on others.

    fit_doubt.py --fit FILE... --test FILE... [--page FILE]

Prints the coefficients of frontend/tracking_doubt.cc and writes the tables of docs/results/doubt.md.
Logistic regression (C. M. Bishop, "Pattern Recognition and Machine Learning", 2006, section 4.3.3) with a
weak prior on the coefficients, by Newton's method."""
import argparse
import sys

import numpy as np

WRONG_TRANSLATION = 0.05  # [m]
WRONG_ROTATION = np.radians(3)
PRIOR = 1.0  # the inverse variance of a coefficient
BINS = [0, 0.001, 0.003, 0.01, 0.03, 0.1, 0.2, 0.35, 0.5, 0.7, 0.9, 1.0000001]


def read(paths):
    """Names, tracked or not, wrong or not, and the terms of the model of all samples."""
    names, tracked, wrong, terms = [], [], [], []
    for path in paths:
        for line in open(path, encoding="utf-8"):
            fields = line.strip().split(",")
            values = [float(field) for field in fields[1:]]
            names.append(fields[0])
            tracked.append(values[3] > 0)
            wrong.append(values[4] > WRONG_TRANSLATION or values[5] > WRONG_ROTATION)
            terms.append(terms_of(*values[6:13]))
    return np.array(names), np.array(tracked), np.array(wrong, dtype=float), np.array(terms)


def terms_of(overlap, cos_theta, sigma, surprise, seconds, rival, features):
    """As in frontend/tracking_doubt.cc."""
    return [1, overlap, min(cos_theta, 1.5), np.log(sigma / 1e-3 + 1e-3),
            np.log1p(surprise / 0.02), np.log1p(30 * max(seconds, 0)), min(rival, 1),
            features == 1, features == 2]


def probabilities(terms, coefficients):
    return 1 / (1 + np.exp(-terms @ coefficients))


def fit(terms, wrong):
    coefficients = np.zeros(terms.shape[1])
    prior = PRIOR * np.eye(terms.shape[1])
    prior[0, 0] = 1e-6  # the constant is free
    for _ in range(100):
        p = probabilities(terms, coefficients)
        gradient = terms.T @ (p - wrong) + prior @ coefficients
        hessian = terms.T @ (terms * (p * (1 - p))[:, None]) + prior
        step = np.linalg.solve(hessian, gradient)
        coefficients -= step
        if np.abs(step).max() < 1e-9:
            break
    return coefficients


def calibration_error(p, wrong):
    """Mean over the samples of the difference between the mean doubt and the share of wrong ones in
    their bin (expected calibration error)."""
    bins = np.digitize(p, BINS)
    return sum(np.sum(bins == b) * abs(p[bins == b].mean() - wrong[bins == b].mean())
               for b in np.unique(bins)) / len(p)


def area_under_roc(p, wrong):
    order = np.argsort(p, kind="stable")
    ranks = np.empty(len(p))
    values, first, counts = np.unique(p[order], return_index=True, return_counts=True)
    ranks[order] = np.repeat(first + (counts + 1) / 2, counts)
    positives = wrong.sum()
    if positives in (0, len(wrong)):
        return float("nan")
    return (ranks[wrong > 0].sum() - positives * (positives + 1) / 2) / (
        positives * (len(wrong) - positives))


def tables(names, tracked, wrong, p):
    lines = ["| recording | registrations | wrong | mean doubt | calibration error | area under ROC |",
             "|---|---|---|---|---|---|"]
    for name in list(dict.fromkeys(names)) + ["all"]:
        chosen = np.ones(len(names), bool) if name == "all" else names == name
        lines.append(f"| {name} | {chosen.sum()} | {int(wrong[chosen].sum())} | {p[chosen].mean():.4f} | "
                     f"{calibration_error(p[chosen], wrong[chosen]):.4f} | "
                     f"{area_under_roc(p[chosen], wrong[chosen]):.3f} |")
    lines += ["", "Reliability, all of them:", "",
              "| doubt | registrations | mean doubt | share that is wrong |", "|---|---|---|---|"]
    bins = np.digitize(p, BINS)
    for b in np.unique(bins):
        chosen = bins == b
        lines.append(f"| {BINS[b - 1]:g} to {min(1, BINS[b]):g} | {chosen.sum()} | "
                     f"{p[chosen].mean():.4f} | {wrong[chosen].mean():.4f} |")
    lines += ["", "What a limit catches, of the frames that are called tracked (ROC):", "",
              "| doubt above | wrong ones caught | right ones accused |", "|---|---|---|"]
    for limit in (0.003, 0.01, 0.03, 0.1, 0.2, 0.3, 0.5, 0.7):
        above = (p > limit) & tracked
        bad, good = tracked & (wrong > 0), tracked & (wrong == 0)
        lines.append(f"| {limit:g} | {int((above & bad).sum())} of {int(bad.sum())} | "
                     f"{100 * (above & good).sum() / max(1, good.sum()):.2f} % |")
    return "\n".join(lines)


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("--fit", nargs="+", required=True)
    parser.add_argument("--test", nargs="+", required=True)
    arguments = parser.parse_args()
    names, tracked, wrong, terms = read(arguments.fit)
    coefficients = fit(terms, wrong)
    print("Coefficients:", ", ".join(f"{c:.3f}" for c in coefficients), file=sys.stderr)
    print("## Recordings that it was fitted to\n")
    print(tables(names, tracked, wrong, probabilities(terms, coefficients)))
    names, tracked, wrong, terms = read(arguments.test)
    print("\n## Other recordings\n")
    print(tables(names, tracked, wrong, probabilities(terms, coefficients)))


if __name__ == "__main__":
    main()
