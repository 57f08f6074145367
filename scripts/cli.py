"""The console command ``tetratrack``: one subcommand for each step, and ``run`` for all. Heavy libraries are imported by the step
that needs them."""

from __future__ import annotations

import sys
from collections.abc import Callable
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import typer

from ..core.common.feedback import Feedback
from .console import FINISHED, NOTHING, Console, execute, prepare_process, print_document

if TYPE_CHECKING:
    from ..core.model.unit_types import UnitType
    from ..core.results.geopackage_reader import EpochPair

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
Seed = Annotated[int, typer.Option("--seed", min=0, max=2**63 - 1, help="Seed of the random draws")]
Quiet = Annotated[bool, typer.Option("--quiet", "-q", help="Nothing but the result and errors")]
LogFile = Annotated[Path | None, typer.Option("--log-file", help="Append every line with its time to this file")]
JsonProgress = Annotated[bool, typer.Option("--json-progress", help="One JSON object a line on standard output, for other programs")]
EpochFrom = Annotated[str | None, typer.Option("--from", help="Earlier epoch; by default of the last pair")]
EpochTo = Annotated[str | None, typer.Option("--to", help="Later epoch")]
Datum = Annotated[str | None, typer.Option("--datum", help="stable or control; by default the result's")]
Separator = Annotated[str, typer.Option("--separator", help="Between fields of a CSV: comma, tab, or semicolon (with decimal commas)")]
Axis = Annotated[str, typer.Option("--axis", help="Axis of the structure: easting,northing easting,northing ...")]
Tolerance = Annotated[float | None, typer.Option("--tolerance", min=0, help="Metres a unit may be from its planned place")]
TurnTolerance = Annotated[float | None, typer.Option("--turn-tolerance", min=0, help="Degrees it may be turned")]
ProfileTolerance = Annotated[float | None, typer.Option("--profile-tolerance", min=0, help="Metres a unit may be off the design profile")]
Reference = Annotated[str, typer.Option("--reference", help="Judged against the profile: outer (outermost point) or centre")]
UnitName = Annotated[str, typer.Option("--unit", help='Type of unit, "tetrapod" or e.g. "tetrapod 8 t"')]
DraftCrs = Annotated[str | None, typer.Option("--crs", help="CRS of the survey where the tiles declare none, or LOCAL; for folders")]
DraftHeight = Annotated[
    float | None, typer.Option("--height", min=1e-6, help="Height of the units, metres, instead of an estimate; for folders")
]
Height = Annotated[float | None, typer.Option("--height", min=1e-6, help="Nominal height H, metres")]
Radius = Annotated[float | None, typer.Option("--radius", min=1e-6, help="Leg cone radius at the unit's centre, metres")]
Gradient = Annotated[float | None, typer.Option("--gradient", min=1e-6, help="Loss of radius per metre of leg")]
LegLength = Annotated[float | None, typer.Option("--leg-length", min=1e-6, help="Centre to end disc, metres")]
Opening = Annotated[str, typer.Option("--opening", help="tetrahedral or paper")]


def _run(quiet: bool, log_file: Path | None, json_progress: bool, step: Callable[[Feedback], dict[str, Any]], left: str = NOTHING) -> None:
    """Run a step with its messages going to the console, and leave with its exit code; ``left`` stays of it when it is ended."""

    def with_feedback(console: Console) -> dict[str, Any]:
        return step(Feedback(console.progress, console.info, console.warning, lambda: console.cancelled))

    raise typer.Exit(execute(Console(quiet, log_file, json_progress), with_feedback, left))


