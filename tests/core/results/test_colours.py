"""Colours that carry a meaning differ for everybody, and stand out from the paper they are on: both in numbers.

Deficient colour vision is simulated by Machado, Oliveira and Fernandes (2009, doi 10.1109/TVCG.2009.113, table for severity 1.0) on linear
RGB; differences are Euclidean in CIE 1976 L*a*b*, where 2.3 is just noticeable (Mahy and others 1994). Contrasts are those of WCAG 2.2.
"""

from __future__ import annotations

import ast
from itertools import combinations
from pathlib import Path
from xml.etree import ElementTree

import numpy as np
import pytest
from tetratrack.core.report import figures
from tetratrack.core.results.class_colours import CLASS_COLOURS

VISION = {
    "normal": np.eye(3),
    "protanopia": np.array([[0.152286, 1.052583, -0.204868], [0.114503, 0.786281, 0.099216], [-0.003882, -0.048116, 1.051998]]),
    "deuteranopia": np.array([[0.367322, 0.860646, -0.227968], [0.280085, 0.672501, 0.047413], [-0.011820, 0.042940, 0.968881]]),
    "tritanopia": np.array([[1.255528, -0.076749, -0.178779], [-0.078411, 0.930809, 0.147602], [0.004733, 0.691367, 0.303900]]),
}
LEAST_DIFFERENCE = 15.0
"""Six to seven times what is just noticeable, since colours on maps are seen apart from each other."""
LEAST_TEXT_CONTRAST = 4.5
LIGHT, DARK = ("#FFFFFF", "#EFEFEF"), ("#2B2B2B", "#323232")
"""Paper and windows of QGIS's themes."""


def linear(colour: str) -> np.ndarray:
    """Linear RGB of a hexadecimal colour (IEC 61966-2-1)."""
    value = np.array([int(colour[k : k + 2], 16) for k in (1, 3, 5)]) / 255
    return np.where(value <= 0.04045, value / 12.92, ((value + 0.055) / 1.055) ** 2.4)


def lab(rgb: np.ndarray) -> np.ndarray:
    """CIE L*a*b* of linear RGB, white D65."""
    to_xyz = np.array([[0.4124564, 0.3575761, 0.1804375], [0.2126729, 0.7151522, 0.0721750], [0.0193339, 0.1191920, 0.9503041]])
    xyz = to_xyz @ np.clip(rgb, 0, 1) / np.array([0.95047, 1, 1.08883])
    f = np.where(xyz > 216 / 24389, np.cbrt(xyz), (24389 / 27 * xyz + 16) / 116)
    return np.array([116 * f[1] - 16, 500 * (f[0] - f[1]), 200 * (f[1] - f[2])])


def too_alike(colours: dict[str, str]) -> list[str]:
    """Pairs of colours that somebody takes for one."""
    found = []
    for (first, one), (second, other) in combinations(colours.items(), 2):
        for vision, matrix in VISION.items():
            difference = np.linalg.norm(lab(matrix @ linear(one)) - lab(matrix @ linear(other)))
            if difference < LEAST_DIFFERENCE:
                found.append(f"{first} and {second}, {vision}: {difference:.1f}")
    return found


def contrast(one: str, other: str) -> float:
    """Contrast of WCAG between two colours."""
    bright, dark = sorted((float(np.array([0.2126, 0.7152, 0.0722]) @ linear(c)) for c in (one, other)), reverse=True)
    return (bright + 0.05) / (dark + 0.05)


def constant(path: Path, name: str) -> dict[str, tuple[str, str]]:
    """A dictionary of colours from a module of the plugin, which needs QGIS to be imported."""
    found: dict[str, tuple[str, str]] = {}
    for node in ast.parse(path.read_text(encoding="utf-8")).body:
        if isinstance(node, ast.Assign | ast.AugAssign):
            target = node.targets[0] if isinstance(node, ast.Assign) else node.target
            if isinstance(target, ast.Name) and target.id == name:
                found |= ast.literal_eval(node.value)
    return found


def test_the_measure_knows_red_and_green() -> None:
    assert any("protanopia" in pair for pair in too_alike({"red": "#B03A2E", "green": "#1E7B4B"}))
    assert contrast("#000000", "#FFFFFF") == pytest.approx(21)


def test_classes_differ_for_everybody() -> None:
    assert too_alike(CLASS_COLOURS) == []


def colours_of_rules(path: Path) -> dict[str, str]:
    """Colour of each entry in the legend of a style, by its label."""
    root = ElementTree.parse(path).getroot()  # noqa: S314 - a file of the repository
    renderer = root.find("renderer-v2")
    found = {}
    for rule in renderer.iter("rule"):
        symbol = renderer.find(f"symbols/symbol[@name='{rule.get('symbol')}']")
        if symbol is not None and rule.get("filter") != "false":
            options = [o for o in symbol.iter("Option") if o.get("name") in ("color", "line_color") and "," in str(o.get("value"))]
            red, green, blue = (int(part) for part in options[0].get("value").split(",")[:3])
            found[rule.get("label")] = f"#{red:02x}{green:02x}{blue:02x}"
    return found


@pytest.mark.parametrize("layer", ["units", "displacements", "displacements_other", "unit_outlines"])
def test_entries_of_a_legend_differ_for_everybody(repository: Path, layer: str) -> None:
    colours = colours_of_rules(repository / "core" / "results" / "styles" / f"{layer}.qml")
    assert len(colours) >= 4
    # one colour for two classes is meant: found and stable, watched apart by other means
    single = {colour: label for label, colour in colours.items()}
    assert too_alike({label: colour for colour, label in single.items()}) == []


def test_features_and_epochs_differ_for_everybody(repository: Path) -> None:
    assert too_alike(figures.FEATURE_COLOURS) == []
    features = constant(repository / "plugin" / "series_view.py", "FEATURE_COLOURS")
    assert len(features) == 5
    for theme in (0, 1):
        assert too_alike({name: pair[theme] for name, pair in features.items()}) == []


def test_decisions_differ_for_everybody_and_are_readable_in_both_themes(repository: Path) -> None:
    decisions = constant(repository / "plugin" / "review_text.py", "DECISION_COLOURS")
    assert set(decisions) == {"accepted", "rejected", "inspect"}
    for theme, papers in enumerate((LIGHT, DARK)):
        assert too_alike({name: pair[theme] for name, pair in decisions.items()}) == []
        for name, pair in decisions.items():
            for paper in papers:
                assert contrast(pair[theme], paper) >= LEAST_TEXT_CONTRAST, (name, paper)
