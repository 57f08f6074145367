"""Decisions of reviewers, kept in the result file itself.

Every act (decide, confirm, undo) is one row appended to ``review_log`` and never changed; ``reviews`` holds, per unit and epoch
pair, the state the log leads to. Both are written in one immediate transaction, so that a crash loses nothing and several
people may work on the same file.

A decision holds the numbers it was made on (``basis``). Where these change, by a correction or by a new run, it no longer counts and
the log says so (``lapse``); where they come back, it counts again (``restore``).
"""

from __future__ import annotations

import sqlite3
import time
from collections.abc import Iterator, Mapping, Sequence
from contextlib import closing, contextmanager
from dataclasses import dataclass
from pathlib import Path
from typing import Any, Literal

from ..common.errors import InputError, OutputError
from ..results.geopackage_reader import EpochPair, add_indices, now_utc, query, table_names
from ..results.result_access import READING_SECONDS, connect, is_writable, limit_computing, patiently, reading
from .basis import Basis, bases, basis_of
from .unit_records import columns_of, tables_of

Decision = Literal["accepted", "rejected", "inspect"]
DECISIONS: tuple[Decision, ...] = ("accepted", "rejected", "inspect")

CREATE_REVIEWS = (
    "CREATE TABLE IF NOT EXISTS reviews (fid INTEGER PRIMARY KEY AUTOINCREMENT NOT NULL, unit_id TEXT, epoch_from TEXT, epoch_to TEXT, "
    "decision TEXT, comment TEXT, reviewer TEXT, reviewed_at DATETIME, confirmed_by TEXT, confirmed_at DATETIME)"
)
CREATE_LOG = (
    "CREATE TABLE IF NOT EXISTS review_log (number INTEGER PRIMARY KEY AUTOINCREMENT NOT NULL, unit_id TEXT NOT NULL, "
    "epoch_from TEXT NOT NULL, epoch_to TEXT NOT NULL, action TEXT NOT NULL, decision TEXT, comment TEXT, reviewer TEXT NOT NULL, "
    "at DATETIME NOT NULL, undoes INTEGER, basis TEXT)"
)
INDEX_LOG = "CREATE INDEX IF NOT EXISTS review_log_unit ON review_log (unit_id)"
PROGRAM = "tetratrack"
"""Who lets a decision lapse when a run, not a person, changed its numbers."""
REGISTER = (
    "INSERT OR IGNORE INTO gpkg_contents (table_name, data_type, identifier, description, last_change) VALUES (?, 'attributes', ?, ?, ?)"
)


class NumbersChangedError(InputError):
    """The numbers that a reviewer decided on are no longer those of the result."""


@dataclass(frozen=True, kw_only=True)
class Review:
    """The state of one unit in one epoch pair: the decision that counts, who made it, and who confirmed it."""

    unit_id: str
    pair: EpochPair
    decision: str
    comment: str
    reviewer: str
    reviewed_at: str
    confirmed_by: str = ""
    confirmed_at: str = ""


@dataclass(frozen=True, kw_only=True)
class ReviewEvent:
    """One act of one reviewer, or what became of a decision when its numbers changed.

    ``undoes`` is the number of the event an undo takes back, ``basis`` what a decision was made on (None in files of earlier versions).
    """

    number: int
    unit_id: str
    pair: EpochPair
    action: Literal["decide", "confirm", "undo", "lapse", "restore"]
    decision: str
    comment: str
    reviewer: str
    at: str
    undoes: int | None
    basis: Basis | None = None


def read_reviews(path: Path) -> dict[tuple[str, EpochPair], Review]:
    """All reviews of a result, by unit and epoch pair; {} before the first decision."""
    if "reviews" not in table_names(path):
        return {}
    with reading(path) as connection:
        rows = query(connection, "SELECT * FROM reviews")
    reviews = [_review(row) for row in rows if row["decision"]]
    return {(review.unit_id, review.pair): review for review in reviews}


def rejected_units(path: Path, pair: EpochPair) -> frozenset[str]:
    """Units a reviewer rejected in an epoch pair: they leave statistics, maps and reports."""
    return frozenset(unit for (unit, found), review in read_reviews(path).items() if found == pair and review.decision == "rejected")


def read_history(path: Path, unit_id: str | None = None) -> list[ReviewEvent]:
    """Every act on one unit (or all of them), oldest first."""
    if "review_log" not in table_names(path):
        return []
    with reading(path) as connection:
        if unit_id is None:
            rows = query(connection, "SELECT * FROM review_log ORDER BY number")
        else:
            rows = query(connection, "SELECT * FROM review_log WHERE unit_id = ? ORDER BY number", (unit_id,))
    return [_event(row) for row in rows]


