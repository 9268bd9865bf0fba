#!/usr/bin/env python3
"""Runs every `remount-cli` command that stands in a block of shell of a document, in the order of the document.

What else stands in such blocks (installing, containers, the window) is not run, and printed as such.

Usage: run_commands.py SOURCE PROGRAM

Each document has a folder of its own in which its commands are run, with /data and /tmp below it; there are the drives and
files that a reader would have: two drives of a vehicle with two LiDARs, tables beside clouds, results and a fleet. A
command must end with 0 and have written anew what it was told to write.
"""

import pathlib
import re
import shlex
import shutil
import subprocess
import sys
import tempfile
from math import cos, sin

SOURCE, PROGRAM = pathlib.Path(sys.argv[1]).resolve(), pathlib.Path(sys.argv[2]).resolve()
SAMPLE = SOURCE / "resources/sample"
DOCUMENTS = [SOURCE / "README.md", *sorted((SOURCE / "docs").rglob("*.md"))]

VEHICLE = ["--duration-s", "14", "--ins-rate-hz", "50",
           "--mount", "front=at:1.25/0.05/1.55/2/0.5/-0.5,beams:16,points:2900,ring-elevation-deg:0.1,ring-range-m:0.01",
           "--mount", "rear=at:-1.2/-0.2/1.1/170/1/-1,beams:16,points:2900,phase:0.03"]
FLEET = """\
format: remount-fleet/1
vehicles:
  - name: van 1
    sessions: [data/drive1, data/drive2]
"""
# Turns of an INS and of a LiDAR that sits 1 m ahead of it, turned by a quarter: P X = X Q.
PAIRS = ((0.3, 0.1, -0.2, 1.0, 0.2, 0.1), (-0.2, 0.4, 0.1, 0.5, -0.3, 0.2), (0.1, -0.3, 0.5, -0.4, 0.8, 0.3),
         (0.5, 0.2, 0.3, 0.9, 0.1, -0.2))


def product(a, b):
    return [[sum(a[i][k] * b[k][j] for k in range(4)) for j in range(4)] for i in range(4)]


def inverse(a):
    turned = [[a[j][i] for j in range(3)] for i in range(3)]
    moved = [-sum(turned[i][k] * a[k][3] for k in range(3)) for i in range(3)]
    return [turned[0] + [moved[0]], turned[1] + [moved[1]], turned[2] + [moved[2]], [0, 0, 0, 1]]


def rigid(roll, pitch, yaw, x, y, z):
    def about(axis, angle):
        i, j = [(1, 2), (2, 0), (0, 1)][axis]
        out = [[float(r == c) for c in range(4)] for r in range(4)]
        out[i][i] = out[j][j] = cos(angle)
        out[i][j], out[j][i] = -sin(angle), sin(angle)
        return out

    out = product(product(about(2, yaw), about(1, pitch)), about(0, roll))
    for i, value in enumerate((x, y, z)):
        out[i][3] = value
    return out


def pairs_csv():
    ins_from_lidar = rigid(0, 0, 1.5708, 1.0, 0.0, 1.5)
    names = [f"{letter}{row}{column}" for letter in "PQ" for row in range(3) for column in range(4)]
    lines = [",".join(["set", "i", "j", *names])]
    for number, motion in enumerate(PAIRS):
        p = rigid(*motion)
        q = product(product(inverse(ins_from_lidar), p), ins_from_lidar)
        values = [f"{m[row][column]:.12f}" for m in (p, q) for row in range(3) for column in range(4)]
        lines.append(",".join(["a", str(number), str(number + 1), *values]))
    return "\n".join(lines) + "\n"


def velodyne_calibration(lasers):
    items = "".join(
        f"<item><px><id_>{laser}</id_><rotCorrection_>0</rotCorrection_><vertCorrection_>{elevation:.6f}</vertCorrection_>"
        "<distCorrection_>0</distCorrection_><distCorrectionX_>0</distCorrectionX_><distCorrectionY_>0</distCorrectionY_>"
        "<vertOffsetCorrection_>0</vertOffsetCorrection_><horizOffsetCorrection_>0</horizOffsetCorrection_></px></item>\n"
        for laser, elevation in enumerate(-15 + 30 * laser / (lasers - 1) for laser in range(lasers)))
    return ('<?xml version="1.0"?>\n<boost_serialization><DB class_id="0"><distLSB_>0.2</distLSB_><points_>\n'
            f"{items}</points_></DB></boost_serialization>\n")