@app.command()
def run(
    survey: Annotated[
        list[str],
        typer.Argument(
            metavar="SURVEY.toml|FOLDER...", help="What was surveyed, or folders, tiles or patterns of them", show_default=False
        ),
    ],
    output: Output,
    crs: DraftCrs = None,
    unit_height: DraftHeight = None,
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
        from ..core.data.file_patterns import given_paths
        from ..core.pipeline.given_survey import Given, given_survey
        from ..core.pipeline.local_processes import processes_for

        found = given_survey(given_paths(survey), Given(height=unit_height, crs=crs), output, feedback)
        with processes_for(workers, scheduler, forked=True) as processes:
            # they load their libraries while this process loads its own, or are copies of it
            processes.start(len(found.epochs))
            from ..core.pipeline.run_options import RunOptions
            from ..core.pipeline.whole_survey import run_survey

            return run_survey(found, output, RunOptions(workers, scheduler, resume, seed), feedback, processes)

    _run(quiet, log_file, json_progress, step, NOTHING if len(survey) == 1 and survey[0].endswith(".toml") and not resume else FINISHED)


@app.command()
def init(
    given_folders: Annotated[
        list[str] | None, typer.Argument(metavar="FOLDER...", help="Folders, tiles or patterns of them", show_default=False)
    ] = None,
    crs: DraftCrs = None,
    unit_height: DraftHeight = None,
    name: Annotated[str | None, typer.Option("--name", help="Name of the survey; default the folder's")] = None,
    size: Annotated[bool, typer.Option("--size/--no-size", help="Estimate the size of the units, which takes a minute")] = True,
    epochs: Annotated[Path | None, typer.Option("--epochs", help="Epochs as the plugin's table holds them, JSON", hidden=True)] = None,
    output: Annotated[Path | None, typer.Option("--output", "-o", help="File to write instead of standard output")] = None,
    quiet: Quiet = False,
    log_file: LogFile = None,
    json_progress: JsonProgress = False,
) -> None:
    """Write a survey.toml from what the files in folders say: epochs, CRS, tables, size of the units.

    It goes to standard output; on a terminal, to survey.toml in the first folder.
    """

    def step(feedback: Feedback) -> dict[str, Any]:
        from ..core.data.file_patterns import given_paths
        from ..core.data.survey_draft import draft_record, draft_text
        from ..core.pipeline.given_epochs import read_given_epochs
        from ..core.pipeline.given_survey import Given
        from ..core.pipeline.new_survey import check_draft, draft_of_rows, draft_survey, write_draft

        given, folders = Given(height=unit_height, crs=crs, name=name), given_paths(given_folders or [])
        beside = folders[0] / "survey.toml" if folders and sys.stdout is not None and sys.stdout.isatty() and folders[0].is_dir() else None
        target = output or beside
        if target is not None:
            check_draft(target)
        if epochs is not None:
            draft = draft_of_rows(read_given_epochs(epochs), given, feedback, size=size)
        else:
            draft = draft_survey(folders, given, feedback, size=size)
        for warning in (*draft.questions, *draft.warnings):
            feedback.warning(warning)
        found = {"questions": len(draft.questions)} | ({"draft": draft_record(draft)} if json_progress else {})
        if target is None:
            return found if json_progress else {"document": draft_text(draft)}
        feedback.info(draft_text(draft, target.absolute().parent))
        write_draft(draft, target)
        return {"survey": str(target)} | found

    _run(quiet, log_file, json_progress, step)


@app.command()
def inspect(
    tiles: Annotated[
        list[str], typer.Argument(metavar="TILES...", help="Tiles, folders or patterns of them, or a survey.toml", show_default=False)
    ],
    output: Annotated[Path | None, typer.Option("--output", "-o", help="GeoPackage for a layer of the tiles' extents")] = None,
    quiet: Quiet = False,
    log_file: LogFile = None,
    json_progress: JsonProgress = False,
) -> None:
    """Verdict on every input: tiles with extent, CRS, points; tables and epochs against each other. Exit code 2 if a run would refuse."""

    def step(console: Console) -> dict[str, Any]:
        from ..core.data.file_patterns import given_paths
        from ..core.data.folder_epochs import given_tiles
        from ..core.data.survey_reader import read_survey
        from ..core.pipeline.inspection import run_inspect

        feedback = Feedback(console.progress, console.info, console.warning)
        inputs = [read_survey(path) if path.suffix.lower() == ".toml" else path for path in given_tiles(given_paths(tiles))]
        outputs, error = run_inspect(inputs, output, feedback)
        if error is not None:
            console.result(outputs)
            raise error
        return outputs

    raise typer.Exit(execute(Console(quiet, log_file, json_progress), step))


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
        from ..core.data.survey_reader import read_survey
        from ..core.pipeline.run_options import RunOptions
        from ..core.pipeline.whole_survey import run_segment

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
        from ..core.data.survey_reader import read_survey
        from ..core.pipeline.run_options import RunOptions
        from ..core.pipeline.whole_survey import run_fit

        return run_fit(read_survey(survey), units, output, RunOptions(workers, scheduler, resume, seed), feedback)

    _run(quiet, log_file, json_progress, step)


@app.command()
def features(
    units: ResultFile,
    output: Output,
    end_discs: Annotated[bool, typer.Option("--end-discs", help="Centres of the legs' end discs as well: d1 to d4")] = False,
    leg_length: LegLength = None,
    quiet: Quiet = False,
    log_file: LogFile = None,
    json_progress: JsonProgress = False,
) -> None:
    """Feature points with covariance from adjusted units."""

    def step(feedback: Feedback) -> dict[str, Any]:
        from ..core.pipeline.whole_survey import run_features

        return run_features(units, output, feedback, end_discs=end_discs, leg_length=leg_length)

    _run(quiet, log_file, json_progress, step)


@app.command()
def register(
    survey: SurveyFile, output: Output, quiet: Quiet = False, log_file: LogFile = None, json_progress: JsonProgress = False
) -> None:
    """Register every epoch's cloud to survey control."""

    def step(feedback: Feedback) -> dict[str, Any]:
        from ..core.data.survey_reader import read_survey
        from ..core.pipeline.run_options import RunOptions
        from ..core.pipeline.whole_survey import run_register

        return run_register(read_survey(survey), output, RunOptions(), feedback)

    _run(quiet, log_file, json_progress, step)


@app.command()
def track(
    units: ResultFile,
    output: Output,
    registration: Annotated[list[Path] | None, typer.Option("--registration", help="Result of register; repeat for several")] = None,
    frame: Annotated[str, typer.Option("--frame", help="Whether an epoch's cloud may be bent: auto, rigid or elastic")] = "auto",
    quiet: Quiet = False,
    log_file: LogFile = None,
    json_progress: JsonProgress = False,
) -> None:
    """Identity, datum and displacements from the fitted units of several epochs."""

    def step(feedback: Feedback) -> dict[str, Any]:
        from ..core.data.file_patterns import given_paths
        from ..core.pipeline.layer_tracking import run_track

        return run_track(units, given_paths(registration or []), output, feedback, frame)

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
        from ..core.pipeline.single_steps import run_validate

        return run_validate(features, check, picks, epoch, output, feedback)

    _run(quiet, log_file, json_progress, step)


@app.command()
def export(
    result: ResultFile,
    output: Annotated[Path, typer.Option("--output", "-o", help="Folder for one file a layer", show_default=False)],
    formats: Annotated[list[str] | None, typer.Option("--format", help="csv or parquet; repeat for both, which is the default")] = None,
    layers: Annotated[list[str] | None, typer.Option("--layer", help="Layer to write; repeat for several, default all")] = None,
    separator: Separator = "comma",
    quiet: Quiet = False,
    log_file: LogFile = None,
    json_progress: JsonProgress = False,
) -> None:
    """Layers of a result as CSV and GeoParquet."""

    def step(feedback: Feedback) -> dict[str, Any]:
        from ..core.results.export import FORMATS, export_layers

        return {"output": str(output), "files": len(export_layers(result, output, formats or FORMATS, layers or (), separator))}

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
        from ..core.data.file_patterns import given_paths
        from ..core.pipeline.single_steps import run_register_views

        return run_register_views(given_paths(views), output, voxel, feedback)

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
    castings: Annotated[bool, typer.Option("--castings", help="Units differ from ideal cones as real castings do")] = False,
    bridging: Annotated[
        float, typer.Option("--bridging", min=0, help="Photogrammetry: radius of the narrowest hollow it follows, metres; 0: all")
    ] = 0.0,
    broken: Annotated[int | None, typer.Option("--broken", min=0, help="Units with a broken leg; default one of 38")] = None,
    other_views: Annotated[bool, typer.Option("--other-views", help="Later epochs are seen from other lines or stations")] = False,
    bend: Annotated[float, typer.Option("--bend", min=0, help="Bend of every epoch along the site, metres rms per coordinate")] = 0.0,
    drift: Annotated[float, typer.Option("--drift", min=0, help="Bend of every strip or station for itself, metres rms")] = 0.0,
    bowl: Annotated[float, typer.Option("--bowl", min=0, help="Doming of an image block: height error at the site's ends, metres")] = 0.0,
    wave_lengths: Annotated[
        tuple[float, float], typer.Option("--wave-lengths", help="Shortest and longest wave of bend and drift, metres")
    ] = (60.0, 300.0),
    length: Annotated[float, typer.Option("--length", min=0, help="Coast of this length in metres, of stretches of --units each")] = 0.0,
    targets_every: Annotated[float, typer.Option("--targets-every", min=0, help="Distance of targets along a coast; 0 for none")] = 24.0,
    slide: Annotated[float, typer.Option("--slide", min=0, help="Slide of a coast's middle stretch after the first epoch, metres")] = 0.0,
    calibrate: Annotated[str, typer.Option("--calibrate", hidden=True)] = "",
    seed: Seed = 0,
    quiet: Quiet = False,
    log_file: LogFile = None,
    json_progress: JsonProgress = False,
) -> None:
    """Simulate a survey of a pile of units, or of a coast of many, with ground truth."""

    def step(feedback: Feedback) -> dict[str, Any]:
        from ..core.simulation.bent_frames import FrameErrors
        from ..core.simulation.survey_plan import plan_of, usual_height
        from ..core.simulation.virtual_survey import simulate_survey

        told = usual_height(instrument) if height is None and unit.strip().lower() == "tetrapod" else height
        plan = plan_of(
            instrument, name, _unit(unit, told, radius, gradient, leg_length, opening), units=units, epochs=epochs, seed=seed,
            density=density or None, noise=noise or None, crs=crs, castings=castings, bridging=bridging, other_views=other_views,
            frame=FrameErrors(bend=bend, drift=drift, bowl=bowl, shortest=wave_lengths[0], longest=wave_lengths[1]),
            length=length, targets_every=targets_every, slide=slide, broken=broken,
        )  # fmt: skip
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
    coast: Annotated[float, typer.Option("--coast", help="Length of the structure, metres: says how many stations of targets")] = 0.0,
    limit: Annotated[float, typer.Option("--limit", help="Detection limit wanted against control anywhere on it, metres")] = 0.05,
    bend: Annotated[float, typer.Option("--bend", help="Bend of an epoch, metres rms per coordinate")] = 0.03,
    correlation_length: Annotated[
        float, typer.Option("--correlation-length", help="Distance over which the bend forgets itself, metres (see layer frame_errors)")
    ] = 35.0,
    target_sd: Annotated[float, typer.Option("--target-sd", help="Standard deviation of a target in the cloud, metres")] = 0.006,
    targets: Annotated[int, typer.Option("--targets", min=1, help="Targets of a station")] = 3,
    curves: Annotated[bool, typer.Option("--curves", help="Also over densities and visible shares, for a chart", hidden=True)] = False,
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
    """Smallest displacement that a planned survey can detect, and targets that a long structure needs."""

    def step(feedback: Feedback) -> dict[str, Any]:
        import math

        from ..core.adjustment.detectability import SurveyPlan, detectability, detectability_curves
        from ..core.adjustment.expectation import expected
        from ..core.common.errors import InputError
        from ..core.registration.target_spacing import BentSurvey, stations_for

        try:
            shape = _unit(unit, height, radius, gradient, leg_length, opening)
            survey = SurveyPlan(
                density,
                noise,
                visible_share=visible,
                systematic=systematic,
                registration=registration,
                tilt=math.radians(tilt),
                shape_fixed=shape_fixed,
                significance=significance,
                power=power,
            )
            found = detectability(shape, survey)
            shown = expected(density * shape.height**2, noise / shape.height, shape)
            drawn = {"curves": detectability_curves(shape, survey)} if curves else {}
        except ValueError as error:
            raise InputError(str(error), remedy="Change the number it names.") from error
        along: dict[str, Any] = {}
        # a length that is none is refused there
        if coast != 0:
            bent = BentSurvey(bend=bend, correlation_length=correlation_length, target_sd=target_sd, targets=targets)
            stations, spacing = stations_for(bent, limit, coast)
            along = {"stations": stations, "station_spacing": spacing, "detectable_control": bent.detectable(spacing)}
        numbers = {
            "points": found.points,
            "sd_centre": found.sd_centre,
            "sd_rotation_deg": math.degrees(found.sd_rotation),
            "sd_displacement": found.sd_displacement,
            "detectable_worst": found.detectable_worst,
            "detectable_mean": found.detectable_mean,
            "detectable_rotation_deg": math.degrees(found.detectable_rotation),
            "points_per_square": density * shape.height**2,
            **dict(zip(("recall_30", "recall_15", "recall_5"), shown.recall, strict=True)),
        }
        return along | drawn | numbers

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
        from ..core.data.survey_reader import read_survey
        from ..core.pipeline.relief import run_relief

        return run_relief(read_survey(survey), output, feedback)

    _run(quiet, log_file, json_progress, step, FINISHED)


