"""Whole runs of the command on a cluster of this machine: what is found, what is written, what no file says, and what breaks in between."""
import contextlib
import faulthandler
import io
import json
import logging
import os
import pathlib
import shutil
import signal
import subprocess
import sys
import tempfile
import threading
import time
import unittest
from unittest import mock

from volume_view_archive.cli import main
from volume_view_archive.ledger import Ledger
from volume_view_archive.places import Place
from volume_view_archive.run_archive import Plan
from volume_view_archive.run_batch import Job
from volume_view_archive.watch_archive import watch_archive

from helpers import COMMAND, PLANTED, catalogue_of, children_of, command_of, scans_in, write_niftis, write_radar, write_series

MORE = ["--", "--poster", "0"]

# Seconds for a run as a process of its own.
LIMIT = 150


class Archive(unittest.TestCase):
    def setUp(self):
        # A run that does not end is a failure that shows where it waits.
        faulthandler.dump_traceback_later(2 * LIMIT, exit=True)
        self.addCleanup(faulthandler.cancel_dump_traceback_later)
        # Temporary folders of batches are below it too, so that what is left of them is seen.
        self.work = pathlib.Path(tempfile.mkdtemp())
        self.addCleanup(shutil.rmtree, self.work, True)
        self.folder, self.site, self.tmp = self.work / "in", self.work / "site", self.work / "tmp"
        self.tmp.mkdir()

    def arguments(self, *more):
        return [str(self.folder), "--out", str(self.site), "--tmp", str(self.tmp), "--prepare", COMMAND, "--workers", "2", "--batch", "10", *more, *MORE]

    def run_main(self, *more):
        out, said = io.StringIO(), io.StringIO()
        with contextlib.redirect_stdout(out), contextlib.redirect_stderr(said):
            status = main(self.arguments(*more))
        text = out.getvalue().strip()
        return status, json.loads(text) if text else None, text + said.getvalue()

    def start(self):
        return subprocess.Popen([sys.executable, "-m", "volume_view_archive", *self.arguments()], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)

    def expect_whole(self, count, failed=0):
        """Nothing is lost, nothing is there twice, nothing is left over."""
        ids = scans_in(self.site)
        self.assertEqual(len(ids), count)
        entries = catalogue_of(self.site)
        self.assertEqual(sorted(one["id"] for one in entries), sorted(ids))
        table = (self.work / "site.private/quarantine.tsv").read_text()
        self.assertEqual(len(table.splitlines()), failed, table)


