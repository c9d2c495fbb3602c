"""A rolling archive: takes new files as they come, and lets the oldest scans go."""
import time

from .catalogue import write_catalogue
from .run_archive import run_archive
from .run_batch import NoSpace


class Settled:
    """Which files are whole: those that have stayed as they are. It goes by what it has seen, not by the clock of a file server."""

    def __init__(self, seconds):
        self.seconds = seconds
        self.seen = {}

    def take(self, entries, now):
        """entries: of `Place.list`. now: seconds of a clock that never goes back."""
        before, self.seen = self.seen, {}
        for one in entries:
            since, stamp = before.get(one.path, (now, one.stamp))
            self.seen[one.path] = (since if stamp == one.stamp else now, one.stamp)
        return [one for one in entries if now - self.seen[one.path][0] >= self.seconds]


def watch_archive(client, job, ledger, plan, stop, say, every, settle, keep):
    """Runs until `stop` is set. every, settle: seconds. keep: so many scans, all if None.

    A DICOM series is taken when none of its files has changed for that time; one that grows later is taken again, as another scan.
    """
    settled = Settled(settle)
    seen = {}
    problem = None
    _remove_folders(job.target, ledger)
    while not stop.is_set():
        try:
            entries = settled.take(job.source.list(), time.monotonic())
            state = {one.path: one.stamp for one in entries}
            if state != seen:
                totals, units = run_archive(client, job, ledger, plan, lambda words: None, entries)
                ledger.write_quarantine(units)
                if totals.done or totals.failed:
                    # Scans whose files are gone stay: what the archive keeps is for `keep` to say.
                    _let_go(job.target, ledger, keep)
                    write_catalogue(job.target, ledger.scans())
                    say(f"{totals.scans} scans made, {totals.failed} failed")
                seen = state
            problem = None
        except NoSpace as error:
            problem = _say_once(say, f"{error}; it is tried again", problem)
        except OSError as error:
            problem = _say_once(say, f"the folder or the archive can not be used now ({type(error).__name__}); it is tried again", problem)
        stop.wait(every)


def _let_go(target, ledger, keep):
    if keep is None:
        return
    lines = sorted(ledger.scans(), key=lambda line: (line.get("time", ""), line["id"]))
    old = lines[: max(0, len(lines) - keep)]
    if old:
        # First they leave the list, so that a run that is ended here does not list what is gone.
        ledger.keep_removed([line["id"] for line in old])
        write_catalogue(target, ledger.scans())
        _remove_folders(target, ledger)


def _remove_folders(target, ledger):
    ids = sorted(ledger.removed - ledger.gone)
    for name in ids:
        target.remove(name)
    if ids:
        ledger.keep_gone(ids)


def _say_once(say, words, before):
    if words != before:
        say(words)
    return words
