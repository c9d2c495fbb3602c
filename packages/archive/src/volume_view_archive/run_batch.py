"""One task of a worker: it brings the files of some units to its disk, runs the command over them, and puts what came out into the archive."""
import ctypes
import errno
import json
import os
import re
import resource
import shutil
import signal
import subprocess
import tempfile
import time
from dataclasses import dataclass, field

from .find_units import names_of

WORK_PREFIX = "volume-view-archive-"

# Failures that say nothing about the file: memory, time, or a file that could not be fetched.
MAY_PASS = {"format/too-large", "source/not-found", "source/unavailable", "site/not-writable", "batch/failed"}


class NoSpace(Exception):
    """The disk of the worker or of the archive is full. It carries no path."""


@dataclass(frozen=True)
class Job:
    """What all batches have in common. Seconds, bytes; `secret` makes ids, so that equal files have equal ids in all batches."""

    source: object
    target: object
    command: tuple
    options: tuple
    secret: str
    timeout: int
    folder: str | None = None


@dataclass
class Outcome:
    """What became of a unit. `lines` are those of the command: numbers and words of the program, no name of a file."""

    key: str
    status: str  # done, failed, none
    lines: list = field(default_factory=list)
    bytes_in: int = 0
    bytes_out: int = 0


@dataclass
class BatchResult:
    """problem: why the batch as a whole has no outcomes, in words without a path; `is_full` where that is a full disk."""

    outcomes: list = field(default_factory=list)
    seconds: float = 0.0
    command_seconds: float = 0.0
    peak_bytes: int = 0
    problem: str = ""
    is_full: bool = False


class BatchProblem(Exception):
    """The command ended without an answer. Its words have no path."""


def run_batch(job, units):
    """Makes the volumes of units. What goes wrong is a part of the result: the log of a worker would have an exception."""
    began = time.perf_counter()
    _remove_left(job.folder)
    _wait_for_memory(max(unit.size for unit in units))
    # The name says whose it is: what a worker that was killed has left is removed by the next one.
    work = tempfile.mkdtemp(prefix=f"{WORK_PREFIX}{os.getpid()}-", dir=job.folder)
    try:
        return _run(job, units, work, began)
    except NoSpace as error:
        return BatchResult(problem=str(error), is_full=True)
    except BatchProblem as error:
        return BatchResult(problem=str(error))
    except Exception as error:
        is_full = is_no_space(error)
        words = "no space is left on the disk of a worker or of the archive" if is_full else f"a batch failed ({type(error).__name__})"
        return BatchResult(problem=words, is_full=is_full)
    finally:
        shutil.rmtree(work, ignore_errors=True)


def is_no_space(error):
    return isinstance(error, OSError) and error.errno in (errno.ENOSPC, errno.EDQUOT)


def _run(job, units, work, began):
    outcomes = {unit.key: Outcome(unit.key, "none", bytes_in=unit.size) for unit in units}
    for number, unit in enumerate(units):
        for path, name in zip(unit.files, names_of(unit)):
            try:
                job.source.fetch(path, f"{work}/in/{number}/{name}")
            except FileNotFoundError:
                outcomes[unit.key].lines = [_failed("source/not-found", "a file is gone since it was listed")]
                outcomes[unit.key].status = "failed"
                shutil.rmtree(f"{work}/in/{number}", ignore_errors=True)
                break
    os.makedirs(f"{work}/in", exist_ok=True)
    started = time.perf_counter()
    lines = _run_command(job, work)
    command_seconds = time.perf_counter() - started
    for number, line in lines:
        outcome = outcomes[units[number].key]
        if line["status"] == "done":
            line, size = _deliver(job.target, work, line)
            outcome.bytes_out += size
        outcome.lines.append(line)
    for outcome in outcomes.values():
        if outcome.lines:
            is_done = all(line["status"] == "done" for line in outcome.lines)
            outcome.status = "done" if is_done else "failed"
    return BatchResult(list(outcomes.values()), time.perf_counter() - began, command_seconds, _peak_bytes())