class Runs(Archive):
    def test_all_scans_are_made_broken_ones_are_listed_and_no_name_is_written(self):
        broken = {17, 40}
        write_niftis(self.folder, 60, broken)
        write_series(self.folder / "plantedfolder", "1.2.3.98765.10", 6, 100)
        write_series(self.folder / "plantedfolder", "1.2.3.98765.11", 4, 900)
        (self.folder / "plantedfile.txt").write_text("Plantedname")
        status, report, said = self.run_main()
        self.assertEqual(status, 2, said)
        self.assertEqual(report["units"], {"all": 63, "unchanged": 0, "done": 60, "failed": 2, "noVolume": 1, "triedAgain": 0})
        self.assertEqual(report["failures"], {"format/corrupt": 2})
        self.expect_whole(60, 2)
        sizes = [tuple(one["dimensions"]) for one in catalogue_of(self.site)]
        self.assertEqual((sizes.count((4, 3, 6)), sizes.count((4, 3, 4))), (1, 1))
        for path in self.site.rglob("*"):
            texts = [str(path.relative_to(self.site))] + ([path.read_bytes().decode("latin1")] if path.is_file() else [])
            for text in [*texts, said, (self.work / "site.private/report.json").read_text()]:
                for word in [*PLANTED, str(self.work)]:
                    self.assertNotIn(word.lower(), text.lower())
        self.assertEqual(list(self.tmp.iterdir()), [])

        # The scans of the command itself, with the same secret, have the same ids and bytes.
        alone = self.work / "alone"
        (self.work / "alone.private").mkdir()
        (self.work / "alone.private/salt").write_text((self.work / "site.private/secret").read_text())
        subprocess.run([*COMMAND.split(), str(self.folder), "--out", str(alone), "--poster", "0"], capture_output=True, timeout=LIMIT)
        self.assertEqual(scans_in(alone), scans_in(self.site))
        for name in scans_in(alone):
            for file in (alone / name).iterdir():
                self.assertEqual(file.read_bytes(), (self.site / name / file.name).read_bytes())

        # A second run finds nothing to do; one after a change makes that one alone.
        before = {path: path.stat().st_mtime_ns for path in self.site.rglob("*") if path.is_file()}
        with mock.patch("volume_view_archive.run_archive.run_batch", side_effect=AssertionError):
            status, report, _ = self.run_main()
        self.assertEqual((status, report["units"]["unchanged"]), (2, 63))
        self.assertEqual({path: path.stat().st_mtime_ns for path in self.site.rglob("*") if path.is_file()}, before)
        write_niftis(self.folder, 18, ())
        status, report, _ = self.run_main()
        self.assertEqual(report["units"]["failed"], 0)
        self.assertEqual(report["units"]["all"], 63)
        self.expect_whole(61, 1)

    def test_workers_that_are_killed_lose_nothing(self):
        write_niftis(self.folder, 60, {5})
        run = self.start()
        killed, until = 0, time.monotonic() + LIMIT
        self.addCleanup(run.kill)
        while run.poll() is None:
            self.assertLess(time.monotonic(), until, "the run ends")
            time.sleep(0.7)
            workers = [pid for pid in children_of(run.pid) if "--multiprocessing" in command_of(pid) or "spawn_main" in command_of(pid)]
            busy = [pid for pid in workers if any("volume-view-prepare" in command_of(child) for child in children_of(pid))]
            if busy and killed < 4:
                os.kill(busy[0], signal.SIGKILL)
                killed += 1
        self.assertEqual(run.returncode, 2)
        self.assertGreater(killed, 1)
        self.expect_whole(59, 1)

    def test_what_a_killed_worker_was_writing_is_gone_when_the_run_ends(self):
        self.folder.mkdir()

        def leave(client, job, *rest):
            left = pathlib.Path(job.target.at()) / ".unfinished-left"
            (left / "new").mkdir(parents=True)

        with mock.patch("volume_view_archive.run_archive._run_all", side_effect=leave) as ran:
            self.run_main()
        self.assertEqual(ran.call_count, 1)
        self.assertFalse([one.name for one in self.site.iterdir() if one.name.startswith(".unfinished")])

    def test_a_run_that_is_killed_goes_on(self):
        write_niftis(self.folder, 60)
        run = self.start()
        self.addCleanup(run.kill)
        until = time.monotonic() + LIMIT
        # A batch is written down, and others are not.
        journal = self.work / "site.private/journal.jsonl"
        while not journal.exists() or '"unit"' not in journal.read_text():
            self.assertLess(time.monotonic(), until)
            time.sleep(0.1)
        run.kill()
        run.wait()
        for path in self.site.glob("[0-9a-f]*"):
            self.assertTrue((path / "volume.json").exists(), "no half folder")
        status, report, said = self.run_main()
        self.assertEqual(status, 0, said)
        self.assertLess(report["units"]["done"], 60, "it goes on")
        self.expect_whole(60)
        ledger = Ledger(str(self.work / "site.private"), "")
        self.assertEqual(len(ledger.outcomes), 60)
        ledger.close()

    def test_a_full_disk_ends_the_run_in_words_and_the_next_one_goes_on(self):
        write_niftis(self.folder, 30)
        self.site.mkdir()
        script = (
            'mount -t tmpfs -o size=100k tmpfs "$0" || exit 77; "$@"; echo "status $?" >&2; mount -o remount,size=64m tmpfs "$0"; "$@"; status=$?; '
            'cp -r "$0" "$0.copy"; exit $status'
        )
        command = [sys.executable, "-m", "volume_view_archive", *self.arguments()]
        run = subprocess.run(["unshare", "-rm", "sh", "-c", script, str(self.site), *command], capture_output=True, text=True, timeout=LIMIT)
        if run.returncode == 77 or "unshare" in run.stderr[:20]:
            self.skipTest("this system lets nobody mount a small disk")
        self.assertRegex(run.stderr, r"no space is left [^;]+; make room, and run the command again\nstatus 1\n")
        self.assertEqual(run.returncode, 0, run.stderr)
        self.site = pathlib.Path(f"{self.site}.copy")
        self.expect_whole(30)

    def test_a_cluster_that_is_there_already_and_an_object_store(self):
        import boto3
        from distributed import LocalCluster
        from moto.server import ThreadedMotoServer

        logging.getLogger("werkzeug").setLevel(logging.ERROR)

        write_niftis(self.folder, 20, {3})
        write_series(self.folder, "1.2.3.98765.10", 5, 100)
        write_radar(self.folder / "radar.h5", 5)
        with mock.patch.dict(os.environ, AWS_ACCESS_KEY_ID="test", AWS_SECRET_ACCESS_KEY="test", AWS_DEFAULT_REGION="us-east-1"), LocalCluster(n_workers=2, threads_per_worker=1, dashboard_address=None) as cluster:
            server = ThreadedMotoServer("127.0.0.1", 0, verbose=False)
            server.start()
            self.addCleanup(server.stop)
            address = "http://%s:%s" % server.get_host_and_port()
            bucket = boto3.resource("s3", endpoint_url=address).create_bucket(Bucket="archive")
            for path in self.folder.rglob("*"):
                if path.is_file():
                    bucket.upload_file(str(path), f"in/{path.relative_to(self.folder)}")
            remote = [
                *("s3://archive/in", "--out", "s3://archive/site", "--private", str(self.work / "private"), "--store", json.dumps({"endpoint_url": address})),
                *("--cluster", cluster.scheduler_address, "--prepare", COMMAND, "--batch", "6", "--tmp", str(self.tmp), *MORE),
            ]
            for unchanged in (0, 22):
                out = io.StringIO()
                with contextlib.redirect_stdout(out), contextlib.redirect_stderr(io.StringIO()):
                    self.assertEqual(main(remote), 2)
                self.assertEqual(json.loads(out.getvalue())["units"]["unchanged"], unchanged)
            for one in bucket.objects.filter(Prefix="site/"):
                target = self.site / one.key[len("site/"):]
                target.parent.mkdir(parents=True, exist_ok=True)
                bucket.download_file(one.key, str(target))
        ids = scans_in(self.site)
        self.assertEqual(len(ids), 21)
        self.assertEqual({one["id"] for one in catalogue_of(self.site)}, ids)
        self.assertEqual(len(list(self.site.glob("stac/2024-05-17/????????????????.json"))), 1)

    def test_what_can_not_be_done_is_said_in_words(self):
        self.folder.mkdir()
        for arguments, words in (
            ([str(self.folder), "--out", "memory://x"], "--private"),
            ([str(self.folder), "--out", str(self.site), "--prepare", "false"], "got no answer of false --version"),
            ([str(self.folder), "--out", str(self.site), "--", "--keep-names"], "--keep-names after --"),
            ([str(self.folder), "--out", str(self.site), "--", "--out=x"], "--out=x after --"),
        ):
            with self.assertRaises(SystemExit) as refused:
                main(arguments)
            self.assertIn(words, str(refused.exception))


