"""Words of the figures lie within them, whatever the ticks and the language."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import pytest
from matplotlib.figure import Figure
from synthetic_result import write_result
from tetratrack.core.report.figures import overview_map
from tetratrack.core.report.report import ReportOptions, write_report
from tetratrack.core.results.unit_rows import UnitRow


@pytest.fixture(scope="module")
def harbour(tmp_path_factory: pytest.TempPathFactory) -> Path:
    path = tmp_path_factory.mktemp("layout") / "result.gpkg"
    write_result(path, 160)
    return path


@pytest.mark.parametrize("language", ["en", "pt"])
def test_no_name_of_an_axis_is_cut(harbour: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, language: str) -> None:
    looked_at, cut = [], []
    save = Figure.savefig

    def saved(figure: Figure, *arguments: Any, **options: Any) -> None:
        save(figure, *arguments, **options)
        width, height = figure.canvas.get_width_height()
        for axes in figure.axes:
            for text in (axes.title, axes.xaxis.label, axes.yaxis.label):
                looked_at.append(text.get_text())
                box = text.get_window_extent()
                if text.get_text() and (min(box.x0, box.y0) < -0.5 or box.x1 > width + 0.5 or box.y1 > height + 0.5):
                    cut.append((text.get_text(), box.extents.round().tolist(), (width, height)))

    monkeypatch.setattr(Figure, "savefig", saved)
    write_report(harbour, tmp_path / "report.html", ReportOptions(worst=2, language=language))
    assert len([text for text in looked_at if text]) > 10
    assert cut == []


def test_no_name_is_cut_beside_a_long_coast(monkeypatch: pytest.MonkeyPatch) -> None:
    """A map wider than high, with numbers of seven digits and a long legend, whose ticks change as it is laid out."""
    boxes = []
    save = Figure.savefig

    def saved(figure: Figure, *arguments: Any, **options: Any) -> None:
        save(figure, *arguments, **options)
        boxes.append(
            (figure.axes[0].yaxis.label.get_window_extent().x0, figure.axes[0].get_legend().get_window_extent().x1, figure.bbox.width)
        )

    monkeypatch.setattr(Figure, "savefig", saved)
    kinds = ("stable", "moved", "lost", "new", "uncertain", "unseen")
    rows = [
        UnitRow(unit_id=f"U{k}", kind=kinds[k % 6], place=np.array([236475 + 3.65 * k, 285141 - 2.475 * k, 3.0]), coverage=0.5, height=2.3)
        for k in range(41)
    ]
    control = [{"geom": np.array([236480.0 + k, 285125.0 - k, 8.0]), "used": k != 3} for k in range(4)]
    overview_map(rows, {}, control, frozenset(), str)
    ((left, right, width),) = boxes
    assert left >= 0
    assert right <= width
