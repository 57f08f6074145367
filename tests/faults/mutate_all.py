"""Mutated inputs over all readers, each given to a command that reads it: exit code 0 or 2, one sentence, no hang, memory within a GiB.

    python tests/faults/mutate_all.py [--number 2000] [--seed 1] [--only NAME...]

prints a line a kind of input. A fault is written to ``--keep FOLDER``, from where it goes to the corpus or becomes a test.
"""

from __future__ import annotations

import argparse
import multiprocessing
import os
import random
import resource
import sys
import tempfile
import time
from collections.abc import Callable, Sequence
from dataclasses import dataclass, field
from multiprocessing.connection import Connection
from pathlib import Path

if __name__ == "__main__" or multiprocessing.parent_process() is not None:
    sys.path[:0] = [str(Path(__file__).resolve().parents[1]), str(Path(__file__).resolve().parents[1] / "helpers")]

import numpy as np
from mutations import mutated

SECONDS = 60.0
MEMORY = 1 << 30
"""Bytes that the process which looks may ever have taken, libraries included."""
TILE_HEAD = 1200


@dataclass(frozen=True)
class Kind:
    """A kind of input: the file that is changed, its share of all mutations, and the commands that read it, in turn."""

    name: str
    file: str
    share: float
    commands: tuple[tuple[str, ...], ...]
    near_start: int | None = None


@dataclass
class Tally:
    """What became of the mutations of a kind."""

    read: int = 0
    refused: int = 0
    longest: float = 0.0
    memory: int = 0
    faults: list[str] = field(default_factory=list)


SURVEY = (("inspect", "survey.toml"),)
CHEAP = ("alarms result.gpkg -o out.csv --threshold 0", "features result.gpkg -o points.gpkg", "track result.gpkg -o out.gpkg")
COSTLY = ("export result.gpkg -o out", "model result.gpkg -o out.json", "report result.gpkg -o out.html")
VALIDATE = "validate result.gpkg --check check.csv --picks picks.csv --epoch {epoch} -o checked.gpkg"
REFIT = "refit result.gpkg --unit {unit} --epoch {epoch} --near {near} --editor me"


def kinds(site: Path) -> tuple[Kind, ...]:
    """All kinds of inputs of a site made by :func:`make_site`."""
    known = dict(line.split("=") for line in (site / "known.txt").read_text().splitlines())
    validate, refit = (tuple(text.format(**known).split()) for text in (VALIDATE, REFIT))
    result = (*(tuple(text.split()) for text in (*CHEAP, *CHEAP, *COSTLY)), validate, refit)
    cells, points = (sorted((site / "result.points").glob(f"*.{what}.npy"))[0].name for what in ("cells", "points"))
    memory = sorted((site / "cache" / "tetratrack" / "tiles").glob("*.npz"))[0].relative_to(site)
    return (
        Kind("LAS tile", "a.las", 0.13, (("inspect", "a.las"),), TILE_HEAD),
        Kind("LAZ tile", "a.laz", 0.13, (("inspect", "a.laz"),), TILE_HEAD),
        Kind("COPC tile", "a.copc.laz", 0.07, (("inspect", "a.copc.laz"),), TILE_HEAD),
        Kind("survey.toml", "survey.toml", 0.15, SURVEY),
        Kind("control", "control.csv", 0.07, SURVEY),
        Kind("targets", "targets.csv", 0.05, SURVEY),
        Kind("trajectory", "flight.csv", 0.05, SURVEY),
        Kind("check points", "check.csv", 0.04, (validate,)),
        Kind("picks", "picks.csv", 0.03, (validate,)),
        Kind("areas, GeoPackage", "areas.gpkg", 0.05, SURVEY),
        Kind("areas, GeoJSON", "areas.geojson", 0.04, (("inspect", "geojson.toml"),)),
        Kind("result", "result.gpkg", 0.09, result),
        Kind("point index", "result.points/index.json", 0.03, (refit,)),
        Kind("points of units", f"result.points/{points}", 0.02, (refit,)),
        Kind("cells of units", f"result.points/{cells}", 0.02, (refit,)),
        Kind("block of a run", "block.npz", 0.02, (("block", "block.npz"),)),
        Kind("memory of tiles", str(memory), 0.01, (("inspect", "a.las"),)),
    )