class Watched(Archive):
    def test_a_rolling_archive_keeps_the_newest_scans(self):
        from distributed import Client, LocalCluster

        with LocalCluster(n_workers=1, threads_per_worker=1, processes=False, dashboard_address=None) as cluster, Client(cluster) as client:
            self.folder.mkdir()
            ledger = Ledger(str(self.work / "private"), "")
            job = Job(Place(str(self.folder)), Place(str(self.site)), tuple(COMMAND.split()), ("--poster", "0"), ledger.secret, 60, str(self.tmp))
            stop, said = threading.Event(), []
            watch = threading.Thread(
                target=watch_archive, args=(client, job, ledger, Plan(), stop, said.append), kwargs={"every": 0.2, "settle": 1.5, "keep": 3}
            )
            watch.start()
            try:
                for minute in (5, 10, 15, 20):
                    write_radar(self.folder / f"{minute}.h5", minute)
                self.wait_for([10, 15, 20])
                broken = self.folder / "25.h5"
                write_radar(broken, 25)
                whole = broken.read_bytes()
                broken.write_bytes(b"")
                for at in range(0, len(whole), len(whole) // 6 + 1):
                    with broken.open("ab") as file:
                        file.write(whole[at : at + len(whole) // 6 + 1])
                    # Far less than the time for which a file has to stay: this process may have to wait for its turn.
                    time.sleep(0.1)
                self.wait_for([15, 20, 25])
                self.assertFalse(any("1 failed" in words for words in said), said)
                self.wait_for_folders(3)
                # The source may go: what the archive has stays.
                (self.folder / "15.h5").unlink()
                write_radar(self.folder / "30.h5", 30)
                self.wait_for([20, 25, 30])
            finally:
                stop.set()
                watch.join()
                ledger.close()
            self.assertEqual(len(list(self.site.glob("stac/*/????????????????.json"))), 3)
            self.assertEqual(len(scans_in(self.site)), 3)

    def wait_for_folders(self, count):
        until = time.monotonic() + LIMIT
        found = None
        while found != count:
            self.assertLess(time.monotonic(), until, f"{found} folders")
            time.sleep(0.1)
            with contextlib.suppress(AssertionError, OSError):
                found = len(scans_in(self.site))

    def wait_for(self, minutes):
        until = time.monotonic() + LIMIT
        found = None
        while found != minutes:
            self.assertLess(time.monotonic(), until, f"{found}, expected {minutes}")
            time.sleep(0.2)
            with contextlib.suppress(OSError, ValueError, AssertionError):
                found = [int(one["time"][14:16]) for one in catalogue_of(self.site)]


if __name__ == "__main__":
    unittest.main()
