"""A still picture of a volume, for notebooks whose widgets do not run: its three middle slices, in grey."""

from __future__ import annotations

import struct
import zlib

import numpy as np

#: Pixels of the longest edge of a slice, and between two slices.
LONGEST, GAP = 256, 4


def draw_slices(array: np.ndarray, spacing: tuple[float, float, float]) -> bytes:
    """A PNG. array: [i, j, k]; spacing: mm along these"""
    middle = [length // 2 for length in array.shape]
    planes = [
        (array[:, :, middle[2]], spacing[0], spacing[1]),
        (array[:, middle[1], :], spacing[0], spacing[2]),
        (array[middle[0], :, :], spacing[1], spacing[2]),
    ]
    values = np.concatenate([np.asarray(plane, float).ravel() for plane, *_ in planes])
    values = values[np.isfinite(values)]
    low, high = np.percentile(values, [1, 99.5]) if len(values) else (0.0, 1.0)
    if not high > low:
        low, high = (values.min(), values.max()) if len(values) else (0.0, 1.0)
    span = high - low if high > low else 1.0
    longest = max(length * edge for length, edge in zip(array.shape, spacing)) or 1.0
    pictures = [_scale(plane, across, down, LONGEST / longest) for plane, across, down in planes]
    height = max(picture.shape[0] for picture in pictures)
    row = []
    for picture in pictures:
        grey = np.zeros((height, picture.shape[1]), np.uint8)
        grey[: picture.shape[0]] = np.clip(np.nan_to_num((picture - low) / span), 0, 1) * 255
        row += [grey, np.zeros((height, GAP), np.uint8)]
    return write_png(np.concatenate(row[:-1], axis=1))


def _scale(plane: np.ndarray, across: float, down: float, pixels: float) -> np.ndarray:
    """Nearest voxels; the first axis goes to the right, and the second one up."""
    width = max(1, round(plane.shape[0] * across * pixels))
    height = max(1, round(plane.shape[1] * down * pixels))
    columns = np.arange(width) * plane.shape[0] // width
    rows = np.arange(height) * plane.shape[1] // height
    return np.asarray(plane, float)[columns][:, rows[::-1]].T


def write_png(grey: np.ndarray) -> bytes:
    """grey: [row, column], 8 bits. Source: PNG specification, third edition"""

    def chunk(name: bytes, body: bytes) -> bytes:
        return struct.pack(">I", len(body)) + name + body + struct.pack(">I", zlib.crc32(name + body))

    height, width = grey.shape
    lines = np.concatenate([np.zeros((height, 1), np.uint8), grey], axis=1).tobytes()
    head = struct.pack(">IIBBBBB", width, height, 8, 0, 0, 0, 0)
    return b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", head) + chunk(b"IDAT", zlib.compress(lines)) + chunk(b"IEND", b"")