@app.command()
def report(
    result: ResultFile,
    output: Annotated[Path, typer.Option("--output", "-o", help="File to write, .html or .pdf", show_default=False)],
    epoch_from: EpochFrom = None,
    epoch_to: EpochTo = None,
    datum: Datum = None,
    language: Annotated[str, typer.Option("--language", help="ja, ko, zh-Hans, fr, pt, es; otherwise English")] = "en",
    axis: Axis = "",
    width: Annotated[float | None, typer.Option("--width", help="Length of structure looked at, metres, for N_od")] = None,
    section: Annotated[float | None, typer.Option("--section", help="Length of a section along the axis, metres")] = None,
    worst: Annotated[int, typer.Option("--worst", min=0, help="Units shown one by one")] = 8,
    step_length: Annotated[float | None, typer.Option("--step", help="Distance of the cross-sections, metres; default 4 H")] = None,
    bands: Annotated[str, typer.Option("--bands", help="Movement bands: cm (5, 10), dn (0.5, 1 Dn), usace (0.09, 0.30, 0.61 m)")] = "usace",
    plan: Annotated[str, typer.Option("--plan", help="Placement plan to compare with, as of design")] = "",
    profile: Annotated[str, typer.Option("--profile", help="Design profile to compare with, as of design")] = "",
    tolerance: Tolerance = None,
    turn_tolerance: TurnTolerance = None,
    profile_tolerance: ProfileTolerance = None,
    reference: Reference = "outer",
    quiet: Quiet = False,
    log_file: LogFile = None,
    json_progress: JsonProgress = False,
) -> None:
    """Report of a reviewed result, as a web page or PDF."""

    def step(feedback: Feedback) -> dict[str, Any]:
        from ..core.armour.comparisons import design_of
        from ..core.common.axis import parse_axis
        from ..core.report.report import ReportOptions, said_of_fonts, write_report
        from ..core.report.structure_pages import StructureOptions

        line = parse_axis(axis) if axis else None
        limits = {"tolerance": tolerance, "turn_tolerance": turn_tolerance, "profile_tolerance": profile_tolerance}
        wanted = design_of(plan=plan, profile=profile, reference=reference, axis=axis, **limits) if plan or profile else None
        structure = StructureOptions(design=wanted, step=step_length, bands=bands)
        pair = _pair(epoch_from, epoch_to)
        options = ReportOptions(
            pair=pair, datum=datum, language=language, axis=line, width=width, section=section, worst=worst, structure=structure
        )
        data = write_report(result, output, options)
        for note in data.notes:
            feedback.warning(note)
        said = said_of_fonts(data, language)
        if said:
            feedback.warning(said)
        return {"report": str(output), "units": len(data.kept), "rejected": len(data.rejected)}

    _run(quiet, log_file, json_progress, step)


