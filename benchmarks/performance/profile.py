"""Where the time of a whole run goes, by step and by kernel: processor seconds of one worker, each without what it calls further down.

    python benchmarks/performance/profile.py SURVEY...

Functions are timed where they are looked up, so that an import of the same function elsewhere is timed as well. A run before each compiles
and fills the memory of tiles; that memory is emptied again, since a first look through the tiles is part of a run.
"""

from __future__ import annotations

import argparse
import os
import sys
import tempfile
import time
from collections import defaultdict
from collections.abc import Callable
from functools import wraps
from pathlib import Path
from typing import Any

os.environ.setdefault("OMP_NUM_THREADS", "1")

from tetratrack.core.common.feedback import Feedback
from tetratrack.core.common.kernels import threads_of_kernels
from tetratrack.core.data.survey_reader import read_survey
from tetratrack.core.pipeline.run_options import RunOptions
from tetratrack.core.pipeline.whole_survey import run_survey

STEPS = {
    "check and look through tiles": ("pipeline.epoch_plans.plan_survey",),
    "size of the units": ("pipeline.size_check.check_sizes",),
    "read blocks": ("data.tiles.read_points",),
    "surface elements": ("segmentation.surface_elements.surface_elements", "segmentation.surface_elements.surface_noise"),
    "legs": ("segmentation.conic_ransac.find_legs",),
    "poses from legs": ("segmentation.assembly.poses_from_pairs", "segmentation.assembly.poses_from_single_legs"),
    "refinement": ("segmentation.pose_refinement.refine",),
    "evidence": ("segmentation.pose_evidence.evidence",),
    "selection": ("segmentation.verification.select",),
    "twists": ("segmentation.twist.settle_twists",),
    "points to units": ("segmentation.aggregation.assign", "segmentation.aggregation.contested"),
    "ends of legs": ("segmentation.leg_ends.leg_ends", "segmentation.sight_lines.SightLines"),
    "adjustment, linearisation": ("adjustment.cone_conditions.linearise_points",),
    "adjustment, correlation": ("adjustment.residual_correlation.correlated_part",),
    "adjustment, all else": ("adjustment.gauss_helmert.adjust",),
    "units over epochs": ("pipeline.epoch_tracking.track_tables",),
    "gaps": ("pipeline.gap_table.look_into_tiles",),
    "writing": ("results.geopackage_writer.write_result",),
}
"""Functions by step."""


class Clock:
    """Processor seconds and calls by name, those of functions called meanwhile taken out."""

    def __init__(self) -> None:
        self.seconds: dict[str, float] = defaultdict(float)
        self.calls: dict[str, int] = defaultdict(int)
        self._inner = [0.0]

    def timed(self, name: str, function: Callable[..., Any]) -> Callable[..., Any]:
        """The function, with its time added up under a name."""

        @wraps(function, updated=())
        def measured(*arguments: Any, **options: Any) -> Any:
            start = time.process_time()
            self._inner.append(0.0)
            try:
                return function(*arguments, **options)
            finally:
                spent = time.process_time() - start
                self.seconds[name] += spent - self._inner.pop()
                self._inner[-1] += spent
                self.calls[name] += 1

        return measured

    def listen(self) -> None:
        """Put timed functions in place of those of ``STEPS`` in all modules that are loaded."""
        for name, paths in STEPS.items():
            for path in paths:
                module, _, function = path.rpartition(".")
                original = getattr(sys.modules[f"tetratrack.core.{module}"], function)
                measured = self.timed(name, original)
                for other in [m for key, m in sys.modules.items() if key.startswith("tetratrack.core.")]:
                    if getattr(other, function, None) is original:
                        setattr(other, function, measured)


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("surveys", nargs="+", type=Path, metavar="SURVEY")
    options = parser.parse_args()
    shares: dict[str, list[str]] = {name: [] for name in (*STEPS, "all else", "CPU s")}
    clock = None
    for folder in options.surveys:
        survey = read_survey(folder / "survey.toml")
        with tempfile.TemporaryDirectory() as name, threads_of_kernels(1):
            # loads every module and every kernel
            run_survey(survey, Path(name) / "first.gpkg", RunOptions(workers=1), Feedback())
            if clock is None:
                clock = Clock()
                clock.listen()
            os.environ["XDG_CACHE_HOME"] = name
            sys.modules["tetratrack.core.common.user_cache"].cache_folder.cache_clear()
            sys.modules["tetratrack.core.data.scan_cache"].scans_folder.cache_clear()
            clock.seconds.clear()
            start = time.process_time()
            run_survey(survey, Path(name) / "result.gpkg", RunOptions(workers=1), Feedback())
            total = time.process_time() - start
        for step in STEPS:
            shares[step].append(f"{100 * clock.seconds[step] / total:.1f} %")
        shares["all else"].append(f"{100 * (1 - sum(clock.seconds.values()) / total):.1f} %")
        shares["CPU s"].append(f"{total:.1f}")
    print(f"| step | {' | '.join(folder.resolve().name for folder in options.surveys)} |\n{'| --- ' * (1 + len(options.surveys))}|")
    for name, cells in shares.items():
        print(f"| {name} | {' | '.join(cells)} |")


if __name__ == "__main__":
    main()
