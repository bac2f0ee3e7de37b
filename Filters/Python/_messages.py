"""Errors, warnings and the logger of the package."""
from __future__ import annotations

import logging
import re
import sys
import warnings
from typing import Any, List, Optional

logger = logging.getLogger("anisotropic_remeshing")

# What VTK puts before a message: the kind, the place in the source, the object.
_ORIGIN = re.compile(r"^\w[\w ]*: In [^\n]*, line \d+\n(?:\w+ \([^\n)]*\): )?", re.IGNORECASE)
_NO_MEMORY = "There is not enough memory"


class RemeshingError(ValueError):
    """The surface or an argument cannot be used. The text is the filter's own sentence."""


class RemeshingStopped(RuntimeError):
    """The callable given as `progress` returned False."""


class RemeshingWarning(UserWarning):
    """A result is not all that was asked for. The text is the filter's own sentence."""


def plain_text(message: str) -> str:
    """A message of VTK without its origin."""
    return _ORIGIN.sub("", message).strip()


class Messages:
    """What a VTK object and its executive tell while this is entered, instead of in red."""

    def __init__(self, *objects: Any) -> None:
        self.errors: List[str] = []
        self.warnings: List[str] = []
        self.failed = False  # as executives tell it, without a reason
        self._objects = objects
        self._tags: List[Any] = []

    def __enter__(self) -> Messages:
        def note_error(_caller: Any, _event: str, text: str) -> None:
            if "returned failure for request" in text:
                self.failed = True
            else:
                self.errors.append(plain_text(text))

        def note_warning(_caller: Any, _event: str, text: str) -> None:
            self.warnings.append(plain_text(text))

        for event, note in (("ErrorEvent", note_error), ("WarningEvent", note_warning)):
            note.CallDataType = "string0"  # type: ignore[attr-defined]
            for told in self._objects:
                self._tags.append((told, told.AddObserver(event, note)))
        return self

    def __exit__(self, *_: Any) -> None:
        for told, tag in self._tags:
            told.RemoveObserver(tag)
        self._tags.clear()

    def tell(self) -> None:
        """Raises the first error; else the warnings become Python's, at the caller's line."""
        if self.errors or self.failed:
            error = (self.errors or ["The filter failed without a message."])[0]
            raise MemoryError(error) if error.startswith(_NO_MEMORY) else RemeshingError(error)
        for text in self.warnings:
            logger.info("warning: %s", text)
            warnings.warn(text, RemeshingWarning, stacklevel=_level_of_caller())


def _level_of_caller() -> int:
    """The level, for warnings.warn() in the function that calls this, of code outside."""
    level = 1
    frame: Optional[Any] = sys._getframe(1)
    while frame is not None and frame.f_globals.get("__name__", "").startswith(
        __name__.partition(".")[0] + "."
    ):
        frame = frame.f_back
        level += 1
    return level
