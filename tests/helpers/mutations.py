"""Files changed at random, as transfers, disks and editors change them."""

from __future__ import annotations

import random

SIGNS = (b"\x00", b"\xff\xfe", b"\\", b'"', b"[", b"]]", b",,", b"\n", b"1e999", b"nan", b"-", b"=")
"""What means something in one of the formats."""


def mutated(data: bytes, rng: random.Random, near_start: int | None = None) -> bytes:
    """Flip, overwrite, remove, double or truncate; in text also replace signs by those that mean something there.

    Half of the changes lie within ``near_start`` bytes, where headers and tables are.
    """
    changed = bytearray(data)
    reach = near_start if near_start is not None and rng.random() < 0.5 else len(changed)
    for _ in range(rng.choice((1, 1, 2, 6))):
        if not changed:
            break
        at = rng.randrange(min(reach, len(changed)))
        kind = rng.random()
        if kind < 0.3:
            changed[at] ^= 1 << rng.randrange(8)
        elif kind < 0.6:
            changed[at : at + rng.randrange(1, 4)] = rng.choice(SIGNS)
        elif kind < 0.75:
            del changed[at : at + rng.randrange(1, 64)]
        elif kind < 0.9:
            stretch = bytes(changed[at : at + rng.randrange(1, 200)])
            changed[at:at] = stretch * rng.choice((1, 1, 50))
        else:
            del changed[at:]
    return bytes(changed)
