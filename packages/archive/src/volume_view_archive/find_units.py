"""Which files belong together: a unit is what the command makes volumes of - a DICOM series, a header and its data, a file."""
import hashlib
import hmac
import posixpath
import re
from dataclasses import dataclass

HEADERS_AT_ONCE = 500

# Files of one name before the ending belong together: the first is the header, the others its data.
PAIRS = [
    {".hdr", ".img", ".hdr.gz", ".img.gz"},
    {".nhdr", ".raw", ".raw.gz"},
    {".mhd", ".raw", ".zraw"},
    {".head", ".brik", ".brik.gz"},
    {".json", ".png"},
]
OTHER_FORMATS = re.compile(
    r"\.(nii|nii\.gz|nrrd|nhdr|mha|mhd|mgh|mgz|mnc|npy|npz|vti|h5|hdf|hdf5|nc|nc4|ar2v|vol|zip|tiff?|json|png|jpe?g|webp|hdr|img|raw|zraw|head|brik|txt|csv|xml|html?)(\.(gz|bz2))?$",
    re.I,
)
WHILE_WRITTEN = re.compile(r"(\.(part|partial|filepart|tmp|temp|crdownload|download|inprogress)|~)$", re.I)


@dataclass(frozen=True)
class Unit:
    """Files that belong together. `key` is a number that only who has the secret can compute of the files."""

    key: str
    files: tuple
    size: int
    is_series: bool


def secret_number(secret, text):
    return hmac.new(secret.encode(), text.encode(), hashlib.sha256).hexdigest()[:32]


def read_series(place, paths, secret):
    """For each file a number for its DICOM series; None of a file that is none. No UID leaves this function."""
    import pydicom

    found = []
    for path in paths:
        try:
            with place.store.open(place.at(path), "rb") as file:
                start = file.read(132)
                if start[128:] != b"DICM" and OTHER_FORMATS.search(path):
                    found.append(None)
                    continue
                file.seek(0)
                tags = ["StudyInstanceUID", "SeriesInstanceUID", "Rows"]
                head = pydicom.dcmread(file, stop_before_pixels=True, force=True, specific_tags=tags)
            series = head.get("SeriesInstanceUID")
            found.append(secret_number(secret, f"{head.get('StudyInstanceUID')} {series}") if series and head.get("Rows") else None)
        except Exception:  # A stranger's file may break the reader in any way; the command says what is wrong.
            found.append(None)
    return found


def find_units(place, entries, secret, known, client=None):
    """Groups all files of a place.

    known: a dict from (path, stamp) to the number of the series, which spares a second look; new ones are added to it.
    """
    entries = [one for one in entries if not WHILE_WRITTEN.search(one.path)]
    fresh = [one for one in entries if (one.path, one.stamp) not in known]
    parts = [fresh[i : i + HEADERS_AT_ONCE] for i in range(0, len(fresh), HEADERS_AT_ONCE)]
    paths = [[one.path for one in part] for part in parts]
    if client is not None and len(parts) > 1:
        results = client.gather(client.map(lambda names: read_series(place, names, secret), paths, pure=False))
    else:
        results = [read_series(place, names, secret) for names in paths]
    for part, numbers in zip(parts, results):
        for one, number in zip(part, numbers):
            known[(one.path, one.stamp)] = number
    groups = {}
    for one in entries:
        number = known[(one.path, one.stamp)]
        groups.setdefault(("series", number) if number else ("files", _pair_name(one.path)), []).append(one)
    return [_unit(files, kind == "series", secret) for (kind, _), files in groups.items()]


def _pair_name(path):
    stem, ending = re.match(r"(.*?)((?:\.[A-Za-z]\w*)?(?:\.gz)?)$", path, re.S).groups()
    if any(ending.lower() in endings for endings in PAIRS):
        return stem
    return path


def _unit(files, is_series, secret):
    text = "\n".join(f"{one.path} {one.stamp}" for one in files)
    return Unit(secret_number(secret, text), tuple(one.path for one in files), sum(one.size for one in files), is_series)


def names_of(unit):
    """Names of its files in the folder of a batch: of slices they are numbers; headers name their data, so others stay as they are."""
    if unit.is_series:
        return [f"{i:06d}.dcm" for i in range(len(unit.files))]
    return [posixpath.basename(path) for path in unit.files]
