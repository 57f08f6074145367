"""Coasts from a seed, surveyed, run and judged: one line a coast, so that two states of the product can be held against each other.

    .venv/bin/python benchmarks/accuracy/coasts.py [--seeds 101 102] [--kinds uav tls_short] [--length 100] [--density 300]
    .venv/bin/python benchmarks/accuracy/coasts.py --folder SURVEY --result FILE.gpkg

Columns: centres of units in the control frame (RMSE, mm, and mean squared normalised error per coordinate, 1 is honest); in both datums
RMSE of the displacements of units seen to 15 % or more in both epochs (mm) and that of all resting units, the same error of these,
coordinates of these within their 95 % bounds (%), resting units flagged (%), and moves of 2 cm and of 5 cm or more found; resting
stretches called significant in both datums, of how many; targets excluded in epochs before the last, which are all good, and in the last,
where one was knocked by twelve times the deviation of a target.
"""

from __future__ import annotations

import argparse
import csv
import sqlite3
import tempfile
from dataclasses import dataclass
from pathlib import Path

import laspy
import numpy as np
from scipy.spatial.transform import Rotation
from tetratrack.benchmarks.accuracy.honesty import matched, true_units
from tetratrack.core.common.feedback import Feedback
from tetratrack.core.data.survey_reader import read_survey
from tetratrack.core.pipeline.run_options import RunOptions
from tetratrack.core.pipeline.whole_survey import run_survey
from tetratrack.core.simulation.bent_frames import RIGID, FrameErrors
from tetratrack.core.simulation.survey_plan import plan_of
from tetratrack.core.simulation.virtual_instruments import Instrument
from tetratrack.core.simulation.virtual_survey import simulate_survey

WELL_SEEN = 0.15
"""Least share of a unit's surface that an epoch sees for its displacement to count in the first figure."""
SEEN_MOVES = (0.02, 0.05)
"""Least true motions that count as found or not, metres."""
BOUND_95 = 1.96
"""Standard deviations within which 95 % of normal errors lie."""
TURN, SHIFT = 4.0, np.array([3.1, -2.3, 1.6])
"""Degrees about the vertical and metres by which a turned cloud lies."""
VECTORS = "select unit_id, epoch_from, epoch_to, de, dn, dh, sd_e, sd_n, sd_h, significant from "
QUERIES = {
    "stable": VECTORS + "displacements where feature = 'centre' and datum = 'stable'",
    "control": VECTORS + "displacements_other where feature = 'centre' and datum = 'control'",
}
COLUMNS = ("coast", "units", "centres", "stable", "control", "stretches", "targets")


@dataclass(frozen=True, kw_only=True)
class Kind:
    """What a coast is: instrument, errors of its frames, distance of targets in metres (0 for none), and slide of its middle.

    ``anonymous`` clouds have neither numbers of strips nor times; of a ``turned`` coast the last epoch's cloud, with its targets, lies
    turned and shifted.
    """

    instrument: Instrument
    frame: FrameErrors = RIGID
    targets_every: float = 24.0
    slide: float = 0.0
    anonymous: bool = False
    turned: bool = False


