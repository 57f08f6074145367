"""The console command ``tetratrack``: one subcommand for each step, and ``run`` for all. Heavy libraries are imported by the step
that needs them."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import typer

from ..core.feedback import Feedback
from .console import Console, execute

if TYPE_CHECKING:
    from ..core.result_tables import EpochPair
    from ..core.unit_types import UnitType

app = typer.Typer(
    add_completion=False,
    no_args_is_help=True,
    pretty_exceptions_enable=False,
    context_settings={"help_option_names": ["-h", "--help"]},
    help="Displacements of tetrapod armour units from LAS/LAZ point clouds, with survey control.",
)

SurveyFile = Annotated[Path, typer.Argument(metavar="SURVEY.toml", help="What was surveyed; see: tetratrack template", show_default=False)]
ResultFile = Annotated[Path, typer.Argument(metavar="RESULT.gpkg", help="Result of an earlier step", show_default=False)]
Output = Annotated[Path, typer.Option("--output", "-o", help="File to write", show_default=False)]
Workers = Annotated[int, typer.Option("--workers", "-j", min=0, help="Local processes; 0 takes one per core")]
Scheduler = Annotated[str | None, typer.Option("--scheduler", help="Address of a dask scheduler, e.g. tcp://host:8786")]
Resume = Annotated[bool, typer.Option("--resume", help="Keep finished blocks in OUTPUT.jobs/ and use those of an interrupted run")]
Seed = Annotated[int, typer.Option("--seed", help="Seed of the random draws")]
Quiet = Annotated[bool, typer.Option("--quiet", "-q", help="Nothing but the result and errors")]
LogFile = Annotated[Path | None, typer.Option("--log-file", help="Append every line with its time to this file")]
JsonProgress = Annotated[bool, typer.Option("--json-progress", help="One JSON object a line on standard output, for other programs")]
EpochFrom = Annotated[str | None, typer.Option("--from", help="Earlier epoch; by default of the last pair")]
EpochTo = Annotated[str | None, typer.Option("--to", help="Later epoch")]
Datum = Annotated[str | None, typer.Option("--datum", help="stable or control; by default the result's")]
UnitName = Annotated[str, typer.Option("--unit", help='Type of unit, "tetrapod" or e.g. "tetrapod 8 t"')]
Height = Annotated[float | None, typer.Option("--height", min=1e-6, help="Nominal height H, metres")]
Radius = Annotated[float | None, typer.Option("--radius", min=1e-6, help="Leg cone radius at the unit's centre, metres")]
Gradient = Annotated[float | None, typer.Option("--gradient", min=1e-6, help="Loss of radius per metre of leg")]
LegLength = Annotated[float | None, typer.Option("--leg-length", min=1e-6, help="Centre to end disc, metres")]
Opening = Annotated[str, typer.Option("--opening", help="tetrahedral or paper")]


def _run(quiet: bool, log_file: Path | None, json_progress: bool, step: Callable[[Feedback], dict[str, Any]]) -> None:
    """Run a step with its messages going to the console, and leave with its exit code."""

    def with_feedback(console: Console) -> dict[str, Any]:
        return step(Feedback(console.progress, console.info, console.warning))

    raise typer.Exit(execute(Console(quiet, log_file, json_progress), with_feedback))


@app.command()
def run(
    survey: SurveyFile,
    output: Output,
    workers: Workers = 0,
    scheduler: Scheduler = None,
    resume: Resume = False,
    seed: Seed = 0,
    quiet: Quiet = False,
    log_file: LogFile = None,
    json_progress: JsonProgress = False,
) -> None:
    """All steps: tiles to units, feature points, registration and displacements."""

    def step(feedback: Feedback) -> dict[str, Any]:
        from ..core.run_options import RunOptions
        from ..core.survey import read_survey
        from ..core.workflow import run_survey

        return run_survey(read_survey(survey), output, RunOptions(workers, scheduler, resume, seed), feedback)

    _run(quiet, log_file, json_progress, step)


@app.command()
def inspect(
    tiles: Annotated[list[Path], typer.Argument(metavar="TILES...", help="LAS/LAZ/COPC files, or a survey.toml", show_default=False)],
    output: Annotated[Path | None, typer.Option("--output", "-o", help="GeoPackage for a layer of the tiles' extents")] = None,
    quiet: Quiet = False,
    log_file: LogFile = None,
    json_progress: JsonProgress = False,
) -> None:
    """Extent, CRS, number and density of points of tiles."""

    def step(feedback: Feedback) -> dict[str, Any]:
        from ..core.epoch_plans import plan_survey
        from ..core.survey import read_survey
        from ..core.workflow import run_inspect

        paths: list[Path] = []
        for tile in tiles:
            if tile.suffix.lower() == ".toml":
                survey = read_survey(tile)
                plan_survey(survey, feedback)
                paths += [path for epoch in survey.epochs for path in epoch.tiles]
            else:
                paths.append(tile)
        return run_inspect(paths, output, feedback)

    _run(quiet, log_file, json_progress, step)


@app.command()
def segment(
    survey: SurveyFile,
    output: Output,
    workers: Workers = 0,
    scheduler: Scheduler = None,
    resume: Resume = False,
    seed: Seed = 0,
    quiet: Quiet = False,
    log_file: LogFile = None,
    json_progress: JsonProgress = False,
) -> None:
    """Find the units of every epoch: approximate poses, in the frame of the epoch's cloud."""

    def step(feedback: Feedback) -> dict[str, Any]:
        from ..core.run_options import RunOptions
        from ..core.survey import read_survey
        from ..core.workflow import run_segment

        return run_segment(read_survey(survey), output, RunOptions(workers, scheduler, resume, seed), feedback)

    _run(quiet, log_file, json_progress, step)


