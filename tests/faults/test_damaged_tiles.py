"""Five hundred damaged tiles: no crash, no hang, one sentence each, and never points where there were none."""

from __future__ import annotations

import multiprocessing
import random
from pathlib import Path

import numpy as np
import pytest
from las_files import grid_points, write_las
from tetratrack.core.common.errors import InputError
from tetratrack.core.data.tiles import inspect_tile, read_points

MUTATIONS = 500
SECONDS = 60


def _mutated(data: bytes, rng: random.Random) -> bytes:
    """Flip bits, overwrite or remove a stretch, truncate; half of the time near the start, where headers and tables are."""
    changed = bytearray(data)
    reach = len(changed) if rng.random() < 0.5 else min(len(changed), 1200)
    for _ in range(rng.choice((1, 1, 2, 8))):
        at = rng.randrange(reach)
        kind = rng.random()
        if kind < 0.5:
            changed[at] ^= 1 << rng.randrange(8)
        elif kind < 0.7:
            stretch = rng.randrange(1, 16)
            changed[at : at + stretch] = rng.choice((b"\x00", b"\xff", b"\x7f")) * stretch
        elif kind < 0.85:
            del changed[at : at + rng.randrange(1, 64)]
        else:
            del changed[at:]
        if not changed:
            break
        reach = min(reach, len(changed))
    return bytes(changed)


def _read(path: str) -> tuple[str, object]:
    """What a worker makes of a tile: its points, or the sentence."""
    try:
        cloud = read_points([inspect_tile(path, "EPSG:32650")], "EPSG:32650")
    except InputError as error:
        return "refused", str(error)
    return "read", cloud.xyz + cloud.origin


@pytest.mark.parametrize("ending", ["las", "laz"])
def test_mutations(tmp_path: Path, ending: str) -> None:
    points = grid_points(3000)
    good = write_las(tmp_path / f"good.{ending}", points, time=np.arange(3000.0)).read_bytes()
    rng = random.Random(11)
    low, high = points.min(axis=0) - 0.01, points.max(axis=0) + 0.01
    refused = changed = 0
    # a process of its own: a crash or hang of a decoder must not pass for a result, nor end the tests
    with multiprocessing.get_context("spawn").Pool(1) as pool:
        for number in range(MUTATIONS // 2):
            path = tmp_path / f"tile{number}.{ending}"
            path.write_bytes(_mutated(good, rng))
            outcome, what = pool.apply_async(_read, (str(path),)).get(timeout=SECONDS)
            if outcome == "refused":
                refused += 1
                assert path.name in what
                assert "\n" not in what
                assert len(what) < 400 + len(str(path))
            else:
                # what the format itself cannot tell (it has no checksums) stays within the extent that the header gives
                changed += len(what) != len(points)
                if (what < low).any() or (what > high).any():
                    # only a header that says so itself may place points elsewhere
                    assert path.read_bytes()[131:227] != good[131:227], [
                        i for i, (a, b) in enumerate(zip(path.read_bytes(), good, strict=False)) if a != b
                    ][:20]
            path.unlink()
    assert refused > MUTATIONS // 8
