"""What can be expected of a cloud before it is worked on: share of the units found, and displacements that show.

Recall is the phase diagram that ``benchmarks/accuracy/poor_clouds.py`` measures on thinned and noised copies of surveys with ground truth,
interpolated; the detection limit is the bound of :mod:`.detectability` for a unit of which three tenths are seen.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from ..common.arrays import FloatArray
from ..model.unit_types import UnitType
from .detectability import SurveyPlan, detectability

CLASSES = ("30 % or more", "15-30 %", "5-15 %")
"""Visible shares of a unit's surface for which recall is told."""
DENSITIES = (100.0, 200.0, 400.0, 800.0, 1600.0, 4000.0)
"""Points per square of edge H, seen from above, of the phase diagram."""
NOISES = (0.007, 0.013, 0.021, 0.033)
"""Standard deviations of a point across the surface, as shares of H, of the phase diagram."""
RECALL = (
    ((0.81, 0.3, 0.0), (1.0, 0.6, 0.0), (1.0, 0.85, 0.0), (1.0, 1.0, 0.5), (1.0, 1.0, 0.75), (1.0, 1.0, 0.75)),
    ((0.0, 0.0, 0.0), (0.72, 0.2, 0.0), (0.96, 0.5, 0.12), (1.0, 0.8, 0.25), (1.0, 1.0, 0.5), (1.0, 1.0, 0.88)),
    ((0.06, 0.0, 0.0), (0.66, 0.05, 0.0), (0.91, 0.25, 0.0), (1.0, 0.6, 0.0), (1.0, 0.95, 0.25), (1.0, 1.0, 0.75)),
    ((0.0, 0.0, 0.0), (0.19, 0.0, 0.0), (0.68, 0.1, 0.0), (0.87, 0.4, 0.12), (1.0, 0.7, 0.25), (1.0, 0.95, 0.62)),
)
"""Share of units found: by noise, density and class."""
SEEN = 0.3
"""Visible share for which the detection limit is told."""
SYSTEMATIC_RATIO = 0.0005
"""What does not average out over the points of a unit, as a share of H: roughness, offsets of strips."""
LEVEL = 0.05
"""Significance of the test of a displacement, as in a run."""
SHORT, FAIR = 0.9, 0.5
"""Recall of well-seen units below which a cloud is called poor, and share of the units in the next class that a fair one shows."""
ORIENTATIONS = 24


@dataclass(frozen=True)
class Expectation:
    """What a cloud shows.

    Attributes
    ----------
    recall
        (3,) share of the units found, 0 to 1, by ``CLASSES``.
    limit
        Smallest displacement between two such epochs that is found with a probability of 80 %, metres; inf where no pose is determined.
    """

    recall: tuple[float, float, float]
    limit: float


def expected(density: float, noise: float, unit: UnitType) -> Expectation:
    """What to expect of a cloud.

    Parameters
    ----------
    density
        Points per square of edge H as seen from above.
    noise
        Standard deviation of a point across the surface as a share of H.
    unit
        Geometry of the units.
    """
    return Expectation(recall=_recall(density, noise), limit=_limit(density, noise, unit))


def _recall(density: float, noise: float) -> tuple[float, float, float]:
    """Bilinear in the logarithm of the density and in the noise; nothing is found far below the sparsest that was measured."""
    table: FloatArray = np.array(RECALL)
    # a cloud four times sparser than one in which nothing was found shows nothing, whatever the interpolation says
    densities = np.log([DENSITIES[0] / 4, *DENSITIES])
    at_noise = np.array([np.interp(noise, NOISES, column) for column in table.reshape(len(NOISES), -1).T]).reshape(len(DENSITIES), 3)
    padded = np.vstack([np.zeros(3), at_noise])
    first, second, third = (float(np.interp(np.log(max(density, 1e-9)), densities, column)) for column in padded.T)
    return first, second, third


def _limit(density: float, noise: float, unit: UnitType) -> float:
    plan = SurveyPlan(
        density=max(density, 1e-3) / unit.height**2,
        noise=max(noise, 1e-5) * unit.height,
        visible_share=SEEN,
        systematic=SYSTEMATIC_RATIO * unit.height,
        significance=LEVEL,
    )
    try:
        return detectability(unit, plan, orientations=ORIENTATIONS).detectable_worst
    except ValueError:
        return float("inf")


def advice(density: float, noise: float, unit: UnitType) -> tuple[str, bool]:
    """A sentence on a cloud, and whether it is poor enough to be a warning; arguments as for :func:`expected`."""
    here = expected(density, noise, unit)
    found = " / ".join(f"{100 * share:.0f}" for share in here.recall)
    said = (
        f"the cloud: {_rounded(density)} points per H², {100 * noise:.1f} % of H noise: expect {found} % of the units of which "
        f"{' / '.join(CLASSES)} of the surface are seen"
    )
    if np.isfinite(here.limit) and here.recall[0] > 0:
        said += f", and displacements from {_length(here.limit)} on (80 % found)"
    if here.recall[0] >= SHORT and here.recall[1] >= FAIR:
        return said, False
    gains = {"four times the points": _recall(4 * density, noise), "half the noise": _recall(density, noise / 2)}
    best = max(gains, key=lambda name: sum(gains[name]))
    better = " / ".join(f"{100 * share:.0f}" for share in gains[best])
    return f"{said}; {best} would show {better} %", here.recall[0] < SHORT


def _rounded(value: float) -> str:
    """A number to two significant digits, thousands apart."""
    return f"{float(f'{value:.2g}'):,.0f}".replace(",", " ")


def _length(metres: float) -> str:
    return f"{1000 * metres:.0f} mm" if metres < 0.1 else f"{metres:.2f} m"
