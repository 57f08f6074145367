"""The instruments of simulated surveys and their figures, each with a source or said to be an assumption.

No figure is that of one product: each lies where the sheets of makers and published tests of instruments of its kind lie. What is marked
*assumed* is this project's own choice, made so that surveys look like those that users have; results on simulated surveys hold for
such instruments, not for a certain one.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Literal

from .virtual_scanner import Returns, survey_depth_camera, survey_photogrammetry, survey_tls, survey_uav
from .virtual_scene import Surfaces

Instrument = Literal["uav", "tls", "photogrammetry", "depth_camera"]

SENSOR_FILES: dict[Instrument, str] = {"uav": "trajectory", "tls": "stations"}
"""Key of survey.toml under which an instrument's positions are given."""

ANGLE_SD = 0.002
"""Standard deviation of a beam's direction that the survey.toml proposes, degrees: the simulated beams are all but exact."""


@dataclass(frozen=True, kw_only=True)
class VirtualInstrument:
    """What distinguishes one kind of survey; lengths in metres.

    Attributes
    ----------
    scan
        Function of ``virtual_scanner`` that measures a scene.
    density
        Points per square metre at which the site is sampled, all lines together, or per station after thinning.
    noise
        Standard deviation of a range.
    offset
        Greatest offset of a flight line, station or view per axis.
    registration
        Standard deviation of the shift of a whole epoch.
    turn_deg
        Standard deviation of the turn of a whole epoch about each axis, degrees.
    target, control
        Standard deviation of a target in the cloud, and of its surveyed coordinates.
    surfaces
        Relief of the units.
    generator
        Generating software named in the LAS header.
    """

    scan: Callable[..., Returns]
    density: float
    noise: float
    offset: float
    registration: float
    turn_deg: float
    target: float
    control: float
    surfaces: Surfaces
    generator: str


OUTDOORS = Surfaces(roughness=0.003, fillet=0.05, chamfer=0.03, growth=0.4)
"""Of units of 2.3 m cast in steel moulds; all assumed: joints of formwork leave some millimetres, chamfers and fillets some centimetres,
and growth is seen on a good third of the units at the water line."""
INSTRUMENTS: dict[Instrument, VirtualInstrument] = {
    "uav": VirtualInstrument(
        scan=survey_uav,
        # assumed: a low and slow flight with overlapping strips
        density=950,
        # between 12 mm (thickness of the cloud from 120 m: sheet of DJI Zenmuse L3) and 20 mm (the same from 300 m), precision of 15 mm
        # and accuracy of 20 mm (sheet of RIEGL VQ-840-GL)
        noise=0.017,
        # assumed: what is left between strips after their adjustment
        offset=0.01,
        # assumed: below the 30 and 40 mm in height and plan that the sheet of DJI Zenmuse L3 states for its clouds without control
        registration=0.025,
        turn_deg=0.01,
        # assumed: centre of a panel from some hundred points; total station from a fixed network
        target=0.006,
        control=0.003,
        surfaces=OUTDOORS,
        generator="virtual UAV",
    ),
    "tls": VirtualInstrument(
        scan=survey_tls,
        # assumed: thinned as it is kept
        density=1250,
        # test of a Leica RTC360 by ISO 17123-9: 2.7 to 3.9 mm from 10 to 40 m, 7.7 mm at 50 m
        noise=0.004,
        # assumed: stations joined on targets of their own, the whole then shifted
        offset=0.004,
        registration=0.02,
        turn_deg=0.01,
        target=0.003,
        control=0.003,
        surfaces=OUTDOORS,
        generator="virtual TLS",
    ),
    "photogrammetry": VirtualInstrument(
        scan=survey_photogrammetry,
        # assumed: images of about one centimetre a pixel on the ground, matched to a fraction of one; no data sheet states it
        density=1100,
        noise=0.007,
        offset=0.0,
        registration=0.02,
        turn_deg=0.01,
        target=0.006,
        control=0.003,
        # dense matching smooths creases and edges over some pixels
        surfaces=Surfaces(roughness=0.004, fillet=0.16, chamfer=0.08, growth=0.4),
        generator="virtual photogrammetry",
    ),
    "depth_camera": VirtualInstrument(
        scan=survey_depth_camera,
        # assumed: pixels of a time-of-flight camera of one megapixel from less than a metre (sheet of Azure Kinect DK: 640 x 576 in 75 x 65
        # degrees)
        density=260_000,
        # assumed: mean of many frames; a single one stays below 17 mm up to 3.5 m (the same sheet, which Tölgyessy et al.,
        # 2021, confirm)
        noise=0.0017,
        offset=0.0004,
        registration=0.002,
        turn_deg=0.1,
        target=0.0004,
        control=0.0002,
        surfaces=Surfaces(roughness=0.0001, fillet=0.005, chamfer=0.003, growth=0.0),
        generator="virtual depth camera",
    ),
}