@app.command()
def fit(
    survey: SurveyFile,
    output: Output,
    units: Annotated[
        Path | None, typer.Option("--units", help="GeoPackage with approximate poses in layer units; without it units are found")
    ] = None,
    workers: Workers = 0,
    scheduler: Scheduler = None,
    resume: Resume = False,
    seed: Seed = 0,
    quiet: Quiet = False,
    log_file: LogFile = None,
    json_progress: JsonProgress = False,
) -> None:
    """Adjust every unit to its points (Gauss-Helmert), in the frame of the epoch's cloud."""

    def step(feedback: Feedback) -> dict[str, Any]:
        from ..core.run_options import RunOptions
        from ..core.survey import read_survey
        from ..core.workflow import run_fit

        return run_fit(read_survey(survey), units, output, RunOptions(workers, scheduler, resume, seed), feedback)

    _run(quiet, log_file, json_progress, step)


@app.command()
def features(
    units: ResultFile, output: Output, quiet: Quiet = False, log_file: LogFile = None, json_progress: JsonProgress = False
) -> None:
    """Feature points with covariance from adjusted units."""

    def step(feedback: Feedback) -> dict[str, Any]:
        from ..core.workflow import run_features

        return run_features(units, output, feedback)

    _run(quiet, log_file, json_progress, step)


@app.command()
def register(
    survey: SurveyFile, output: Output, quiet: Quiet = False, log_file: LogFile = None, json_progress: JsonProgress = False
) -> None:
    """Register every epoch's cloud to survey control."""

    def step(feedback: Feedback) -> dict[str, Any]:
        from ..core.run_options import RunOptions
        from ..core.survey import read_survey
        from ..core.workflow import run_register

        return run_register(read_survey(survey), output, RunOptions(), feedback)

    _run(quiet, log_file, json_progress, step)


