"""Frames and datum: control, stable areas, views."""
