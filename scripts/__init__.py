"""Console command and batch runs."""
