#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The cvo_slam authors
# SPDX-License-Identifier: BSD-3-Clause
"""Summarises cells of the suite: medians and spread over the perturbations, and how often one program
is better than another one. Writes <out>.md, .csv and .json."""
import argparse
import csv
import json
import pathlib
import statistics

FIGURES = {"rpe_mm": "RPE 1 s [mm]", "rpe_deg": "RPE 1 s [deg]", "ate_mm": "ATE [mm]"}
DIGITS = {"rpe_mm": 1, "rpe_deg": 2, "ate_mm": 1}


def runs_of(cell):
    """The figures of each run of a cell: {variant: {figure: value}}; None if there is no cell."""
    if not cell.exists():
        return None
    runs = {}
    report = json.loads(cell.read_text())
    for system in report["systems"]:
        evaluation = system["evaluation"] or {}
        second = next((rpe["error"] for rpe in evaluation.get("rpe", []) if rpe["unit"] == "s"), None)
        ate = evaluation.get("ate")
        runs[system["name"]] = {
            "rpe_mm": second["translation_m"]["rmse"] * 1e3 if second else None,
            "rpe_deg": second["rotation_deg"]["rmse"] if second else None,
            "ate_mm": ate["translation_m"]["rmse"] * 1e3 if ate else None,
            "lost": system["lost"],
            "wrong": system.get("wrong"),  # None without a reference, and in cells of older programs
            "features_asked": system.get("features_asked"),  # None in odometry, and in such cells
            "frames": len(range(report["begin"], report["end"], report["step"])),
            "cpu_ms": system["cpu_ms"]["mean"],
            "path_m": report.get("reference_path_m"),  # None in cells of older programs
        }
    return runs


def values(runs, figure):
    return [run[figure] for run in runs.values() if run[figure] is not None]


def compare(runs, other, figure):
    """In how many pairs of runs ours is the lower and the higher, and of how many. What is equal to a
    tenth of what is printed is neither."""
    pairs = [(runs[name][figure], other[name][figure]) for name in runs if name in other]
    pairs = [(round(a, DIGITS[figure] + 1), round(b, DIGITS[figure] + 1)) for a, b in pairs
             if a is not None and b is not None]
    return sum(a < b for a, b in pairs), sum(a > b for a, b in pairs), len(pairs)


def count_wrong(runs):
    """The frames of all runs that are called tracked and are wrong, and of how many; None if they were
    not counted."""
    found = [run["wrong"] for run in runs.values()]
    if None in found:
        return None, None
    return sum(len(wrong["frames"]) for wrong in found), sum(wrong["checked"] for wrong in found)


def share_asked(runs):
    """The share of the frames of all runs for which features were asked; None if it was not counted."""
    asked = [run["features_asked"] for run in runs.values()]
    return None if None in asked else sum(asked) / sum(run["frames"] for run in runs.values())


def summarise(runs, other):
    wrong, checked = count_wrong(runs)
    row = {"runs": len(runs), "lost": sum(run["lost"] for run in runs.values()),
           "wrong": wrong, "wrong_of": checked, "features_asked": share_asked(runs),
           "cpu_ms": statistics.median(values(runs, "cpu_ms")),
           "path_m": next(iter(runs.values()))["path_m"]}
    for figure in FIGURES:
        found = values(runs, figure)
        if not found:
            continue
        row[figure] = statistics.median(found)
        row[figure + "_min"], row[figure + "_max"] = min(found), max(found)
        if other and values(other, figure):
            row[figure + "_against"] = statistics.median(values(other, figure))
            (row[figure + "_wins"], row[figure + "_losses"],
             row[figure + "_pairs"]) = compare(runs, other, figure)
    if other:
        row["lost_against"] = sum(run["lost"] for run in other.values())
        row["wrong_against"] = count_wrong(other)[0]
        row["cpu_ms_against"] = statistics.median(values(other, "cpu_ms"))
    return row


