"""Units in a cloud: conic features, whole units, aggregation of points (paper 2.1)."""
