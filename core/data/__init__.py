"""What the user gives: survey, CRS, tiles, tables of points, trajectories."""
