"""Door for the scripts of users: ``read_survey``, which the house itself takes from ``core.data.survey_reader``."""

from .data.survey_reader import read_survey

__all__ = ["read_survey"]