def prepare(path: Path) -> None:
    """Create what reviewing needs in a result: the two tables, and indices by unit and epoch pair.

    Raises
    ------
    OutputError
        The file is read-only or locked.
    """
    with writing(path) as connection:
        _prepare(connection)
        add_indices(connection)
        settle(connection, PROGRAM)


def settle_decisions(path: Path) -> int:
    """After a run replaced the numbers of a result: let decisions lapse that were made on others; how many changed.

    Raises
    ------
    OutputError
        The file is read-only or locked.
    """
    if "review_log" not in table_names(path):
        return 0
    with writing(path) as connection:
        _prepare(connection)
        return settle(connection, PROGRAM)


def settle(connection: sqlite3.Connection, by: str) -> int:
    """Bring the decisions of a result into step with its numbers, inside a transaction that changed them; how many changed.

    Parameters
    ----------
    connection
        Of :func:`writing`.
    by
        Who changed the numbers.
    """
    if not {"review_log", "reviews"} <= tables_of(connection):
        return 0
    by_unit: dict[tuple[str, EpochPair], list[ReviewEvent]] = {}
    for row in query(connection, "SELECT * FROM review_log ORDER BY number"):
        event = _event(row)
        by_unit.setdefault((event.unit_id, event.pair), []).append(event)
    if not by_unit:
        return 0
    stored = {(review.unit_id, review.pair) for row in query(connection, "SELECT * FROM reviews") if (review := _review(row)).decision}
    found = bases(connection, {pair for _, pair in by_unit})
    changed = 0
    for (unit, pair), events in by_unit.items():
        decision = _standing(events)
        if decision is None:
            continue
        now = found.get((unit, pair), Basis({}))
        counts = decision.basis is None or decision.basis.agrees(now)
        if counts == ((unit, pair) in stored):
            continue
        words = f"{_length(decision.basis)} → {_length(now)}"
        _append(connection, unit, pair, "restore" if counts else "lapse", decision.decision, words, by, None, basis=now)
        changed += 1
    return changed


def decide(
    path: Path,
    unit_ids: Sequence[str],
    pair: EpochPair,
    decision: Decision,
    *,
    comment: str,
    reviewer: str,
    shown: Mapping[str, Basis] | None = None,
) -> list[int]:
    """Store a decision on each unit at once; returns the numbers of the events.

    Parameters
    ----------
    shown
        By unit the numbers that the reviewer saw; None where the caller has just read them.

    Raises
    ------
    NumbersChangedError
        The result now holds other numbers than were shown.
    InputError
        The reviewer has no name, the decision is none of ``DECISIONS``, or a unit has left the result.
    OutputError
        The file is read-only, locked by someone for more than half a minute, or the disk is full.
    """
    if decision not in DECISIONS:
        raise InputError(f"there is no decision {decision!r}", remedy=f"Use one of {', '.join(DECISIONS)}.")
    who = _name(reviewer)
    with writing(path) as connection:
        _prepare(connection)
        numbers = []
        for unit in unit_ids:
            if connection.execute("SELECT 1 FROM units WHERE unit_id = ? LIMIT 1", (unit,)).fetchone() is None:
                raise InputError("is not in the result any more", where=f"unit {unit}", remedy="Somebody deleted or merged it meanwhile.")
            basis = _as_shown(connection, unit, pair, shown)
            numbers.append(_append(connection, unit, pair, "decide", decision, comment, who, None, basis=basis))
        return numbers


def confirm(
    path: Path, unit_id: str, pair: EpochPair, *, reviewer: str, comment: str = "", shown: Mapping[str, Basis] | None = None
) -> int:
    """Confirm another reviewer's decision; ``shown`` as in :func:`decide`.

    Raises
    ------
    NumbersChangedError
        The result now holds other numbers than were shown.
    InputError
        There is no decision to confirm, or it is the reviewer's own.
    OutputError
        The file cannot be written.
    """
    who = _name(reviewer)
    with writing(path) as connection:
        _prepare(connection)
        basis = _as_shown(connection, unit_id, pair, shown)
        state = _state(_events(connection, unit_id, pair), basis)
        if state is None:
            raise InputError(
                "there is no decision to confirm yet", where=f"unit {unit_id}", remedy="Decide first; another reviewer then confirms."
            )
        if state.reviewer.casefold() == who.casefold():
            raise InputError(f"{who} made this decision", where=f"unit {unit_id}", remedy="A second reviewer has to confirm it.")
        return _append(connection, unit_id, pair, "confirm", state.decision, comment, who, None, basis=basis)


