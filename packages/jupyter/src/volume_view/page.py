"""A page of one file, from the page that lessons of one file have."""

from __future__ import annotations

import base64
import html
import re

#: Stands in the page where the element goes.
PLACE = "<!--volume-view-->"


def write_page(player: str, attributes: dict[str, str], file: bytes, title: str) -> str:
    """player: the page without a volume; file: shown in place of the attribute src, where it is not empty"""
    shown = dict(attributes)
    shown.setdefault("alt", title)
    if file:
        shown["src"] = f"data:application/octet-stream;base64,{base64.b64encode(file).decode()}"
    tag = "".join(f' {name}="{html.escape(value)}"' for name, value in shown.items())
    before, after = player.split(PLACE)
    for name in ("title", "h1"):
        before = re.sub(rf"<{name}>.*?</{name}>", f"<{name}>{html.escape(title)}</{name}>".replace("\\", r"\\"), before, count=1)
    return f"{before}<volume-view{tag}></volume-view>{after}"
