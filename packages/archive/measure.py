"""Runs the archive over many small scans, and prints a table: what it takes besides the work, and what grows with their number.

    pip install -e '.[test]'
    python measure.py --scans 10000 --broken 0.01 --kills 5

The scans are NIfTI files of a few voxels, so that the time is that of the archive and of starting the command, not of reading large volumes.
"""
import argparse
import json
import os
import pathlib
import random
import shutil
import signal
import subprocess
import sys
import tempfile
import threading
import time

HERE = pathlib.Path(__file__).parent
sys.path.insert(0, str(HERE / "tests"))

from helpers import COMMAND, catalogue_of, children_of, command_of, scans_in, write_nifti  # noqa: E402


# The driver's memory is noted when so many units are written down.
MARKS = (500, 1000, 2000, 5000, 10000, 20000, 50000, 100000)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--scans", type=int, default=1000)
    parser.add_argument("--broken", type=float, default=0.01, help="share of files that are cut short")
    parser.add_argument("--kills", type=int, default=0, help="so many times a worker is killed")
    parser.add_argument("--workers", type=int, default=2)
    parser.add_argument("--batch", type=int, default=50)
    args = parser.parse_args()
    work = pathlib.Path(tempfile.mkdtemp(prefix="measure-archive-"))
    try:
        measure(args, work)
    finally:
        shutil.rmtree(work)


def measure(args, work):
    drawn = random.Random(1)
    broken = {i for i in range(args.scans) if drawn.random() < args.broken}
    for i in range(args.scans):
        path = work / "in" / f"{i // 1000}" / f"{i}.nii"
        write_nifti(path, i % 30000, 400 if i in broken else None)
        if i >= 30000 and i not in broken:
            with path.open("r+b") as file:
                file.seek(354)
                file.write((i // 30000).to_bytes(2, "little"))
    first = run(args, work, args.kills)
    second = run(args, work, 0)
    ids = scans_in(work / "site")
    listed = [one["id"] for one in catalogue_of(work / "site")]
    table = (work / "site.private/quarantine.tsv").read_text().splitlines()
    expected = args.scans - len(broken)
    print("| | first run | second run |\n| --- | --- | --- |")
    for name, of in ROWS.items():
        print(f"| {name} | {of(first)} | {of(second)} |")
    lost, twice = expected - len(ids), len(listed) - len(set(listed))
    print(f"\nexpected {expected} scans: {lost} lost, {twice} twice in the catalogue; {len(table)} of {len(broken)} broken files listed; {first['killed']} workers killed")


ROWS = {
    "units, done, failed": lambda one: f"{one['units']['all']}, {one['units']['done']}, {one['units']['failed']}",
    "seconds of the whole command": lambda one: f"{one['all']:.1f}",
    "processor seconds of the whole command": lambda one: f"{one['cpu']:.1f}",
    "units a second": lambda one: one["unitsPerSecond"],
    "worker seconds a unit in the command, ms": lambda one: f"{1000 * one['workerSeconds']['ofTheCommand'] / max(1, one['units']['done']):.1f}",
    "worker seconds a unit besides it, ms": lambda one: f"{1000 * (one['workerSeconds']['all'] - one['workerSeconds']['ofTheCommand']) / max(1, one['units']['done']):.1f}",
    "memory of the driver at so many units written down, MB": lambda one: ", ".join(f"{units}: {size / 1e6:.1f}" for units, size in one["driver"].items()),
    "largest process of a worker, MB": lambda one: f"{one['peakBytesOfAProcess'] / 1e6:.0f}",
}


def run(args, work, kills):
    command = [sys.executable, "-m", "volume_view_archive", str(work / "in"), "--out", str(work / "site"), "--tmp", str(work), "--prepare", COMMAND]
    command += ["--workers", str(args.workers), "--batch", str(args.batch), "--", "--poster", "0"]
    began, before = time.monotonic(), os.times()
    driver, size, seconds, killed = {}, 0, 0, 0
    process = subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True, env={**os.environ, "PYTHONPATH": str(HERE / "src")})
    answer = []
    reader = threading.Thread(target=lambda: answer.append(process.stdout.read()))
    reader.start()
    while process.poll() is None:
        time.sleep(1)
        seconds += 1
        size = resident(process.pid) or size
        done = units_in(work)
        driver.update({f"{mark:,}": size for mark in MARKS if mark <= done and f"{mark:,}" not in driver})
        if killed < kills and seconds % 15 == 0:
            killed += kill_worker(process.pid)
    reader.join()
    after = os.times()
    cpu = after.children_user + after.children_system - before.children_user - before.children_system
    # The catalogue, which is written last, takes more.
    driver["the end"] = size
    return {**json.loads(answer[0]), "all": time.monotonic() - began, "cpu": cpu, "driver": driver, "killed": killed}


def units_in(work):
    """The number of units that the run has written down."""
    try:
        with (work / "site.private/journal.jsonl").open("rb") as file:
            return sum(line.startswith(b'{"unit"') for line in file)
    except OSError:
        return 0


def resident(process):
    try:
        return 4096 * int(pathlib.Path(f"/proc/{process}/statm").read_text().split()[1])
    except (OSError, IndexError):
        return 0


def kill_worker(driver):
    """Kills a process of the cluster that runs the command. Returns how many."""
    for child in children_of(driver):
        if any("volume-view-prepare" in command_of(one) for one in children_of(child)):
            os.kill(child, signal.SIGKILL)
            return 1
    return 0


if __name__ == "__main__":
    main()