def cell_text(row, figure):
    if figure not in row:
        return "-"
    number = f"{{:.{DIGITS[figure] if row[figure] >= 1 or figure == 'rpe_deg' else 2}f}}"
    text = "{} [{}, {}]".format(*(number.format(row[figure + end]) for end in ("", "_min", "_max")))
    if figure + "_against" not in row:
        return text
    return "{} → {}; {}, {}".format(number.format(row[figure + "_against"]), text,
                                    row[figure + "_wins"], row[figure + "_losses"])


def table(rows, mode, against):
    lines = ["| sequence | " + " | ".join(FIGURES.values()) + " | lost | wrong | CPU [ms a frame] |",
             "| --- | ---: | ---: | ---: | ---: | ---: | ---: |"]
    count = lambda number: "-" if number is None else str(number)
    for row in (row for row in rows if row["mode"] == mode):
        lost, wrong, cpu = str(row["lost"]), count(row["wrong"]), f"{row['cpu_ms']:.1f}"
        if against and "lost_against" in row:
            lost, cpu = f"{row['lost_against']} → {lost}", f"{row['cpu_ms_against']:.1f} → {cpu}"
            wrong = f"{count(row['wrong_against'])} → {wrong}"
        lines.append("| " + " | ".join([row["sequence"]] + [cell_text(row, f) for f in FIGURES] +
                                       [lost, wrong, cpu]) + " |")
    return "\n".join(lines)


def wrong_text(rows, mode, cells):
    """How many frames of a mode are wrong, and each of them."""
    rows = [row for row in rows if row["mode"] == mode and row["wrong"] is not None]
    tracked = sum(row["wrong_of"] for row in rows)
    if not tracked:
        return ""
    lines = []
    for row in (row for row in rows if row["wrong"]):
        for variant, run in runs_of(cells / mode / f"{row['sequence']}.json").items():
            lines += [f"- {row['sequence']}, {variant}: frame at {frame['stamp']} s, "
                      f"{frame['translation_m'] * 100:.0f} cm, {frame['rotation_deg']:.1f} deg"
                      for frame in run["wrong"]["frames"]]
    text = f"Wrong: {len(lines)} of {tracked} tracked frames, {len(lines) / tracked:.3%}"
    others = [row.get("wrong_against") for row in rows]
    if rows and None not in others:
        text += f"; the other program: {sum(others)}"
    return "\n".join([text + "."] + ([""] + lines if lines else []))


def features_text(rows, mode):
    """Where features were asked for a second opinion."""
    rows = [row for row in rows if row["mode"] == mode and row["features_asked"] is not None]
    if not rows:
        return ""
    asked = [f"{row['sequence']} {row['features_asked']:.1%}" for row in rows if row["features_asked"]]
    return "Share of the frames for which features were asked: " + ", ".join(asked + ["all others 0"]) + "."


def path_text(rows, mode):
    """The ATE as a share of the length of the path."""
    rows = [row for row in rows if row["mode"] == mode and row.get("path_m") and "ate_mm" in row]
    if not rows:
        return ""
    shares = [f"{row['sequence']} {row['ate_mm'] * 1e-3 / row['path_m']:.2%} of {row['path_m']:.1f} m"
              for row in rows]
    return "ATE as a share of the path: " + ", ".join(shares) + "."


def others_table(folder, sequences, rows):
    """Other systems beside the medians of our odometry; one run of each."""
    ours = {row["sequence"]: row for row in rows if row["mode"] == "odometry"}
    lines = ["| sequence | system | RPE 1 s [mm] | RPE 1 s [deg] | ATE [mm] | lost | CPU [ms a frame] |",
             "| --- | --- | ---: | ---: | ---: | ---: | ---: |"]
    for name in sequences:
        runs = {"ours": ours[name]} if name in ours else {}
        runs.update(runs_of(folder / f"{name}.json") or {})
        for system, run in runs.items():
            figures = ["-" if run.get(f) is None else f"{run[f]:.{DIGITS[f]}f}" for f in FIGURES]
            lines.append(f"| {name} | {system} | " + " | ".join(figures) +
                         f" | {run['lost']} | {run['cpu_ms']:.1f} |")
    return "\n".join(lines)


