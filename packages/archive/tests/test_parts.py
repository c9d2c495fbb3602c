"""The parts of the archive, without a cluster."""
import json
import pathlib
import tempfile
import time
import unittest
from unittest import mock

from volume_view_archive.catalogue import write_catalogue
from volume_view_archive.cli import copy_script
from volume_view_archive.find_units import Unit, find_units, names_of
from volume_view_archive.ledger import Ledger
from volume_view_archive.places import Entry, Place
from volume_view_archive.run_archive import Plan, divide
from volume_view_archive.run_batch import Outcome
from volume_view_archive.watch_archive import Settled

from helpers import write_nifti, write_series


class Folder(unittest.TestCase):
    def setUp(self):
        self.work = tempfile.TemporaryDirectory()
        self.addCleanup(self.work.cleanup)
        self.folder = pathlib.Path(self.work.name)


class FindUnits(Folder):
    def units(self, known=None):
        place = Place(str(self.folder))
        return find_units(place, place.list(), "secret", {} if known is None else known)

    def test_series_are_found_by_headers_wherever_their_files_lie(self):
        write_series(self.folder, "1.2.3.98765.10", 6, 100)
        write_series(self.folder, "1.2.3.98765.11", 4, 900)
        write_nifti(self.folder / "a/head.nii", 1)
        units = self.units()
        self.assertEqual(sorted((len(one.files), one.is_series) for one in units), [(1, False), (4, True), (6, True)])
        series = next(one for one in units if len(one.files) == 6)
        self.assertEqual({path.split("/")[0] for path in series.files}, {"a", "b"})
        self.assertEqual(names_of(series)[:2], ["000000.dcm", "000001.dcm"])

    def test_a_header_and_its_data_are_a_unit_and_a_sidecar_is_none(self):
        for name in ("v.hdr", "v.img", "w.nhdr", "w.raw.gz", "x+orig.HEAD", "x+orig.BRIK", "y.nii", "y.json", "z.mha", ".hidden", "p.h5.part"):
            (self.folder / name).write_bytes(b"x" * 200)
        files = sorted(one.files for one in self.units())
        self.assertEqual(files, [("v.hdr", "v.img"), ("w.nhdr", "w.raw.gz"), ("x+orig.BRIK", "x+orig.HEAD"), ("y.json",), ("y.nii",), ("z.mha",)])

    def test_a_header_is_not_read_twice_and_a_key_changes_with_a_file(self):
        write_series(self.folder, "1.2.3.98765.10", 3, 100)
        known = {}
        before = self.units(known)
        with mock.patch("volume_view_archive.find_units.read_series", side_effect=AssertionError):
            self.assertEqual(self.units(known), before)
        write_series(self.folder, "1.2.3.98765.10", 4, 100)
        self.assertNotEqual(self.units()[0].key, before[0].key)


class Batches(unittest.TestCase):
    def test_batches_have_so_many_units_and_not_many_more_bytes(self):
        units = [Unit(str(i), (str(i),), size, False) for i, size in enumerate([1, 1, 1, 50, 1, 200, 1])]
        sizes = [[one.size for one in batch] for batch in divide(units, Plan(batch=3, batch_bytes=100))]
        self.assertEqual(sizes, [[1, 1, 1], [50, 1], [200], [1]])


class PlayerTest(Folder):
    def test_the_script_comes_with_its_parts_and_once(self):
        for name in ("classic/1.js", "x3dom.js", "volume-view.iife.js", "other.js"):
            path = self.folder / "dist" / name
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_text(name)
        site = self.folder / "site"
        copy_script(Place(str(site)), str(self.folder / "dist"))
        self.assertEqual({str(one.relative_to(site)) for one in site.rglob("*.js")}, {"classic/1.js", "x3dom.js", "volume-view.iife.js"})
        (site / "x3dom.js").unlink()
        copy_script(Place(str(site)), str(self.folder / "dist"))
        self.assertFalse((site / "x3dom.js").exists(), "the same script is not copied again")


class LedgerTest(Folder):
    def test_a_line_that_was_cut_loses_itself_alone(self):
        ledger = Ledger(str(self.folder / "private"), "v1")
        ledger.keep([Outcome("a", "done", [{"status": "done", "id": "1"}])])
        ledger.close()
        path = self.folder / "private/journal.jsonl"
        path.write_text(path.read_text() + '{"unit": {"key": "b", "sta')
        ledger = Ledger(str(self.folder / "private"), "v1")
        self.assertTrue(ledger.is_finished("a") and not ledger.is_finished("b"))
        ledger.keep([Outcome("c", "done", [{"status": "done", "id": "3"}])])
        ledger.close()
        ledger = Ledger(str(self.folder / "private"), "v1")
        self.assertEqual([line["id"] for line in ledger.scans()], ["1", "3"])
        ledger.keep([Outcome("d", "failed", [{"status": "failed", "code": "batch/failed"}])])
        self.assertTrue(ledger.is_finished("d"))
        ledger.forget_failed()
        self.assertFalse(ledger.is_finished("d"))
        self.assertTrue(ledger.is_finished("c"))
        ledger.close()
        with self.assertRaises(SystemExit):
            (self.folder / "private/lock").write_text("1")
            Ledger(str(self.folder / "private"), "v1")
        (self.folder / "private/lock").write_text("0")
        other = Ledger(str(self.folder / "private"), "other options")
        self.assertFalse(other.is_finished("a"))
        other.close()


