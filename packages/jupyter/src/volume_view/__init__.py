"""Volumes in notebooks."""

from .widget import VolumeView

__all__ = ["VolumeView"]
