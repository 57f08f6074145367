"""Fit and check the score of the segmentation on simulated surveys.

    .venv/bin/tetratrack simulate …            # write some surveys with truth, of several kinds and seeds, rock without units too
    .venv/bin/python benchmarks/accuracy/score_calibration.py --fit SURVEY… --check SURVEY…

Prints the weights to put into ``core/segmentation/pose_score.py`` and, for both sets, how often poses of a stated score are right. Units
with less than 5 % of their surface seen, and poses whose twist no leg determines, count neither way. Sparse and noisy clouds have weights
of their own, fitted to thinned and noised copies (``poor_copies.py``) of surveys and of rock. With ``--among`` the sure units around
a pose, sure by the weights fitted first, are a feature too, and the misfit typical of the cloud is none: those are the weights of clouds
whose noise was taken off. With ``--bridged`` what the rich model says, extent and support are the features, of surveys simulated with
``--bridging`` and of rock; where neighbours share their noise the noisy model stands for the rich one. With ``--residuals`` they are what
the score says without the raw points and how these lie to the pose, of clouds whose noise was taken off.
"""

from __future__ import annotations

import argparse
import csv
import tomllib
from dataclasses import dataclass
from itertools import pairwise
from pathlib import Path

import laspy
import numpy as np
from scipy.optimize import minimize
from scipy.spatial.transform import Rotation
from tetratrack.core.model.unit_types import UnitType
from tetratrack.core.segmentation.pose_score import (
    SURE_ALONE,
    among_feature,
    bridged_features,
    matched_features,
    residual_features,
    score_among,
    score_features,
)
from tetratrack.core.segmentation.segment import JudgedPoses, judge_poses

RIGHT_CENTRE, RIGHT_ANGLE = 0.2, np.radians(15)
"""A pose is right within this share of the height and this angle, of the nearest truth; registration errors are far below both."""


TYPICAL_MISFIT = 3
"""Column of the misfit against what is typical of the cloud."""


@dataclass(frozen=True)
class EpochRows:
    """Poses of one epoch: features (n, 6), whether right (n,), certainty of the twist (n,), centres (n, 3) and the unit."""

    features: np.ndarray
    right: np.ndarray
    certainty: np.ndarray
    centres: np.ndarray
    unit: UnitType

    def with_company(self, model: np.ndarray) -> np.ndarray:
        """(n, 7) features and the one of sure units around, by (7,) weights of the features alone."""
        sure = probability(model, self.features) >= SURE_ALONE
        return np.column_stack([self.features, among_feature(self.centres, sure, self.unit)])


def survey_rows(folder: Path, kind: str = "elements") -> list[EpochRows]:
    """All epochs of a survey; poses of units that are hardly seen are left out. ``kind`` of features: ``bridged``, ``residuals``."""
    settings = tomllib.loads((folder / "survey.toml").read_text())
    unit = UnitType.tetrapod(**{k: v for k, v in settings["unit"].items() if k in ("height", "radius", "gradient", "leg_length")})
    epochs = []
    for epoch in settings["epoch"]:
        cloud = np.vstack([laspy.read(tile).xyz for tile in sorted(folder.glob(epoch["tiles"]))])
        origin = np.floor(cloud.mean(axis=0))
        judged = judge_poses(cloud - origin, unit)
        truth = _truth(folder, str(epoch["label"]))
        taken: set[int] = set()
        verdicts = {int(k): _verdict(judged.poses[k], origin, truth, unit, taken) for k in np.argsort(-judged.evidence.support)}
        kept = np.array([k for k, verdict in verdicts.items() if verdict is not None], dtype=np.int64)
        epochs.append(
            EpochRows(
                _features(judged, unit, kind)[kept],
                np.array([bool(verdicts[int(k)]) for k in kept], dtype=bool),
                judged.certainty[kept],
                judged.poses[kept, :3],
                unit,
            )
        )
    return epochs


def _features(judged: JudgedPoses, unit: UnitType, kind: str) -> np.ndarray:
    """Of every pose of a cloud."""
    if kind == "residuals":
        if judged.residuals is None:
            raise SystemExit("raw residuals are of clouds whose noise was taken off")
        scores = score_among(judged.evidence, judged.poses[:, :3], judged.tolerance, judged.typical, unit)
        return residual_features(scores, judged.residuals, judged.evidence.support)
    bridged = matched_features if judged.elements.shared_noise else bridged_features
    return (bridged if kind == "bridged" else score_features)(judged.evidence, judged.tolerance, judged.typical)


def _truth(folder: Path, label: str) -> list[tuple[np.ndarray, np.ndarray, float]]:
    with open(folder / "truth" / "units.csv", newline="") as handle:
        rows = [r for r in csv.DictReader(handle) if r["epoch"] == label and r["status"] != "removed"]
    return [
        (
            np.array([float(r[k]) for k in "ENH"]),
            Rotation.from_quat([float(r[k]) for k in ("qx", "qy", "qz", "qw")]).as_matrix(),
            float(r["visible_area_fraction"]),
        )
        for r in rows
    ]