def run(words, folder):
    return subprocess.run([str(PROGRAM), *map(str, words)], cwd=folder, capture_output=True, text=True, timeout=600)


def must(words, folder):
    done = run(words, folder)
    if done.returncode != 0:
        sys.exit(f"what documents rest on: {' '.join(map(str, words))} ended with {done.returncode}:\n{done.stderr}")


def make_stock(stock):
    """What a reader has: recordings, results of yesterday, files of others."""
    data = stock / "data"
    data.mkdir()
    (stock / "tmp").mkdir()
    must(["simulate", "figure-eight", data / "drive1", *VEHICLE], stock)
    must(["simulate", "figure-eight", data / "drive2", *VEHICLE, "--seed", "2"], stock)
    must(["simulate", "figure-eight", data / "tables", "--duration-s", "8", "--beams", "16", "--azimuth-steps", "180"], stock)
    for file in ("session.yaml", "truth.yaml"):
        (data / "tables" / file).unlink(missing_ok=True)
    must(["calibrate", data / "drive1", data / "drive2", "-o", stock / "result.yaml"], stock)
    must(["calibrate", data / "drive1", "--lidars", "all", "-o", stock / "vehicle.yaml"], stock)
    must(["export", stock / "vehicle.yaml", "--to", "autoware", "-o", stock / "sensor_kit_calibration.yaml"], stock)
    must(["export", stock / "vehicle.yaml", "--to", "yaml", "--lidar", "rear", "-o", stock / "rear.yaml"], stock)
    for name in ("monday.yaml", "friday.yaml", "by-trajectory.yaml"):
        shutil.copy(stock / "result.yaml", stock / name)
    (stock / "FLEET.yaml").write_text(FLEET)
    (stock / "PAIRS.csv").write_text(pairs_csv())
    (stock / "db.xml").write_text(velodyne_calibration(16))


def commands_of(document):
    for block in re.findall(r"^```sh\n(.*?)^```", document.read_text(), re.S | re.M):
        for line in re.sub(r" *\\\n *", " ", block).splitlines():
            words = shlex.split(line, comments=True)
            if words[:1] == ["remount-cli"] and not any(re.search(r"[<{…]|^VERB$", word) for word in words):
                yield words[1:]
            elif words:
                print(f"not run  {document.relative_to(SOURCE)}: {' '.join(words)}")


def newest_ns(path):
    """When it was written last, of a folder what is in it; None where there is nothing."""
    if not path.exists():
        return None
    return max(part.stat().st_mtime_ns for part in [path, *path.rglob("*")])


def main():
    count, failures = 0, []
    with tempfile.TemporaryDirectory(prefix="remount-documents-") as place:
        stock = pathlib.Path(place) / "stock"
        stock.mkdir()
        make_stock(stock)
        for document in DOCUMENTS:
            commands = list(commands_of(document))
            if not commands:
                continue
            folder = pathlib.Path(place) / document.relative_to(SOURCE).with_suffix("").as_posix().replace("/", "-")
            shutil.copytree(stock, folder)
            for words in commands:
                count += 1
                real = [re.sub(r"^/(data|tmp)\b", rf"{folder}/\1", word.replace("/usr/share/remount/sample", str(SAMPLE)))
                        for word in words]
                outputs = [folder / value for option, value in zip(real, real[1:]) if option in ("-o", "--output")]
                before = [newest_ns(output) for output in outputs]
                done = run(real, folder)
                said = f"{document.relative_to(SOURCE)}: remount-cli {' '.join(words)}"
                if done.returncode != 0:
                    failures.append(f"{said}\n  ended with {done.returncode}: {(done.stderr or done.stdout).strip()[-600:]}")
                for output, written_before in zip(outputs, before):
                    if done.returncode == 0 and newest_ns(output) in (None, written_before):
                        failures.append(f"{said}\n  wrote no {output.name}")
                print(f"{done.returncode}  {said}", flush=True)
    print(f"{count} commands of documents were run, {len(failures)} failed")
    for failure in failures:
        print(failure)
    if count == 0 or failures:
        sys.exit(1)


main()
