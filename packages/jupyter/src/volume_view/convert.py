"""Makes a file of what programs call a volume. No library is imported that the data do not come from."""

from __future__ import annotations

import tempfile
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np

from .nifti import write_nifti

#: ITK and DICOM count to the left and to the back, NIfTI to the right and to the front.
_to_ras = np.diag([-1.0, -1.0, 1.0, 1.0])


@dataclass(frozen=True)
class VolumeFile:
    """A file, and a few of its numbers for a still picture."""

    name: str
    bytes: bytes
    #: [i, j, k]; None where only the element can read the file
    array: np.ndarray | None = None
    #: mm along i, j and k
    spacing: tuple[float, float, float] = (1, 1, 1)


def to_file(data: Any, affine: Any = None, spacing: Any = None, axes: str | None = None) -> VolumeFile:
    """Makes a file of data.

    affine: 4 x 4, from indices to mm to the right, front and head (RAS), in place of what the data say
    spacing: three lengths, in the order of the axes i, j, k, in place of what the data say
    axes: what the axes of an array are, like "zyx"; "xyz" if it is not said
    Raises TypeError and ValueError, in words.
    """
    library = type(data).__module__.split(".")[0]
    if isinstance(data, (str, Path, bytes, bytearray, memoryview)):
        return _of_file(data, affine, spacing)
    if _is_tree(data):
        return _of_radar(data)
    if library == "nibabel":
        found = np.asanyarray(data.dataobj), data.affine, None
    elif library == "SimpleITK":
        found = _of_simpleitk(data)
    elif library == "pydicom" or _is_series(data):
        found = _of_dicom([data] if library == "pydicom" else list(data))
    elif library == "xarray":
        found = _of_xarray(data)
    else:
        array = np.asarray(data)
        found = _reorder(array, axes), None, None
    array, own, time_step = found
    if own is None and spacing is None and affine is None:
        return _write(array, None, (1, 1, 1), time_step)
    if affine is not None:
        own = _check_affine(affine)
        if spacing is not None:
            raise ValueError("got an affine and a spacing; expected one of them")
    elif spacing is not None:
        lengths = tuple(float(length) for length in spacing)
        if len(lengths) != 3 or not all(np.isfinite(length) and length > 0 for length in lengths):
            raise ValueError(f"spacing got {spacing}; expected three lengths above 0")
        if own is None:
            return _write(array, None, lengths, time_step)
        own = own.copy()
        own[:3, :3] *= np.array(lengths) / np.linalg.norm(own[:3, :3], axis=0)
    return _write(array, own, (1, 1, 1), time_step)


def _write(array: np.ndarray, affine: np.ndarray | None, spacing: Any, time_step: float | None) -> VolumeFile:
    lengths = spacing if affine is None else np.linalg.norm(affine[:3, :3], axis=0)
    return VolumeFile(
        "volume.nii",
        write_nifti(array, affine, spacing, time_step or 0),
        array if array.ndim == 3 else array[..., 0],
        tuple(float(length) for length in lengths),
    )


def _check_affine(affine: Any) -> np.ndarray:
    matrix = np.asarray(affine, float)
    if matrix.shape != (4, 4) or not np.isfinite(matrix).all() or np.linalg.det(matrix[:3, :3]) == 0:
        raise ValueError("affine got no matrix that can be inverted; expected 4 x 4 numbers, from indices to mm")
    return matrix


def _reorder(array: np.ndarray, axes: str | None) -> np.ndarray:
    """To [x, y, z] or [x, y, z, t]."""
    if axes is None:
        return array
    names = axes.lower()
    if len(names) != array.ndim or sorted(names) not in (sorted("xyz"), sorted("xyzt")):
        raise ValueError(f'axes got "{axes}" for an array of shape {array.shape}; expected x, y, z, and t if there is time, like "zyx"')
    return array.transpose([names.index(name) for name in "xyzt" if name in names])


def _of_file(data: Any, affine: Any, spacing: Any) -> VolumeFile:
    if affine is not None or spacing is not None:
        raise ValueError("got a file, and an affine or a spacing; expected one of them: a file says its own place")
    if isinstance(data, (str, Path)):
        # What comes after the first dot says the format; the rest of the name may be that of a patient.
        ending = "".join(Path(data).suffixes[-2:])
        return VolumeFile(f"volume{ending}", Path(data).read_bytes())
    return VolumeFile("volume", bytes(data))


def _of_simpleitk(image: Any) -> tuple[np.ndarray, np.ndarray, float | None]:
    import SimpleITK

    if image.GetNumberOfComponentsPerPixel() != 1:
        raise ValueError("got an image of several numbers a voxel; expected one: choose one with SimpleITK.VectorIndexSelectionCast")
    dimension = image.GetDimension()
    if dimension not in (3, 4):
        raise ValueError(f"got an image of {dimension} dimensions; expected 3, or 4 with time")
    # Its arrays have the last axis first.
    array = SimpleITK.GetArrayViewFromImage(image).transpose()
    spacing = np.array(image.GetSpacing())
    direction = np.array(image.GetDirection()).reshape(dimension, dimension)[:3, :3]
    lps = np.eye(4)
    lps[:3, :3] = direction * spacing[:3]
    lps[:3, 3] = image.GetOrigin()[:3]
    return array, _to_ras @ lps, float(spacing[3]) if dimension == 4 else None


def _is_series(data: Any) -> bool:
    return isinstance(data, (list, tuple)) and len(data) > 0 and type(data[0]).__module__.split(".")[0] == "pydicom"


#: mm by which places of slices may differ from even steps
_uneven = 0.01