@app.command()
def track(
    units: ResultFile,
    output: Output,
    registration: Annotated[list[Path] | None, typer.Option("--registration", help="Result of register; repeat for several")] = None,
    quiet: Quiet = False,
    log_file: LogFile = None,
    json_progress: JsonProgress = False,
) -> None:
    """Identity, datum and displacements from the fitted units of several epochs."""

    def step(feedback: Feedback) -> dict[str, Any]:
        from ..core.epoch_steps import run_track

        return run_track(units, registration or [], output, feedback)

    _run(quiet, log_file, json_progress, step)


@app.command()
def validate(
    features: ResultFile,
    check: Annotated[Path, typer.Option("--check", help="CSV of surveyed check points", show_default=False)],
    output: Output,
    epoch: Annotated[str | None, typer.Option("--epoch", help="Epoch the check points belong to")] = None,
    picks: Annotated[Path | None, typer.Option("--picks", help="CSV of manual picks: point_id,epoch,easting,northing,height")] = None,
    quiet: Quiet = False,
    log_file: LogFile = None,
    json_progress: JsonProgress = False,
) -> None:
    """Feature points less surveyed check points."""

    def step(feedback: Feedback) -> dict[str, Any]:
        from ..core.epoch_steps import run_validate

        return run_validate(features, check, picks, epoch, output, feedback)

    _run(quiet, log_file, json_progress, step)


@app.command()
def export(
    result: ResultFile,
    output: Annotated[Path, typer.Option("--output", "-o", help="Folder for one file a layer", show_default=False)],
    formats: Annotated[list[str] | None, typer.Option("--format", help="csv or parquet; repeat for both, which is the default")] = None,
    layers: Annotated[list[str] | None, typer.Option("--layer", help="Layer to write; repeat for several, default all")] = None,
    quiet: Quiet = False,
    log_file: LogFile = None,
    json_progress: JsonProgress = False,
) -> None:
    """Layers of a result as CSV and GeoParquet."""

    def step(feedback: Feedback) -> dict[str, Any]:
        from ..core.export import FORMATS, export_layers

        return {"output": str(output), "files": len(export_layers(result, output, formats or FORMATS, layers or ()))}

    _run(quiet, log_file, json_progress, step)


@app.command("register-views")
def register_views(
    views: Annotated[list[Path], typer.Argument(metavar="VIEWS...", help="LAS/LAZ files that overlap", show_default=False)],
    output: Output,
    voxel: Annotated[float | None, typer.Option("--voxel", help="Edge of the voxels, metres; default from the point spacing")] = None,
    quiet: Quiet = False,
    log_file: LogFile = None,
    json_progress: JsonProgress = False,
) -> None:
    """Register overlapping views of a depth camera into one cloud."""

    def step(feedback: Feedback) -> dict[str, Any]:
        from ..core.epoch_steps import run_register_views

        return run_register_views(views, output, voxel, feedback)

    _run(quiet, log_file, json_progress, step)


@app.command()
def simulate(
    output: Annotated[Path, typer.Option("--output", "-o", help="Folder to make", show_default=False)],
    instrument: Annotated[str, typer.Option("--instrument", help="uav, tls, photogrammetry or depth_camera")] = "uav",
    name: Annotated[str, typer.Option("--name", help="Name of the survey")] = "simulated",
    units: Annotated[int | None, typer.Option("--units", min=0, help="Units of the first epoch (75; 4 models in the laboratory)")] = None,
    epochs: Annotated[int, typer.Option("--epochs", min=1, help="Number of epochs")] = 2,
    density: Annotated[float | None, typer.Option("--density", min=0, help="Points per m2; default and 0: the instrument's own")] = None,
    noise: Annotated[
        float | None, typer.Option("--noise", min=0, help="Range noise in metres; default and 0: the instrument's own")
    ] = None,
    crs: Annotated[str, typer.Option("--crs", help="Projected CRS of the site; the laboratory is LOCAL")] = "EPSG:32650",
    unit: UnitName = "tetrapod",
    height: Height = None,
    radius: Radius = None,
    gradient: Gradient = None,
    leg_length: LegLength = None,
    opening: Opening = "tetrahedral",
    calibrate: Annotated[str, typer.Option("--calibrate", hidden=True)] = "",
    seed: Seed = 0,
    quiet: Quiet = False,
    log_file: LogFile = None,
    json_progress: JsonProgress = False,
) -> None:
    """Simulate a survey of a pile of units, with ground truth."""

    def step(feedback: Feedback) -> dict[str, Any]:
        from ..core.virtual_survey import plan_of, simulate_survey

        nominal = (
            None
            if height is None and opening == "tetrahedral" and unit.strip().lower() == "tetrapod"
            else _unit(unit, height, radius, gradient, leg_length, opening)
        )
        plan = plan_of(
            instrument, name, nominal, units=units, epochs=epochs, seed=seed, density=density or None, noise=noise or None, crs=crs
        )
        return {"survey": str(simulate_survey(plan, output, feedback.progress))}

    _run(quiet, log_file, json_progress, step)


