#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The cvo_slam authors
# SPDX-License-Identifier: BSD-3-Clause
"""Gives the program inputs of other people's making and writes docs/results/foreign-input.md.

usage: foreign_input.py <program> [page]      (make foreign-input)

Each case says what is right: an exit code and words of the output. A case that is not right makes
the exit code 1. Recordings are rendered by the program itself; those below CVO_SLAM_DATA (default
../shared/data) are used where they are.
"""
import dataclasses
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

PROGRAM = pathlib.Path(sys.argv[1]).resolve()
ROOT = pathlib.Path(__file__).resolve().parent.parent
PAGE = pathlib.Path(sys.argv[2] if len(sys.argv) > 2 else ROOT / "docs/results/foreign-input.md")
DATA = pathlib.Path(os.environ.get("CVO_SLAM_DATA", ROOT.parent / "shared/data")).resolve()


@dataclasses.dataclass
class Case:
    section: str
    what: str
    command: list
    code: int
    expected: list  # regular expressions that the output has
    kept: pathlib.Path | None = None  # a file that must stay as it is
    memory_mb: int = 600
    seconds: int = 60
    result: str = ""
    right: bool = False


CASES = []
WORK = pathlib.Path(tempfile.mkdtemp(prefix="cvo_slam_foreign_"))


def add(section, what, command, code, *expected, **more):
    CASES.append(Case(section, what, [str(word) for word in command], code, list(expected), **more))


def write(name, text):
    file = WORK / name
    file.parent.mkdir(parents=True, exist_ok=True)
    file.write_bytes(text if isinstance(text, bytes) else text.encode())
    return file


def run_case(case):
    limit = f"ulimit -v {case.memory_mb * 1024 * 4}; exec \"$@\""  # address space, not memory
    before = case.kept.read_bytes() if case.kept else None
    try:
        run = subprocess.run(["/usr/bin/env", "bash", "-c", limit, "case", str(PROGRAM)] + case.command,
                             capture_output=True, timeout=case.seconds, cwd=WORK, check=False)
        output = (run.stdout + run.stderr).decode(errors="replace")
        code = run.returncode
    except subprocess.TimeoutExpired:
        output, code = "no answer in time", -1
    missing = [words for words in case.expected if not re.search(words, output)]
    lost = before is not None and case.kept.read_bytes() != before
    case.right = code == case.code and not missing and not lost
    lines = [line for line in output.splitlines() if line.strip()]
    said = [line for line in lines if any(re.search(words, line) for words in case.expected)]
    case.result = f"exit {code}: " + " / ".join(dict.fromkeys(said or lines[-1:]))
    if not case.right:
        case.result += f" — WRONG: expected exit {case.code}, {case.expected}"


# Recordings.


def recording(name, camera=True, frames=15):
    """A room in the TUM layout."""
    base = WORK / "base"
    if not base.exists():
        subprocess.run([str(PROGRAM), "synth", "room", str(base), "--frames", str(frames)],
                       check=True, capture_output=True)
    folder = WORK / name
    shutil.copytree(base, folder)
    if not camera:
        (folder / "camera.yaml").rename(WORK / f"{name.replace('/', '_')}.yaml")
        for extra in folder.glob("*.yaml"):
            extra.unlink()
    return folder


def edit(file, change):
    file.write_text(change(file.read_text()))


