"""tetratrack: displacements of tetrapod armour units from point clouds, as a QGIS plugin and a Python package."""

from typing import Any


def classFactory(iface: Any) -> Any:  # the name QGIS looks for
    """Return the plugin object; QGIS calls this when it loads the plugin."""
    from .plugin.tetratrack_plugin import TetratrackPlugin

    return TetratrackPlugin(iface)
