#!/usr/bin/env python3
"""Blender's dynamic topology and Fettle, the same strokes in turns, in one run:

    tests/bench/peers.py [--rounds 5] [--bench build/release/tests/bench/fettle_bench] [CASE...]

Needs blender and xvfb-run (Debian: blender xvfb). Prints for each case the milliseconds a dab, the best of all rounds: on a
machine that others share only the least is a program's own. The time of Blender is that of its sculpt operator less what
a stroke of one dab costs (blender_strokes.py), undo included, redraw and upload not; Fettle's leaves out the first dab, too,
and holds exact verification, undo journal and the patch for viewers. "cpu" counts all threads of each.
"""

import argparse
import json
import os
import pathlib
import subprocess
import sys
import tempfile

HERE = pathlib.Path(__file__).resolve().parent

#        name                   subdivisions, radius, detail, dabs; row of fettle_bench
CASES = {
    "2.5k": (5, 0.25, 1, 200, "peersStroke/cuts:16/radius_e-6:250000/shuffled:0"),
    "41k": (7, 0.0625, 1, 200, "peersStroke/cuts:64/radius_e-6:62500/shuffled:0"),
    "164k": (8, 0.031, 1, 200, "peersStroke/cuts:128/radius_e-6:31000/shuffled:0"),
    "655k": (9, 0.0156, 1, 200, "peersStroke/cuts:256/radius_e-6:15600/shuffled:0"),
    "41k-large": (7, 0.25, 0.25, 100, "largeDab/cuts:64/radius_e-6:250000/detail_e-4:2500/dabs:100"),
    "164k-large": (8, 0.25, 0.124, 100, "largeDab/cuts:128/radius_e-6:250000/detail_e-4:1240/dabs:100"),
    "655k-large": (9, 0.25, 0.0624, 40, "largeDab/cuts:256/radius_e-6:250000/detail_e-4:624/dabs:40"),
}


def run_blender(case, out):
    subdivisions, radius, detail, dabs, _ = CASES[case]
    command = ["xvfb-run", "-a", "-s", "-screen 0 1280x800x24", "blender", "--factory-startup", "--python-exit-code", "1",
               "--python", str(HERE / "blender_strokes.py"), "--", str(subdivisions), str(radius), str(detail), str(dabs), out]
    done = subprocess.run(command, capture_output=True, text=True, env={**os.environ, "LIBGL_ALWAYS_SOFTWARE": "1"}, check=False)
    if done.returncode != 0:
        sys.exit(f"Blender failed on {case}:\n{done.stdout}{done.stderr}")
    with open(out, encoding="utf-8") as file:
        return json.load(file)


def run_fettle(bench, case, out):
    subprocess.run([bench, f"--benchmark_filter={CASES[case][4]}/", "--benchmark_repetitions=1", f"--benchmark_out={out}"],
                   capture_output=True, check=True)
    with open(out, encoding="utf-8") as file:
        row = json.load(file)["benchmarks"][0]
    return {"wall_ms": row["wall_mean"] / 1e3, "cpu_ms": row["cpu_all_mean"] / 1e3, "stroke_ms": row["stroke"] / 1e3,
            "touched": row["touched"]}


def best(results):
    return {key: min(result[key] for result in results) for key in ("wall_ms", "cpu_ms", "stroke_ms", "touched")}


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n", maxsplit=1)[0])
    parser.add_argument("--rounds", type=int, default=5)
    parser.add_argument("--bench", default=str(HERE.parents[1] / "build/release/tests/bench/fettle_bench"))
    parser.add_argument("cases", nargs="*", choices=[[], *CASES], metavar="CASE", help=", ".join(CASES))
    options = parser.parse_args()
    cases = options.cases or list(CASES)

    blender, fettle = {case: [] for case in cases}, {case: [] for case in cases}
    with tempfile.TemporaryDirectory() as folder:
        for turn in range(options.rounds):
            for case in cases:
                print(f"round {turn + 1} of {options.rounds}: {case}", file=sys.stderr)
                blender[case].append(run_blender(case, f"{folder}/blender.json"))
                fettle[case].append(run_fettle(options.bench, case, f"{folder}/fettle.json"))

    version = blender[cases[0]][0]["version"]
    print(f"ms a dab, best of {options.rounds}; touched vertices and what a stroke costs by itself of both programs")
    print(f"{'':11}{'touched':>17}{'wall: Blender':>15}{'Fettle':>9}{'ratio':>7}{'cpu: Blender':>15}{'Fettle':>9}{'ratio':>7}{'a stroke':>19}")
    for case in cases:
        b, f = best(blender[case]), best(fettle[case])
        print(f"{case:11}{b['touched']:9.0f}{f['touched']:8.0f}"
              f"{b['wall_ms']:15.3f}{f['wall_ms']:9.3f}{f['wall_ms'] / b['wall_ms']:7.2f}"
              f"{b['cpu_ms']:15.3f}{f['cpu_ms']:9.3f}{f['cpu_ms'] / b['cpu_ms']:7.2f}"
              f"{b['stroke_ms']:10.2f}{f['stroke_ms']:9.2f}")
    print(f"Blender {version}")


if __name__ == "__main__":
    main()