def cameras():
    section = "A camera that was guessed"
    unknown = r"the camera of this sequence is not known.*give --camera .*tum_fr1"
    for name in ("livingroom1", "fr2_walk_home", "rgbd_dataset_freiburg1_rpy_mine"):
        folder = recording(f"{name}/{name}", camera=False)
        add(section, f"a folder `{name}` with rgb.txt, depth.txt and no camera file",
            ["run", folder, "--out", WORK / "out"], 2, unknown)
    add(section, "the same with `--camera`",
        ["run", folder, "--camera", WORK / f"{name}_{name}.yaml", "--out", WORK / "given", "--mode",
         "odometry", "--quiet", "--json"], 0, r'"camera_origin": "given by the caller"')
    folder = recording("depth_first/sequence", camera=False)
    pairs = [f"{i + 1} {d} {i + 1} {c}\n" for i, (c, d) in enumerate(zip(
        [line.split()[1] for line in (folder / "rgb.txt").read_text().splitlines() if line[0] != "#"],
        [line.split()[1] for line in (folder / "depth.txt").read_text().splitlines() if line[0] != "#"]))]
    write("depth_first/sequence/associations.txt", "".join(pairs))
    add(section, "a depth-first list with frame numbers", ["info", folder], 2, unknown)
    folder = recording("above/sequence", camera=False)
    shutil.copy(WORK / "above_sequence.yaml", WORK / "above/camera.yaml")
    add(section, "a camera.yaml above the folder", ["info", folder], 0,
        "camera.yaml in the folder above the sequence")
    folder = recording("foreign/sequence", camera=False)
    write("foreign/sequence/intrinsics.txt", "600 0 80\n0 600 60\n0 0 1\n")
    add(section, "a camera file of a format that is not read", ["info", folder], 2,
        "intrinsics.txt .*format that is not read")
    if (DATA / "fixtures/icl_nuim").exists():
        add(section, "the excerpt of ICL-NUIM", ["info", DATA / "fixtures/icl_nuim"], 0,
            "camera +icl_nuim", "re-project several times better")
    if (DATA / "7scenes/seq-01").exists():
        add(section, "7-Scenes", ["info", DATA / "7scenes/seq-01"], 0, "camera +7scenes",
            "re-project several times better")
        folder = WORK / "seven/seq"
        folder.mkdir(parents=True)
        for i in range(20):
            for kind in ("color.jpg", "depth.png", "pose.txt"):
                os.symlink(DATA / f"7scenes/seq-01/frame-{i:06}.{kind}", folder / f"frame-{i:06}.{kind}")
        write("seven/camera-intrinsics.txt", "518 0 325\n0 519 253\n0 0 1\n")
        add(section, "the layout of 7-Scenes with other intrinsics in a file above", ["info", folder], 2,
            "not known whether the camera is 7scenes")
    rpy = DATA / "tum/rgbd_dataset_freiburg1_rpy"
    if rpy.exists():
        add(section, "fr1/rpy", ["info", rpy], 0, "camera +tum_fr1", "the recording is 'rgbd_dataset")
        add(section, "fr1/rpy with the camera of ICL-NUIM, `info --check`",
            ["info", rpy, "--camera", "icl_nuim", "--check"], 0, "warning: frames re-project badly")
    folder = recording("halved/sequence")
    edit(folder / "camera.yaml", lambda text: re.sub("depth_scale: 5000", "depth_scale: 2500", text))
    add(section, "a depth_scale that is wrong by 2",
        ["run", folder, "--out", WORK / "scaled", "--mode", "odometry"], 0,
        "warning: (the reference is|frames re-project badly)")
    folder = recording("fold/sequence")
    edit(folder / "camera.yaml", lambda text: text + "distortion: [-3, 0, 0, 0, 0]\n")
    add(section, "a distortion that folds back inside the image", ["info", folder], 0,
        "warning: the distortion of the colour camera folds back")


def trajectories():
    section = "Lines that vanish; numbers of others"
    poses = [f"{1000 + i / 30:.4f} {0.01 * i:.3f} {0.02 * (i % 7):.3f} {0.03 * (i % 5)} 0 0 0 1\n"
             for i in range(788)]
    truth = write("truth.txt", "".join(poses))
    rounded = write("rounded.txt", "".join(re.sub(r"^(\d+)\.\d+", r"\1", line) for line in poses))
    add(section, "an estimate whose stamps are rounded to seconds", ["eval", truth, rounded], 0,
        r"27 of 788", "(?i)warning")
    add(section, "the same in JSON", ["eval", truth, rounded, "--json"], 0, "(?i)duplicate|left out")
    add(section, "a byte order mark", ["eval", truth, write("bom.txt", b"\xef\xbb\xbf" + "".join(poses).encode())],
        0, "788 of 788")
    add(section, "UTF-16", ["eval", truth, write("utf16.txt", "".join(poses).encode("utf-16"))], 2, "UTF-16")
    add(section, "`+0.5` and `1e-400`",
        ["eval", truth, write("plus.txt", "".join(poses).replace(" 0 0 0 1", " +0 1e-400 0 +1"))], 0, "788 of 788")
    add(section, "decimal commas",
        ["eval", truth, write("comma.txt", "".join(poses).replace(".", ","))], 2, "(?i)comma")
    add(section, "stamps in nanoseconds",
        ["eval", truth, write("ns.txt", "".join(f"{1305031102000000000 + i} 0 0 0 0 0 0 1\n" for i in range(9)))],
        2, "(?i)nanoseconds")
    add(section, "stamps in milliseconds",
        ["eval", truth, write("ms.txt", "".join(f"{1305031102175.5 + i} 0 0 0 0 0 0 1\n" for i in range(9)))],
        2, "(?i)milliseconds")
    add(section, "CSV", ["eval", truth, write("poses.csv", "".join(poses).replace(" ", ","))], 0, "788 of 788")
    add(section, "errors of 10^12 m: columns stay apart",
        ["eval", truth, write("far.txt", "".join(poses).replace(" 0.0", " 98765432109870.0")), "--align", "none"],
        0, r"translation \[m\] +\S+ +\S+ +\S+ +\S+ +\S+ +\S+ +\S+ +\d+")
    folder = recording("nan_truth/sequence")
    edit(folder / "groundtruth.txt", lambda text: text + "2000 nan nan nan 0 0 0 1\n")
    add(section, "ground truth with a row that is not finite", ["info", folder], 0, r"groundtruth.txt.*(not finite|skipped|left out)")
    folder = recording("bad_truth/sequence")
    write("bad_truth/sequence/groundtruth.txt", "these are no poses\n")
    add(section, "ground truth that cannot be read", ["run", folder, "--out", WORK / "bt", "--mode", "odometry"], 0,
        "the ground truth cannot be read")


