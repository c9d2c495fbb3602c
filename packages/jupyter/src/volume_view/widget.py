"""The widget."""

from __future__ import annotations

import base64
import json
from pathlib import Path
from typing import Any, Callable

import anywidget
import traitlets

from .attributes import Attributes
from .convert import VolumeFile, to_file
from .page import write_page
from .png import draw_slices

_here = Path(__file__).parent


class VolumeView(Attributes, anywidget.AnyWidget):
    """Shows a volume.

    data: an array of NumPy or xarray, an image of nibabel or SimpleITK, data sets of pydicom, a tree of xradar, a path or bytes of a file
    affine: 4 x 4, from indices to mm to the right, front and head, in place of what the data say
    spacing: three lengths along i, j and k
    axes: what the axes of a NumPy array are, like "zyx"; "xyz" if it is not said
    Attributes of the element are traits: `VolumeView(data, transfer_function="ct-bone", camera_orbit="30deg 70deg 90%")`.
    """

    _esm = _here / "widget.js"

    #: The volume as a file, and its name's ending.
    _file = traitlets.Bytes(b"").tag(sync=True)
    _name = traitlets.Unicode("").tag(sync=True)

    #: The element's attribute that each trait is.
    _attributes_of = traitlets.Dict().tag(sync=True)

    #: What was clicked last, where `pickable` is set: see VolumePick in the element's reference.
    pick = traitlets.Dict(None, allow_none=True, read_only=True).tag(sync=True)
    #: Where the camera is now: `camera_orbit`, `camera_target` and `field_of_view`, as texts.
    camera = traitlets.Dict({}, read_only=True).tag(sync=True)
    #: What the element says of the volume: its format, unit, size, and what of the file is not shown.
    volume = traitlets.Dict(None, allow_none=True, read_only=True).tag(sync=True)
    #: Why there is no picture, in words.
    error = traitlets.Unicode(None, allow_none=True, read_only=True).tag(sync=True)
    #: The last picture, a PNG; empty before the first.
    picture = traitlets.Bytes(b"", read_only=True).tag(sync=True, from_json=lambda value, _widget: bytes(value or b""))

    def __init__(self, data: Any = None, affine: Any = None, spacing: Any = None, *, axes: str | None = None, **attributes: Any) -> None:
        self._data: VolumeFile | None = None
        if data is not None:
            # The element's own attribute spacing is for mosaic images.
            self._data = to_file(data, affine, spacing, axes)
        elif affine is not None or axes is not None:
            raise ValueError("got an affine or axes without data")
        elif spacing is not None:
            attributes["spacing"] = spacing
        super().__init__(**attributes)
        self._attributes_of = {
            name: trait.metadata["attribute"] for name, trait in self.traits().items() if "attribute" in trait.metadata
        }
        if self._data:
            self._name, self._file = self._data.name, self._data.bytes
        self.on_msg(self._answer)

    def on_pick(self, callback: Callable[[dict | None], None]) -> None:
        """Calls back with each place that is clicked; needs `pickable=True`."""
        self.observe(lambda change: callback(change.new), "pick")

    def to_html(self, path: str | Path | None = None, title: str = "Volume") -> str:
        """One page with everything inside, which needs no network; also written to `path`.

        Raises ValueError where the data are a DICOM file, which has a patient's name.
        """
        if self._file and self._file[128:132] == b"DICM":
            raise ValueError("got a DICOM file, which has the name of a patient inside; give VolumeView what pydicom or SimpleITK read of it")
        text = write_page((_here / "static/player.html").read_text("utf-8"), self._attributes(), self._file, title)
        if path is not None:
            Path(path).write_text(text, "utf-8")
        return text

    def _attributes(self) -> dict[str, str]:
        """The element's attributes that are set."""
        found: dict[str, str] = {}
        for name, trait in self.traits().items():
            attribute, value = trait.metadata.get("attribute"), getattr(self, name)
            if attribute and value is not None and value is not False:
                found[attribute] = "" if value is True else value
        return found

    def _answer(self, _widget: Any, content: Any, _buffers: Any) -> None:
        if content == {"ask": "player"}:
            # Once a page: it is the same for all widgets.
            self.send({"player": 1}, [(_here / "static/player.html").read_bytes()])

    def _repr_mimebundle_(self, **kwargs: Any) -> Any:
        bundle = super()._repr_mimebundle_(**kwargs)
        picture = self.picture
        if not picture and self._data and self._data.array is not None:
            picture = draw_slices(self._data.array, self._data.spacing)
        if bundle and picture:
            first = bundle[0] if isinstance(bundle, tuple) else bundle
            first["image/png"] = base64.b64encode(picture).decode()
        return bundle
