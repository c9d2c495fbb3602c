"""Values and places of each kind of data, against nibabel and SimpleITK."""

import tempfile
import unittest
from pathlib import Path

import numpy as np

from volume_view.convert import to_file

try:
    import nibabel
except ImportError:
    nibabel = None
try:
    import SimpleITK
except ImportError:
    SimpleITK = None
try:
    import pydicom
except ImportError:
    pydicom = None
try:
    import xarray
except ImportError:
    xarray = None

#: A turned, sheared and scaled affine whose axes are all different.
AFFINE = np.array([[1.9, -0.3, 0.2, -40], [0.4, 2.1, -0.5, 25], [0.1, 0.6, 3.2, -7], [0, 0, 0, 1]])


def numbers(shape=(4, 5, 6), dtype=np.int16):
    return (np.arange(np.prod(shape)).reshape(shape) * 7 % 251 - 60).astype(dtype)


def read(file):
    return nibabel.Nifti1Image.from_bytes(file.bytes)


@unittest.skipIf(nibabel is None, "nibabel is not installed")
class Converted(unittest.TestCase):
    def same(self, file, array, affine):
        image = read(file)
        np.testing.assert_array_equal(np.asanyarray(image.dataobj), array)
        np.testing.assert_allclose(image.affine, affine, atol=1e-4)

    def test_numpy_of_every_type(self):
        for name in "uint8 int8 uint16 int16 uint32 int32 uint64 int64 float32 float64".split():
            array = np.abs(numbers()).astype(name)
            self.same(to_file(array, affine=AFFINE), array, AFFINE)
            self.assertEqual(read(to_file(array)).get_data_dtype(), np.dtype(name))
        self.same(to_file(numbers() > 0, AFFINE), (numbers() > 0).astype(np.uint8), AFFINE)
        self.same(to_file(numbers().astype(">i2"), AFFINE), numbers(), AFFINE)
        self.same(to_file(numbers().astype(np.float16), AFFINE), numbers().astype(np.float32), AFFINE)
        self.same(to_file(np.asfortranarray(numbers())[::-1], AFFINE), numbers()[::-1], AFFINE)

    def test_without_a_place_nothing_is_said_of_directions(self):
        header = read(to_file(numbers(), spacing=(1, 2, 3))).header
        self.assertEqual((int(header["sform_code"]), int(header["qform_code"])), (0, 0))
        np.testing.assert_allclose(header.get_zooms(), (1, 2, 3))

    def test_axes_of_an_array(self):
        self.same(to_file(numbers(), AFFINE, axes="zyx"), numbers().transpose(2, 1, 0), AFFINE)
        self.same(to_file(numbers((2, 3, 4, 5)), AFFINE, axes="tzyx"), numbers((2, 3, 4, 5)).transpose(3, 2, 1, 0), AFFINE)
        for axes in ("xyy", "zy", "abc"):
            with self.assertRaisesRegex(ValueError, "expected x, y, z"):
                to_file(numbers(), axes=axes)

    def test_nibabel_with_its_scale(self):
        image = nibabel.Nifti1Image(numbers(), AFFINE)
        image.header.set_slope_inter(0.5, -3)
        again = nibabel.Nifti1Image.from_bytes(image.to_bytes())
        self.same(to_file(again), np.asanyarray(again.dataobj), AFFINE)
        self.assertNotIn(b"name", to_file(nibabel.Nifti1Image(numbers(), AFFINE)).bytes[148:348])

    def test_spacing_takes_the_place_of_the_own_one(self):
        file = to_file(nibabel.Nifti1Image(numbers(), AFFINE), spacing=(1, 1, 1))
        found = read(file).affine
        np.testing.assert_allclose(np.linalg.norm(found[:3, :3], axis=0), 1, atol=1e-5)
        np.testing.assert_allclose(found[:3, 3], AFFINE[:3, 3])

    def test_refused_in_words(self):
        for data, options, words in [
            (numbers((3, 4)), {}, "expected \\[i, j, k\\]"),
            (numbers().astype(complex), {}, "whole numbers or floats"),
            (numbers(), {"affine": np.zeros((4, 4))}, "can be inverted"),
            (numbers(), {"affine": AFFINE, "spacing": (1, 1, 1)}, "expected one of them"),
            (numbers(), {"spacing": (1, 0, 1)}, "above 0"),
            ("x.nii", {"affine": AFFINE}, "a file says its own place"),
        ]:
            with self.assertRaisesRegex((ValueError, TypeError), words):
                to_file(data, **options)

    @unittest.skipIf(SimpleITK is None, "SimpleITK is not installed")
    def test_simpleitk_is_where_it_says(self):
        image = SimpleITK.GetImageFromArray(numbers((6, 5, 4)))
        image.SetSpacing((0.7, 1.1, 2.5))
        image.SetOrigin((10, -20, 30))
        turn = np.linalg.qr(np.array([[1, 0.2, 0], [-0.3, 1, 0.1], [0, 0.2, 1.0]]))[0]
        image.SetDirection(turn.ravel())
        found = read(to_file(image))
        array = np.asanyarray(found.dataobj)
        self.assertEqual(array.shape, image.GetSize())
        for index in [(0, 0, 0), (3, 0, 0), (0, 4, 0), (0, 0, 5), (3, 2, 1)]:
            left, back, up = image.TransformIndexToPhysicalPoint(index)
            np.testing.assert_allclose((found.affine @ [*index, 1])[:3], [-left, -back, up], atol=1e-4)
            self.assertEqual(array[index], image[index])
        # As SimpleITK itself writes it.
        with tempfile.TemporaryDirectory() as folder:
            SimpleITK.WriteImage(image, f"{folder}/a.nii")
            np.testing.assert_allclose(nibabel.load(f"{folder}/a.nii").affine, found.affine, atol=1e-4)
        with self.assertRaisesRegex(ValueError, "several numbers"):
            to_file(SimpleITK.Image(2, 2, 2, SimpleITK.sitkVectorUInt8))

    @unittest.skipIf(pydicom is None or SimpleITK is None, "pydicom or SimpleITK is not installed")
    def test_pydicom_is_where_simpleitk_has_it(self):
        with tempfile.TemporaryDirectory() as folder:
            paths = write_series(Path(folder))
            reader = SimpleITK.ImageSeriesReader()
            reader.SetFileNames([str(path) for path in paths])
            image = reader.Execute()
            series = [pydicom.dcmread(path) for path in paths]
            file = to_file([series[2], series[0], series[3], series[1]])
            found, wanted = read(file), read(to_file(image))
            np.testing.assert_array_equal(np.asanyarray(found.dataobj), np.asanyarray(wanted.dataobj))
            np.testing.assert_allclose(found.affine, wanted.affine, atol=1e-3)
            self.assertNotIn(b"Geheim", file.bytes)
            one = read(to_file(series[0]))
            self.assertEqual(one.shape, (5, 6, 1))
            with self.assertRaisesRegex(ValueError, "even steps"):
                to_file([series[0], series[1], series[3]])

    @unittest.skipIf(xarray is None, "xarray is not installed")
    def test_xarray_by_its_names(self):
        coords = {"z": 5 + 2.5 * np.arange(4), "y": 10 - 0.5 * np.arange(5), "x": np.arange(6) * 3.0}
        data = xarray.DataArray(numbers(), dims=("z", "y", "x"), coords=coords)
        affine = np.array([[3, 0, 0, 0], [0, -0.5, 0, 10], [0, 0, 2.5, 5], [0, 0, 0, 1]])
        self.same(to_file(data), numbers().transpose(2, 1, 0), affine)
        times = np.datetime64("2020-01-01") + np.arange(2) * np.timedelta64(90, "s")
        series = xarray.concat([data, data + 1], dim=xarray.DataArray(times, dims="time", name="time"))
        found = read(to_file(series))
        self.assertEqual((found.shape, float(found.header["pixdim"][4])), ((6, 5, 4, 2), 90))
        self.assertEqual(int(read(to_file(data.drop_vars(list("xyz")))).header["sform_code"]), 0)
        with self.assertRaisesRegex(ValueError, "expected x, y, z"):
            to_file(data.rename(z="height"))
        with self.assertRaisesRegex(ValueError, "uneven steps along z"):
            to_file(data.assign_coords(z=[0, 1, 2, 4]))