@app.command()
def model(
    result: ResultFile,
    output: Annotated[Path, typer.Option("--output", "-o", help="File to write: .glb, .obj, .dxf, .ifc or .json", show_default=False)],
    epoch: Annotated[str | None, typer.Option("--epoch", help="Epoch to show; default the latest with units", show_default=False)] = None,
    quiet: Quiet = False,
    log_file: LogFile = None,
    json_progress: JsonProgress = False,
) -> None:
    """As-built model of one epoch, or its poses (.json)."""

    def step(feedback: Feedback) -> dict[str, Any]:
        from ..core.report.model_export import write_model

        written = write_model(result, output, epoch)
        return {"model": str(output), "units": len(written.units), "epoch": written.epoch}

    _run(quiet, log_file, json_progress, step)


@app.command()
def design(
    result: ResultFile,
    output: Annotated[Path, typer.Option("--output", "-o", help="GeoPackage to write", show_default=False)],
    plan: Annotated[str, typer.Option("--plan", help="Placement plan: CSV unit_id,easting,northing,height, or a layer of points")] = "",
    profile: Annotated[str, typer.Option("--profile", help="Design profile: layer of lines with heights, or DXF")] = "",
    tolerance: Tolerance = None,
    turn_tolerance: TurnTolerance = None,
    profile_tolerance: ProfileTolerance = None,
    reference: Reference = "outer",
    axis: Axis = "",
    epoch: Annotated[str | None, typer.Option("--epoch", help="Epoch to compare; default the latest with units")] = None,
    quiet: Quiet = False,
    log_file: LogFile = None,
    json_progress: JsonProgress = False,
) -> None:
    """As-built units against a placement plan and a design profile."""

    def step(feedback: Feedback) -> dict[str, Any]:
        from ..core.armour.comparisons import design_of, write_design_comparison
        from ..core.results.field_checks import foreign_contents

        limits = {"tolerance": tolerance, "turn_tolerance": turn_tolerance, "profile_tolerance": profile_tolerance}
        wanted = design_of(plan=plan, profile=profile, reference=reference, axis=axis, **limits)
        with foreign_contents(result):
            found = write_design_comparison(result, output, wanted, epoch)
        if found.plan is not None and found.plan.doubt:
            feedback.warning(found.plan.doubt)
        return {"output": str(output), "epoch": found.epoch} | found.counts

    _run(quiet, log_file, json_progress, step)