class SettledTest(unittest.TestCase):
    def test_a_file_is_taken_when_it_has_stayed_as_it_is(self):
        settled = Settled(10)
        grows = lambda size: [Entry("a", size, str(size)), Entry("b", 1, "1")]  # noqa: E731
        self.assertEqual(settled.take(grows(1), 0), [])
        self.assertEqual([one.path for one in settled.take(grows(2), 11)], ["b"])
        self.assertEqual([one.path for one in settled.take(grows(2), 20)], ["b"])
        self.assertEqual([one.path for one in settled.take(grows(2), 21)], ["a", "b"])


class CatalogueTest(Folder):
    def line(self, i):
        radar = {"name": "Testfeld", "latitude": 50.5, "longitude": -7.25, "moment": "DBZH"} if i % 1000 == 0 else None
        return {
            "status": "done", "id": f"{i:016x}", "title": f"Scan {i:08x}", "page": f"{i:016x}/index.html", "format": "ODIM_H5 2.0" if radar else "NIfTI-1",
            "unit": "dBZ", "dimensions": [40, 36, 3], "bytes": 1000, "error": {"max": 0, "rms": 0}, "poster": True,
            "time": f"2024-{1 + i // 2880 % 12:02d}-{1 + i // 96 % 28:02d}T{i // 4 % 24:02d}:{15 * (i % 4):02d}:00Z", **({"radar": radar} if radar else {}),
        }

    @mock.patch("os.fsync")
    def test_a_hundred_thousand_scans_are_pages_of_a_size_and_one_more_scan_changes_few_files(self, _):
        written = []
        place = Place(str(self.folder))
        write = place.write
        place.write = lambda name, data: (written.append((name, len(data))), write(name, data))[1]
        lines = [self.line(i) for i in range(100_000)]
        began = time.process_time()
        write_catalogue(place, lines)
        self.assertLess(time.process_time() - began, 60)
        index = json.loads((self.folder / "catalogue/index.json").read_text())
        self.assertEqual((index["scans"], index["pages"]), (100_000, 834))
        self.assertLess(max(size for name, size in written if "page-" in name), 60_000)
        self.assertLess(next(size for name, size in written if "words" in name), 8_000_000)
        words = json.loads((self.folder / "catalogue/words.json").read_text())
        self.assertEqual(len([one for one in words if " radar " in one]), 100)
        self.assertIn("scan 00000000 radar odim_h5 2.0 dbz 40x36x3 2024-01-01t00:00:00z testfeld dbzh", words)
        written.clear()
        write_catalogue(place, lines)
        self.assertEqual(written, [])
        newest = {**self.line(100_000), "time": "2025-01-01T00:00:00Z"}
        write_catalogue(place, [*lines, newest])
        self.assertLessEqual(len(written), 8, [name for name, _ in written])
        # Scans that have gone take their STAC items with them.
        write_catalogue(place, lines[:240])
        self.assertEqual(json.loads((self.folder / "catalogue/index.json").read_text())["pages"], 2)
        self.assertEqual(len(list(self.folder.glob("catalogue/page-*.json"))), 2)
        self.assertEqual(len(list(self.folder.glob("stac/*/0*.json"))), 1)

    def test_volumes_of_one_file_stand_together_in_their_order(self):
        ids = [f"{7:016x}" + (f"-{n}" if n > 1 else "") for n in range(1, 13)]
        volumes = [{**self.line(7), "id": one, "time": f"{2 * n} s"} for n, one in enumerate(ids)]
        dated = self.line(2000)
        write_catalogue(Place(str(self.folder)), [dated, *reversed(volumes), {**self.line(5), "time": ""}])
        page = json.loads((self.folder / "catalogue/page-1.json").read_text())
        self.assertEqual([one["id"] for one in page], [f"{5:016x}", *ids, dated["id"]])

    def test_stac_is_what_pystac_reads(self):
        import pystac

        write_catalogue(Place(str(self.folder)), [self.line(i) for i in range(10_000)])
        catalog = pystac.Catalog.from_file(str(self.folder / "stac/catalog.json"))
        items = list(catalog.get_items(recursive=True))
        self.assertEqual(len(items), 10)
        for item in items:
            item.validate()
            self.assertEqual(item.geometry, {"type": "Point", "coordinates": [-7.25, 50.5]})
            self.assertTrue(item.assets["manifest"].get_absolute_href().endswith(f"/{item.id}/volume.json"))
        catalog.validate_all()


if __name__ == "__main__":
    unittest.main()
