"""Door for the scripts of users: ``Feedback``, which the house itself takes from ``core.common.feedback``."""

from .common.feedback import Feedback

__all__ = ["Feedback"]