def write_series(folder):
    """Four slices of a tilted plane, with a scale and the name of a patient."""
    from pydicom.dataset import FileDataset, FileMetaDataset
    from pydicom.uid import CTImageStorage, ExplicitVRLittleEndian, generate_uid

    row, column = np.array([0.8, 0.6, 0]), np.array([0, 0, -1.0])
    normal = np.cross(row, column)
    frame, series = generate_uid(), generate_uid()
    paths = []
    for k in range(4):
        meta = FileMetaDataset()
        meta.MediaStorageSOPClassUID, meta.TransferSyntaxUID = CTImageStorage, ExplicitVRLittleEndian
        meta.MediaStorageSOPInstanceUID = generate_uid()
        one = FileDataset(None, {}, file_meta=meta, preamble=bytes(128))
        one.SOPClassUID, one.SOPInstanceUID = CTImageStorage, meta.MediaStorageSOPInstanceUID
        one.SeriesInstanceUID, one.FrameOfReferenceUID, one.Modality = series, frame, "CT"
        one.PatientName = "Geheim^Name"
        one.Rows, one.Columns, one.BitsAllocated, one.BitsStored, one.HighBit = 6, 5, 16, 16, 15
        one.PixelRepresentation, one.SamplesPerPixel, one.PhotometricInterpretation = 1, 1, "MONOCHROME2"
        one.PixelSpacing, one.SliceThickness = [0.5, 0.75], 2
        one.ImageOrientationPatient = [*row, *column]
        one.ImagePositionPatient = [round(float(x), 6) for x in np.array([-10, 20, 30]) + 2 * k * normal]
        one.RescaleSlope, one.RescaleIntercept = 2, -1024
        one.PixelData = (numbers((6, 5)) + 11 * k).astype("<i2").tobytes()
        path = folder / f"{k}.dcm"
        one.save_as(path, enforce_file_format=True)
        paths.append(path)
    return paths


if __name__ == "__main__":
    unittest.main()
