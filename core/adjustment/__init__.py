"""Gauss-Helmert adjustment of four cones, its covariance and what it can detect (paper 2.3)."""
