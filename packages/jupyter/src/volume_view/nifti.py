"""Writes NIfTI-1: only the numbers, their place, and steps of time."""

from __future__ import annotations

import numpy as np

#: Types that NIfTI-1 has, by NumPy's names. Source: nifti1.h
CODES = {
    "uint8": 2,
    "int16": 4,
    "int32": 8,
    "float32": 16,
    "float64": 64,
    "int8": 256,
    "uint16": 512,
    "uint32": 768,
    "int64": 1024,
    "uint64": 1280,
}

#: The largest number of voxels along an axis that the header can hold.
LONGEST = 32767

#: Bytes before the numbers.
OFFSET = 352

_header = np.dtype(
    [
        ("sizeof_hdr", "<i4"),
        ("unused", "S36"),
        ("dim", "<i2", 8),
        ("intent", "V14"),
        ("datatype", "<i2"),
        ("bitpix", "<i2"),
        ("slice_start", "<i2"),
        ("pixdim", "<f4", 8),
        ("vox_offset", "<f4"),
        ("scl_slope", "<f4"),
        ("scl_inter", "<f4"),
        ("slice_end", "<i2"),
        ("slice_code", "u1"),
        ("xyzt_units", "u1"),
        ("times_and_texts", "V128"),
        ("qform_code", "<i2"),
        ("sform_code", "<i2"),
        ("quatern", "<f4", 6),
        ("srow", "<f4", (3, 4)),
        ("intent_name", "S16"),
        ("magic", "S4"),
    ]
)
assert _header.itemsize == 348


def write_nifti(
    array: np.ndarray,
    affine: np.ndarray | None = None,
    spacing: tuple[float, float, float] = (1, 1, 1),
    time_step: float = 0,
) -> bytes:
    """A NIfTI-1 file.

    array: [i, j, k] or [i, j, k, time]
    affine: 4 x 4, from indices to mm to the right, front and head; None where nothing is known of the directions
    spacing: mm, where there is no affine
    time_step: seconds
    """
    if array.ndim not in (3, 4) or 0 in array.shape:
        raise ValueError(f"got an array of shape {array.shape}; expected [i, j, k] or [i, j, k, time]")
    if max(array.shape) > LONGEST:
        raise ValueError(f"got an array of shape {array.shape}; expected at most {LONGEST} along each axis")
    array = _storable(array)
    header = np.zeros((), _header)
    header["sizeof_hdr"] = 348
    header["dim"] = [array.ndim, *array.shape, *[1] * (7 - array.ndim)]
    header["datatype"] = CODES[array.dtype.name]
    header["bitpix"] = 8 * array.dtype.itemsize
    header["vox_offset"] = OFFSET
    header["scl_slope"] = 1
    header["xyzt_units"] = 2 | 8  # mm and s
    steps = spacing if affine is None else np.linalg.norm(np.asarray(affine)[:3, :3], axis=0)
    header["pixdim"] = [1, *steps, time_step, 0, 0, 0]
    if affine is not None:
        header["sform_code"] = 2
        header["srow"] = np.asarray(affine, float)[:3]
    header["magic"] = b"n+1"
    return header.tobytes() + bytes(OFFSET - 348) + array.tobytes(order="F")


def _storable(array: np.ndarray) -> np.ndarray:
    if array.dtype == bool:
        return array.astype(np.uint8)
    if array.dtype == np.float16:
        return array.astype(np.float32)
    if array.dtype.name not in CODES:
        raise TypeError(f"got an array of {array.dtype}; expected whole numbers or floats")
    return array.astype(array.dtype.newbyteorder("<"), copy=False)
