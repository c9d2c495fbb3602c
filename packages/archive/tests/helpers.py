"""Folders of small scans, and what is in an archive."""
import json
import os
import pathlib
import re
import shlex
import struct
import subprocess

from pydicom.dataset import Dataset, FileMetaDataset
from pydicom.uid import CTImageStorage, ExplicitVRLittleEndian

PROJECT = pathlib.Path(__file__).parents[3]
FIXTURES = PROJECT / "test/fixtures"
COMMAND = os.environ.get("VOLUME_VIEW_PREPARE", f"node {shlex.quote(str(PROJECT / 'packages/prepare/dist/volume-view-prepare.js'))}")

# Words that only the files have.
PLANTED = ["Plantedname", "PLANTEDID77", "19011231", "20111213", "Plantedhospital", "1.2.3.98765", "plantedfolder", "plantedfile"]


def write_nifti(path, number, cut=None):
    """A volume of a few voxels that has this number in it."""
    data = bytearray((FIXTURES / "nifti/v1-le-i2.nii").read_bytes())
    struct.pack_into("<h", data, 352, number)
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_bytes(bytes(data[:cut]))


def write_niftis(folder, count, broken=()):
    for i in range(count):
        write_nifti(folder / f"plantedfolder{i % 7}" / f"plantedfile{i}.nii", i, 400 if i in broken else None)


def write_series(folder, uid, count, base):
    """A CT series of slices of 4 x 3 pixels, in two folders."""
    for i in range(count):
        meta = FileMetaDataset()
        meta.TransferSyntaxUID, meta.MediaStorageSOPClassUID, meta.MediaStorageSOPInstanceUID = ExplicitVRLittleEndian, CTImageStorage, f"{uid}.{i}"
        data = Dataset()
        data.file_meta = meta
        data.PatientName, data.PatientID, data.PatientBirthDate = "Plantedname^Erika", "PLANTEDID77", "19011231"
        data.StudyDate, data.InstitutionName = "20111213", "Plantedhospital"
        data.SOPClassUID, data.SOPInstanceUID, data.Modality = CTImageStorage, f"{uid}.{i}", "CT"
        data.StudyInstanceUID, data.SeriesInstanceUID, data.InstanceNumber = "1.2.3.98765.1", uid, i + 1
        data.Rows, data.Columns, data.SamplesPerPixel, data.PhotometricInterpretation = 3, 4, 1, "MONOCHROME2"
        data.BitsAllocated, data.BitsStored, data.HighBit, data.PixelRepresentation = 16, 12, 11, 0
        data.PixelSpacing, data.ImageOrientationPatient, data.ImagePositionPatient = [1, 1], [1, 0, 0, 0, 1, 0], [0, 0, 5 * i]
        data.RescaleSlope, data.RescaleIntercept = 1, -1024
        data.PixelData = struct.pack("<12H", *(base + 100 * i + j for j in range(12)))
        target = folder / ("a" if i % 2 else "b") / f"plantedfile-{base}-{i}"
        target.parent.mkdir(parents=True, exist_ok=True)
        data.save_as(target, enforce_file_format=True)


def write_radar(path, minute):
    """A scan of three sweeps, at that minute after 12."""
    text = (FIXTURES / "radar/odim-2.0.h5").read_bytes()
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_bytes(re.sub(rb"12000(\d)", rb"12%02d0\1" % minute, text))


def scans_in(site):
    """Ids of the folders of an archive, and a check that each of them is whole."""
    found = set()
    for folder in pathlib.Path(site).iterdir():
        if re.fullmatch(r"[0-9a-f]{16}(-\d+)?", folder.name):
            names = {one.name for one in folder.iterdir()}
            assert {"index.html", "volume.json", "volume.png"} <= names, names
            json.loads((folder / "volume.json").read_text())
            found.add(folder.name)
        else:
            assert not folder.name.startswith("."), folder.name
    return found


def catalogue_of(site):
    root = pathlib.Path(site) / "catalogue"
    index = json.loads((root / "index.json").read_text())
    entries = [one for page in range(index["pages"]) for one in json.loads((root / f"page-{page + 1}.json").read_text())]
    assert len(entries) == index["scans"] == len(json.loads((root / "words.json").read_text()))
    return entries


def children_of(process):
    found = subprocess.run(["ps", "--ppid", str(process), "-o", "pid="], capture_output=True, text=True).stdout
    return [int(one) for one in found.split()]


def command_of(process):
    try:
        return pathlib.Path(f"/proc/{process}/cmdline").read_bytes().replace(b"\0", b" ").decode()
    except OSError:
        return ""
