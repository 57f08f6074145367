"""Corrections of one open result: points picked on the map or in the views, and edits of the selected units."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass, field
from functools import partial

import numpy as np
from qgis.core import QgsPointXY
from qgis.gui import QgsMapTool
from qgis.PyQt.QtWidgets import QFileDialog, QMenu, QMessageBox

from ..algorithms.support.lengths import length_format
from ..algorithms.support.translation import tr
from ..core.common.arrays import FloatArray
from ..core.model.unit_types import LEG_LENGTH_RATIO
from ..core.review.corrections import (
    add_placeholder,
    delete_unit,
    last_edit_of,
    merge_units,
    set_pose,
    split_unit,
    store_picks,
    undo_edit,
)
from ..core.review.point_index import kept_survey
from ..core.review.pose_consequences import NewPose
from ..core.review.pose_from_picks import pose_from_features
from .review_map import ReviewMap
from .review_panels import DecisionPanel, StatusLine
from .review_pick import ClickTool
from .review_tabs import UnitTabs
from .review_text import edit_label

PICK_SD_SPACINGS = 1.0
"""Standard deviation of one picked coordinate in point spacings: a pick lands on the nearest point."""

MISFIT_SDS, LEAST_MISFIT_HEIGHTS, MOST_MISFIT_HEIGHTS = 2.0, 0.02, 0.05
"""Picks that miss the unit's shape by more than so many of their standard deviations are asked about; between these shares of the
unit's height."""


@dataclass
class Picking:
    """Clicks gathered so far for a correction; ``epoch`` is 0 for the earlier, 1 for the later epoch."""

    kind: str
    epoch: int
    points: list[FloatArray] = field(default_factory=list)

    @property
    def on_cloud(self) -> bool:
        """Whether the clicks must land on points of the cloud."""
        return self.kind in ("pin", "pick")


