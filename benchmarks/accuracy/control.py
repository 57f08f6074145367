"""Registration by targets, by Monte Carlo: displacement that it brings to the units, what the covariance states, targets it excludes.

    python benchmarks/accuracy/control.py [--surveys 150] [--seed 0] [--instrument uav tls] [--units 75] [--height 2.3]

Each survey has the simulator's targets in two epochs; in the second one of them is disturbed. Epochs are registered as in a run
(*product*), by an ideal that knows the disturbed target and all standard deviations, and with the disturbed target kept. Displacements
are true zeros at a grid of places over the armour slope. Misses and exclusions are of all targets of both epochs.
"""

from __future__ import annotations

import argparse
import tempfile
from collections import defaultdict
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray
from tetratrack.core.data.point_tables import SurveyedPoints, read_control, read_targets
from tetratrack.core.registration.control import Registration, register
from tetratrack.core.simulation.armour_pile import Site
from tetratrack.core.simulation.survey_plan import SimulationPlan
from tetratrack.core.simulation.survey_simulation import Simulation, label_of
from tetratrack.core.simulation.virtual_instruments import INSTRUMENTS

FloatArray = NDArray[np.float64]
WAYS = ("product", "ideal", "kept")
NEVER = 1e-300
"""Level of the outlier test at which no target is excluded."""


def slope_places(site: Site, metre: float) -> FloatArray:
    """(42, 3) places of units over the slope, in the site frame; ``metre`` is one for units of 2.3 m."""
    x = np.linspace(-1, 1, 7) * (site.half_length - 2 * metre)
    y = np.linspace(site.wall + metre, site.toe - metre, 6)
    grid = np.stack(np.meshgrid(x, y, indexing="ij"), axis=-1).reshape(-1, 2)
    return np.column_stack([grid, np.interp(grid[:, 1], [site.wall, site.toe], [site.deck, 0.0])])


def without(points: SurveyedPoints, number: int | None, sd: float) -> SurveyedPoints:
    """Targets with their true standard deviation, less the disturbed one."""
    keep = [k for k in range(len(points.ids)) if k != number]
    return SurveyedPoints(tuple(points.ids[k] for k in keep), points.coordinates[keep], np.full((len(keep), 3), sd))


def stated(registration: Registration, places: FloatArray, factor: float = 1.0) -> float:
    """Mean over the places of the stated variance of the position, all axes together."""
    jacobian = registration.transformation.jacobian(places)
    return float(np.einsum("nij,jk,nik->n", jacobian, registration.transformation.covariance / factor, jacobian).mean())


def survey_errors(plan: SimulationPlan, folder: Path) -> dict[str, float]:
    """One survey: mean squared errors of displacement by way, stated variances, disturbed targets missed and good ones excluded."""
    simulation = Simulation(plan, folder)
    assert simulation.site is not None
    targets = simulation.targets()
    places = simulation.frame.place(slope_places(simulation.site, plan.height / 2.3))
    sd = simulation.instrument.target
    epochs, seen, disturbed = [], [], None
    for number, time in enumerate(simulation.times):
        simulation.write_control(targets, time, disturbed=number == 1)
        epochs.append((read_control(folder / f"control_{label_of(time)}.csv"), read_targets(folder / f"targets_{label_of(time)}.csv")))
        seen.append(simulation.in_cloud(places))
        if number == 1:
            off = epochs[1][1].coordinates - simulation.in_cloud(simulation.frame.place(targets))
            disturbed = int(np.argmax(np.linalg.norm(off, axis=1)))
    alone = [register(*epoch) for epoch in epochs]
    errors = {way: np.zeros_like(places) for way in WAYS}
    report: dict[str, float] = defaultdict(float)
    for number, (control, measured) in enumerate(epochs):
        gone = disturbed if number == 1 else None
        registrations = {
            "product": register(control, measured, others=[alone[1 - number]]),
            "ideal": register(control, without(measured, gone, sd), level=NEVER),
            "kept": register(control, measured, level=NEVER),
        }
        for way, registration in registrations.items():
            errors[way] += (2 * number - 1) * (registration.transformation.apply(seen[number]) - places)
        report["product stated"] += stated(registrations["product"], places)
        report["ideal stated"] += stated(registrations["ideal"], places, max(1.0, registrations["ideal"].sigma0) ** 2)
        excluded = set(registrations["product"].excluded)
        bad = set() if gone is None else {control.ids[gone]}
        report["missed"] += len(bad - excluded)
        report["excluded"] += len(excluded - bad)
        report["good"] += len(control.ids) - len(bad)
    return {**report, **{way: float(np.sum(e**2, axis=1).mean()) for way, e in errors.items()}}


def run(plan: SimulationPlan, surveys: int, seed: int) -> dict[str, FloatArray]:
    """``survey_errors`` of so many surveys, by key."""
    seeds = np.random.default_rng(seed).integers(2**32, size=surveys).tolist()
    with tempfile.TemporaryDirectory(prefix="control-") as folder:
        reports = [survey_errors(replace(plan, seed=number), Path(folder)) for number in seeds]
    return {key: np.array([report[key] for report in reports]) for key in reports[0]}


def row(instrument: Any, options: argparse.Namespace) -> str:
    report = run(SimulationPlan("control", instrument, options.units, options.height), options.surveys, options.seed)
    rmse = {key: 1e3 * float(np.sqrt(report[key].mean())) for key in (*WAYS, "product stated", "ideal stated")}
    spread = " / ".join(f"{1e3 * v:.0f}" for v in np.sqrt(np.percentile(report["product"], [10, 50, 90])))
    counts = {key: int(report[key].sum()) for key in ("missed", "excluded", "good")}
    virtual = INSTRUMENTS[instrument]
    cells = [
        f"{instrument}: {1e3 * virtual.target:g} mm in the cloud, {1e3 * virtual.control:g} mm surveyed",
        *(f"{rmse[way]:.1f}" for way in WAYS),
        f"{rmse['product stated']:.1f}",
        *(f"{rmse[way] / rmse[f'{way} stated']:.2f}" for way in ("product", "ideal")),
        spread,
        f"{counts['missed']} of {options.surveys}",
        f"{counts['excluded']} of {counts['good']}",
    ]
    return f"| {' | '.join(cells)} |"


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--surveys", type=int, default=150, help="of each instrument")
    parser.add_argument("--seed", type=int, default=0)
    parser.add_argument("--instrument", nargs="+", choices=("uav", "tls", "photogrammetry"), default=["uav", "tls"])
    parser.add_argument("--units", type=int, default=75, help="they give the length of the wall that holds the targets")
    parser.add_argument("--height", type=float, default=2.3, help="metres")
    options = parser.parse_args()
    print("| targets | product, mm | ideal, mm | disturbed kept, mm | stated, mm | product / stated | ideal / its stated ", end="")
    print("| 10 / 50 / 90 % of surveys, mm | disturbed missed | good ones excluded |")
    print("| --- " * 10 + "|")
    for instrument in options.instrument:
        print(row(instrument, options), flush=True)


if __name__ == "__main__":
    main()