def settings():
    section = "Settings files of others, YAML"
    orb = ("%YAML:1.0\nCamera.fx: 262.5\nCamera.fy: 262.5\nCamera.cx: 79.5\nCamera.cy: 59.5\n"
           "Camera.width: 160\nCamera.height: 120\nDepthMapFactor: 5000.0\n")
    folder = recording("settings/sequence")

    def camera(name, text, code, *expected):
        add(section, name, ["info", folder, "--camera", write(f"settings/{len(CASES)}.yaml", text)], code, *expected)

    camera("a settings file of ORB-SLAM", orb, 0, "given by the caller")
    camera("`Camera.k4: 0.1`", orb + "Camera.k4: 0.1\n", 2, "Camera.k4")
    camera("`Camera.model: fisheye`", orb + "Camera.model: fisheye\n", 2, "Camera.model.*fisheye")
    camera("`Camera.type: KannalaBrandt8`", orb + "Camera.type: KannalaBrandt8\n", 2, "Camera.type.*KannalaBrandt8")
    camera("p1 = 636", orb + "Camera.p1: 636\n", 2, "p1")
    camera("a key of the lens that is not known", orb + "Camera.mirror: 1.1\n", 2, "Camera.mirror")
    camera("an alias within its own anchor", "x: &a {b: *a}\n", 2, "(?i)alias|anchor")
    bomb = "a0: &a0 [x]\n" + "".join(f"a{i}: &a{i} [*a{i - 1}, *a{i - 1}]\n" for i in range(1, 40))
    camera("aliases that double", bomb, 2, "(?i)alias|anchor")
    camera("nesting 100,000 deep", "a: " + "[" * 100000, 2, "nested too deeply|a key must be")
    camera("a depth camera of 65536 x 65536", orb.replace("%YAML:1.0\n", "").replace("Camera.", "").replace(
        "DepthMapFactor", "depth_scale") + "depth: {width: 65536, height: 65536, fx: 1, fy: 1, cx: 1, cy: 1, "
        "T_color_depth: [[1,0,0,0],[0,1,0,0],[0,0,1,0],[0,0,0,1]]}\n", 2, "65536")
    subprocess.run([str(PROGRAM), "synth", "structure_texture_near", "--dump-world", str(WORK / "world.yaml")],
                   check=True, capture_output=True)
    text = (WORK / "world.yaml").read_text()
    long_world = write("long_world.yaml", re.sub(r"duration: .*", "duration: 1e15", text))
    add(section, "a world of 1e15 s", ["synth", long_world, WORK / "synth_long"], 2, "duration|1e\\+?15")


