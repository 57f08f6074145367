"""Pictures of moulds: their profile along a leg, and unrolled around it."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from matplotlib.ticker import MultipleLocator

from ..model.mould import AXIAL_CELLS, THIRD
from .castings_page import MouldView
from .figures import Translate, drawn_as_uri, empty_figure


def mould_charts(moulds: Sequence[MouldView], _: Translate) -> dict[str, str]:
    """Profile and unrolled picture of every mould by name."""
    return {f"mould_{k}": mould_chart(view, _) for k, view in enumerate(moulds)}


def mould_chart(view: MouldView, _: Translate) -> str:
    """Departure of a mould from its cones along a leg, and unrolled around a third of it, as a data URI."""
    figure = empty_figure(7.0, 2.6)
    profile, unrolled = figure.subplots(1, 2, width_ratios=(1.0, 1.15))
    along, mean = view.mould.profile()
    grid = 1000 * view.height * np.array(view.mould.side).reshape(AXIAL_CELLS, THIRD)
    profile.fill_between(
        along, grid.min(axis=1), grid.max(axis=1), color="#0072B2", alpha=0.15, linewidth=0, label=_("least and most around the leg")
    )
    profile.plot(along, 1000 * view.height * mean, "o-", color="#0072B2", markersize=3, linewidth=1.2, label=_("mean around the leg"))
    profile.plot([1.0], [1000 * view.height * view.mould.disc], "s", color="#D55E00", markersize=4, label=_("end disc"))
    profile.axhline(0, color="#7F8C8D", linewidth=0.6)
    profile.set_xlabel(_("share of the leg, from the unit's centre"), fontsize=8)
    profile.set_ylabel(_("outside the cone (mm)"), fontsize=8)
    profile.tick_params(labelsize=7)
    profile.legend(fontsize=6, frameon=False)
    most = max(float(np.abs(grid).max()), 1.0)
    # three times, so that the picture closes around the leg
    image = unrolled.imshow(
        np.tile(grid, (1, 3)), origin="lower", aspect="auto", extent=(0, 360, 0, 1), cmap="RdBu_r", vmin=-most, vmax=most
    )
    unrolled.xaxis.set_major_locator(MultipleLocator(120))
    unrolled.set_xlabel(_("around the leg (degrees)"), fontsize=8)
    unrolled.set_ylabel(_("share of the leg, from the unit's centre"), fontsize=8)
    unrolled.tick_params(labelsize=7)
    bar = figure.colorbar(image, ax=unrolled)
    bar.ax.tick_params(labelsize=6)
    bar.set_label("mm", fontsize=7)
    return drawn_as_uri(figure)
