"""What is known from run to run, in a folder that must not be on a server: it has the secret, and the paths of files that failed."""
import contextlib
import json
import os
import secrets
import sys
import tempfile
from typing import NamedTuple

# A journal with so many lines that no longer count, and more of them than of those that do, is written again at the start of a run.
STALE_LINES = 1000


class Known(NamedTuple):
    """What became of a unit. `lines` stay JSON: as dicts they would take five times the memory, and only a catalogue reads them."""

    status: str
    made: str
    lines: bytes


class Ledger:
    """Each unit that is finished is a line, on the disk before the next batch is looked at: a run that is ended loses what it was at."""

    def __init__(self, folder, made):
        """folder: of this machine. made: says how scans are made; what was made in another way is made again."""
        self.folder, self.made = folder, made
        os.makedirs(folder, mode=0o700, exist_ok=True)
        self._lock()
        self.secret = self._read_secret()
        self.outcomes = {}
        self.series = {}
        # Scans that are no longer listed, and those of them whose folders are gone.
        self.removed, self.gone = set(), set()
        self._path = os.path.join(folder, "journal.jsonl")
        stale = self._read()
        if stale > max(STALE_LINES, len(self.outcomes) + len(self.series)):
            self._compact()
        self._file = open(self._path, "a", encoding="utf-8")
        if self._file.tell() and not self._ends_whole():
            self._file.write("\n")

    def is_finished(self, key):
        outcome = self.outcomes.get(key)
        return outcome is not None and outcome.made == self.made

    def forget_failed(self):
        """What failed is tried again in this run; what comes of it is written down then."""
        self.outcomes = {key: one for key, one in self.outcomes.items() if one.status != "failed"}

    def keep(self, outcomes):
        """Writes what became of units. outcomes: of `run_batch`."""
        for one in outcomes:
            self._take({**vars(one), "made": self.made})
            self._file.write(json.dumps({"unit": {**vars(one), "made": self.made}}) + "\n")
        self._flush()

    def keep_series(self, known):
        """known: of `find_units`: a number for each file, so that no header is read twice."""
        for (path, stamp), number in known.items():
            if self.series.get((path, stamp), "") != number:
                self._file.write(json.dumps({"file": path, "stamp": stamp, "series": number}) + "\n")
        self.series = dict(known)
        self._flush()

    def keep_removed(self, ids):
        self._keep_ids("removed", ids)

    def keep_gone(self, ids):
        self._keep_ids("gone", ids)

    def _keep_ids(self, name, ids):
        getattr(self, name).update(ids)
        self._file.write(json.dumps({name: sorted(ids)}) + "\n")
        self._flush()

    def scans(self, keys=None):
        """The lines of all scans that are in the archive, each id once. keys: of the units that count; all if None."""
        lines = {}
        for key, outcome in self.outcomes.items():
            if keys is None or key in keys:
                for line in json.loads(outcome.lines):
                    if line["status"] == "done" and line["id"] not in self.removed:
                        lines[line["id"]] = line
        return list(lines.values())

    def write_quarantine(self, units):
        """The table of what failed, for the person who has the files. units: a dict from keys to units."""
        rows = []
        for key, unit in units.items():
            outcome = self.outcomes.get(key)
            if outcome and outcome.status == "failed":
                codes = sorted({line["code"] for line in json.loads(outcome.lines) if line["status"] == "failed"})
                rows.append("\t".join([",".join(codes), unit.files[0], str(len(unit.files))]))
        write_whole(os.path.join(self.folder, "quarantine.tsv"), "".join(f"{row}\n" for row in rows))

    def close(self):
        self._file.close()
        os.unlink(os.path.join(self.folder, "lock"))

    def _flush(self):
        self._file.flush()
        os.fsync(self._file.fileno())

    def _ends_whole(self):
        with open(self._path, "rb") as file:
            file.seek(-1, os.SEEK_END)
            return file.read() == b"\n"

    def _take(self, unit):
        # Of a million units most have the same few words.
        status, made = sys.intern(unit["status"]), sys.intern(unit["made"])
        self.outcomes[unit["key"]] = Known(status, made, json.dumps(unit["lines"], separators=(",", ":")).encode())

    def _compact(self):
        """Writes the journal with what counts alone, as a whole."""
        with whole_file(self._path) as file:
            for key, (status, made, lines) in self.outcomes.items():
                file.write(json.dumps({"unit": {"key": key, "status": status, "made": made, "lines": json.loads(lines)}}) + "\n")
            for (path, stamp), number in self.series.items():
                file.write(json.dumps({"file": path, "stamp": stamp, "series": number}) + "\n")
            file.write(json.dumps({"removed": sorted(self.removed), "gone": sorted(self.gone)}) + "\n")

    def _read(self):
        """Returns how many lines no longer count: others for the same unit or file came later."""
        count = 0
        if not os.path.exists(self._path):
            return count
        with open(self._path, encoding="utf-8", errors="replace") as file:
            for text in file:
                count += 1
                try:
                    line = json.loads(text)
                except ValueError:
                    continue  # The end of a run that was killed.
                if "unit" in line:
                    self._take(line["unit"])
                elif "file" in line:
                    self.series[(line["file"], line["stamp"])] = line["series"]
                else:
                    self.removed.update(line.get("removed", ()))
                    self.gone.update(line.get("gone", ()))
        return count - len(self.outcomes) - len(self.series)

    def _read_secret(self):
        path = os.path.join(self.folder, "secret")
        if not os.path.exists(path):
            write_whole(path, secrets.token_hex(32), 0o600)
        with open(path) as file:
            return file.read()

    def _lock(self):
        path = os.path.join(self.folder, "lock")
        try:
            with open(path) as file:
                other = int(file.read() or 0)
        except (FileNotFoundError, ValueError):
            other = 0
        if other and other != os.getpid() and _is_alive(other):
            raise SystemExit(f"another run (process {other}) writes this archive; wait for its end")
        with open(path, "w") as file:
            file.write(str(os.getpid()))


def _is_alive(process):
    try:
        os.kill(process, 0)
    except ProcessLookupError:
        return False
    except PermissionError:
        pass
    return True


@contextlib.contextmanager
def whole_file(path, mode=0o644):
    """A text file that has its name when all of it is on the disk; nothing is left where an error ends it."""
    handle, beside = tempfile.mkstemp(dir=os.path.dirname(path))
    try:
        with os.fdopen(handle, "w", encoding="utf-8") as file:
            yield file
            file.flush()
            os.fsync(file.fileno())
        os.chmod(beside, mode)
        os.replace(beside, path)
    except BaseException:
        os.unlink(beside)
        raise


def write_whole(path, text, mode=0o644):
    with whole_file(path, mode) as file:
        file.write(text)
