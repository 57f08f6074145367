"""How right results are: units, gaps, registration, relocations, against ground truth."""