def undo(path: Path, numbers: Sequence[int], *, reviewer: str) -> None:
    """Take back events of one's own; what other reviewers did meanwhile stands.

    Raises
    ------
    InputError
        An event does not exist, is another reviewer's, or is taken back already.
    OutputError
        The file cannot be written.
    """
    who = _name(reviewer)
    with writing(path) as connection:
        for number in numbers:
            row = connection.execute("SELECT * FROM review_log WHERE number = ?", (number,)).fetchone()
            taken_back = connection.execute("SELECT 1 FROM review_log WHERE undoes = ?", (number,)).fetchone()
            if row is None or taken_back or row["reviewer"].casefold() != who.casefold():
                raise InputError(f"act {number} is not yours to undo, or is undone already", remedy="Decide anew instead.")
            event = _event(dict(row))
            _append(connection, event.unit_id, event.pair, "undo", event.decision, "", who, number)


@contextmanager
def writing(path: Path) -> Iterator[sqlite3.Connection]:
    """An immediate transaction on a result file, committed to the disk on leaving, rolled back on any error."""
    if not path.is_file():
        raise OutputError("there is no such file any more", source=path, remedy="Open the result again.")
    if not is_writable(path):
        raise OutputError(
            "is read-only, so nothing can be stored", source=path, remedy="Allow writing to the file and its folder, or review a copy."
        )
    with closing(connect(path, write=True)) as connection:
        start = time.monotonic()
        try:
            connection.execute("PRAGMA synchronous = FULL")
            patiently(lambda: connection.execute("BEGIN IMMEDIATE"))
            # a trigger of a stranger may never end
            limit_computing(connection, READING_SECONDS)
            yield connection
            patiently(lambda: connection.execute("COMMIT"))
        except sqlite3.OperationalError as error:
            connection.set_progress_handler(None, 0)
            if connection.in_transaction:
                connection.execute("ROLLBACK")
            if "interrupted" in str(error) and time.monotonic() - start < 0.9 * READING_SECONDS:
                # SQLite drops what a signal handler raises while it computes
                raise KeyboardInterrupt from error
            if "interrupted" in str(error):
                raise OutputError(
                    f"takes longer than {READING_SECONDS:.0f} s to store anything", source=path, remedy="Take out triggers of other tools."
                ) from error
            raise OutputError(
                f"could not be written ({error})", source=path, remedy="Close other programs that are writing to it, then try again."
            ) from error
        except BaseException:
            if connection.in_transaction:
                connection.execute("ROLLBACK")
            raise


def register_attributes(connection: sqlite3.Connection, table: str, description: str) -> None:
    """List a table without geometry in the GeoPackage's contents, so that QGIS shows it."""
    connection.execute(REGISTER, (table, table, description, now_utc()))


def _prepare(connection: sqlite3.Connection) -> None:
    connection.execute(CREATE_REVIEWS)
    connection.execute(CREATE_LOG)
    connection.execute(INDEX_LOG)
    present = columns_of(connection, "reviews")
    if "confirmed_by" not in present:
        connection.execute("ALTER TABLE reviews ADD COLUMN confirmed_by TEXT")
    if "confirmed_at" not in present:
        connection.execute("ALTER TABLE reviews ADD COLUMN confirmed_at DATETIME")
    if "basis" not in columns_of(connection, "review_log"):
        connection.execute("ALTER TABLE review_log ADD COLUMN basis TEXT")
    register_attributes(connection, "reviews", "Decision of the reviewers on each unit and epoch pair")
    register_attributes(connection, "review_log", "Every act of every reviewer, oldest first")


def _as_shown(connection: sqlite3.Connection, unit_id: str, pair: EpochPair, shown: Mapping[str, Basis] | None) -> Basis:
    """Present numbers of a unit, which must be those that were shown."""
    basis = basis_of(connection, unit_id, pair)
    if shown is not None and not shown.get(unit_id, Basis({})).agrees(basis):
        raise NumbersChangedError(
            "now has other numbers than were shown, so nothing was stored",
            where=f"unit {unit_id}",
            remedy="A run or a correction changed them meanwhile: look at them, then decide.",
        )
    return basis


