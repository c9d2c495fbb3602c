"""The kinds of traits that attributes of an element have."""

from __future__ import annotations

from typing import Any

import traitlets


class Flag(traitlets.Bool):
    """An attribute that is there or not."""

    def __init__(self, attribute: str, help: str = "") -> None:
        super().__init__(False, help=help)
        self.tag(sync=True, attribute=attribute)


class Words(traitlets.TraitType):
    """An attribute with a value: a text, a number, or numbers, which are written one after another; None for none."""

    info_text = "a text, a number, a list of numbers, True or None"

    def __init__(self, attribute: str, help: str = "") -> None:
        super().__init__(None, allow_none=True, help=help)
        self.tag(sync=True, attribute=attribute)

    def validate(self, obj: Any, value: Any) -> str | None:
        if value is None or isinstance(value, str):
            return value
        if value is True:
            return ""
        if value is False:
            return None
        if isinstance(value, (int, float)):
            return _number(value)
        try:
            numbers = [float(one) for one in value]
        except (TypeError, ValueError):
            self.error(obj, value)
        return " ".join(map(_number, numbers))


def _number(value: float) -> str:
    return str(int(value)) if float(value).is_integer() and abs(value) < 1e15 else repr(float(value))
