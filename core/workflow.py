"""Door for the scripts of users: ``run_survey``, which the house itself takes from ``core.pipeline.whole_survey``."""

from .pipeline.whole_survey import run_survey

__all__ = ["run_survey"]