KINDS = {
    "uav": Kind(instrument="uav", frame=FrameErrors(bend=0.03)),
    "uav_sparse": Kind(instrument="uav", frame=FrameErrors(bend=0.03), targets_every=70.0),
    "uav_strong": Kind(instrument="uav", frame=FrameErrors(bend=0.05)),
    "uav_strong_short": Kind(instrument="uav", frame=FrameErrors(bend=0.05, shortest=30.0, longest=60.0)),
    "uav_slide": Kind(instrument="uav", frame=FrameErrors(bend=0.03), slide=0.1),
    "uav_flat": Kind(instrument="uav"),
    "uav_drift": Kind(instrument="uav", frame=FrameErrors(drift=0.03)),
    "uav_anonymous": Kind(instrument="uav", anonymous=True),
    "uav_anonymous_bent": Kind(instrument="uav", frame=FrameErrors(bend=0.03), anonymous=True),
    "uav_anonymous_short": Kind(instrument="uav", frame=FrameErrors(bend=0.03, shortest=30.0, longest=60.0), anonymous=True),
    "uav_turned": Kind(instrument="uav", turned=True),
    "uav_turned_alone": Kind(instrument="uav", turned=True, targets_every=0.0),
    "uav_no_targets": Kind(instrument="uav", frame=FrameErrors(bend=0.03), targets_every=0.0),
    "tls_flat": Kind(instrument="tls"),
    "tls_short": Kind(instrument="tls", frame=FrameErrors(bend=0.05, shortest=30.0, longest=60.0)),
    "tls_bent": Kind(instrument="tls", frame=FrameErrors(bend=0.03)),
    "photogrammetry_bent": Kind(instrument="photogrammetry", frame=FrameErrors(bend=0.03)),
    "bowl": Kind(instrument="photogrammetry", frame=FrameErrors(bowl=0.05)),
}


def alter(folder: Path, kind: Kind) -> None:
    """Take from a simulated survey's clouds what its kind lacks, and turn the last one."""
    epochs = sorted(path for path in (folder / "tiles").iterdir() if path.is_dir())
    middle: np.ndarray | None = None
    turn = Rotation.from_euler("z", TURN, degrees=True)
    for tile in sorted(folder.glob("tiles/*/*.laz")) if kind.anonymous or kind.turned else []:
        cloud = laspy.read(tile)
        if kind.anonymous:
            cloud.point_source_id[:] = 0
            cloud.gps_time[:] = 0
        if kind.turned and tile.parent == epochs[-1]:
            middle = np.asarray(cloud.xyz).mean(axis=0) if middle is None else middle
            cloud.xyz = turn.apply(np.asarray(cloud.xyz) - middle) + middle + SHIFT
        cloud.write(tile)
    targets = folder / f"targets_{epochs[-1].name}.csv"
    if middle is not None and targets.exists():
        head, *rows = list(csv.reader(targets.open()))
        places = turn.apply(np.array([row[1:4] for row in rows], dtype=np.float64) - middle) + middle + SHIFT
        with targets.open("w", newline="") as stream:
            csv.writer(stream).writerows([head, *([row[0], *(f"{v:.4f}" for v in place)] for row, place in zip(rows, places, strict=True))])


def line_of(name: str, folder: Path, result: Path) -> str:
    """Figures of one coast."""
    names, counts = matched(result, folder)
    parts = [name, str(counts[0]), ", ".join(f"{value:.{digits}f}" for value, digits in zip(centres(result, folder, names), (1, 2)))]
    with sqlite3.connect(result) as connection:
        parts += [_displacements(connection, datum, folder, names) for datum in QUERIES]
        parts.append(_stretches(connection))
        parts.append(_targets(connection))
    return " | ".join(parts)


def centres(result: Path, folder: Path, names: dict[tuple[str, str], str]) -> tuple[float, float]:
    """Of all units that are right: RMSE in millimetres, and mean squared normalised error per coordinate."""
    true = {(name, epoch): centre for epoch, own in true_units(folder)[0].items() for name, centre in own}
    with sqlite3.connect(result) as connection:
        rows = connection.execute("select unit_id, epoch, geom, sd_e, sd_n, sd_h from feature_points where feature = 'centre'").fetchall()
    known = [row for row in rows if (row[0], row[1]) in names]
    away = np.array([np.frombuffer(blob[-24:], dtype="<f8") - true[names[u, e], e] for u, e, blob, *_ in known])
    sds = np.array([row[3:] for row in known], dtype=np.float64)
    return 1000 * float(np.sqrt(np.mean(np.sum(away**2, axis=1)))), float(np.mean((away / sds) ** 2))


