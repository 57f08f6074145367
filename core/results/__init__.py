"""The result file; sqlite3 only, readable inside QGIS."""
