"""One of two windows on the same result: decides or corrects (TETRATRACK_ROLE) TETRATRACK_ACTS times with the dock's own buttons."""

from __future__ import annotations

import os
import time
from pathlib import Path
from typing import Any

from qgis.PyQt.QtWidgets import QAction, QToolButton
from steps import action, click, plugin, run, until, wait

ACTS = int(os.environ["TETRATRACK_ACTS"])
RESULT, ROLE, MEETING = Path(os.environ["TETRATRACK_RESULT"]), os.environ["TETRATRACK_ROLE"], Path(os.environ["TETRATRACK_MEETING"])
OTHER = {"deciding": "correcting", "correcting": "deciding"}[ROLE]


def script() -> dict[str, Any]:
    """Open, wait for the other, act, and look until both have done."""
    action("Displacement review").trigger()
    dock = until(lambda: plugin().review_dock, 10, "the dock")
    dock.open(RESULT)
    dock.decisions.reviewer.setText(ROLE)
    names = sorted(row.unit_id for row in dock.store.rows if row.d_3d is not None)
    meet("open")
    said = [decide(dock, k, names) if ROLE == "deciding" else correct(dock, k, names) for k in range(ACTS)]
    meet("done")
    ended = time.monotonic()
    # the longest that a look at the file may take
    wait(5000)
    return {"said": said, "shown": shown(dock), "looked": time.monotonic() - ended}


def meet(what: str) -> None:
    """Both windows have come so far."""
    (MEETING / f"{ROLE} {what}").touch()
    until((MEETING / f"{OTHER} {what}").is_file, 300, f"the other window: {what}")


def decide(dock: Any, k: int, names: list[str]) -> str:
    """Select a unit of the list and press a button; every tenth time take the last one back."""
    present = [name for name in names if dock.store.row(name) is not None]
    dock.store.select([present[(7 * k) % len(present)]])
    name = "undo" if k % 10 == 9 else ("accepted", "rejected", "inspect")[k % 3]
    click(dock.findChild(QToolButton, f"review_{name}"))
    # at once: a look at the file says later what the other did
    said = str(dock.status.text())
    wait(20)
    return said


def correct(dock: Any, k: int, names: list[str]) -> str:
    """Choose in the pencil's menu: delete a unit, split one, or take the last correction back."""
    # a unit that was split is in one of the epochs only
    present = [name for name in names if (row := dock.store.row(name)) is not None and row.d_3d is not None]
    dock.store.select([present[(11 * k) % len(present)]])
    begins = "Take back" if k % 4 == 3 else ("Delete", "Split")[k % 2]
    entry = next(a for a in dock.findChildren(QAction, "correction") if a.text().startswith(begins))
    entry.trigger()
    # at once: a look at the file says later what the other did
    said = str(dock.status.text())
    wait(20)
    return said


def shown(dock: Any) -> dict[str, list[str | None]]:
    """What the list says of each unit: class, displacement, decision, reviewer."""
    rows = [dock.store.shown(k) for k in range(len(dock.store.order))]
    return {row.unit_id: [dock.model.text(row, column) for column in ("kind", "d_3d", "decision", "reviewer")] for row in rows}


run(script)
