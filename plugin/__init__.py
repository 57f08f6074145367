"""What lives inside the QGIS window: provider, review dock, styles, dependency check."""
