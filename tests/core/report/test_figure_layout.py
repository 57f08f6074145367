"""Words of the figures lie within them, whatever the ticks and the language."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest
from matplotlib.figure import Figure
from synthetic_result import write_result
from tetratrack.core.report.report import ReportOptions, write_report


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
