"""Speed of the review dock with 10 000 units: time to open, and from a selection to the repainted window.

Run with QGIS's Python under a display: ``xvfb-run -a .venv-qgis/bin/python benchmarks/performance/review.py [UNITS]``.
"""

from __future__ import annotations

import os
import statistics
import sys
import tempfile
import time
from collections.abc import Callable
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "tests"))
sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "tests/helpers"))

import conftest  # noqa: F401 - makes this checkout importable as tetratrack
import numpy as np
from qgis.core import QgsApplication, QgsCoordinateReferenceSystem, QgsProject
from qgis.gui import QgsMapCanvas
from qgis.PyQt.QtCore import Qt
from qgis.PyQt.QtWidgets import QMainWindow
from synthetic_result import SRS, write_points, write_result

PROCESSOR_SECONDS: list[float] = []
"""Processor time of the main thread per act: what the act takes when nothing else runs."""
OPEN_LIMIT, SELECT_LIMIT = 2.0, 0.1
"""Seconds: what the founders ask for."""


def timed(act: Callable[[], object], application: QgsApplication) -> float:
    """Seconds until an act is done and everything it caused in the main thread is painted."""
    start, worked = time.perf_counter(), time.thread_time()
    act()
    application.processEvents()
    PROCESSOR_SECONDS.append(time.thread_time() - worked)
    return time.perf_counter() - start


def main(count: int) -> int:
    """Print the times; 1 when a limit is exceeded."""
    application = QgsApplication([], True)
    application.initQgis()
    from tetratrack.plugin.review_dock import ReviewDock

    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "result.gpkg"
        units = write_result(path, count)
        write_points(path, units, per_unit=1000)
        window = QMainWindow()
        canvas = QgsMapCanvas(window)
        canvas.setDestinationCrs(QgsCoordinateReferenceSystem(f"EPSG:{SRS}"))
        canvas.enableAntiAliasing(True)
        window.setCentralWidget(canvas)
        dock = ReviewDock(canvas, QgsProject.instance(), window)
        window.addDockWidget(Qt.DockWidgetArea.RightDockWidgetArea, dock)
        window.resize(1920, 1080)
        window.show()
        dock.decisions.reviewer.setText("benchmark")
        application.processEvents()
        opened = timed(lambda: dock.open(path), application)
        again = timed(lambda: dock.open(path), application)
        rng = np.random.default_rng(0)
        names = [row.unit_id for row in dock.store.rows]
        report = {"open, first time": [opened], "open again": [again]}
        for page, tab in enumerate(("views", "series", "numbers", "history")):
            dock.tabs.setCurrentIndex(page)
            chosen = rng.choice(names, 40, replace=False)
            report[f"select, {tab}"] = [timed(lambda unit=unit: dock.store.select([unit]), application) for unit in chosen]
        dock.tabs.setCurrentIndex(0)
        report["next unit"] = [timed(lambda: dock.step(1), application) for _ in range(40)]
        fids = [feature.id() for feature in dock.map.units.getFeatures()]
        report["select on the map"] = [timed(lambda f=f: dock.map.units.selectByIds([int(f)]), application) for f in rng.choice(fids, 40)]
        report["sort"] = [timed(lambda d=d: dock.store.sort("coverage", d), application) for d in (True, False)]
        report["filter"] = [timed(lambda t=t: dock.filters.threshold.setValue(t), application) for t in (5.0, 0.0)]
        report["decide"] = [timed(lambda: dock.decide("accepted"), application) for _ in range(10)]
        load = f", load average {os.getloadavg()[0]:.1f} on {os.cpu_count()} cores" if hasattr(os, "getloadavg") else ""
        print(f"{count} units, {len(dock.store.epochs)} epochs{load}")
        for name, seconds in report.items():
            print(
                f"{name:20s} median {1000 * statistics.median(seconds):7.1f} ms   largest {1000 * max(seconds):7.1f} ms   n {len(seconds)}"
            )
        slow = [name for name, seconds in report.items() if name.startswith("select") and statistics.median(seconds) > SELECT_LIMIT]
        if opened > OPEN_LIMIT:
            slow.append("open")
        later = statistics.median(PROCESSOR_SECONDS[2:])
        print(f"processor time: open {1000 * PROCESSOR_SECONDS[0]:.0f} ms, of all acts after it median {1000 * later:.0f} ms")
        print("over the limit: " + ", ".join(slow) if slow else f"within the limits: open {OPEN_LIMIT} s, select {SELECT_LIMIT} s")
        dock.close()
        window.close()
    return int(bool(slow))


if __name__ == "__main__":
    sys.exit(main(int(sys.argv[1]) if len(sys.argv) > 1 else 10_000))
