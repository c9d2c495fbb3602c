"""What a web server has besides the scans: a list in pages of JSON, a gallery that reads them, and STAC items of radars."""
import json
import re
from importlib.resources import files

from . import __version__

# A page of the gallery is one request.
PAGE = 120
STAC = "1.0.0"


def write_catalogue(target, lines, say=lambda words: None):
    """Writes the list, the gallery and, of radars, STAC. lines: of the ledger, of scans that are there."""
    # The newest last: a new scan changes the last page alone. The gallery shows them from the end.
    entries = sorted((_entry(line) for line in lines), key=_order)
    pages = [entries[i : i + PAGE] for i in range(0, len(entries), PAGE)] or [[]]
    writer = ChangedFiles(target)
    for number, page in enumerate(pages, 1):
        writer.write(f"catalogue/page-{number}.json", page)
    # One line of words for each scan: this is what a search reads, once.
    writer.write("catalogue/words.json", [_words(one) for one in entries])
    _write_stac(writer, entries)
    # Last, as it says how many pages there are.
    writer.write("catalogue/index.json", {"version": __version__, "scans": len(entries), "pages": len(pages), "perPage": PAGE})
    writer.write_text("index.html", files(__package__).joinpath("gallery.html").read_text(encoding="utf-8"))
    writer.finish()
    say(f"{len(entries)} scans in the catalogue")


class ChangedFiles:
    """Writes files that are not as the last time, whose numbers are in a file of the catalogue."""

    STATE = "catalogue/written.json"

    def __init__(self, target):
        self.target = target
        try:
            self.before = json.loads(target.read(self.STATE))
        except (FileNotFoundError, ValueError):
            self.before = {}
        self.now = {}

    def write(self, name, value):
        self.write_text(name, json.dumps(value, ensure_ascii=False, separators=(",", ":")))

    def write_text(self, name, text):
        import hashlib

        data = text.encode()
        self.now[name] = hashlib.sha256(data).hexdigest()[:16]
        if self.before.get(name) != self.now[name]:
            self.target.write(name, data)

    def finish(self):
        if self.now != self.before:
            self.target.write(self.STATE, json.dumps(self.now).encode())
        for name in self.before.keys() - self.now.keys():
            self.target.remove(name)


def _entry(line):
    kept = {name: line[name] for name in ("id", "title", "page", "scans", "format", "unit", "dimensions", "from", "time", "bytes", "error", "radar", "poster") if name in line}
    return kept


def _order(entry):
    """Dates, then the volumes of one file in their order: their times are seconds from its beginning, and say nothing of other scans."""
    time = entry.get("time", "")
    scan, _, number = entry["id"].partition("-")
    return (time if re.match(r"\d{4}-\d\d-\d\dT", time) else "", scan, int(number or 1))


def _words(entry):
    radar = entry.get("radar", {})
    kind = "radar" if radar else ""
    return " ".join(
        str(one)
        for one in (entry["title"], kind, entry["format"], entry["unit"], "x".join(map(str, entry["dimensions"])), entry.get("time", ""), radar.get("name", ""), radar.get("moment", ""))
        if one
    ).lower()


def _write_stac(writer, entries):
    """A STAC catalogue with a child for each day, so that no file has a line for each scan of years."""
    days = {}
    for one in entries:
        radar = one.get("radar", {})
        if "time" in one and {"latitude", "longitude"} <= radar.keys():
            days.setdefault(one["time"][:10], []).append(one)
    if not days:
        return
    for day, scans in days.items():
        for one in scans:
            writer.write(f"stac/{day}/{one['id']}.json", _stac_item(one))
        links = [{"rel": "root", "href": "../catalog.json"}, {"rel": "parent", "href": "../catalog.json"}]
        links += [{"rel": "item", "href": f"./{one['id']}.json", "type": "application/geo+json"} for one in scans]
        writer.write(f"stac/{day}/catalog.json", _stac_catalog(day, f"Radar scans of {day}", links))
    links = [{"rel": "root", "href": "./catalog.json"}]
    links += [{"rel": "child", "href": f"./{day}/catalog.json"} for day in sorted(days)]
    writer.write("stac/catalog.json", _stac_catalog("radar-scans", "Radar scans by day", links))


def _stac_catalog(name, description, links):
    return {"type": "Catalog", "stac_version": STAC, "id": name, "description": description, "links": links}


def _stac_item(one):
    radar = one["radar"]
    longitude, latitude = radar["longitude"], radar["latitude"]
    root = f"../../{one['id']}"
    assets = {
        "manifest": {"href": f"{root}/volume.json", "type": "application/json", "title": "Manifest of <volume-view>", "roles": ["metadata"]},
        "volume": {"href": f"{root}/volume.png", "type": "image/png", "title": "Mosaic of the sweeps", "roles": ["data"]},
        "page": {"href": f"{root}/index.html", "type": "text/html", "title": "The scan in the browser", "roles": ["overview"]},
    }
    if one.get("poster"):
        assets["thumbnail"] = {"href": f"{root}/poster.png", "type": "image/png", "roles": ["thumbnail"]}
    return {
        "type": "Feature",
        "stac_version": STAC,
        "id": one["id"],
        "geometry": {"type": "Point", "coordinates": [longitude, latitude]},
        "bbox": [longitude, latitude, longitude, latitude],
        "properties": {"datetime": one["time"], "title": one["title"], "radar:name": radar.get("name", ""), "radar:moment": radar["moment"]},
        "links": [{"rel": "root", "href": "../catalog.json"}, {"rel": "parent", "href": "./catalog.json"}],
        "assets": assets,
    }
