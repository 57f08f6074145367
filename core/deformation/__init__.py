"""Epochs compared: identity, joint adjustment, congruence, displacements."""