def graphs():
    section = "Pose graphs"
    information = "100 0 0 0 0 0 100 0 0 0 0 100 0 0 0 100 0 0 100 0 100"
    nodes = [f"VERTEX_SE3:QUAT {i} {i * 0.9} {0.05 * i} 0 0 0 0 1\n" for i in range(30)]
    backwards = [f"EDGE_SE3:QUAT {i + 1} {i} -1 0 0 0 0 0 1 {information}\n" for i in range(29)]
    wrong = [f"EDGE_SE3:QUAT {i} {i + 9} 0 5 0 0 0 0 1 {information}\n" for i in range(0, 18, 6)]
    graph = write("backwards.g2o", "".join(nodes + backwards + wrong))
    add(section, "gnc, odometry edges from the newer to the older vertex, three wrong loops",
        ["optimize", graph, WORK / "backwards_out.g2o", "--loss", "gnc"], 0, r"edges +32, 3 rejected",
        "(?i)note.*(loop|reject)")
    extras = ("PARAMS_SE3OFFSET 0 0 0 0 0 0 0 1\nVERTEX_TRACKXYZ 99 1 2 3\n"
              f"EDGE_SE3_PRIOR 0 0 0 0 0 0 0 0 1 {information}\n")
    graph = write("extras.g2o", "".join(nodes + backwards) + extras)
    add(section, "parameters, priors and landmarks", ["optimize", graph, WORK / "extras_out.g2o"], 0, "(?i)note.*(skipped|left out)")
    add(section, "the same with `--strict`", ["optimize", graph, WORK / "extras_out.g2o", "--strict"], 2, "PARAMS_SE3OFFSET|unknown entry")
    rounding = information.replace("100 0 0 0 0 0 100", "0 1e-4 0 0 0 0 100", 1)
    graph = write("rounding.g2o", "".join(nodes + backwards) + f"EDGE_SE3:QUAT 0 5 5 0 0 0 0 0 1 {rounding}\n")
    add(section, "an information matrix that is negative by rounding", ["optimize", graph, WORK / "r.g2o"], 0, "(?i)note")
    graph = write("negative.g2o", "".join(nodes + backwards) + f"EDGE_SE3:QUAT 0 5 5 0 0 0 0 0 1 {information.replace('100', '-100', 1)}\n")
    add(section, "one that is negative", ["optimize", graph, WORK / "n.g2o"], 2, r"negative.g2o:60: ")
    graph = write("upper.G2O", "".join(nodes + backwards))
    add(section, "`.G2O`", ["optimize", graph, WORK / "u.g2o"], 0, "nodes +30")
    add(section, "a disk that is full (`optimize g g`)", ["optimize", graph, "/dev/full"], 1, "/dev/full", kept=graph)


def clouds():
    section = "Point clouds"

    def ply(name, properties, rows, binary=False):
        kind = "binary_little_endian" if binary else "ascii"
        lines = "".join(f"property {p}\n" for p in properties)
        head = f"ply\nformat {kind} 1.0\nelement vertex {len(rows)}\n{lines}end_header\n"
        return write(name, head + "".join(" ".join(str(v) for v in row) + "\n" for row in rows))

    grid = [(400000 + 0.01 * i, 5000000 + 0.01 * j, 0.0) for i in range(60) for j in range(60)]
    xyz = ["double x", "double y", "double z"]
    add(section, "doubles in UTM coordinates", ["render", ply("utm.ply", xyz, grid), "-o", WORK / "utm.png"], 0)
    colors = ["float red", "float green", "float blue"]
    rows = [(i, j, 0, 200.0, 100.0, 50.0) for i in range(9) for j in range(9)]
    add(section, "colours as float, 0 to 255", ["render", ply("f255.ply", ["float x", "float y", "float z"] + colors, rows), "-o", WORK / "f.png"], 0)
    odd = ["float x", "float y", "float z", "float f_dc_0", "float f_dc_1", "float f_dc_2"]
    add(section, "colour properties that are not understood", ["render", ply("odd.ply", odd, rows), "-o", WORK / "o.png"], 0, "note: .*the points are grey")
    holes = rows + [("inf", 0, 0, 1, 1, 1), ("nan", 0, 0, 1, 1, 1)]
    add(section, "`inf` and `nan`", ["render", ply("inf.PLY", ["float x", "float y", "float z"] + colors, holes), "-o", WORK / "i.png"], 0)
    huge = write("huge.ply", b"ply\nformat binary_little_endian 1.0\nelement a 18446744073709551615\nproperty double v\n"
                 b"element vertex 18446744073709551615\nproperty float x\nproperty float y\nproperty float z\nend_header\nabc")
    add(section, "counts of 2^64 - 1", ["render", huge, "-o", WORK / "h.png"], 2, "huge.ply")