def make_site(folder: Path) -> None:
    """A small survey with all kinds of tables, and a result with the points of its units."""
    import geopandas
    import shapely
    import synthetic_result
    from crooked_las import write_survey
    from las_files import ORIGIN, grid_points, write_copc, write_las
    from tetratrack.core.pipeline.array_files import save_arrays
    from tetratrack.core.results.geopackage_reader import epoch_pairs, read_layer_rows

    points = grid_points(500)
    write_las(folder / "a.las", points, time=np.arange(500.0))
    write_las(folder / "a.laz", points, time=np.arange(500.0))
    write_copc(folder / "a.copc.laz", points)
    places = [(f"T{k}", *(ORIGIN + step)) for k, step in enumerate(((0, 0, 1), (6, 1, 1), (1, 7, 2), (8, 8, 0)))]
    _table(folder / "control.csv", "point_id,easting,northing,height,sd_e,sd_n,sd_h", [(*place, 0.003, 0.003, 0.003) for place in places])
    _table(folder / "targets.csv", "point_id,x,y,z", places)
    _table(folder / "flight.csv", "gps_time,x,y,z", [(10 * k, ORIGIN[0] + k, ORIGIN[1], 90) for k in range(60)])
    areas = geopandas.GeoDataFrame(geometry=[shapely.box(*ORIGIN[:2], *(ORIGIN[:2] + 4))], crs="EPSG:32650")
    areas.to_file(folder / "areas.gpkg", layer="stable", driver="GPKG")
    areas.to_file(folder / "areas.geojson", driver="GeoJSON")
    tables = 'control = "control.csv"\ntargets = "targets.csv"\ntrajectory = "flight.csv"\nrange_sd = 0.02\nangle_sd = 0.01\n'
    survey = write_survey(folder, tiles="a.laz", more=tables)
    text = survey.read_text()
    survey.write_text(text.replace("[unit]", 'stable_areas = "areas.gpkg"\n[unit]', 1))
    (folder / "geojson.toml").write_text(text.replace("[unit]", 'stable_areas = "areas.geojson"\n[unit]', 1))
    result = folder / "result.gpkg"
    synthetic_result.write_points(result, synthetic_result.write_result(result, count=12, epochs=2), epochs=2, per_unit=200)
    pair = epoch_pairs(result)[0]
    features = [row for row in read_layer_rows(result, "feature_points") if row["epoch"] == pair.epoch_to and row["geom"] is not None]
    centres = [row for row in features if row["feature"] == "centre"]
    head = "unit_easting,unit_northing,unit_height,easting,northing,height"
    joints = [row for row in features if row["feature"] == "f123"]
    rows = [(f"P{k}", *c["geom"], *j["geom"]) for k, (c, j) in enumerate(zip(centres, joints, strict=True))]
    _table(folder / "check.csv", f"point_id,{head},sd", [(*row, 0.002) for row in rows])
    _table(folder / "picks.csv", "point_id,epoch,easting,northing,height", [(row[0], pair.epoch_to, *row[4:]) for row in rows])
    save_arrays(folder / "block.npz", {"table": np.arange(400.0).reshape(80, 5), "kind": np.arange(80)})
    near = ",".join(f"{value:.3f}" for value in centres[0]["geom"])
    (folder / "known.txt").write_text(f"unit={centres[0]['unit_id']}\nepoch={pair.epoch_to}\nnear={near}\n")
    (folder / "cache").mkdir()


def _table(path: Path, head: str, rows: list[tuple[object, ...]]) -> None:
    path.write_text("\n".join([head, *(",".join(str(value) for value in row) for row in rows)]) + "\n", encoding="utf-8")


def prepare(site: str) -> None:
    """Put a process that looks at files into the site."""
    os.environ["XDG_CACHE_HOME"] = str(Path(site) / "cache")
    os.chdir(site)


def look(command: tuple[str, ...]) -> tuple[int, str, int]:
    """What a command ends with: exit code, what it said on standard error, and how much memory the process ever took, bytes."""
    from tetratrack.core.pipeline.array_files import load_arrays
    from tetratrack.scripts.cli import app
    from typer.testing import CliRunner

    if command[0] == "block":
        load_arrays(Path(command[1]))
        code, words = 0, ""
    else:
        told = CliRunner().invoke(app, [*command, "--quiet"])
        code, words = told.exit_code, told.stderr
    return code, words, peak_memory()


def peak_memory() -> int:
    """Most memory that this process ever took, bytes; without that of the process that started it, which ``ru_maxrss`` counts too."""
    status = Path("/proc/self/status")
    if not status.is_file():
        return resource.getrusage(resource.RUSAGE_SELF).ru_maxrss * 1024
    peak = next(line for line in status.read_text().splitlines() if line.startswith("VmHWM:"))
    return int(peak.split()[1]) * 1024


def judged(code: int, words: str) -> str:
    """What is wrong with an ending; empty where nothing is."""
    errors = [line for line in words.splitlines() if line.startswith("error: ")]
    if code not in (0, 2) or "Traceback" in words:
        return f"exit {code}: {words[-400:]}"
    if code == 2 and (len(errors) != 1 or len(errors[0]) > 1500):
        return f"not one sentence: {words[-400:]}"
    return ""


def serve(commands: Connection, site: str) -> None:
    """Run commands in a site, one after another, for a :class:`Looker`."""
    prepare(site)
    # libraries are loaded before the time of the first command begins
    from tetratrack.core.pipeline import inspection, single_steps  # noqa: F401
    from tetratrack.scripts.cli import app  # noqa: F401

    commands.send("ready")
    while True:
        commands.send(look(commands.recv()))


