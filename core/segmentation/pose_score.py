"""How sure a pose is that of a unit: the evidence for it, held against what units and chance show in clouds as rich as this one."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace
from typing import NamedTuple

import numpy as np
from scipy.spatial import cKDTree

from ..common.arrays import BoolArray, FloatArray
from ..model.unit_types import UnitType
from .pose_evidence import QUIET_RATIO
from .scene import Evidence, Scene

FEW_ELEMENTS = 40
"""Fewer supporting elements than this make a pose less likely, whatever share of those around it they are."""
FINE_TOLERANCE = 0.02
"""Tolerance, as a share of the height, up to which that holds: in proportion to a wider one more elements come to lie on a surface by
chance, so that in sparse clouds of much noise rock looks like units."""
NOISY_RATIO = 0.05
"""Tolerance, as a share of the height, above which the noise decides what can be seen."""
SPARSE_RATIO = 0.014
"""Spacing of points, as a share of the height, above which a cloud is sparse: small parts of legs show as legs no longer, normals blur."""


SURE_ALONE = 0.9
"""Score by its own elements from which the units around a pose can only add to it, and it is one of those around others."""
APART = 2
"""A pose with fewer sure ones around stands apart."""
AMONG_HEIGHTS = 1.6
"""Distance of centres, in heights, up to which units stand beside each other: 5 to 10 of a pile are that near to one of it."""


class Weights(NamedTuple):
    """Of a logistic model: intercept, and what each feature is multiplied by."""

    intercept: float
    features: tuple[float, ...]


class ScoreModel(NamedTuple):
    """Models of the score: of its features alone, and of these and the number of sure units around where that is asked too.

    ``doubts`` says whether what no unit shows speaks against a pose beyond its features; ``features`` makes these, (k, n), from the
    evidence for k poses, the tolerance in metres and what is typical of the cloud. ``apart_odds`` says how much likelier chance stands
    apart than a unit: by these the odds of what is judged by its own elements are divided there.
    """

    alone: Weights
    among: Weights | None
    doubts: bool
    features: Callable[[Evidence, float, TypicalUnit], FloatArray]
    apart_odds: float = 1.0


def score_features(found: Evidence, tolerance: float, typical: TypicalUnit) -> FloatArray:
    """(k, 6) what the score is made of.

    Log-odds that an element near the surface lies on it and that its normal agrees, both the more telling the more surface cells
    they come from; elements inside the solid; misfit against what is typical of this cloud and against the tolerance; extent.
    """
    close = found.close
    # two per cent of disagreement is always allowed for, so that the odds stay finite
    on_surface = np.log((close + 1) / (found.reached - close + 1 + 0.02 * close))
    agreeing = np.log((found.support + 1) / (close - found.support + 1 + 0.02 * close))
    extent = np.log1p(found.cells)
    return np.column_stack(
        [
            extent * on_surface,
            extent * agreeing,
            np.log1p(found.inside / (0.01 * close + 1)),
            np.minimum(found.misfit / max(typical.misfit, 1e-12), 4.0),
            found.misfit / tolerance,
            extent,
        ]
    )


def bridged_features(found: Evidence, tolerance: float, typical: TypicalUnit) -> FloatArray:
    """(k, 3) what the score is made of where gaps are bridged: log-odds of the rich model as far as believed, extent and support."""
    return _explained(RICH, found, tolerance, typical)


def matched_features(found: Evidence, tolerance: float, typical: TypicalUnit) -> FloatArray:
    """(k, 3) the same where neighbours share their noise, with the log-odds of the noisy model."""
    return _explained(NOISY, found, tolerance, typical)


def _explained(model: ScoreModel, found: Evidence, tolerance: float, typical: TypicalUnit) -> FloatArray:
    log_odds = _log_odds(model.alone, model.features(found, tolerance, typical), found, tolerance, replace(typical, model=model))
    return np.column_stack([np.clip(log_odds, -MOST_LOG_ODDS, MOST_LOG_ODDS), np.log1p(found.cells), np.log1p(found.support)])


RICH = ScoreModel(Weights(-4.48, (1.08, 1.67, -1.22, -1.62, -1.71, -1.41)), None, True, score_features)
SPARSE = ScoreModel(Weights(5.16, (0.60, 0.06, -3.11, 0.85, -19.6, 0.12)), None, False, score_features, apart_odds=20.0)
NOISY = ScoreModel(Weights(0.73, (0.06, 0.99, -2.36, -0.30, -25.7, 2.24)), None, False, score_features)
SMOOTHED = ScoreModel(
    Weights(-3.79, (0.68, 0.82, -4.39, 0.0, -7.79, -0.37)),
    Weights(-10.37, (0.64, 0.59, -3.51, 0.0, -9.66, 0.33, 3.86)),
    False,
    score_features,
    apart_odds=100.0,
)
"""In sparse clouds normals say little, and how closely the elements lie to the surface nearly all; in noisy ones of too few points to take
the noise off both, and the extent; where it was taken off, rock smoothed alike fits a part of a unit about as well, but hardly ever where
units stand around. There what is typical of the cloud is left out, as a table that fits badly is where few units stand on one.

