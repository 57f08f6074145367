"""Door for the scripts of users: ``epoch_pairs``, which the house itself takes from ``core.results.geopackage_reader``."""

from .results.geopackage_reader import epoch_pairs

__all__ = ["epoch_pairs"]
