"""Where a step says how far it is, and hears that it is to end."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace

from .errors import Cancelled


@dataclass(frozen=True)
class Feedback:
    """Where a step's messages go, and who may end it.

    Attributes
    ----------
    progress
        Share done, 0 to 1, and what is being done.
    info, warning
        One sentence for the log.
    is_cancelled
        Asked often; True ends the run with :class:`Cancelled`.
    """

    progress: Callable[[float, str], None] = lambda fraction, message: None
    info: Callable[[str], None] = lambda message: None
    warning: Callable[[str], None] = lambda message: None
    is_cancelled: Callable[[], bool] = lambda: False

    def part(self, first: float, last: float) -> Feedback:
        """Feedback whose progress fills only a part of this one's."""
        return replace(self, progress=lambda fraction, message: self.progress(first + (last - first) * fraction, message))

    def check(self) -> None:
        """End here if the user wants it."""
        if self.is_cancelled():
            raise Cancelled("cancelled")
