"""Door for the scripts of users: ``RunOptions``, which the house itself takes from ``core.pipeline.run_options``."""

from .pipeline.run_options import RunOptions

__all__ = ["RunOptions"]
