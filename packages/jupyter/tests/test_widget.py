"""The widget without a page: its traits, its page of one file, and what a notebook keeps."""

import base64
import html
import re
import struct
import unittest
import zlib
from pathlib import Path

import numpy as np

try:
    import anywidget
except ImportError:
    anywidget = None
else:
    from volume_view import VolumeView

BALL = (np.hypot(np.hypot(*np.mgrid[-4:5, -5:6]), 0)[..., None] < np.arange(7)).astype(np.float32)
STATIC = Path(__file__).parent.parent / "src/volume_view/static/player.html"


@unittest.skipIf(anywidget is None, "anywidget is not installed")
class Widget(unittest.TestCase):
    def test_each_attribute_is_a_trait(self):
        view = VolumeView(BALL, transfer_function="ct-bone", camera_target=[1, 2.5, -3], opacity_factor=2, pickable=True, rings=True)
        self.assertEqual(
            view._attributes(),
            {"transfer-function": "ct-bone", "camera-target": "1 2.5 -3", "opacity-factor": "2", "pickable": "", "rings": ""},
        )
        view.camera_orbit = "30deg 70deg 90%"
        view.rings = False
        self.assertEqual(view._attributes()["camera-orbit"], "30deg 70deg 90%")
        self.assertNotIn("rings", view._attributes())
        self.assertEqual(view._attributes_of["value_window"], "value-window")
        with self.assertRaisesRegex(Exception, "a list of numbers"):
            view.value_window = {"a": 1}

    def test_data_are_bytes_and_nothing_of_them_is_json(self):
        state = VolumeView(BALL, spacing=(1, 1, 2)).get_state()
        self.assertIsInstance(state["_file"], bytes)
        self.assertEqual(len(state["_file"]), 352 + 4 * BALL.size)
        self.assertIsNone(state["spacing"])
        self.assertEqual(VolumeView(src="a.nii", spacing=(1, 1, 2)).spacing, "1 1 2")

    def test_a_pick_calls_back(self):
        view, got = VolumeView(BALL), []
        view.on_pick(got.append)
        view.set_state({"pick": {"value": 3}})
        self.assertEqual(got, [{"value": 3}])

    def test_a_notebook_keeps_a_picture(self):
        data, _ = VolumeView(BALL)._repr_mimebundle_()
        self.assertIn("application/vnd.jupyter.widget-view+json", data)
        png = base64.b64decode(data["image/png"])
        width, height = struct.unpack(">II", png[16:24])
        rows = np.frombuffer(zlib.decompress(png[png.index(b"IDAT") + 4 : -16]), np.uint8).reshape(height, width + 1)[:, 1:]
        # The middle slice along k, seen with i to the right and j up, is the disk of BALL.
        disk = rows[:, : round(256 * 9 / 11)] > 127
        self.assertAlmostEqual(float(disk.mean()), float(BALL[:, :, 3].mean()), delta=0.02)
        view = VolumeView(BALL)
        view.set_state({"picture": b"own"})
        self.assertEqual(base64.b64decode(view._repr_mimebundle_()[0]["image/png"]), b"own")

    @unittest.skipUnless(STATIC.exists(), "the player is not built: node scripts/build-jupyter.mjs")
    def test_a_page_of_one_file(self):
        view = VolumeView(BALL, alt='A "ball" <b>', look="soft")
        text = view.to_html(title="Ball & <more>")
        [tag] = re.findall(r"<volume-view [^>]*>", text)
        self.assertIn('look="soft"', tag)
        self.assertIn('alt="A &quot;ball&quot; &lt;b&gt;"', tag)
        self.assertEqual(base64.b64decode(re.search(r'base64,([^"]*)"', tag)[1]), view._file)
        self.assertIn(f"<title>{html.escape('Ball & <more>')}</title>", text)
        self.assertEqual(re.findall(r'(?:src|href)="https?:', text[: text.index("data-x3dom")]), [])
        with self.assertRaisesRegex(ValueError, "name of a patient"):
            VolumeView(bytes(128) + b"DICM").to_html()


if __name__ == "__main__":
    unittest.main()