class ReviewCorrections:
    """Corrects the units of one open result and shows the outcome.

    Parameters
    ----------
    review_map
        Layers of the result; its canvas takes the clicks, and its store the changes.
    tabs
        Views that take clicks as well.
    decisions
        Whose name and comment are stored with every correction.
    status
        Says what to click, what was done and why not.
    start_engine
        Runs the engine in the background, given a title, its arguments and what to say on success.
    """

    def __init__(
        self,
        review_map: ReviewMap,
        tabs: UnitTabs,
        decisions: DecisionPanel,
        status: StatusLine,
        start_engine: Callable[[str, list[str], str], None],
    ) -> None:
        self.store, self.map = review_map.store, review_map
        self._tabs, self._decisions, self._status, self._start_engine = tabs, decisions, status, start_engine
        self._picking: Picking | None = None
        self._tool: ClickTool | None = None
        self._old_tool: QgsMapTool | None = None
        tabs.picked.connect(self.add_pick)

    def close(self) -> None:
        """Let go of map and views."""
        self.end_picking()
        self._tabs.picked.disconnect(self.add_pick)

    def fill_menu(self, menu: QMenu) -> None:
        """Offer every correction in a menu; none can be chosen for a file that takes none."""
        menu.clear()
        for text, run in (
            (tr("Fit again after a click on the unit (earlier epoch)"), partial(self.start_picking, "refit", 0)),
            (tr("Fit again after a click on the unit (later epoch)"), partial(self.start_picking, "refit", 1)),
            (tr("Pin by three joints of legs (earlier epoch)"), partial(self.start_picking, "pin", 0)),
            (tr("Pin by three joints of legs (later epoch)"), partial(self.start_picking, "pin", 1)),
            (tr("Pick feature points beside the fit (earlier epoch)"), partial(self.start_picking, "pick", 0)),
            (tr("Pick feature points beside the fit (later epoch)"), partial(self.start_picking, "pick", 1)),
            (tr("Placeholder for a unit not found"), partial(self.start_picking, "placeholder", 1)),
            (tr("Merge the two selected units"), self.merge),
            (tr("Split at the later epoch: two units taken for one"), self.split),
            (tr("Delete: not a unit"), self.delete),
            (tr("Take back your last correction"), self.undo),
            (tr("Read the points around the units…"), self.ask_index),
        ):
            action = menu.addAction(text)
            action.setObjectName("correction")
            action.setEnabled(self.store.writable)
            action.triggered.connect(lambda checked=False, run=run: run())

    def reload(self) -> None:
        """Take in what a correction or the engine changed in the file."""
        selected = self.store.selected
        self.store.reload()
        self.map.reload()
        # layers that are read anew have lost their selection, and the table followed them
        self.store.select(selected)

    # picking

    def start_picking(self, kind: str, epoch: int) -> None:
        """Gather clicks, on the map or in the views, for ``refit``, ``pin``, ``pick`` or ``placeholder``."""
        picking = Picking(kind, epoch)
        if kind != "placeholder" and self._current() is None:
            return
        if picking.on_cloud and self.store.index is None:
            self._status.say(tr("The points around the units are needed: read them from the correction menu."), bad=True)
            return
        self.end_picking()
        self._picking = picking
        self._tool = ClickTool(self.map.canvas)
        self._tool.clicked.connect(self._clicked_map)
        self._tool.left.connect(self.leave)
        self._old_tool = self.map.canvas.mapTool()
        self.map.canvas.setMapTool(self._tool)
        self._tabs.set_picking(epoch)
        self._status.say(
            {
                "refit": tr("Click the middle of the unit on the map or in a view; Escape ends."),
                "pin": tr("Click three joints where three legs meet, on the map or in the views; Escape ends."),
                "pick": tr("Click a joint where three legs meet; Escape ends."),
                "placeholder": tr("Click where the unit lies on the map; Escape ends."),
            }[kind]
        )

    def end_picking(self) -> None:
        """Back to the map tool used before."""
        self._picking = None
        self._tabs.set_picking(None)
        if self._tool is not None:
            self.map.canvas.unsetMapTool(self._tool)
            if self._old_tool is not None:
                self.map.canvas.setMapTool(self._old_tool)
            self._tool.deleteLater()
        self._tool = self._old_tool = None

    def leave(self) -> None:
        """End picking because the user pressed Escape, on the map or in the dock, and say so."""
        if self._picking is None:
            return
        self.end_picking()
        self._status.say(tr("Ended: nothing was stored."))

    def add_pick(self, point: FloatArray) -> None:
        """Take one click into the correction that is going on."""
        picking = self._picking
        if picking is None:
            return
        picking.points.append(np.asarray(point, dtype=np.float64))
        if picking.kind == "pin" and len(picking.points) < 3:
            self._status.say(tr("{count} of 3 joints.").format(count=len(picking.points)))
            return
        act = {"refit": self._refit, "pin": self._pin, "pick": self._pick, "placeholder": self._placeholder}[picking.kind]
        self.end_picking()
        self._status.attempt(lambda: act(self._epoch(picking.epoch), picking.points))

    def _clicked_map(self, point: QgsPointXY) -> None:
        place = self.map.to_survey(point)
        if place is None or self._picking is None:
            return
        surface = self._surface_point(place.x(), place.y(), self._picking)
        if surface is None:
            self._status.say(tr("There are no points here; click on the cloud."), bad=True)
        else:
            self.add_pick(surface)

    def _surface_point(self, e: float, n: float, picking: Picking) -> FloatArray | None:
        """The highest point of the cloud near a place of the map.

        Where there is none: nothing if it must be a point of the cloud, else that place at the height of the nearest unit.
        """
        near = [(row.place, row.height or 2.0) for row in self.store.rows if row.place is not None]
        place, height = min(near, key=lambda unit: math.hypot(unit[0][0] - e, unit[0][1] - n))
        flat = np.array([e, n, place[2]])
        if self.store.index is None:
            return flat
        points = self.store.points_around(self._epoch(picking.epoch), flat, 2 * height)
        close = points[np.hypot(points[:, 0] - e, points[:, 1] - n) < 0.04 * height]
        if len(close) > 0:
            return close[np.argmax(close[:, 2])]
        return None if picking.on_cloud else flat

    def _epoch(self, place: int) -> str:
        return (self.store.pair.epoch_from, self.store.pair.epoch_to)[place]

    # what the picks are for

    def _refit(self, epoch: str, points: list[FloatArray]) -> None:
        unit = self._current()
        if unit is None:
            return
        place = ",".join(f"{value:.3f}" for value in points[0])
        arguments = ["refit", str(self.store.path), "--unit", unit, "--epoch", epoch, "--near", place, "--editor", self._editor]
        self._start_engine(tr("Fitting {unit} again").format(unit=unit), arguments, tr("{unit} was fitted again.").format(unit=unit))

    def _pin(self, epoch: str, points: list[FloatArray]) -> None:
        unit = self._current()
        if unit is None:
            return
        details, row = self.store.details(unit), self.store.row(unit)
        known_height = None if row is None else row.height
        shape = details.shapes.get(epoch) or next(iter(details.shapes.values()), None)
        if shape is None:
            self._status.say(tr("The unit has no pose in any epoch to take its size from."), bad=True)
            return
        centre, rotation, names, misfit = pose_from_features(points, shape.radius, shape.gradient, shape.rotation)
        sd = self._pick_sd(epoch, shape.centre)
        size = known_height or 2.0
        worst = min(max(MISFIT_SDS * sd, LEAST_MISFIT_HEIGHTS * size), MOST_MISFIT_HEIGHTS * size)
        if misfit > worst and not self._wanted_all_the_same(unit, misfit, worst):
            self._status.say(tr("Nothing was stored: pick the three joints again."))
            return
        # picks that do not fit the unit's shape say how far they may be off
        sd = max(sd, misfit)
        # three picks of equal precision: the mean holds the centre, their distance from it the rotation
        turn = math.degrees(sd * math.sqrt(3) / float(np.linalg.norm(points[0] - centre)))
        height = known_height or shape.leg_length / LEG_LENGTH_RATIO
        pose = NewPose(
            centre=centre,
            rotation=rotation,
            radius=shape.radius,
            gradient=shape.gradient,
            height=height,
            sd=np.full(3, sd),
            sd_rotation_deg=turn,
        )
        picks = dict(zip(names, points, strict=True))
        set_pose(self.store.path, unit, epoch, pose, editor=self._editor, comment=tr("pinned by three joints"), picks=picks)
        self.reload()
        self._status.say(tr("{unit} pinned; the picks fit within {length}.").format(unit=unit, length=length_format().text(misfit)))

    def _wanted_all_the_same(self, unit: str, misfit: float, worst: float) -> bool:
        lengths = length_format()
        question = tr(
            "The three points do not fit the shape of {unit}: they are {misfit} off, where {worst} would be usual. Were they joints of "
            "this unit? Store the pose all the same?"
        ).format(unit=unit, misfit=lengths.text(misfit), worst=lengths.text(worst))
        buttons = QMessageBox.StandardButton.Yes | QMessageBox.StandardButton.No
        answer = QMessageBox.question(self._tabs, tr("Pin by three joints"), question, buttons, QMessageBox.StandardButton.No)
        return answer == QMessageBox.StandardButton.Yes

    def _pick(self, epoch: str, points: list[FloatArray]) -> None:
        unit, place = self._current(), points[0]
        if unit is None:
            return
        features = {name: value[0] for name, value in self.store.details(unit).features.get(epoch, {}).items() if name != "centre"}
        if not features:
            self._status.say(tr("The unit was not found in this epoch: pin it by three joints instead."), bad=True)
            return
        apart = {name: float(np.linalg.norm(feature - place)) for name, feature in features.items()}
        name = min(apart, key=lambda feature: apart[feature])
        store_picks(self.store.path, unit, epoch, {name: place}, editor=self._editor)
        self.reload()
        self._tabs.show_unit()
        self._status.say(tr("{feature} picked, {length} from the fit.").format(feature=name, length=length_format().text(apart[name])))

    def _placeholder(self, epoch: str, points: list[FloatArray]) -> None:
        name = add_placeholder(self.store.path, epoch, points[0], editor=self._editor, comment=self._comment)
        self.reload()
        self._status.say(tr("Placeholder {name} stored; it counts as a unit not found.").format(name=name))

    def _pick_sd(self, epoch: str, place: FloatArray) -> float:
        """Standard deviation of a picked coordinate, metres: the spacing of the points around the unit."""
        points = self.store.points_around(epoch, place, 1.0)
        # a surface of the cube's size holds n points: spacing = edge / sqrt(n)
        return PICK_SD_SPACINGS * 2.0 / math.sqrt(max(len(points), 1))

    # edits of the selected units

    def merge(self) -> None:
        """Make one unit of the two selected."""
        if len(self.store.selected) != 2:
            self._status.say(tr("Select the two units to merge."), bad=True)
            return
        keep, other = sorted(self.store.selected)
        if self._status.attempt(lambda: merge_units(self.store.path, keep, other, editor=self._editor, comment=self._comment)):
            self._edited(keep, tr("{other} is now {keep}.").format(other=other, keep=keep))

    def split(self) -> None:
        """Make two units of the current one, from the later epoch on."""
        unit, epoch = self._current(), self.store.pair.epoch_to
        names: list[str] = []
        if unit is None:
            return
        if self._status.attempt(lambda: names.append(split_unit(self.store.path, unit, epoch, editor=self._editor))):
            self._edited(unit, tr("{unit} is called {name} from {epoch} on.").format(unit=unit, name=names[0], epoch=epoch))

    def delete(self) -> None:
        """Take the current unit out of the result."""
        unit = self._current()
        if unit is None:
            return
        if self._status.attempt(lambda: delete_unit(self.store.path, unit, editor=self._editor, comment=self._comment)):
            self._edited(None, tr("{unit} was deleted; take it back from the correction menu.").format(unit=unit))

    def undo(self) -> None:
        """Take back one's own last correction that stands."""
        last = last_edit_of(self.store.path, self._editor)
        if last is None:
            self._status.say(tr("There is no correction of yours to take back."))
            return
        if self._status.attempt(lambda: undo_edit(self.store.path, last.number, editor=self._editor)):
            self._edited(last.unit_id, tr("Taken back: {kind} {unit}.").format(kind=edit_label(last.kind), unit=last.unit_id))

    def ask_index(self) -> None:
        """Read the points around the units with the engine, from the survey kept beside the result; else ask where it is."""
        name = str(kept_survey(self.store.path))
        if not kept_survey(self.store.path).is_file():
            name, _ = QFileDialog.getOpenFileName(self._tabs, tr("Survey description"), str(self.store.path.parent), tr("Survey (*.toml)"))
        if name:
            self._start_engine(tr("Reading points around units"), ["unit-points", name, str(self.store.path)], tr("Points read."))

    @property
    def _editor(self) -> str:
        return self._decisions.reviewer.text()

    @property
    def _comment(self) -> str:
        return self._decisions.comment.text()

    def _current(self) -> str | None:
        """The current unit; says so where there is none."""
        if self.store.current is None:
            self._status.say(tr("Select a unit first."), bad=True)
        return self.store.current

    def _edited(self, unit: str | None, message: str) -> None:
        self.reload()
        if unit is not None:
            self.store.select([unit])
        self._status.say(message)
