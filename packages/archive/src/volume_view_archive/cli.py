"""The command `volume-view-archive`."""
import argparse
import json
import os
import shlex
import shutil
import signal
import subprocess
import sys
import threading

from . import __version__
from .catalogue import write_catalogue
from .clusters import open_cluster
from .ledger import Ledger
from .places import Place
from .report import describe, make_report, write_report
from .run_archive import Plan, run_archive
from .run_batch import Job, NoSpace, is_no_space
from .watch_archive import watch_archive

OWN_OPTIONS = {"--out", "--watch", "--newest", "--every", "--settle", "--jobs", "--keep-names", "--as", "--deface"}


def main(arguments=None):
    """Runs the command. Returns its exit status: 0, 2 where some units failed, 1 where the run could not go on."""
    given = list(sys.argv[1:] if arguments is None else arguments)
    given, more = (given[: given.index("--")], given[given.index("--") + 1 :]) if "--" in given else (given, [])
    args = _parser().parse_args(given)
    for option in more:
        if option.split("=")[0] in OWN_OPTIONS:
            raise SystemExit(f"got {option} after --; expected options of volume-view-prepare such as --poster or --fit")
    source, target = Place(args.source, json.loads(args.store)), Place(args.out, json.loads(args.store))
    private = args.private or (f"{target.at()}.private" if target.is_local else None)
    if private is None:
        raise SystemExit("got --out of an object store without --private; expected a folder of this machine, which is not for the server")
    command = _find_command(args.prepare)
    ledger = Ledger(private, json.dumps([__version__, _version_of(command), more]))
    if args.again:
        ledger.forget_failed()
    job = Job(source, target, tuple(command), tuple(more), ledger.secret, args.timeout, args.tmp)
    plan = Plan(batch=args.batch, retries=args.retries)
    try:
        target.remove_unfinished()
        copy_script(target, args.player)
        with open_cluster(args.cluster, args.workers, json.loads(args.slurm)) as client:
            if args.watch:
                return _watch(client, job, ledger, plan, args)
            return _run_once(client, job, ledger, plan)
    except (NoSpace, OSError) as error:
        if isinstance(error, OSError) and not is_no_space(error):
            raise
        # Nothing is lost: what came back is written down, and the next run goes on.
        words = error if isinstance(error, NoSpace) else "no space is left for the archive"
        _say(f"{words}; make room, and run the command again")
        return 1
    finally:
        ledger.close()


def _run_once(client, job, ledger, plan):
    totals, units = run_archive(client, job, ledger, plan, _progress)
    ledger.write_quarantine(units)
    write_catalogue(job.target, ledger.scans(units.keys()), _say)
    report = make_report(totals)
    write_report(ledger, report)
    for line in describe(report):
        _say(line)
    print(json.dumps(report))
    failed = sum(ledger.outcomes[key].status == "failed" for key in units)
    if failed:
        _say("what failed is in quarantine.tsv of the private folder")
    return 2 if failed else 0


def _watch(client, job, ledger, plan, args):
    stop = threading.Event()
    for name in (signal.SIGINT, signal.SIGTERM):
        signal.signal(name, lambda *_: stop.set())
    watch_archive(client, job, ledger, plan, stop, _say, every=args.every, settle=args.settle, keep=args.keep)
    return 0


def _find_command(text):
    if text:
        return shlex.split(text)
    if shutil.which("volume-view-prepare"):
        return ["volume-view-prepare"]
    if shutil.which("npx"):
        return ["npx", "--yes", "volume-view-prepare"]
    raise SystemExit("got no volume-view-prepare on the PATH; expected it, or Node, or --prepare with a command")


def _version_of(command):
    """Of the command: another version makes all scans again."""
    try:
        answer = subprocess.run([*command, "--version"], capture_output=True, text=True, timeout=300)
    except (OSError, subprocess.TimeoutExpired):
        answer = None
    if answer is None or answer.returncode != 0:
        raise SystemExit(f"got no answer of {command[0]} --version; expected volume-view-prepare, or --prepare with its command")
    return answer.stdout.strip()


def copy_script(target, player):
    """The element's files, which the pages need; they come from the folder dist of the package volume-view."""
    if player is None:
        if not target.exists("volume-view.iife.js"):
            _say("the pages need volume-view.iife.js, x3dom.js and the folder classic of the package volume-view next to index.html; --player DIST copies them")
        return
    with open(os.path.join(player, "volume-view.iife.js"), "rb") as file:
        script = file.read()
    # It is written last: where it is, all the rest is.
    if target.exists("volume-view.iife.js") and target.read("volume-view.iife.js") == script:
        return
    folders = {"": ["x3dom.js", "volume-view.iife.js"], "classic": sorted(os.listdir(os.path.join(player, "classic")))}
    for folder in ("classic", ""):
        for name in folders[folder]:
            with open(os.path.join(player, folder, name), "rb") as file:
                target.write(f"{folder}/{name}".lstrip("/"), file.read())


def _say(words):
    print(words, file=sys.stderr, flush=True)


def _progress(words):
    if sys.stderr.isatty():
        print(f"\r{words}\x1b[K", end="", file=sys.stderr, flush=True)


def _count(text):
    number = int(text)
    if number < 1:
        raise argparse.ArgumentTypeError(f"got {text}; expected a whole number from 1")
    return number


def _parser():
    parser = argparse.ArgumentParser(
        prog="volume-view-archive",
        description="Makes an archive of scans ready for <volume-view>: batches of scans, each a run of volume-view-prepare, on a Dask cluster.",
        epilog="Options of volume-view-prepare follow after --, such as: -- --poster 128 --fit phone",
    )
    parser.add_argument("source", help="a folder, or a URL of fsspec such as s3://bucket/scans")
    parser.add_argument("--out", required=True, help="where the site is written: a folder or a URL")
    parser.add_argument("--private", help="a folder of this machine for what must not be on a server; by default OUT.private")
    parser.add_argument("--cluster", default="local", help="local, slurm, or the address of a Dask scheduler such as tcp://host:8786")
    parser.add_argument("--workers", type=_count, default=os.cpu_count(), help="processes of a local cluster, or jobs of Slurm")
    parser.add_argument("--slurm", default="{}", help='options of SLURMCluster as JSON: {"queue": "long", "memory": "8GB", "walltime": "08:00:00"}')
    parser.add_argument("--store", default="{}", help='options of the store as JSON: {"endpoint_url": "http://..."}')
    parser.add_argument("--batch", type=_count, default=50, help="scans of a task; 50 by default")
    parser.add_argument("--retries", type=int, default=2, help="how often a scan is tried again, alone, that failed for want of memory, time or a file")
    parser.add_argument("--again", action="store_true", help="tries again what failed before, though its files have not changed")
    parser.add_argument("--timeout", type=_count, default=3600, help="seconds for a batch")
    parser.add_argument("--tmp", help="a folder of each worker for a batch; the system's by default")
    parser.add_argument("--prepare", help="the command volume-view-prepare, if it is not on the PATH")
    parser.add_argument("--player", help="the folder dist of the package volume-view, whose script is copied into the site")
    parser.add_argument("--watch", action="store_true", help="runs until it is ended, and takes new files")
    parser.add_argument("--every", type=float, default=10, help="with --watch: seconds between two looks")
    parser.add_argument("--settle", type=float, default=10, help="with --watch: seconds for which a file has to stay as it is")
    parser.add_argument("--keep", type=_count, help="with --watch: so many of the newest scans stay in the archive; all by default")
    parser.add_argument("--version", action="version", version=__version__)
    return parser
