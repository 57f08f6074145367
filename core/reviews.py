"""Door for the scripts of users: ``decide`` and ``undo``, which the house itself takes from ``core.review.decisions``."""

from .review.decisions import decide, undo

__all__ = ["decide", "undo"]
