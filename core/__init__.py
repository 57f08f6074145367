"""The science of tetratrack: arrays in, typed results out; no QGIS, no printing, no global state."""

import os

# QGIS brings a TBB that is too old for numba, which would say so at every start; OpenMP and numba's own threads serve as well
os.environ.setdefault("NUMBA_THREADING_LAYER_PRIORITY", "omp workqueue tbb")