@app.command()
def plan(
    density: Annotated[float, typer.Option("--density", help="Points per m2 of a surface that faces the instrument", show_default=False)],
    noise: Annotated[float, typer.Option("--noise", help="Noise of a point along the surface normal, metres", show_default=False)],
    visible: Annotated[float, typer.Option("--visible", help="Share of a unit's surface that holds points")] = 0.3,
    registration: Annotated[
        float, typer.Option("--registration", help="Registration of an epoch at the unit, metres per coordinate")
    ] = 0.0,
    systematic: Annotated[float, typer.Option("--systematic", help="What does not average out, metres per coordinate")] = 0.0,
    tilt: Annotated[float, typer.Option("--tilt", help="Line of sight from the vertical, degrees")] = 0.0,
    significance: Annotated[float, typer.Option("--significance", help="Probability of a false alarm for one unit")] = 0.001,
    power: Annotated[float, typer.Option("--power", help="Probability with which the displacement is found")] = 0.8,
    shape_fixed: Annotated[bool, typer.Option("--shape-fixed/--shape-free", help="Radius and gradient are known and held")] = True,
    unit: UnitName = "tetrapod",
    height: Height = None,
    radius: Radius = None,
    gradient: Gradient = None,
    leg_length: LegLength = None,
    opening: Opening = "tetrahedral",
    calibrate: Annotated[str, typer.Option("--calibrate", hidden=True)] = "",
    quiet: Quiet = False,
    log_file: LogFile = None,
    json_progress: JsonProgress = False,
) -> None:
    """Smallest displacement that a planned survey can detect."""

    def step(feedback: Feedback) -> dict[str, Any]:
        import math

        from ..core.errors import InputError
        from ..core.planning import SurveyPlan, detectability

        try:
            shape = _unit(unit, height, radius, gradient, leg_length, opening)
            survey = SurveyPlan(density, noise, visible, systematic, registration, math.radians(tilt), shape_fixed, significance, power)
            found = detectability(shape, survey)
        except ValueError as error:
            raise InputError(str(error), remedy="Change the option it names.") from error
        return {
            "points": found.points,
            "sd_centre": found.sd_centre,
            "sd_rotation_deg": math.degrees(found.sd_rotation),
            "sd_displacement": found.sd_displacement,
            "detectable_worst": found.detectable_worst,
            "detectable_mean": found.detectable_mean,
            "detectable_rotation_deg": math.degrees(found.detectable_rotation),
        }

    _run(quiet, log_file, json_progress, step)


@app.command()
def relief(
    survey: SurveyFile,
    output: Annotated[Path, typer.Option("--output", "-o", help="Start of the files' names: OUTPUT_<epoch>.tif", show_default=False)],
    quiet: Quiet = False,
    log_file: LogFile = None,
    json_progress: JsonProgress = False,
) -> None:
    """Shaded relief of every epoch from above, as GeoTIFF."""

    def step(feedback: Feedback) -> dict[str, Any]:
        from ..core.relief import run_relief
        from ..core.survey import read_survey

        return run_relief(read_survey(survey), output, feedback)

    _run(quiet, log_file, json_progress, step)