Of 373 right poses in noised copies of six simulated piles one stands apart, of 645 wrong ones (two scenes of rock among them) 354; a second
right one is allowed for. In sparse copies of eight piles and ten scenes of rock 8 of 2241 right poses (five of them one unit) stand apart,
of 2705 wrong ones 1661: held against the scores the odds are 28 to 46, and less excludes the same."""
BRIDGED = ScoreModel(Weights(-23.34, (0.63, 3.11, 2.15)), None, False, bridged_features)
"""Of :func:`bridged_features`, where image matching bridges the gaps between units: what lies beside their surfaces speaks less against a
pose than elsewhere, and how much of one it explains speaks for it. Elements inside and misfit stay as the rich model weighs them: real
units of such clouds have a score of elements inside, simulated ones none."""
LAYERED = ScoreModel(Weights(-8.75, (0.35, 1.44, 0.96)), None, False, bridged_features)
"""Of the same where the layers that bridge gaps were taken off, in rich and in sparse clouds: what is left of them beside surfaces says
little, and extent and support the more. Fitted to three epochs of two simulated piles and to rock (``docs/benchmarks-units.md``); held out
by epoch 122 of 132 right poses have 0.65 or more (115 with the weights for bridged clouds)."""
MATCHED = ScoreModel(Weights(-19.90, (0.70, 3.64, 1.08)), None, False, matched_features)
"""Of :func:`matched_features`, where matching noise that neighbours share leaves the tolerance wide: rock lies within it often, and what
tells a unit is how much of one a pose explains."""
BRIDGED_SHARE = 0.92
"""Share of the elements near the best supported poses that lie on their surfaces, below which gaps are bridged: 0.97 and more in simulated
surveys by laser and by images matched ideally, 0.75 to 0.83 where hollows of 5 to 15 cm are bridged, 0.86 on real units by images."""
MOST_LOG_ODDS = 6.0
"""Of the rich model, that a bridged cloud believes, of the noisy one, that a cloud of shared noise does; of the smoothed one, that raw
points believe."""
WITH_RESIDUALS = Weights(-27.92, (0.91, -1.41, 3.87, -5.99, 0.55))
"""Of :func:`residual_features`, in noise of 1.3, 2.1 and 3.3 % of the height."""
MOST_WITHIN = 1.15
"""Variance of points within patches, over that of the noise, beyond which more says nothing: on sure poses 1.1 to 1.16."""
USUAL_RESIDUALS, FEWEST_SURE = (0.55, 1.2, -3.75), 3
"""Raw residuals, medians over the sure poses of a cloud, that no simulated one exceeds; where those of so many do, what is beyond (moulds
that differ, strips that do not fit) says nothing."""


@dataclass(frozen=True)
class TypicalUnit:
    """What fitting real surfaces leaves in a cloud.

    Attributes
    ----------
    misfit
        Median misfit, metres.
    agreement
        Median share of the elements on the surface whose normal agrees.
    fewest
        Supporting elements below which a pose is less likely.
    model
        Of the score, for a cloud of its density.
    """

    misfit: float
    agreement: float
    fewest: float = FEW_ELEMENTS
    model: ScoreModel = RICH


def is_sparse(scene: Scene) -> bool:
    """Whether the number of points, and not their noise, limits what can be seen."""
    return not scene.smoothed and scene.spacing > SPARSE_RATIO * scene.unit.height and scene.tolerance <= QUIET_RATIO * scene.unit.height


def _model_for(scene: Scene) -> ScoreModel:
    if scene.smoothed:
        return SMOOTHED
    if scene.shared_noise:
        return MATCHED
    if scene.layered:
        return LAYERED
    if is_sparse(scene):
        return SPARSE
    return NOISY if scene.tolerance > NOISY_RATIO * scene.unit.height else RICH


def typical_unit(found: Evidence, scene: Scene) -> TypicalUnit:
    """What the poses that are surely units have in common.

    Where rock abounds most poses are none. Units are the poses whose elements' normals agree nearly as often as those of the best
    supported poses do.
    """
    fewest = FEW_ELEMENTS * max(1.0, scene.tolerance / (FINE_TOLERANCE * scene.unit.height))
    model = _model_for(scene)
    if not len(found):
        return TypicalUnit(0.0, 1.0, fewest, model)
    agreeing = found.support / np.maximum(found.close, 1.0)
    agreement = float(np.median(agreeing[found.support >= 0.5 * found.support.max()]))
    return TypicalUnit(float(np.median(found.misfit[agreeing >= 0.9 * agreement])), agreement, fewest, model)


def where_bridged(typical: TypicalUnit, found: Evidence) -> TypicalUnit:
    """What is typical of a cloud, with the model of its poses (k) for gaps that are bridged where they show that; rich clouds only."""
    if typical.model is not RICH or not len(found):
        return typical
    strong = found.support >= 0.5 * found.support.max()
    on_surface = float(np.median(found.close[strong] / np.maximum(found.reached[strong], 1.0)))
    return replace(typical, model=BRIDGED) if on_surface < BRIDGED_SHARE else typical


def score(found: Evidence, tolerance: float, typical: TypicalUnit) -> FloatArray:
    """(k,) probability, 0 to 1, that the evidence is that of a real unit in its true pose: a logistic model of its features.

    The weights were fitted to simulated piles, rock and laboratory scenes (``benchmarks/accuracy/score_calibration.py``), never to a real
    survey. What no unit of those shows speaks against a pose beyond that.
    """
    return _probability(typical.model.alone, typical.model.features(found, tolerance, typical), found, tolerance, typical)


def score_among(found: Evidence, centres: FloatArray, tolerance: float, typical: TypicalUnit, unit: UnitType) -> FloatArray:
    """(k,) as :func:`score`, from the number of sure units around (k, 3) centres as well where the model asks for it.

    Units lie among units. In noisy clouds a fifth of one and a rock look alike, and the place tells them apart. A pose that is sure by its
    own elements keeps that score, and so does every pose of a sparse cloud; where it stands apart, the odds of that lower it.
    """
    alone = score(found, tolerance, typical)
    model = typical.model
    if not len(found) or (model.among is None and model.apart_odds == 1.0):
        return alone
    return score_in_company(alone, found, among_feature(centres, alone >= SURE_ALONE, unit), tolerance, typical)


def score_in_company(alone: FloatArray, found: Evidence, company: FloatArray, tolerance: float, typical: TypicalUnit) -> FloatArray:
    """(k,) as :func:`score_among`, from the (k,) :func:`score` and :func:`among_feature` of the poses."""
    model = typical.model
    apart = company < np.log1p(APART) - 1e-9
    own = np.where(apart, alone / (alone + model.apart_odds * (1 - alone)), alone)
    if model.among is None:
        return own
    features = np.column_stack([model.features(found, tolerance, typical), company])
    among = _probability(model.among, features, found, tolerance, typical)
    return np.where(alone >= SURE_ALONE, np.maximum(own, among), among)


def score_with_residuals(scores: FloatArray, residuals: FloatArray, support: FloatArray) -> FloatArray:
    """(k,) scores of smoothed clouds as raw points change them; arguments as in :func:`residual_features`."""
    log_odds = WITH_RESIDUALS.intercept + residual_features(scores, residuals, support) @ np.array(WITH_RESIDUALS.features)
    return np.where(scores > 0, 1 / (1 + np.exp(-log_odds)), 0.0)


def residual_features(scores: FloatArray, residuals: FloatArray, support: FloatArray) -> FloatArray:
    """(k, 5) what the score of a smoothed cloud is made of.

    Log-odds of (k,) ``scores`` by the elements and their place, as far as believed; (k, 3) :func:`.raw_residuals.raw_residuals` less what
    is beyond the usual on sure poses; logarithm of the (k,) supporting elements: few points agree by chance.
    """
    likely = np.clip(scores, 1e-12, 1 - 1e-12)
    log_odds = np.clip(np.log(likely / (1 - likely)), -MOST_LOG_ODDS, MOST_LOG_ODDS)
    sure = scores >= SURE_ALONE
    if np.count_nonzero(sure) >= FEWEST_SURE:
        residuals = residuals - np.maximum(np.median(residuals[sure], axis=0) - USUAL_RESIDUALS, 0.0)
    patches, within, inside = residuals.T
    return np.column_stack([log_odds, patches, np.minimum(within, MOST_WITHIN), inside, np.log1p(support)])


def among_feature(centres: FloatArray, sure: BoolArray, unit: UnitType) -> FloatArray:
    """(k,) logarithm of one more than the ``sure`` (k,) poses around (k, 3) centres, themselves left out."""
    near = cKDTree(centres).query_ball_point(centres, AMONG_HEIGHTS * unit.height) if len(centres) else []
    return np.log1p([np.count_nonzero(sure[own]) - int(sure[k]) for k, own in enumerate(near)])


def _probability(weights: Weights, features: FloatArray, found: Evidence, tolerance: float, typical: TypicalUnit) -> FloatArray:
    log_odds = _log_odds(weights, features, found, tolerance, typical)
    return np.where(found.close < 1, 0.0, 1 / (1 + np.exp(-log_odds)))


def _log_odds(weights: Weights, features: FloatArray, found: Evidence, tolerance: float, typical: TypicalUnit) -> FloatArray:
    log_odds = weights.intercept + np.array([np.dot(weights.features, row) for row in features])
    return np.asarray(log_odds - _unlikeness(found, tolerance, typical) if typical.model.doubts else log_odds)


def _unlikeness(found: Evidence, tolerance: float, typical: TypicalUnit) -> FloatArray:
    """(k,) log-odds against a pose that is in one way unlike all units, however good the rest looks; 0 for most."""
    close = np.maximum(found.close, 1.0)
    # points scattered evenly over the window have a misfit of 1.15 tolerances, units hardly ever more than a half
    scattered = 20 * np.maximum(0.0, found.misfit / tolerance - 0.5)
    # few elements align by chance
    few = 4 * np.maximum(0.0, 1 - found.support / typical.fewest)
    # what is odd in few elements is telling in many
    odd = 20 * np.maximum(0.0, 1 - 3 / np.sqrt(close) - found.support / close / max(typical.agreement, 1e-12))
    return np.asarray(scattered + few + odd)
