"""Progress of a run: a bar, a line, or the user's callable, which may stop it."""
from __future__ import annotations

import sys
from typing import Any, Callable, Optional, Union

from ._messages import RemeshingStopped

#: None or False: nothing; True: a bar or a line; callable(fraction, phase): False stops the run
Progress = Union[None, bool, Callable[[float, str], Any]]


class _Bar:
    """tqdm's bar, in percent."""

    def __init__(self, make: Any) -> None:
        self._bar = make(
            total=100, desc="Remeshing", bar_format="{desc}: {percentage:3.0f}%|{bar}| {elapsed}"
        )

    def __call__(self, fraction: float, phase: str) -> None:
        self._bar.set_description_str(phase or "Remeshing", refresh=False)
        self._bar.update(round(100.0 * fraction) - self._bar.n)

    def close(self) -> None:
        self._bar.close()


class _Line:
    """One line of standard error that is written over; a line for each phase in a file."""

    def __init__(self) -> None:
        self._rewrites = sys.stderr.isatty()
        self._last = ""

    def __call__(self, fraction: float, phase: str) -> None:
        text = f"{100.0 * fraction:3.0f} % {phase}" if self._rewrites else phase
        if text == self._last:
            return
        self._last = text
        print(f"\r{text:<40}" if self._rewrites else text, end="" if self._rewrites else "\n",
              file=sys.stderr, flush=True)

    def close(self) -> None:
        if self._rewrites and self._last:
            print(file=sys.stderr)


def _show() -> Any:
    try:
        from tqdm.auto import tqdm
    except ImportError:
        return _Line()
    return _Bar(tqdm)


class Reporter:
    """While it is entered, it tells of an algorithm's progress; what is raised stops the run."""

    def __init__(self, algorithm: Any, progress: Progress) -> None:
        if progress is not None and not isinstance(progress, bool) and not callable(progress):
            raise TypeError("progress must be True, False or a callable (fraction, phase).")
        self._algorithm = algorithm
        self._progress = progress
        self._shown: Any = None
        self._tag: Optional[int] = None
        self.error: Optional[BaseException] = None

    def __enter__(self) -> Reporter:
        if self._progress is True:
            self._shown = _show()
        if self._progress:
            self._tag = self._algorithm.AddObserver("ProgressEvent", self._report)
        return self

    def __exit__(self, *_: Any) -> None:
        if self._tag is not None:
            self._algorithm.RemoveObserver(self._tag)
        if self._shown is not None:
            self._shown.close()

    def _report(self, algorithm: Any, _event: str) -> None:
        if self.error is not None:
            return
        call: Any = self._shown or self._progress
        try:
            if call(algorithm.GetProgress(), algorithm.GetProgressText() or "") is False:
                raise RemeshingStopped("The run was stopped by the progress callable.")
        except BaseException as error:  # raised again when the run has ended
            self.error = error
            algorithm.AbortExecuteOn()