@app.command()
def report(
    result: ResultFile,
    output: Annotated[Path, typer.Option("--output", "-o", help="File to write, .html or .pdf", show_default=False)],
    epoch_from: EpochFrom = None,
    epoch_to: EpochTo = None,
    datum: Datum = None,
    language: Annotated[str, typer.Option("--language", help="ja, ko, zh-Hans, fr, pt, es; otherwise English")] = "en",
    axis: Annotated[str, typer.Option("--axis", help="Axis of the structure: easting,northing easting,northing ...")] = "",
    width: Annotated[float | None, typer.Option("--width", help="Length of structure looked at, metres, for N_od")] = None,
    section: Annotated[float | None, typer.Option("--section", help="Length of a section along the axis, metres")] = None,
    worst: Annotated[int, typer.Option("--worst", min=0, help="Units shown one by one")] = 8,
    quiet: Quiet = False,
    log_file: LogFile = None,
    json_progress: JsonProgress = False,
) -> None:
    """Report of a reviewed result, as a web page or PDF."""

    def step(feedback: Feedback) -> dict[str, Any]:
        from ..core.report import ReportOptions, parse_axis, write_report

        line = parse_axis(axis) if axis else None
        options = ReportOptions(_pair(epoch_from, epoch_to), datum, language, line, width, section, worst)
        data = write_report(result, output, options)
        return {"report": str(output), "units": len(data.kept), "rejected": len(data.rejected)}

    _run(quiet, log_file, json_progress, step)


@app.command()
def alarms(
    result: ResultFile,
    output: Annotated[Path, typer.Option("--output", "-o", help="File to write, .csv or .geojson", show_default=False)],
    threshold: Annotated[float, typer.Option("--threshold", min=0, help="3D displacement in metres above which a unit is listed")] = 0.10,
    epoch_from: EpochFrom = None,
    epoch_to: EpochTo = None,
    datum: Datum = None,
    quiet: Quiet = False,
    log_file: LogFile = None,
    json_progress: JsonProgress = False,
) -> None:
    """List of units over a threshold, lost and relocated ones included, rejected ones left out."""

    def step(feedback: Feedback) -> dict[str, Any]:
        from ..core.alarms import write_alarms

        count = write_alarms(result, output, threshold, pair=_pair(epoch_from, epoch_to), datum=datum)
        return {"alarms": str(output), "units": count}

    _run(quiet, log_file, json_progress, step)


@app.command("unit-points")
def unit_points(
    survey: SurveyFile, result: ResultFile, quiet: Quiet = False, log_file: LogFile = None, json_progress: JsonProgress = False
) -> None:
    """Index the points around the units of a result, so that the review shows them at once."""

    def step(feedback: Feedback) -> dict[str, Any]:
        from ..core.survey import read_survey
        from ..core.unit_refit import index_unit_points

        return index_unit_points(read_survey(survey), result, feedback)

    _run(quiet, log_file, json_progress, step)


@app.command("label-tiles")
def label_tiles(
    survey: SurveyFile,
    result: ResultFile,
    folder: Annotated[Path, typer.Option("--folder", help="Folder for the tiles, one subfolder per epoch", show_default=False)],
    quiet: Quiet = False,
    log_file: LogFile = None,
    json_progress: JsonProgress = False,
) -> None:
    """Write the tiles again as LAZ with the number of each point's unit in a dimension unit_id."""

    def step(feedback: Feedback) -> dict[str, Any]:
        from ..core.labelled_tiles import write_labelled_tiles
        from ..core.survey import read_survey

        return write_labelled_tiles(read_survey(survey), result, folder, feedback)

    _run(quiet, log_file, json_progress, step)