class Looker:
    """A process of its own that runs commands in a site, since a crash or hang must not pass for an ending; a new one after a fault."""

    def __init__(self, site: Path) -> None:
        self._site = site
        self._start()

    def _start(self) -> None:
        context = multiprocessing.get_context("spawn")
        self._commands, theirs = context.Pipe()
        self._process = context.Process(target=serve, args=(theirs, str(self._site)), daemon=True)
        self._process.start()
        theirs.close()
        if not self._commands.poll(600.0) or self._commands.recv() != "ready":
            raise RuntimeError("no process to look at files can be started")

    def look(self, command: tuple[str, ...]) -> tuple[int, str, int]:
        """Exit code, what is wrong (empty where nothing is), and memory in bytes."""
        self._commands.send(command)
        code, memory, wrong = 1, 0, f"no end after {SECONDS:.0f} s"
        if self._commands.poll(SECONDS):
            try:
                code, words, memory = self._commands.recv()
                wrong = judged(code, words)
            except EOFError:
                wrong = "the process crashed"
        if memory > MEMORY:
            wrong = wrong or f"{memory >> 20} MiB"
        if wrong or memory > MEMORY // 2:
            self.close()
            self._start()
        return code, wrong, memory

    def close(self) -> None:
        """End the process, whatever it does: commands take a polite signal for Ctrl-C."""
        self._process.kill()
        self._process.join()
        self._commands.close()


def try_kind(site: Path, looker: Looker, kind: Kind, number: int, seed: int, keep: Path | None = None) -> Tally:
    """Try mutations of one kind of input."""
    rng = random.Random(f"{seed} {kind.name}")
    path = site / kind.file
    good = {file: file.read_bytes() for file in (path, site / "result.gpkg")}
    tally = Tally()
    for k in range(number):
        data = mutated(good[path], rng, kind.near_start)
        path.write_bytes(data)
        command = kind.commands[k % len(kind.commands)]
        start = time.monotonic()
        code, wrong, memory = looker.look(command)
        tally.longest, tally.memory = max(tally.longest, time.monotonic() - start), max(tally.memory, memory)
        tally.read, tally.refused = tally.read + (code == 0), tally.refused + (code == 2)
        if wrong:
            tally.faults.append(f"mutation {k}, {' '.join(command)}: {wrong}")
            if keep is not None:
                (keep / f"{seed}-{k}-{path.name}").write_bytes(data)
        # a command may have corrected the result, or recovered it
        for file, content in good.items():
            file.write_bytes(content)
        for left in site.glob("result.gpkg-*"):
            left.unlink()
    return tally


FIRST = ("inspect", "a.las")


def compile_loops(site: str) -> None:
    """Let each command compile the loops that it needs, in a process of its own: compiling takes memory that reading a file does not."""
    prepare(site)
    look(FIRST)
    for command in dict.fromkeys(command for kind in kinds(Path(site)) for command in kind.commands):
        look(command)


def try_all(
    site: Path,
    number: int,
    seed: int = 1,
    only: Sequence[str] = (),
    keep: Path | None = None,
    told: Callable[[str], object] = lambda line: None,
) -> list[Tally]:
    """Make a site and try mutations of every kind of input in it, ``number`` in all."""
    make_site(site)
    compiling = multiprocessing.get_context("spawn").Process(target=compile_loops, args=(str(site),))
    compiling.start()
    compiling.join()
    looker = Looker(site)
    tallies = []
    try:
        # what is remembered of a tile comes to be, and all that is sound is read; units made up have no covariance to track them with
        first = looker.look(FIRST)[:2]
        assert first == (0, ""), first
        for command in dict.fromkeys(command for kind in kinds(site) for command in kind.commands):
            assert looker.look(command)[:2] == (2 if command[0] == "track" else 0, ""), command
        for kind in kinds(site):
            if only and kind.name not in only:
                continue
            tally = try_kind(site, looker, kind, max(1, round(number * kind.share)), seed, keep)
            tallies.append(tally)
            told(
                f"{kind.name}: {tally.read} read, {tally.refused} refused, {len(tally.faults)} faults, longest {tally.longest:.1f} s, "
                f"memory {tally.memory >> 20} MiB"
            )
            for fault in tally.faults:
                told(f"    {fault}")
    finally:
        looker.close()
    return tallies


def _say(line: str) -> None:
    sys.stdout.write(f"{line}\n")
    sys.stdout.flush()


def main() -> int:
    """Run from the command line; exit code 1 if there was a fault."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--number", type=int, default=2000)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--only", nargs="*", default=[])
    parser.add_argument("--keep", type=Path)
    options = parser.parse_args()
    with tempfile.TemporaryDirectory() as folder:
        tallies = try_all(Path(folder), options.number, options.seed, options.only, options.keep, _say)
    total = sum(tally.read + tally.refused for tally in tallies)
    faults = sum(len(tally.faults) for tally in tallies)
    _say(f"all: {total} ended as they should, {faults} faults, longest {max(t.longest for t in tallies):.1f} s")
    return int(faults > 0)


if __name__ == "__main__":
    sys.exit(main())
