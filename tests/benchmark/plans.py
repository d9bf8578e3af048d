#!/usr/bin/env python3
"""What `wold plan` says before a first run, against what then happens:

    tests/benchmark/plans.py [EXAMPLE:FRAMES]...    e.g. hillside:1-3 cumulus:1; default: all below

Needs build/wold, Blender and POV-Ray. Prints a table: megabytes on disk without pictures, seconds
of `wold generate` and its largest memory, and each renderer's seconds and largest memory, planned
and taken. Exit status 1 when disk or memory is not within 30 %, or time not within a factor of 2.
Times count on an idle machine alone.
"""

import json
import subprocess
import sys
import tempfile
from pathlib import Path

HOME = Path(__file__).resolve().parents[2]
WOLD = HOME / "build/wold"
DEFAULT = [
    "hillside:1-3",
    "mountain:3",
    "evening:1",
    "real_slope:1",
    "first_snow:1,48",
    "cumulus:1",
    "clouds:40",
    "autumn_to_winter:1,60",
    "flight:1,20",
    "fur:1-4",
    "two_grasses:2",
    "snowy_range:1",
]
RENDERERS = ("blender", "povray")
MOST_OFF = {"disk": 1.3, "memory": 1.3, "seconds": 2.0}


def wold(*arguments):
    done = subprocess.run([WOLD, *arguments], stdout=subprocess.PIPE, text=True, check=True)
    return done.stdout


def planned_costs(plan):
    """By "disk", ("seconds", stage) and ("memory", stage); what Wold does itself is "generate"."""
    costs = {"disk": 0.0}
    for stage in plan["stages"]:
        estimate, tasks = stage["estimate"], stage["tasks"]  # each of them takes that much
        name = stage["stage"] if stage["stage"] in RENDERERS else "generate"
        if name == "generate":
            costs["disk"] += tasks * estimate["disk_bytes"] / 1e6
        seconds, memory = ("seconds", name), ("memory", name)
        costs[seconds] = costs.get(seconds, 0.0) + tasks * estimate["seconds"]
        costs[memory] = max(costs.get(memory, 0.0), estimate["memory_bytes"] / 1e6)
    return costs


def generate(options):
    """Seconds and megabytes of a process of its own."""
    measure = (
        "import resource, subprocess, sys, time; begin = time.monotonic(); "
        "subprocess.run(sys.argv[1:], check=True); "
        "print(time.monotonic() - begin, "
        "resource.getrusage(resource.RUSAGE_CHILDREN).ru_maxrss * 1024 / 1e6)"
    )
    command = [sys.executable, "-c", measure, WOLD, "generate", "--quiet", *options]
    done = subprocess.run(command, stdout=subprocess.PIPE, text=True, check=True)
    return [float(number) for number in done.stdout.split()]


def size_mb(folder):
    parts = ("texels", *RENDERERS)
    files = (path for part in parts for path in (folder / part).rglob("*") if path.is_file())
    return sum(path.stat().st_size for path in files) / 1e6


def taken_costs(out, options):
    seconds, memory_mb = generate(options)
    costs = {("seconds", "generate"): seconds, ("memory", "generate"): memory_mb}
    costs["disk"] = size_mb(out)
    wold("render", "--quiet", *options)
    for renderer in RENDERERS:
        records = [json.loads(path.read_text()) for path in out.glob(f"tasks/{renderer}_*.json")]
        costs["seconds", renderer] = sum(record["seconds"] for record in records)
        costs["memory", renderer] = max(record["memory_bytes"] for record in records) / 1e6
    return costs


def is_within(kind, planned, taken):
    ratio = planned / taken
    return 1.0 / MOST_OFF[kind] <= ratio <= MOST_OFF[kind]


def check_example(example, frames, out):
    """Prints its row; whether all is within."""
    scene = HOME / "examples" / f"{example}.toml"
    options = [scene, "--renderer", "both", "--frames", frames, "--out", out]
    planned = planned_costs(json.loads(wold("plan", "--json", *options)))
    taken = taken_costs(out, options)
    cells, all_within = [f"{example} {frames}"], True
    columns = ["disk"]
    columns += [(kind, by) for by in ("generate", *RENDERERS) for kind in ("seconds", "memory")]
    for column in columns:
        kind = column if isinstance(column, str) else column[0]
        within = is_within(kind, planned[column], taken[column])
        all_within = all_within and within
        cells.append(f"{planned[column]:.0f} {taken[column]:.0f}{'' if within else ' (!)'}")
    print("| " + " | ".join(cells) + " |", flush=True)
    return all_within


def main():
    head = ["scene, frames: planned and taken", "disk, MB"]
    head += [f"{by}, {unit}" for by in ("generate", *RENDERERS) for unit in ("s", "MB")]
    print("| " + " | ".join(head) + " |\n" + "|---" * len(head) + "|", flush=True)
    all_within = True
    for argument in sys.argv[1:] or DEFAULT:
        example, frames = argument.split(":")
        with tempfile.TemporaryDirectory() as folder:
            all_within = check_example(example, frames, Path(folder) / "out") and all_within
    return 0 if all_within else 1


if __name__ == "__main__":
    sys.exit(main())
