#!/usr/bin/env python3
"""Renders a film on a cluster that runs Slurm: asks `wold plan` for the stages and submits a job
array for each, with dependencies. Run the same command again to go on: tasks that have been done
end at once.

    submit.py moor.toml --out /shared/moor --frames 1-96 --set grass.blades=300

Everything but the options below goes to `wold`; the scene and DIR have to be on a file system that
all nodes share. SBATCH_PARTITION, SBATCH_ACCOUNT and the like choose where jobs run; a job uses the
processors it is given.
"""

from __future__ import annotations

import argparse
import json
import pathlib
import shutil
import subprocess
import sys
from typing import Any

here = pathlib.Path(__file__).resolve().parent


def parse_arguments() -> tuple[argparse.Namespace, list[str]]:
    """This program's own arguments, and those for `wold`."""
    parser = argparse.ArgumentParser(
        description=__doc__,
        allow_abbrev=False,
        formatter_class=argparse.RawDescriptionHelpFormatter,
    )
    parser.add_argument("scene", help="the scene file")
    parser.add_argument(
        "--out", required=True, metavar="DIR", help="the output folder, shared by all nodes"
    )
    parser.add_argument(
        "--group",
        type=int,
        default=1,
        metavar="N",
        help="frames a job does one after the other; 30 s of work or more pay",
    )
    parser.add_argument(
        "--sbatch",
        action="append",
        default=[],
        metavar="STAGE=OPTION",
        help="an option of sbatch for one stage, such as blender=--mem=4G; may be repeated",
    )
    parser.add_argument(
        "--keep",
        choices=["all", "scenes", "pictures"],
        default="all",
        help="what stays when all is done, as of `wold render`",
    )
    parser.add_argument(
        "--wold",
        default=find_wold(),
        metavar="PROGRAM",
        help="wold, at the same place on all nodes",
    )
    return parser.parse_known_args()


def find_wold() -> str | None:
    beside = [here / "../../build/wold", here / "../../../../bin/wold"]  # built, installed
    return next(
        (str(program.resolve()) for program in beside if program.exists()), shutil.which("wold")
    )


def output_of(*command: str | pathlib.Path) -> str:
    """What a program writes. Ends this one with the other's exit code when that fails."""
    result = subprocess.run(command, stdout=subprocess.PIPE, text=True)
    if result.returncode != 0:
        sys.exit(result.returncode)
    return result.stdout


def numbers(ranges: str) -> list[int]:
    """The numbers of a list of ranges: "1-3,7" is [1, 2, 3, 7]."""
    result: list[int] = []
    for item in ranges.split(","):
        first, _, last = item.partition("-")
        result += range(int(first), int(last or first) + 1)
    return result


def largest_array() -> int:
    """How many elements an array may have here; Slurm's default when the cluster does not say."""
    for line in output_of("scontrol", "show", "config").splitlines():
        key, _, value = line.partition("=")
        if key.strip() == "MaxArraySize":
            return int(value)
    return 1001


class Submission:
    """Submits the jobs of one film."""

    def __init__(self, arguments: argparse.Namespace, options: list[str]) -> None:
        self.arguments = arguments
        self.out = pathlib.Path(arguments.out).resolve()
        self.command = [
            arguments.wold,
            "task",
            str(pathlib.Path(arguments.scene).resolve()),
            "--out",
            str(self.out),
            *options,
        ]
        self.logs = self.out / "logs" / "slurm"
        self.logs.mkdir(parents=True, exist_ok=True)

    def submit(
        self, name: str, dependencies: list[str], *command: str, array: str | None = None
    ) -> str:
        """The new job's id. %A, %a: those of the array and of its element."""
        options = [
            "--parsable",
            f"--job-name=wold-{name}",
            f"--chdir={pathlib.Path.cwd()}",
            f"--output={self.logs}/{name}_%A_%a.log",
        ]
        if dependencies:
            options.append("--dependency=" + ",".join(dependencies))
        if array:
            options.append("--array=" + array)
        chosen = (text.partition("=") for text in self.arguments.sbatch)
        options += [option for stage, _, option in chosen if stage == name]
        job = output_of("sbatch", *options, here / "stage.sbatch", *command)
        return job.strip().partition(";")[0]  # a cluster's name may follow

    def submit_stage(self, stage: dict[str, Any], jobs: dict[str, str]) -> str:
        """Submits a stage of the plan. `jobs` are the ids of earlier stages. Returns the new id."""
        indices = numbers(stage["indices"])
        # Element e does the indices n with (n - 1) / group = e, so that those of two stages match.
        group = max(self.arguments.group, -(-indices[-1] // (largest_array() - 1)))
        elements = sorted({(index - 1) // group for index in indices})
        dependencies = []
        if stage["after"]:
            kind = "afterok" if stage["after"]["tasks"] == "all" else "aftercorr"
            dependencies = [f"{kind}:{jobs[stage['after']['stage']]}"]
        return self.submit(
            stage["stage"],
            dependencies,
            str(group),
            stage["indices"],
            stage["stage"],
            *self.command,
            array=",".join(map(str, elements)),
        )


def main() -> None:
    arguments, options = parse_arguments()
    if not arguments.wold:
        sys.exit(
            "error: wold is neither beside this script nor on the PATH; expected it there, or"
            " --wold PROGRAM"
        )
    question = [arguments.wold, "plan", arguments.scene, "--json", "--out", arguments.out]
    question += ["--keep", arguments.keep]
    plan = json.loads(output_of(*question, *options))
    submission = Submission(arguments, options)
    jobs: dict[str, str] = {}
    for stage in plan["stages"]:
        jobs[stage["stage"]] = submission.submit_stage(stage, jobs)
    # Finds all there and writes manifest.json.
    last = ["afterok:" + ":".join(jobs.values())]
    render = [word if word != "task" else "render" for word in submission.command]
    render += ["--keep", arguments.keep]
    jobs["manifest"] = submission.submit("manifest", last, "1", "1", "render", *render)
    for name, job in jobs.items():
        print(name, job)


if __name__ == "__main__":
    main()
