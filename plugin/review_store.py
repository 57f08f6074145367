"""State of a review without any Qt: rows, order, filter, selection and decisions of one result file.

Table, map and plots observe this store and change it through its methods only, so they cannot fall out of step.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Sequence
from contextlib import contextmanager, suppress
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any, Literal

import numpy as np
from numpy.typing import NDArray

from ..core.common.arrays import FloatArray
from ..core.common.errors import InputError, OutputError, TetratrackError
from ..core.results.geopackage_reader import EpochPair, epoch_pairs, latest_pair
from ..core.results.result_access import is_writable
from ..core.results.unit_rows import EpochInfo, UnitDetails, UnitRow, datums, read_details, read_epochs, read_unit_rows, unit_sizes
from ..core.review.basis import Basis, read_bases
from ..core.review.corrections import contents_stamp
from ..core.review.decisions import (
    Decision,
    NumbersChangedError,
    Review,
    ReviewEvent,
    confirm,
    decide,
    prepare,
    read_history,
    read_reviews,
    undo,
)
from ..core.review.point_index import PointIndex, computed_at, index_of

Topic = Literal["rows", "order", "selection", "reviews"]
TakenIn = Literal["", "decisions", "corrections", "run"]

COLUMNS = (
    "unit_id",
    "kind",
    "d_3d",
    "decision",
    "d_horizontal",
    "vertical",
    "rotation_deg",
    "p_value",
    "coverage",
    "broken_legs",
    "reviewer",
)
"""Columns of the table, by the name of what they show; what a narrow dock must show comes first."""
DETAILS_KEPT = 64


@dataclass(frozen=True, eq=False)
class ReviewFilter:
    """Which units are shown; every condition that is set must hold.

    Attributes
    ----------
    kinds
        Classes to show; empty for all.
    threshold
        Least 3D displacement in metres; lost, new and relocated units and those with a broken leg are shown whatever the threshold.
    area
        Rings ((n, 2) easting, northing in the survey CRS) of a polygon, even-odd; empty for everywhere.
    undecided
        Only units without a decision.
    text
        Part of the unit's name.
    """

    kinds: frozenset[str] = frozenset()
    threshold: float = 0.0
    area: tuple[FloatArray, ...] = ()
    undecided: bool = False
    text: str = ""


@dataclass(frozen=True, kw_only=True)
class Statistics:
    """Counts over the units of the pair, rejected ones left out of all but ``rejected``; ``broken`` are those with a broken leg.

    ``median`` and ``largest`` are 3D displacements in metres, None where no unit has one.
    """

    units: int
    significant: int
    lost: int
    new: int
    broken: int
    decided: int
    rejected: int
    median: float | None
    largest: float | None


class ReviewStore:
    """One open result file and what the reviewer sees of it.

    Parameters
    ----------
    path
        result.gpkg of ``tetratrack run``.

    Raises
    ------
    InputError
        The file cannot be read or holds no epochs to compare.
    """

    def __init__(self, path: str | Path) -> None:
        self.path = Path(path)
        self.epochs: tuple[EpochInfo, ...]
        self._computed, self.epochs, self.pairs = self._read_epochs()
        self.writable = is_writable(self.path)
        if self.writable:
            try:
                prepare(self.path)
            except OutputError:
                # another process holds the file; every write tries again and says so
                self.writable = is_writable(self.path)
        self.pair = latest_pair(self.pairs, [info.label for info in self.epochs])
        self.datum = datums(self.path, self.pair)[0]
        self.rows: list[UnitRow] = []
        self.order: list[int] = []
        self.filter = ReviewFilter()
        self.sort_column, self.descending = "d_3d", True
        self.selected: tuple[str, ...] = ()
        self.reviews: dict[tuple[str, EpochPair], Review] = {}
        self.index: PointIndex | None = None
        self._position: dict[str, int] = {}
        self._statistics: Statistics | None = None
        self._seen: tuple[tuple[int, int], ...] = ()
        self._observers: list[Callable[[Topic], None]] = []
        self._contents: tuple[Any, ...] = ()
        self._bases: dict[str, Basis] = {}
        self._undoable: list[list[int]] = []
        self._details: dict[str, UnitDetails] = {}
        self._load()
        self.open_index()

    # observers

    def observe(self, callback: Callable[[Topic], None]) -> None:
        """Call back after every change with its topic."""
        self._observers.append(callback)

    def forget(self, callback: Callable[[Topic], None]) -> None:
        """Stop calling back."""
        self._observers.remove(callback)

    # what is compared

    def set_pair(self, pair: EpochPair) -> None:
        """Compare another pair of epochs."""
        if pair == self.pair:
            return
        self._compare(pair, self._datum_of(pair))

    def set_datum(self, datum: str) -> None:
        """Show displacements in another datum."""
        if datum != self.datum:
            self._compare(self.pair, datum)

    def _compare(self, pair: EpochPair, datum: str) -> None:
        before = self.pair, self.datum
        self.pair, self.datum = pair, datum
        try:
            self._load()
        except TetratrackError:
            self.pair, self.datum = before
            raise

    @property
    def datums(self) -> tuple[str, ...]:
        """Datums the present pair has."""
        return datums(self.path, self.pair)

    # order and filter

    def sort(self, column: str, descending: bool) -> None:
        """Order the rows by a column of ``COLUMNS``; units without a value come last."""
        self.sort_column, self.descending = column, descending
        self._arrange()

    def set_filter(self, **changes: Any) -> None:
        """Change parts of the filter by the names of :class:`ReviewFilter`."""
        self.filter = replace(self.filter, **changes)
        self._arrange()

    def row(self, unit_id: str) -> UnitRow | None:
        """Row of a unit, shown or not."""
        position = self._position.get(unit_id)
        return None if position is None else self.rows[position]

    def shown(self, index: int) -> UnitRow:
        """The row at a place of the present order."""
        return self.rows[self.order[index]]

    def place_of(self, unit_id: str) -> int | None:
        """Place of a unit in the present order; None when it is filtered out."""
        position = self._position.get(unit_id)
        return self._place.get(position) if position is not None else None

    def value(self, row: UnitRow, column: str) -> Any:
        """What a column shows of a row; None for nothing."""
        if column == "decision":
            review = self.review(row.unit_id)
            return review.decision if review else None
        if column == "reviewer":
            review = self.review(row.unit_id)
            return (f"{review.reviewer} ✓ {review.confirmed_by}" if review.confirmed_by else review.reviewer) if review else None
        if column == "broken_legs":
            return row.broken_legs or None
        return getattr(row, column)

    # selection

    @property
    def current(self) -> str | None:
        """The unit the plots show: the last one selected."""
        return self.selected[-1] if self.selected else None

    def select(self, unit_ids: Iterable[str]) -> None:
        """Select units in table, map and plots; unknown names are left out."""
        chosen = tuple(dict.fromkeys(unit for unit in unit_ids if unit in self._position))
        if chosen != self.selected:
            self.selected = chosen
            self._tell("selection")

    def step(self, by: int, *, undecided: bool = False) -> str | None:
        """Select the next (+1) or previous (-1) unit of the order, on wish the next without a decision; the unit selected."""
        if not self.order:
            return None
        here = self.place_of(self.current) if self.current is not None else None
        place = (-1 if by > 0 else len(self.order)) if here is None else here
        while 0 <= place + by < len(self.order):
            place += by
            unit = self.shown(place).unit_id
            if not undecided or self.review(unit) is None:
                self.select([unit])
                return unit
        return self.current

    def details(self, unit_id: str) -> UnitDetails:
        """Poses, features and check points of a unit, kept for the units looked at last."""
        if unit_id not in self._details:
            if len(self._details) >= DETAILS_KEPT:
                self._details.pop(next(iter(self._details)))
            self._details[unit_id] = read_details(self.path, unit_id, unit_sizes(self.epochs))
        return self._details[unit_id]

    def open_index(self) -> None:
        """Take in the points around the units, where the index beside the result is made, for what the result is now."""
        self.index = None
        # no index yet is the normal case after a run: the views say how to get the points
        with suppress(TetratrackError):
            self.index = index_of(self.path)

    def points_around(self, epoch: str, centre: FloatArray, half_size: float) -> FloatArray:
        """(n, 3) points of an epoch around a place; none where there is no index, or one that turns out to be damaged."""
        if self.index is not None:
            try:
                return self.index.read(epoch, centre, half_size)
            except TetratrackError:
                self.index = None
        return np.empty((0, 3))

    # decisions

    def review(self, unit_id: str) -> Review | None:
        """The decision on a unit in the present pair."""
        return self.reviews.get((unit_id, self.pair))

    def history(self, unit_id: str) -> list[ReviewEvent]:
        """All acts on a unit, in every pair, oldest first."""
        return read_history(self.path, unit_id)

    @property
    def rejected(self) -> frozenset[str]:
        """Units rejected in the present pair."""
        return frozenset(unit for (unit, pair), review in self.reviews.items() if pair == self.pair and review.decision == "rejected")

    def decide(self, decision: Decision, *, reviewer: str, comment: str = "", unit_ids: Sequence[str] | None = None) -> None:
        """Store a decision on the selected units (or the given ones) at once.

        Raises
        ------
        NumbersChangedError
            The file holds other numbers now than are shown; what it holds is read.
        InputError, OutputError
            Nothing is selected, the reviewer has no name, or the file cannot be written.
        """
        units = self._chosen(unit_ids)
        with self._on_numbers_shown():
            self._undoable.append(decide(self.path, units, self.pair, decision, comment=comment, reviewer=reviewer, shown=self._bases))
        self._reviewed()

    def confirm(self, *, reviewer: str, comment: str = "") -> None:
        """Confirm, as a second reviewer, the decision on each selected unit."""
        with self._on_numbers_shown():
            numbers = [
                confirm(self.path, unit, self.pair, reviewer=reviewer, comment=comment, shown=self._bases) for unit in self._chosen(None)
            ]
        self._undoable.append(numbers)
        self._reviewed()

    def undo(self, *, reviewer: str) -> tuple[str, ...]:
        """Take back the reviewer's last act, of this session or of one before; the units it was on."""
        events = read_history(self.path)
        taken_back = {event.undoes for event in events if event.action == "undo"}
        acts = [event for event in events if event.action in ("decide", "confirm") and event.number not in taken_back]
        mine = [event for event in acts if event.reviewer.casefold() == reviewer.strip().casefold()]
        if not mine:
            raise InputError("there is nothing of yours to undo", source=self.path, remedy="Only your own decisions can be undone.")
        last = mine[-1].number
        batch = next((numbers for numbers in self._undoable if last in numbers), [last])
        undo(self.path, sorted(set(batch) & {event.number for event in mine}, reverse=True), reviewer=reviewer)
        self._undoable = [numbers for numbers in self._undoable if last not in numbers]
        self._reviewed()
        return tuple(event.unit_id for event in mine if event.number in batch)

    def refresh(self) -> TakenIn:
        """Take in what other reviewers or a run wrote meanwhile; what it was, empty for nothing."""
        stamp = self._stamp()
        if stamp == self._seen:
            return ""
        found = self._take_in()
        # what could not be read, because another program held the file, is read at the next look
        self._seen = stamp
        return found

    def reload(self) -> None:
        """Read the rows again, after an edit changed poses or displacements."""
        self._details.clear()
        self._load()

    def statistics(self) -> Statistics:
        """Counts of the pair without the rejected units."""
        if self._statistics is None:
            self._statistics = self._count()
        return self._statistics

    # inside

    def _read_epochs(self) -> tuple[float, tuple[EpochInfo, ...], tuple[EpochPair, ...]]:
        """When the result was computed, its epochs, and the pairs of them that it compares."""
        computed, epochs, pairs = computed_at(self.path), read_epochs(self.path), epoch_pairs(self.path)
        if not pairs:
            raise InputError("holds no displacements", source=self.path, remedy="Review needs a survey of two epochs or more.")
        return computed, epochs, pairs

    def _datum_of(self, pair: EpochPair) -> str:
        """The present datum where a pair has it, else its first."""
        available = datums(self.path, pair)
        if not available:
            raise InputError(f"has no displacements for {pair}", source=self.path, remedy="Choose another epoch pair.")
        return self.datum if self.datum in available else available[0]

    def _take_in(self) -> TakenIn:
        if computed_at(self.path) != self._computed:
            self._take_in_run()
            return "run"
        if contents_stamp(self.path) != self._contents:
            self.reload()
            return "corrections"
        reviews = read_reviews(self.path)
        if reviews == self.reviews:
            return ""
        self.reviews = reviews
        self._arrange(tell=False)
        self._tell("reviews")
        return "decisions"

    def _take_in_run(self) -> None:
        """Show what a run put into the file, of the same epochs where it has them."""
        computed, self.epochs, self.pairs = self._read_epochs()
        pair = self.pair if self.pair in self.pairs else latest_pair(self.pairs, [info.label for info in self.epochs])
        self._details.clear()
        self.open_index()
        self._compare(pair, self._datum_of(pair))
        self._computed = computed

    @contextmanager
    def _on_numbers_shown(self) -> Iterator[None]:
        """Show what the file holds where a decision is refused because that is no longer what was shown."""
        try:
            yield
        except NumbersChangedError:
            # where even the epochs are others, the next look takes them in
            with suppress(TetratrackError):
                self.reload()
            raise

    def _stamp(self) -> tuple[tuple[int, int], ...]:
        """When and how large the file and its write-ahead log were last written: a look that costs nothing."""
        files = (self.path, self.path.with_name(f"{self.path.name}-wal"))
        return tuple((file.stat().st_mtime_ns, file.stat().st_size) for file in files if file.exists())

    def _count(self) -> Statistics:
        rejected = self.rejected
        rows = [row for row in self.rows if row.unit_id not in rejected]
        lengths = [row.d_3d for row in rows if row.d_3d is not None]
        return Statistics(
            units=len(rows),
            significant=sum(row.significant for row in rows),
            lost=sum(row.kind == "lost" for row in rows),
            new=sum(row.kind == "new" for row in rows),
            broken=sum(bool(row.broken_legs) for row in rows),
            decided=sum(self.review(row.unit_id) is not None for row in rows),
            rejected=len(rejected & self._position.keys()),
            median=float(np.median(lengths)) if lengths else None,
            largest=max(lengths) if lengths else None,
        )

    def _chosen(self, unit_ids: Sequence[str] | None) -> list[str]:
        units = list(self.selected if unit_ids is None else unit_ids)
        if not units:
            raise InputError("no unit is selected", remedy="Select one in the table or on the map.")
        return units

    def _load(self) -> None:
        # all is read before anything changes: the window may draw itself meanwhile
        # what a decision rests on is read before what is shown: where a run comes in between, a decision is refused
        contents, shown = contents_stamp(self.path), read_bases(self.path, self.pair)
        rows, reviews = read_unit_rows(self.path, self.pair, self.datum), read_reviews(self.path)
        self._contents, self._bases, self.rows, self.reviews = contents, shown, rows, reviews
        self._position = {row.unit_id: k for k, row in enumerate(self.rows)}
        self.selected = tuple(unit for unit in self.selected if unit in self._position)
        self._arrange(tell=False)
        self._tell("rows")

    def _reviewed(self) -> None:
        self.reviews = read_reviews(self.path)
        # a decision must not make the unit jump away under the reviewer's eyes: the order is kept, the filter works at the next change
        self._tell("reviews")

    def _arrange(self, tell: bool = True) -> None:
        places = [k for k in self._inside_area() if self._passes(self.rows[k])]
        values = {k: self.value(self.rows[k], self.sort_column) for k in places}
        known = [k for k in places if values[k] is not None]
        known.sort(key=lambda k: abs(values[k]) if self.sort_column == "vertical" else values[k], reverse=self.descending)
        self.order = known + [k for k in places if values[k] is None]
        self._place = {k: place for place, k in enumerate(self.order)}
        if tell:
            self._tell("order")

    def _passes(self, row: UnitRow) -> bool:
        wanted = self.filter
        if wanted.kinds and row.kind not in wanted.kinds:
            return False
        always = row.kind in ("lost", "new", "relocated") or row.broken_legs
        if wanted.threshold > 0 and not always and (row.d_3d is None or row.d_3d < wanted.threshold):
            return False
        if wanted.undecided and self.review(row.unit_id) is not None:
            return False
        return wanted.text.casefold() in row.unit_id.casefold()

    def _inside_area(self) -> list[int]:
        if not self.filter.area:
            return list(range(len(self.rows)))
        placed = [k for k, row in enumerate(self.rows) if row.place is not None]
        points = np.array([self.rows[k].place for k in placed]).reshape(-1, 3)[:, :2]
        inside = np.zeros(len(points), dtype=bool)
        for ring in self.filter.area:
            inside ^= _in_ring(points, ring)
        return [k for k, hit in zip(placed, inside, strict=True) if hit]

    def _tell(self, topic: Topic) -> None:
        if topic in ("rows", "reviews"):
            self._statistics = None
        for callback in tuple(self._observers):
            callback(topic)


def _in_ring(points: FloatArray, ring: FloatArray) -> NDArray[np.bool_]:
    """Whether (n, 2) points lie in a closed ring ((m, 2), first vertex repeated or not), by counting crossings."""
    start, stop = ring, np.roll(ring, -1, axis=0)
    x, y = points[:, 0][:, None], points[:, 1][:, None]
    straddles = (start[:, 1] > y) != (stop[:, 1] > y)
    rise = np.where(stop[:, 1] == start[:, 1], 1.0, stop[:, 1] - start[:, 1])
    crossing = start[:, 0] + (y - start[:, 1]) * (stop[:, 0] - start[:, 0]) / rise
    return np.asarray(np.sum(straddles & (x < crossing), axis=1) % 2 == 1)