@app.command()
def profiles(
    result: ResultFile,
    output: Annotated[Path, typer.Option("--output", "-o", help="GeoPackage to write", show_default=False)],
    step_length: Annotated[float | None, typer.Option("--step", help="Distance of the sections, metres; default 4 H")] = None,
    profile: Annotated[str, typer.Option("--profile", help="Design profile to draw: layer of lines with heights, or DXF")] = "",
    axis: Axis = "",
    quiet: Quiet = False,
    log_file: LogFile = None,
    json_progress: JsonProgress = False,
) -> None:
    """Cross-sections of all epochs, crest height and width, and settlement along the structure."""

    def step(feedback: Feedback) -> dict[str, Any]:
        from ..core.armour.comparisons import write_profiles
        from ..core.common.axis import parse_axis
        from ..core.results.field_checks import foreign_contents

        with foreign_contents(result):
            found = write_profiles(result, output, axis=parse_axis(axis) if axis else None, step=step_length, profile=profile)
        if not found.has_points:
            feedback.warning("sections show no points: there is no index of them beside the result (tetratrack unit-points)")
        return {"output": str(output), "sections": len(found.planes), "epochs": len(found.epochs)}

    _run(quiet, log_file, json_progress, step)


@app.command()
def residuals(
    result: ResultFile,
    output: Annotated[Path, typer.Option("--output", "-o", help="File to write, .laz or .las", show_default=False)],
    epoch: Annotated[str | None, typer.Option("--epoch", help="Epoch to show; default the latest with units")] = None,
    quiet: Quiet = False,
    log_file: LogFile = None,
    json_progress: JsonProgress = False,
) -> None:
    """Points less blocks: the points of unit-points with their distance to the nearest fitted unit, coloured."""

    def step(feedback: Feedback) -> dict[str, Any]:
        from ..core.armour.residual_cloud import write_residual_cloud
        from ..core.results.field_checks import foreign_contents

        with foreign_contents(result):
            found = write_residual_cloud(result, output, epoch)
        return {"output": str(output), "points": found.points, "near": found.near, "median": found.median}

    _run(quiet, log_file, json_progress, step)