def _run_command(job, work):
    """The lines of the command, each with the number of its unit."""
    os.makedirs(f"{work}/site.private")
    with open(f"{work}/site.private/salt", "w") as file:
        file.write(job.secret)
    command = [*job.command, f"{work}/in", "--out", f"{work}/site", "--jobs", "1", *_memory_of_worker(), *job.options]
    with open(f"{work}/said", "w+") as said, open(f"{work}/lines", "w+") as written:
        process = subprocess.Popen(command, stdin=subprocess.DEVNULL, stdout=written, stderr=said, preexec_fn=_end_with_parent)
        try:
            status = process.wait(timeout=job.timeout)
        except subprocess.TimeoutExpired:
            process.kill()
            process.wait()
            raise BatchProblem("volume-view-prepare took too long") from None
        said.seek(0)
        words = said.read()
        if re.search("ENOSPC|EDQUOT", words):
            raise NoSpace("no space is left on the disk of a worker")
        if status not in (0, 2):
            # Its words may have a path.
            raise BatchProblem(f"volume-view-prepare ended with status {status}")
        written.seek(0)
        lines = [json.loads(line) for line in written if line.strip()]
    if any(line.get("code") == "site/not-writable" for line in lines):
        raise NoSpace("no space is left on the disk of a worker")
    with open(f"{work}/site.private/scans.tsv", encoding="utf-8") as table:
        unit_of = {int(row.split("\t")[0]): int(row.split("\t")[3].split("/")[0]) for row in table if row.strip()}
    return [(unit_of[line.pop("source")], line) for line in lines]


def _deliver(target, work, line):
    """Puts the folder of a volume, and of its series, into the archive. Returns the line for the catalogue, and bytes."""
    size = 0
    for name in {line["id"], *([line["scans"].split("/")[0]] if "scans" in line else [])}:
        folder = f"{work}/site/{name}"
        size += sum(os.path.getsize(f"{folder}/{one}") for one in os.listdir(folder))
        target.take_folder(folder, name)
    manifest = f"{work}/site/{line['id']}/volume.json"
    if os.path.exists(manifest):
        with open(manifest, encoding="utf-8") as file:
            said = json.load(file)
        radar = said.get("site")
        if radar and "moment" in said:
            line["radar"] = {**radar, "moment": said["moment"]}
    line["poster"] = os.path.exists(f"{work}/site/{line['id']}/poster.png")
    return line, size


def _failed(code, message):
    return {"status": "failed", "code": code, "message": message}


def _end_with_parent():
    """On Linux the command ends when its worker does, however that ends (PR_SET_PDEATHSIG)."""
    try:
        ctypes.CDLL(None).prctl(1, signal.SIGKILL)
    except (OSError, AttributeError):
        pass


def _remove_left(folder):
    """Removes what workers of this machine have left that no longer run."""
    root = folder or tempfile.gettempdir()
    for name in os.listdir(root):
        match = re.match(WORK_PREFIX + r"(\d+)-", name)
        if match and not os.path.exists(f"/proc/{match[1]}") and os.path.isdir("/proc/self"):
            shutil.rmtree(os.path.join(root, name), ignore_errors=True)


# A volume takes up to so many times the bytes of its files, which may be packed.
MEMORY_FACTOR = 8
MEMORY_FLOOR = 400 * 2**20
LONGEST_WAIT = 600


def _wait_for_memory(size):
    """Waits until the machine has memory for the largest unit. After ten minutes it goes on: its command says what it lacks."""
    import psutil

    wanted = min(MEMORY_FLOOR + MEMORY_FACTOR * size, psutil.virtual_memory().total // 2)
    until = time.monotonic() + LONGEST_WAIT
    while psutil.virtual_memory().available < wanted and time.monotonic() < until:
        time.sleep(0.5)


def _memory_of_worker():
    """The command takes no more than its worker may; else workers of one machine would each count on all of it."""
    from distributed import get_worker

    try:
        limit = get_worker().memory_manager.memory_limit
    except (ValueError, AttributeError):
        return []
    return ["--memory", str(max(1, limit // 10**6))] if limit else []


def _peak_bytes():
    """Of the worker, or of the largest of its commands so far."""
    return 1024 * max(resource.getrusage(who).ru_maxrss for who in (resource.RUSAGE_SELF, resource.RUSAGE_CHILDREN))