def _verdict(pose: np.ndarray, origin: np.ndarray, truth: list, unit: UnitType, taken: set[int]) -> bool | None:
    """Right, wrong, or None where it counts neither way; a second pose of one unit is wrong."""
    if not truth:
        return False
    away = [float(np.linalg.norm(pose[:3] + origin - centre)) for centre, _, _ in truth]
    k = int(np.argmin(away))
    _, rotation, visible = truth[k]
    if away[k] > RIGHT_CENTRE * unit.height:
        return False
    if visible < 0.05:
        return None
    turns = np.einsum("ij,sjk,lk->sil", pose[3:].reshape(3, 3), unit.symmetries, rotation)
    angle = float(np.arccos(np.clip((np.trace(turns, axis1=1, axis2=2).max() - 1) / 2, -1, 1)))
    if angle > RIGHT_ANGLE or k in taken:
        return False
    taken.add(k)
    return True


def fit(features: np.ndarray, right: np.ndarray, *, wrong_weight: float = 2.0) -> np.ndarray:
    """(k + 1,) intercept and weights of the logistic model with unit ridge; a wrong unit taken for right weighs twice."""
    middle, spread = features.mean(axis=0), features.std(axis=0)
    spread = np.where(spread > 0, spread, np.inf)
    x = np.column_stack([np.ones(len(features)), (features - middle) / spread])
    sign = np.where(right, 1.0, -1.0)
    weight = np.where(right, 1.0, wrong_weight)
    loss = lambda w: float(np.sum(weight * np.logaddexp(0, -sign * (x @ w)))) + 0.5 * float(w[1:] @ w[1:])  # noqa: E731
    scaled = minimize(loss, np.zeros(x.shape[1]), method="BFGS").x
    weights = scaled[1:] / spread
    return np.concatenate([[scaled[0] - weights @ middle], weights])


def probability(model: np.ndarray, features: np.ndarray) -> np.ndarray:
    """(n,) of (n, k) features by (k + 1,) intercept and weights."""
    return np.asarray(1 / (1 + np.exp(-(model[0] + features @ model[1:]))))


def report(name: str, score: np.ndarray, right: np.ndarray) -> None:
    """Print how many poses of each range of (n,) scores are right."""
    print(f"{name}: {len(score)} poses, {int(right.sum())} right")
    edges = (0.0, 0.05, 0.2, 0.5, 0.65, 0.8, 0.95, 1.0001)
    for low, high in pairwise(edges):
        inside = (score >= low) & (score < high)
        if inside.any():
            print(f"  score {low:.2f}-{min(high, 1):.2f}: {int(right[inside].sum())} of {int(inside.sum())} right")
    stated = score >= 0.5
    print(f"  score >= 0.5: {int(right[stated].sum())} of {int(stated.sum())} right")


def gathered(epochs: list[EpochRows], alone: np.ndarray | None = None) -> tuple[np.ndarray, np.ndarray]:
    """Features, with weights ``alone`` the one of sure units around too, and verdicts; poses of undetermined twist left out."""
    features = np.concatenate([e.features if alone is None else e.with_company(alone) for e in epochs])
    right, certainty = (np.concatenate([getattr(e, name) for e in epochs]) for name in ("right", "certainty"))
    return features[certainty > 0.6], right[certainty > 0.6]


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--fit", nargs="+", type=Path, required=True, metavar="SURVEY", help="folders to fit the weights to")
    parser.add_argument("--wrong", type=float, default=2.0, metavar="WEIGHT", help="of a wrong pose against a right one; 1 in poor clouds")
    parser.add_argument("--check", nargs="*", type=Path, default=[], metavar="SURVEY", help="folders to check them on")
    parser.add_argument("--among", action="store_true", help="fit weights with the sure units around a pose as well")
    kinds = parser.add_mutually_exclusive_group()
    kinds.add_argument("--bridged", action="store_true", help="fit the weights of clouds whose gaps are bridged")
    kinds.add_argument("--residuals", action="store_true", help="fit the weights of raw residuals")
    arguments = parser.parse_args()
    kind = "bridged" if arguments.bridged else "residuals" if arguments.residuals else "elements"
    fitted, checked = ([e for folder in some for e in survey_rows(folder, kind)] for some in (arguments.fit, arguments.check))
    if arguments.among:
        for epoch in fitted + checked:
            epoch.features[:, TYPICAL_MISFIT] = 0
    alone = fit(*gathered(fitted), wrong_weight=arguments.wrong)
    models = [(alone, None), (fit(*gathered(fitted, alone), wrong_weight=arguments.wrong), alone)] if arguments.among else [(alone, None)]
    for model, first in models:
        name = "alone" if first is None else "among"
        print(name, "intercept", round(float(model[0]), 2), "weights", tuple(round(float(w), 2) for w in model[1:]))
        for label, epochs in (("fitted", fitted), ("checked", checked)):
            if epochs:
                features, right = gathered(epochs, first)
                report(label, probability(model, features), right)


if __name__ == "__main__":
    main()