def settings_table(folder, rows):
    """What other values of options do to our odometry."""
    defaults = {row["sequence"]: row for row in rows if row["mode"] == "odometry"}
    found = {}
    for cell in sorted(folder.glob("*/*/*.json")):
        option, value = cell.parts[-3:-1]
        found.setdefault((option, value), {})[cell.stem] = summarise(runs_of(cell), None)
    names = list(dict.fromkeys(name for cells in found.values() for name in cells))
    text = lambda row: ("{rpe_mm:.1f} / {rpe_deg:.2f}, {ate_mm:.1f}".format(**row) +
                        (f", {row['lost']} lost" if row["lost"] else "")) if row else "-"
    lines = ["| setting | " + " | ".join(names) + " |", "| --- |" + " ---: |" * len(names),
             "| defaults | " + " | ".join(text(defaults.get(name)) for name in names) + " |"]
    for (option, value), cells in found.items():
        lines.append(f"| `{option}={value}` | " + " | ".join(text(cells.get(n)) for n in names) + " |")
    return "\n".join(lines)


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("cells", type=pathlib.Path)
    parser.add_argument("--against", type=pathlib.Path)
    parser.add_argument("--others", type=pathlib.Path)
    parser.add_argument("--settings", type=pathlib.Path)
    parser.add_argument("--modes", nargs="+", required=True)
    parser.add_argument("--sequences", nargs="+", required=True)
    parser.add_argument("--out", required=True)
    arguments = parser.parse_args()

    rows = []
    for mode in arguments.modes:
        for name in arguments.sequences:
            runs = runs_of(arguments.cells / mode / f"{name}.json")
            if runs is None:
                continue
            other = runs_of(arguments.against / mode / f"{name}.json") if arguments.against else None
            rows.append({"sequence": name, "mode": mode, **summarise(runs, other)})

    label, against = arguments.cells.name, arguments.against.name if arguments.against else ""
    text = [f"Program `{label}`" + (f", compared with `{against}`." if against else "."), "",
            "Medians over the runs of `cvo_slam bench variants` [lowest, highest]; `lost` is the sum of",
            "the lost frames, which keep the pose before them; `wrong` is the sum of the frames that are called",
            "tracked although their motion since the last right one is off by more than 10 cm or 5 degrees."]
    if against:
        text += ["`a → b; w, l`: the other program has the median a, this one b, and is better in w and worse",
                 "in l runs with the same perturbation; the others are equal to a tenth of what is printed. Times",
                 "of two programs were not measured in one run."]
    for mode in arguments.modes:
        text += ["", f"## {mode}", "", table(rows, mode, against), "",
                 wrong_text(rows, mode, arguments.cells), "", features_text(rows, mode), "",
                 path_text(rows, mode)]
    if arguments.others:
        text += ["", "## Other systems", "", "One run of each, beside the medians of our odometry.", "",
                 others_table(arguments.others, arguments.sequences, rows)]
    if arguments.settings:
        text += ["", "## Sensitivity", "", "Odometry with other values of options: medians of RPE 1 s "
                 "[mm / deg], ATE [mm] and the sum of lost frames.", "",
                 settings_table(arguments.settings, rows)]
    pathlib.Path(arguments.out + ".md").write_text("\n".join(text) + "\n")
    pathlib.Path(arguments.out + ".json").write_text(
        json.dumps({"program": label, "against": against, "rows": rows}, indent=1) + "\n")
    with open(arguments.out + ".csv", "w", newline="") as file:
        keys = list(dict.fromkeys(key for row in rows for key in row))
        writer = csv.DictWriter(file, keys, lineterminator="\n")
        writer.writeheader()
        writer.writerows(rows)


if __name__ == "__main__":
    main()
