"""The science of tetratrack: arrays in, typed results out; no QGIS, no printing, no global state."""