def _append(
    connection: sqlite3.Connection,
    unit_id: str,
    pair: EpochPair,
    action: str,
    decision: str,
    comment: str,
    reviewer: str,
    undoes: int | None,
    *,
    basis: Basis | None = None,
) -> int:
    basis = basis or basis_of(connection, unit_id, pair)
    _adopt(connection, unit_id, pair, basis)
    insert = (
        "INSERT INTO review_log (unit_id, epoch_from, epoch_to, action, decision, comment, reviewer, at, undoes, basis) "
        "VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?, ?)"
    )
    key = (unit_id, pair.epoch_from, pair.epoch_to)
    number = connection.execute(insert, (*key, action, decision, comment, reviewer, now_utc(), undoes, basis.json)).lastrowid
    state = _state(_events(connection, unit_id, pair), basis)
    connection.execute("DELETE FROM reviews WHERE unit_id = ? AND epoch_from = ? AND epoch_to = ?", key)
    if state is not None:
        connection.execute(
            "INSERT INTO reviews (unit_id, epoch_from, epoch_to, decision, comment, reviewer, reviewed_at, confirmed_by, confirmed_at) "
            "VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?)",
            (
                *key,
                state.decision,
                state.comment,
                state.reviewer,
                state.reviewed_at,
                state.confirmed_by or None,
                state.confirmed_at or None,
            ),
        )
    connection.execute("UPDATE gpkg_contents SET last_change = ? WHERE table_name IN ('reviews', 'review_log')", (now_utc(),))
    if number is None:
        raise OutputError("the database gave no number to a decision", remedy="Open the result again.")
    return number


def _adopt(connection: sqlite3.Connection, unit_id: str, pair: EpochPair, basis: Basis) -> None:
    """A decision typed straight into ``reviews`` has no event yet: give it one, or an undo would lose it."""
    key = (unit_id, pair.epoch_from, pair.epoch_to)
    row = connection.execute(
        "SELECT * FROM reviews WHERE unit_id = ? AND epoch_from = ? AND epoch_to = ? AND decision IS NOT NULL ORDER BY fid DESC LIMIT 1",
        key,
    ).fetchone()
    if row is None:
        return
    typed = _review(dict(row))
    known = _standing(_events(connection, unit_id, pair))
    if known is not None and (known.decision, known.reviewer, known.comment) == (typed.decision, typed.reviewer, typed.comment):
        return
    connection.execute(
        "INSERT INTO review_log (unit_id, epoch_from, epoch_to, action, decision, comment, reviewer, at, basis) "
        "VALUES (?, ?, ?, 'decide', ?, ?, ?, ?, ?)",
        (*key, typed.decision, typed.comment, typed.reviewer, typed.reviewed_at or now_utc(), basis.json),
    )


def _length(basis: Basis | None) -> str:
    if basis is None or basis.length is None:
        return "–"
    return f"{basis.length:.3f} m"


def _events(connection: sqlite3.Connection, unit_id: str, pair: EpochPair) -> list[ReviewEvent]:
    statement = "SELECT * FROM review_log WHERE unit_id = ? AND epoch_from = ? AND epoch_to = ? ORDER BY number"
    return [_event(row) for row in query(connection, statement, (unit_id, pair.epoch_from, pair.epoch_to))]


def _standing(events: Sequence[ReviewEvent]) -> ReviewEvent | None:
    """The last decision that nobody took back, whatever became of its numbers."""
    taken_back = {event.undoes for event in events if event.action == "undo"}
    return next((event for event in reversed(events) if event.action == "decide" and event.number not in taken_back), None)


def _state(events: Sequence[ReviewEvent], now: Basis) -> Review | None:
    """What the acts on one unit and pair lead to with the numbers of now; None when nothing counts."""
    decision = _standing(events)
    if decision is None or (decision.basis is not None and not decision.basis.agrees(now)):
        return None
    taken_back = {event.undoes for event in events if event.action == "undo"}
    confirmed = next(
        (e for e in reversed(events) if e.action == "confirm" and e.number > decision.number and e.number not in taken_back), None
    )
    return Review(
        unit_id=decision.unit_id,
        pair=decision.pair,
        decision=decision.decision,
        comment=decision.comment,
        reviewer=decision.reviewer,
        reviewed_at=decision.at,
        confirmed_by=confirmed.reviewer if confirmed else "",
        confirmed_at=confirmed.at if confirmed else "",
    )


def _name(reviewer: str) -> str:
    if not reviewer.strip():
        raise InputError("the reviewer has no name", remedy="Enter your name or initials; it stands beside every decision.")
    return reviewer.strip()


def _review(row: dict[str, Any]) -> Review:
    text = {name: str(row.get(name) or "") for name in ("decision", "comment", "reviewer", "reviewed_at", "confirmed_by", "confirmed_at")}
    return Review(unit_id=str(row["unit_id"]), pair=EpochPair(str(row["epoch_from"]), str(row["epoch_to"])), **text)


def _event(row: dict[str, Any]) -> ReviewEvent:
    return ReviewEvent(
        number=int(row["number"]),
        unit_id=row["unit_id"],
        pair=EpochPair(row["epoch_from"], row["epoch_to"]),
        action=row["action"],
        decision=row["decision"] or "",
        comment=row["comment"] or "",
        reviewer=row["reviewer"],
        at=row["at"],
        undoes=row["undoes"],
        basis=Basis.from_json(row.get("basis")),
    )