@app.command()
def alarms(
    result: ResultFile,
    output: Annotated[Path, typer.Option("--output", "-o", help="File to write, .csv or .geojson", show_default=False)],
    threshold: Annotated[float, typer.Option("--threshold", min=0, help="3D displacement in metres above which a unit is listed")] = 0.10,
    epoch_from: EpochFrom = None,
    epoch_to: EpochTo = None,
    datum: Datum = None,
    separator: Separator = "comma",
    quiet: Quiet = False,
    log_file: LogFile = None,
    json_progress: JsonProgress = False,
) -> None:
    """List of units over a threshold, lost and relocated ones included, rejected ones left out."""

    def step(feedback: Feedback) -> dict[str, Any]:
        from ..core.report.alarms import write_alarms

        count = write_alarms(result, output, threshold, pair=_pair(epoch_from, epoch_to), datum=datum, separator=separator)
        return {"alarms": str(output), "units": count}

    _run(quiet, log_file, json_progress, step)


@app.command("unit-points")
def unit_points(
    survey: SurveyFile, result: ResultFile, quiet: Quiet = False, log_file: LogFile = None, json_progress: JsonProgress = False
) -> None:
    """Index the points around the units of a result, so that the review shows them at once."""

    def step(feedback: Feedback) -> dict[str, Any]:
        from ..core.data.survey_reader import read_survey
        from ..core.pipeline.refit import index_unit_points
        from ..core.results.field_checks import foreign_contents

        with foreign_contents(result):
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
        from ..core.data.survey_reader import read_survey
        from ..core.pipeline.labelled_tiles import write_labelled_tiles
        from ..core.results.field_checks import foreign_contents

        with foreign_contents(result):
            return write_labelled_tiles(read_survey(survey), result, folder, feedback)

    _run(quiet, log_file, json_progress, step, FINISHED)


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
        from ..core.common.errors import InputError
        from ..core.pipeline.refit import refit_unit

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
        from ..core.data.file_patterns import given_paths
        from .batch import run_batch

        # each by itself: a survey that is named twice is refused, not run once in silence
        given = [path for name in surveys for path in given_paths([name])]
        return run_batch(given, _run_options(workers, scheduler, resume), feedback)

    _run(quiet, log_file, json_progress, step, FINISHED)


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

    _run(quiet, log_file, json_progress, step, FINISHED)


