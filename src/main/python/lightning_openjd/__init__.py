"""Adaptor of Open Job Description: renders the tasks of a session with one process, which keeps the scene loaded.

Needs ``openjd-adaptor-runtime``. Consecutive frames share what the scene's edits between them leave unchanged.
"""

from .adaptor import ShotAdaptor, frames

__all__ = ["ShotAdaptor", "frames"]
