"""Door for the scripts of users: ``read_survey``, which the house itself takes from ``core.data.survey``."""

from .data.survey import read_survey

__all__ = ["read_survey"]
