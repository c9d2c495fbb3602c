"""What the ledger holds in memory, and how its journal stays small."""
import gc
import os
import pathlib
import shutil
import tempfile
import tracemalloc
import unittest

from volume_view_archive.ledger import STALE_LINES, Ledger
from volume_view_archive.run_batch import Outcome


def line_of(number):
    """A line as the command prints it."""
    place = f"{number:016x}"
    words = {"status": "done", "id": place, "title": f"Scan {number:08x}", "form": "mosaic", "page": f"{place}/index.html"}
    numbers = {"dimensions": [4, 3, 2], "bits": 16, "bytes": 140 + number, "error": {"max": 0, "rms": 0}}
    return {**words, "format": "NIfTI-1", "unit": "", **numbers}


def outcomes(numbers):
    return [Outcome(f"{number:032x}", "done", [line_of(number)], 400, 500) for number in numbers]


class LedgerTest(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.mkdtemp()
        self.addCleanup(shutil.rmtree, self.folder)

    def lines(self):
        return pathlib.Path(self.folder, "journal.jsonl").read_text().splitlines()

    def test_memory_of_a_scan(self):
        count = 2000
        ledger = Ledger(self.folder, "made")
        tracemalloc.start()
        self.addCleanup(tracemalloc.stop)
        for start in range(0, count, 50):
            ledger.keep(outcomes(range(start, start + 50)))
        gc.collect()
        # Nested dicts took 2,200.
        self.assertLess(tracemalloc.get_traced_memory()[0] / count, 800)
        self.assertEqual([line["bytes"] for line in ledger.scans()], [140 + number for number in range(count)])
        ledger.close()

    def test_a_journal_with_stale_lines_is_written_again(self):
        ledger = Ledger(self.folder, "old")
        ledger.keep_series({("a.dcm", "1 2"): "7", ("b.nii", "3 4"): None})
        for _ in range(30):
            ledger.keep(outcomes(range(50)))
        ledger.keep_removed({"0" * 16})
        ledger.keep([Outcome("x", "failed", [{"status": "failed", "code": "format/corrupt", "message": "words"}])])
        ledger.keep_gone({"0" * 16})
        before = (ledger.outcomes, ledger.series, ledger.removed, ledger.gone)
        ledger.close()
        self.assertGreater(len(self.lines()), STALE_LINES + 50)
        for _ in range(2):
            again = Ledger(self.folder, "new")
            self.assertEqual((again.outcomes, again.series, again.removed, again.gone), before)
            self.assertFalse(again.is_finished(f"{1:032x}"))
            self.assertEqual(len(again.scans()), 49)
            again.close()
            # 51 units, two files, and what was removed.
            self.assertEqual(len(self.lines()), 54)
        self.assertEqual(sorted(os.listdir(self.folder)), ["journal.jsonl", "secret"])

    def test_a_short_journal_stays(self):
        ledger = Ledger(self.folder, "made")
        for _ in range(5):
            ledger.keep(outcomes(range(50)))
        ledger.close()
        Ledger(self.folder, "made").close()
        self.assertEqual(len(self.lines()), 250)


if __name__ == "__main__":
    unittest.main()