def _displacements(connection: sqlite3.Connection, datum: str, folder: Path, names: dict[tuple[str, str], str]) -> str:
    truth = {
        (row["unit_id"], row["epoch_from"], row["epoch_to"]): (np.array([float(row[k]) for k in ("de", "dn", "dh")]), int(row["moved"]))
        for row in csv.DictReader((folder / "truth/displacements.csv").open())
    }
    seen = {
        (row["unit_id"], row["epoch"]): float(row["visible_area_fraction"] or 0)
        for row in csv.DictReader((folder / "truth/units.csv").open())
    }
    well_seen, lengths, squares, within, false, found = [], [], [], [], [], []
    for unit, first, second, *values in connection.execute(QUERIES[datum]):
        name = names.get((unit, first))
        if name is None or name != names.get((unit, second)) or (name, first, second) not in truth:
            continue
        vector, moved = truth[name, first, second]
        error = np.array(values[:3]) - vector
        if min(seen[name, first], seen[name, second]) >= WELL_SEEN:
            well_seen.append(float(error @ error))
        if not moved:
            lengths.append(float(error @ error))
            normalised = error / values[3:6]
            squares.append(float(np.mean(normalised**2)))
            within.append(float(np.mean(np.abs(normalised) < BOUND_95)))
            false.append(bool(values[6]))
        else:
            found.append((float(np.linalg.norm(vector)), bool(values[6])))
    if not lengths:
        return "-"
    rmse, resting = (1000 * np.sqrt(np.mean(values)) if values else np.nan for values in (well_seen, lengths))
    moves = [[flag for length, flag in found if length >= least] for least in SEEN_MOVES]
    parts = [f"{rmse:.1f}, {resting:.1f}, {np.mean(squares):.2f}, {100 * np.mean(within):.1f} %, {100 * np.mean(false):.1f} %"]
    return ", ".join([*parts, *(f"{sum(flags)}/{len(flags)}" for flags in moves)])


def _stretches(connection: sqlite3.Connection) -> str:
    parts = []
    for datum in ("stable", "control"):
        flags = [row[0] for row in connection.execute("select significant from stretches where datum = ?", (datum,))]
        parts.append(f"{sum(map(bool, flags))}/{len(flags)}")
    return ", ".join(parts)


def _targets(connection: sqlite3.Connection) -> str:
    rows = connection.execute("select epoch, outlier from control_residuals").fetchall()
    if not rows:
        return "-"
    last = max(epoch for epoch, _ in rows)
    return f"{sum(bool(out) for epoch, out in rows if epoch != last)}, {sum(bool(out) for epoch, out in rows if epoch == last)}"


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--seeds", type=int, nargs="+", default=[101])
    parser.add_argument("--kinds", nargs="+", choices=sorted(KINDS), default=sorted(KINDS))
    parser.add_argument("--length", type=float, default=100.0, help="of a coast, metres")
    parser.add_argument("--units", type=int, default=40, help="of a stretch")
    parser.add_argument("--density", type=float, default=300.0, help="points per square metre")
    parser.add_argument("--folder", type=Path, help="judge this survey by --result, without a run")
    parser.add_argument("--result", type=Path)
    arguments = parser.parse_args()
    print("| " + " | ".join(COLUMNS) + " |\n|" + " --- |" * len(COLUMNS))
    if arguments.folder is not None:
        print(f"| {line_of(arguments.folder.name, arguments.folder, arguments.result)} |")
        return
    with tempfile.TemporaryDirectory() as work:
        for seed in arguments.seeds:
            for name in arguments.kinds:
                kind = KINDS[name]
                plan = plan_of(
                    kind.instrument, f"{name}_{seed}", units=arguments.units, seed=seed, density=arguments.density, frame=kind.frame,
                    length=arguments.length, targets_every=kind.targets_every, slide=kind.slide,
                )  # fmt: skip
                folder = simulate_survey(plan, Path(work) / plan.name).parent
                alter(folder, kind)
                result = Path(work) / f"{plan.name}.gpkg"
                run_survey(read_survey(folder / "survey.toml"), result, RunOptions(workers=1), Feedback())
                print(f"| {line_of(plan.name, folder, result)} |", flush=True)


if __name__ == "__main__":
    main()
