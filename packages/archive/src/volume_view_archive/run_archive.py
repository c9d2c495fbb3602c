"""The run: finds what is not finished, keeps the cluster busy with batches, and writes down each batch that comes back."""
import time
from collections import Counter
from dataclasses import dataclass, field

from .find_units import find_units
from .run_batch import MAY_PASS, BatchResult, NoSpace, Outcome, run_batch

# So many batches wait for each worker: more would take memory of the scheduler, fewer would let workers wait.
IN_FLIGHT = 2
SECONDS_BETWEEN_COUNTS = 5


@dataclass
class Totals:
    """Numbers of a run, for its report."""

    units: int = 0
    unchanged: int = 0
    done: int = 0
    failed: int = 0
    none: int = 0
    retried: int = 0
    scans: int = 0
    bytes_in: int = 0
    bytes_out: int = 0
    codes: Counter = field(default_factory=Counter)
    seconds: float = 0.0
    worker_seconds: float = 0.0
    command_seconds: float = 0.0
    peak_bytes: int = 0
    workers: int = 0


@dataclass(frozen=True)
class Plan:
    """How units become tasks. retries: of a unit alone, after its batch was lost or it failed for want of something."""

    batch: int = 50
    retries: int = 2
    batch_bytes: int = 2**31


def divide(units, plan):
    """Batches of so many units, and not of many more bytes than `batch_bytes`: a worker holds a batch on its disk."""
    batch, size = [], 0
    for unit in units:
        if batch and (len(batch) == plan.batch or size + unit.size > plan.batch_bytes):
            yield batch
            batch, size = [], 0
        batch.append(unit)
        size += unit.size
    if batch:
        yield batch


def run_archive(client, job, ledger, plan, say, entries=None):
    """Does all units of the source that the ledger does not know. Returns totals, and all units by their keys.

    say: takes words for a person, without names. entries: of the source, if they are listed already.
    @raises NoSpace after what had come back was written down
    """
    began = time.perf_counter()
    known = dict(ledger.series)
    units = {unit.key: unit for unit in find_units(job.source, job.source.list() if entries is None else entries, ledger.secret, known, client)}
    ledger.keep_series(known)
    waiting = [unit for key, unit in units.items() if not ledger.is_finished(key)]
    totals = Totals(units=len(units), unchanged=len(units) - len(waiting))
    try:
        if waiting:
            # Jobs of Slurm may begin late.
            client.wait_for_workers(1)
        _run_all(client, job, ledger, plan, say, waiting, totals)
    finally:
        totals.seconds = time.perf_counter() - began
    # All tasks have come back, so nobody writes: what is left is of workers that were killed.
    job.target.remove_unfinished()
    return totals, units


def _run_all(client, job, ledger, plan, say, waiting, totals):
    from distributed import as_completed

    batches = divide(waiting, plan)
    tries = Counter()
    flying = {}
    queue = as_completed()

    def submit(batch):
        # Where a worker dies, Dask itself gives its task to another one; allowed-failures limits that.
        future = client.submit(run_batch, job, batch, pure=False)
        flying[future] = batch
        queue.add(future)

    looked = float("-inf")

    def fill():
        nonlocal looked
        if time.monotonic() - looked > SECONDS_BETWEEN_COUNTS:
            looked = time.monotonic()
            # They come and go: the report says how many there were at most.
            totals.workers = max(totals.workers, len(client.scheduler_info(n_workers=-1)["workers"]))
        while len(flying) < IN_FLIGHT * max(1, totals.workers):
            batch = next(batches, None)
            if batch is None:
                return
            submit(batch)

    fill()
    full = None
    for future in queue:
        batch = flying.pop(future)
        outcomes, again = _settle(future, batch, tries, plan, totals)
        future.release()
        if isinstance(outcomes, NoSpace):
            full = outcomes
        elif outcomes:
            ledger.keep(outcomes)
        if full:
            # What is under way may still end well; nothing new begins.
            continue
        totals.retried += len(again)
        for unit in again:
            submit([unit])
        fill()
        seen = totals.done + totals.failed + totals.none
        say(f"{seen} of {totals.units - totals.unchanged} read, {totals.failed} failed")
    if full:
        raise full


def _settle(future, batch, tries, plan, totals):
    """What a batch that came back means: outcomes to be kept, and units that are tried again, alone."""
    result = future.result() if future.status == "finished" else BatchResult(problem=_describe(future.exception()))
    if result.is_full:
        return NoSpace(result.problem), []
    totals.worker_seconds += result.seconds
    totals.command_seconds += result.command_seconds
    totals.peak_bytes = max(totals.peak_bytes, result.peak_bytes)
    results = result.outcomes
    if result.problem:
        failure = {"status": "failed", "code": "batch/failed", "message": result.problem}
        results = [Outcome(unit.key, "failed", [failure], unit.size) for unit in batch]
    units = {unit.key: unit for unit in batch}
    kept, again = [], []
    for outcome in results:
        may_pass = any(line.get("code") in MAY_PASS for line in outcome.lines)
        if outcome.status == "failed" and may_pass and tries[outcome.key] < plan.retries:
            tries[outcome.key] += 1
            again.append(units[outcome.key])
        else:
            kept.append(outcome)
            _count(outcome, totals)
    return kept, again


def _describe(error):
    """Words of the program: those of an error of Python may have a path."""
    if type(error).__name__ == "KilledWorker":
        return "the process that read it has ended again and again, mostly because it lacked memory"
    return f"a batch failed ({type(error).__name__})"


def _count(outcome, totals):
    setattr(totals, outcome.status, getattr(totals, outcome.status) + 1)
    totals.bytes_in += outcome.bytes_in
    totals.bytes_out += outcome.bytes_out
    totals.scans += sum(line["status"] == "done" for line in outcome.lines)
    totals.codes.update(line["code"] for line in outcome.lines if line["status"] == "failed")