def images():
    section = "Images and lists"
    folder = recording("padded/sequence")
    for image in list((folder / "rgb").iterdir()) + list((folder / "depth").iterdir()):
        image.write_bytes(image.read_bytes() + b"x" * 5000)
    add(section, "5,000 bytes behind the end marker of each image",
        ["run", folder, "--out", WORK / "padded_out", "--mode", "odometry"], 0, r"lost +0.0 %")
    folder = recording("bomb/sequence")
    for image in (folder / "rgb").iterdir():
        data = bytearray(image.read_bytes())
        data[16:24] = (30000).to_bytes(4, "big") * 2
        image.write_bytes(data)
    add(section, "images of 30,000 x 30,000 pixels in a few kB", ["run", folder, "--out", WORK / "bomb_out"], 2,
        "none of the first 10 frames.*30000x30000", memory_mb=300)
    folder = recording("device/sequence")
    edit(folder / "rgb.txt", lambda text: re.sub(r"rgb/\S+", "/dev/zero", text))
    add(section, "`/dev/zero` in a list", ["run", folder, "--out", WORK / "device_out"], 2, "not a regular file")
    folder = recording("outside/sequence")
    shutil.move(str(folder / "rgb"), WORK / "outside/elsewhere")
    edit(folder / "rgb.txt", lambda text: text.replace("rgb/", "../elsewhere/"))
    add(section, "images outside of the folder (`../`)", ["info", folder], 0, "lie outside of the folder")
    folder = recording("comment/sequence")
    edit(folder / "rgb.txt", lambda text: "# " + "file: 'x" * 20000 + "\n" + text)
    add(section, "a comment of 140,000 characters", ["info", folder], 0, "frames +15")
    folder = recording("pairs/sequence")
    pairs = "".join(f"{a.split()[0]} {a.split()[1]} {b.split()[0]} {b.split()[1]} 1 2 3\n" for a, b in zip(
        [l for l in (folder / "rgb.txt").read_text().splitlines() if l[0] != "#"],
        [l for l in (folder / "depth.txt").read_text().splitlines() if l[0] != "#"]))
    add(section, "`--associations` with further columns", ["info", folder, "--associations", write("pairs.txt", pairs)], 0,
        "frames +15", "left out")
    add(section, "`--depth-offset`, `--max-diff`", ["info", folder, "--depth-offset", "0.1", "--max-diff", "0.005"], 0, "frames +1[0-9]")
    name = os.fsencode(str(WORK)) + b"/na\xffme"
    shutil.copytree(WORK / "base", os.fsdecode(name))
    add(section, "a folder whose name is not UTF-8",
        ["run", os.fsdecode(name), "--out", WORK / "utf8_out", "--mode", "odometry", "--json", "--quiet"], 0, '"tracked": 15')
    add(section, "a step near 2^64", ["run", WORK / "base", "--frames", "0:15:18446744073709551615", "--out", WORK / "step",
                                      "--mode", "odometry", "--quiet", "--json"], 0, '"processed": 1')
    mine = write("mine/config.yaml", "tracker.points: 1500\n")
    add(section, "`--out` with a file of the user's that `--config` names",
        ["run", WORK / "base", "--config", mine, "--out", WORK / "mine"], 1, "give --overwrite", kept=mine)


def vocabularies():
    section = "Vocabularies"
    text = write("words.txt", "10 6 0 0\n0 1 " + "1 " * 32 + "0.5\nnonsense\n")
    add(section, "a line that is none", ["vocab", "info", text], 2, "words.txt:3: ")
    add(section, "another file", ["vocab", "info", write("vocabulary", b"\x00\x01\x02")], 2, "vocabulary")


def escape(text):
    return text.replace("|", "\\|").replace(str(WORK) + "/", "").replace(str(DATA) + "/", "")


def main():
    status = subprocess.run(["git", "status", "--porcelain", "--", ".", ":!docs/results", ":!docs/images"], cwd=ROOT,
                            capture_output=True, text=True, check=True).stdout
    if status and "--dirty" not in sys.argv:
        sys.exit("foreign_input.py: the working tree has changes; commit them first")
    for collect in (cameras, trajectories, settings, graphs, clouds, images, vocabularies):
        collect()
    for case in CASES:
        run_case(case)
        if not case.right:
            print(f"{case.section}: {case.what}\n  {' '.join(case.command)}\n  {case.result}", file=sys.stderr)
    revision = subprocess.run(["git", "describe", "--always"], cwd=ROOT, capture_output=True, text=True, check=True).stdout
    wrong = sum(not case.right for case in CASES)
    text = ("# Foreign input\n\nWritten by `make foreign-input`; do not edit. Inputs of other people's making, from public "
            "reports, and what the program says: it is right, or it refuses with a reason. The script is "
            "[bench/foreign_input.py](../../bench/foreign_input.py); it says for each case what is right.\n\n"
            f"- revision: {revision.strip()}\n- cases: {len(CASES)}, right: {len(CASES) - wrong}\n")
    for section in dict.fromkeys(case.section for case in CASES):
        text += f"\n## {section}\n\n| input | what happens |\n|---|---|\n"
        for case in CASES:
            if case.section == section:
                text += f"| {escape(case.what)} | {escape(case.result)} |\n"
    PAGE.write_text(text)
    shutil.rmtree(WORK, ignore_errors=True)
    print(f"{len(CASES) - wrong} of {len(CASES)} cases are right; {PAGE}")
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