def _of_dicom(slices: list[Any]) -> tuple[np.ndarray, np.ndarray, None]:
    """Slices of one series. Of the data sets only the numbers and the place are taken."""
    advice = "Read the series with SimpleITK, or give the element the files"
    if any(int(getattr(one, "NumberOfFrames", 1)) > 1 for one in slices):
        raise ValueError(f"got a data set of several frames; expected one slice each. {advice}")
    first = slices[0]
    if any("ImageOrientationPatient" not in one or "ImagePositionPatient" not in one for one in slices):
        raise ValueError("got a data set without its place (ImagePositionPatient, ImageOrientationPatient)")
    row, column = np.array(first.ImageOrientationPatient, float).reshape(2, 3)
    normal = np.cross(row, column)
    for one in slices:
        same = np.allclose(np.array(one.ImageOrientationPatient, float), [*row, *column], atol=1e-4)
        if not same or (one.Rows, one.Columns) != (first.Rows, first.Columns):
            raise ValueError(f"got slices of several sizes or directions; expected those of one series. {advice}")
    places = np.array([one.ImagePositionPatient for one in slices], float)
    order = np.argsort(places @ normal, kind="stable")
    places, slices = places[order], [slices[i] for i in order]
    if len(slices) > 1:
        step = (places[-1] - places[0]) / (len(slices) - 1)
        if np.linalg.norm(step) == 0 or np.abs(places - (places[0] + np.outer(np.arange(len(slices)), step))).max() > max(
            _uneven, 0.01 * np.linalg.norm(step)
        ):
            raise ValueError(f"got slices that are not in even steps; expected one at each place. {advice}")
    else:
        step = normal * float(first.get("SpacingBetweenSlices") or first.get("SliceThickness") or 1)
    between_rows, between_columns = (float(length) for length in first.PixelSpacing)
    lps = np.eye(4)
    lps[:3, 0] = row * between_columns
    lps[:3, 1] = column * between_rows
    lps[:3, 2] = step
    lps[:3, 3] = places[0]
    planes = [_rescale(one) for one in slices]
    return np.stack(planes, axis=-1), _to_ras @ lps, None


def _rescale(one: Any) -> np.ndarray:
    """[column, row], as values."""
    pixels = one.pixel_array
    if pixels.ndim != 2:
        raise ValueError("got a picture in colours; expected one number a pixel")
    slope, intercept = float(one.get("RescaleSlope", 1)), float(one.get("RescaleIntercept", 0))
    if slope == 1 and intercept == 0:
        return pixels.T
    values = pixels.astype(np.float64) * slope + intercept
    if slope.is_integer() and intercept.is_integer():
        return values.astype(np.int32).T
    return values.astype(np.float32).T


_names = {"x": "x", "y": "y", "z": "z", "i": "x", "j": "y", "k": "z", "t": "t", "time": "t"}


def _of_xarray(data: Any) -> tuple[np.ndarray, np.ndarray | None, float | None]:
    if not hasattr(data, "dims") or hasattr(data, "data_vars"):
        raise TypeError("got a data set of xarray; expected one of its variables, like data['density']")
    axes = {_names.get(str(name).lower(), "?"): name for name in data.dims}
    if sorted(axes) not in (sorted("xyz"), sorted("xyzt")) or len(axes) != data.ndim:
        raise ValueError(f"got the dimensions {tuple(data.dims)}; expected x, y, z (or i, j, k), and time if there is one")
    order = [axes[name] for name in "xyzt" if name in axes]
    array = np.asarray(data.transpose(*order).data)
    steps = [_steps_of(data, name) for name in order]
    time_step = steps[3][1] if len(steps) == 4 and steps[3] else None
    if all(step is None for step in steps[:3]):
        return array, None, time_step
    affine = np.eye(4)
    for axis, found in enumerate(steps[:3]):
        start, step = found or (0.0, 1.0)
        affine[axis, axis], affine[axis, 3] = step, start
    return array, affine, time_step


def _steps_of(data: Any, name: Any) -> tuple[float, float] | None:
    """Where a coordinate begins, and its step; a time begins at 0 and counts seconds."""
    if name not in data.coords:
        return None
    values = np.asarray(data.coords[name].data)
    if np.issubdtype(values.dtype, np.datetime64):
        values = (values - values[0]) / np.timedelta64(1, "s")
    elif np.issubdtype(values.dtype, np.timedelta64):
        values = values / np.timedelta64(1, "s")
    values = values.astype(float)
    if len(values) == 1:
        return float(values[0]), 1.0
    step = float(values[-1] - values[0]) / (len(values) - 1)
    if step == 0 or not np.allclose(values, values[0] + step * np.arange(len(values)), atol=1e-3 * abs(step)):
        raise ValueError(f"got uneven steps along {name}; expected even ones: interpolate the data first")
    return float(values[0]), step


def _is_tree(data: Any) -> bool:
    return type(data).__name__ == "DataTree" and any(str(name).startswith("sweep") for name in data.children)


def _of_radar(tree: Any) -> VolumeFile:
    """xradar's tree of sweeps, as the CfRadial 2 that xradar writes: values in 32 bits, packed."""
    import xradar

    tree = tree.copy()
    # The writer of xradar 0.12 wants a history, and NetCDF has no truth values.
    tree.attrs.setdefault("history", "")
    for node in tree.subtree:
        for holder in (node, *node.variables.values()):
            for name, value in list(holder.attrs.items()):
                if isinstance(value, (bool, np.bool_)):
                    holder.attrs[name] = int(value)
        for name, variable in node.data_vars.items():
            if variable.ndim == 2 and variable.dtype.kind in "fiu":
                node[name] = variable.astype(np.float32)
                node[name].encoding = {"zlib": True, "complevel": 4, "_FillValue": np.float32(np.nan)}
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "scan.nc"
        xradar.io.to_cfradial2(tree, str(path))
        return VolumeFile("scan.nc", path.read_bytes())
