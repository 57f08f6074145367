"""What tracking asks of the points of a few units, as functions of what they hold: whoever has several processes may ask them there."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence
from typing import Any, Protocol

from numpy.typing import NDArray

Answer = Mapping[str, NDArray[Any]]


class Question(Protocol):
    """Holds everything its answer depends on, and survives pickling where its clouds do."""

    def answer(self) -> Answer:
        """Arrays by name."""
        ...


class Ask(Protocol):
    """Answers to questions, in their order.

    ``beside`` is work of the caller's own, done meanwhile where processes answer, and before otherwise.
    """

    def __call__(self, questions: Sequence[Question], beside: Callable[[], None] = lambda: None) -> Iterable[Answer]:
        """Answers, each read or found as it is asked for."""
        ...


def answered_here(questions: Sequence[Question], beside: Callable[[], None] = lambda: None) -> Iterable[Answer]:
    """Answers by this process, one after the other."""
    beside()
    return (question.answer() for question in questions)