@app.command()
def refit(
    result: ResultFile,
    unit_id: Annotated[str, typer.Option("--unit", help="Unit to fit again", show_default=False)],
    epoch: Annotated[str, typer.Option("--epoch", help="Epoch to fit it in", show_default=False)],
    near: Annotated[str, typer.Option("--near", help="Place on the unit: easting,northing,height", show_default=False)],
    editor: Annotated[str, typer.Option("--editor", help="Name stored beside the correction", show_default=False)],
    seed: Seed = 0,
    quiet: Quiet = False,
    log_file: LogFile = None,
    json_progress: JsonProgress = False,
) -> None:
    """Fit one unit again at a place shown, from the points of unit-points, and correct the result."""

    def step(feedback: Feedback) -> dict[str, Any]:
        from ..core.errors import InputError
        from ..core.unit_refit import refit_unit

        try:
            e, n, h = (float(value) for value in near.split(","))
        except ValueError as error:
            raise InputError(f"--near {near!r} is not a place", remedy="Write it as easting,northing,height in metres.") from error
        return refit_unit(result, unit_id, epoch, (e, n, h), editor=editor, seed=seed)

    _run(quiet, log_file, json_progress, step)


@app.command()
def batch(
    surveys: Annotated[list[Path], typer.Argument(metavar="SURVEY.toml...", help="Surveys; results go beside them", show_default=False)],
    workers: Workers = 0,
    scheduler: Scheduler = None,
    resume: Resume = False,
    quiet: Quiet = False,
    log_file: LogFile = None,
    json_progress: JsonProgress = False,
) -> None:
    """Run many surveys one after the other; one that fails does not end the others (exit code 2 at the end)."""

    def step(feedback: Feedback) -> dict[str, Any]:
        from .batch import run_batch

        return run_batch(surveys, _run_options(workers, scheduler, resume), feedback)

    _run(quiet, log_file, json_progress, step)


@app.command()
def watch(
    survey: SurveyFile,
    interval: Annotated[float, typer.Option("--interval", min=1, help="Seconds between looks")] = 60.0,
    once: Annotated[bool, typer.Option("--once", help="Look and, if there is something new, run once; for cron")] = False,
    workers: Workers = 0,
    scheduler: Scheduler = None,
    quiet: Quiet = False,
    log_file: LogFile = None,
    json_progress: JsonProgress = False,
) -> None:
    """Run a survey whenever new tiles or epochs appear; the result goes beside survey.toml."""

    def step(feedback: Feedback) -> dict[str, Any]:
        from .batch import watch as look

        return look(survey, _run_options(workers, scheduler, False), interval, once, feedback)

    _run(quiet, log_file, json_progress, step)


@app.command()
def template() -> None:
    """Print a survey.toml to fill in."""
    from ..core.survey import template as text

    typer.echo(text(), nl=False)


def _pair(epoch_from: str | None, epoch_to: str | None) -> EpochPair | None:
    """Epoch pair of two options, both or none."""
    from ..core.errors import InputError
    from ..core.result_tables import EpochPair

    if epoch_from is None and epoch_to is None:
        return None
    if epoch_from is None or epoch_to is None:
        raise InputError("an epoch pair needs --from and --to", remedy="Give both, or none for the last pair.")
    return EpochPair(epoch_from, epoch_to)


def _unit(
    name: str, height: float | None, radius: float | None, gradient: float | None, leg_length: float | None, opening: str
) -> UnitType:
    """Unit type from options, checked as [unit] of survey.toml is."""
    from ..core.survey import unit_from_keys

    return unit_from_keys(
        {"type": name, "height": height, "radius": radius, "gradient": gradient, "leg_length": leg_length, "opening": opening}
    )


def _run_options(workers: int, scheduler: str | None, resume: bool) -> list[str]:
    """The options of ``run`` that its callers pass on."""
    options = ["--workers", str(workers)]
    if scheduler is not None:
        options += ["--scheduler", scheduler]
    return [*options, "--resume"] if resume else options


def main() -> None:
    """Entry point of the console command."""
    app()


if __name__ == "__main__":
    main()
