"""The report of a run: numbers, and codes of failures. No name, path or number of a file is in it."""
import json


def make_report(totals):
    """totals: of `run_archive`. Seconds and bytes."""
    units = totals.done + totals.failed + totals.none
    work = totals.seconds * max(1, totals.workers)
    return {
        "units": {"all": totals.units, "unchanged": totals.unchanged, "done": totals.done, "failed": totals.failed, "noVolume": totals.none, "triedAgain": totals.retried},
        "scans": totals.scans,
        "failures": dict(totals.codes.most_common()),
        "bytes": {"in": totals.bytes_in, "out": totals.bytes_out},
        "seconds": round(totals.seconds, 3),
        "workers": totals.workers,
        "unitsPerSecond": round(units / totals.seconds, 3) if totals.seconds else 0,
        "workerSeconds": {"all": round(totals.worker_seconds, 3), "ofTheCommand": round(totals.command_seconds, 3)},
        # What a unit takes of a worker besides the command: to find, send, bring, put away and write down.
        "overheadPerUnitMs": round(1000 * (work - totals.command_seconds) / units, 2) if units else 0,
        "peakBytesOfAProcess": totals.peak_bytes,
    }


def describe(report):
    """Lines for a person."""
    units, size = report["units"], report["bytes"]
    lines = [
        f"{units['done']} done, {units['unchanged']} unchanged, {units['failed']} failed, {units['noVolume']} without a volume, {units['triedAgain']} tried again; {report['scans']} scans",
        f"{size['in'] / 1e6:.1f} MB in, {size['out'] / 1e6:.1f} MB out, {report['seconds']:.1f} s, {report['unitsPerSecond']:.2f} a second with {report['workers']} workers",
    ]
    return lines + [f"  {count} x {code}" for code, count in report["failures"].items()]


def write_report(ledger, report):
    from .ledger import write_whole

    write_whole(f"{ledger.folder}/report.json", json.dumps(report, indent=2) + "\n")