@app.command()
def demo(
    folder: Annotated[Path, typer.Argument(metavar="[FOLDER]", help="Where the result and its report go")] = Path("demo"),
    workers: Workers = 0,
    quiet: Quiet = False,
    log_file: LogFile = None,
    json_progress: JsonProgress = False,
) -> None:
    """Run the sample survey and write its report, to see what comes out."""

    def step(feedback: Feedback) -> dict[str, Any]:
        from .demo import run_demo

        return run_demo(folder, workers, feedback)

    _run(quiet, log_file, json_progress, step, FINISHED)


@app.command("warm-up")
def warm_up(quiet: Quiet = False, log_file: LogFile = None, json_progress: JsonProgress = False) -> None:
    """Compile what the first run would otherwise wait for; once after installing, by whoever installs."""

    def step(feedback: Feedback) -> dict[str, Any]:
        from .warm_up import warm_up as compile_loops

        return {"seconds": round(compile_loops(feedback))}

    _run(quiet, log_file, json_progress, step)


@app.command()
def template() -> None:
    """Print a survey.toml to fill in."""
    from ..core.data.survey_keys import template as text

    raise typer.Exit(print_document(text()))


def _pair(epoch_from: str | None, epoch_to: str | None) -> EpochPair | None:
    """Epoch pair of two options, both or none."""
    from ..core.common.errors import InputError
    from ..core.results.geopackage_reader import EpochPair

    if epoch_from is None and epoch_to is None:
        return None
    if epoch_from is None or epoch_to is None:
        raise InputError("an epoch pair needs --from and --to", remedy="Give both, or none for the last pair.")
    return EpochPair(epoch_from, epoch_to)


def _unit(
    name: str, height: float | None, radius: float | None, gradient: float | None, leg_length: float | None, opening: str
) -> UnitType:
    """Unit type from options, checked as [unit] of survey.toml is."""
    from ..core.data.survey_keys import unit_from_keys

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
    prepare_process()
    app()


if __name__ == "__main__":
    main()
