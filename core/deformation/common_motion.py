"""What registrations say of the motion that all units share between two epochs whose frames stay rigid."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from ..common.arrays import FloatArray
from ..registration.transformation import rigid_jacobian
from .target_shifts import TargetShifts, difference_of_shared, numbers_of_shared
from .tracked_epoch import TrackedEpoch


def common_prior(epochs: Sequence[TrackedEpoch], first: int, second: int, origin: FloatArray) -> FloatArray | None:
    """(7, 7) covariance of the motion common to all units between two registered epochs, about (3,) ``origin``; None without control.

    What both registrations share drops out of their difference: the whole error of one epoch that both are tied to, or the error of
    coordinates that were surveyed once and registered both.
    """
    total = np.zeros((7, 7))
    roots = []
    for number in (first, second):
        placement = epochs[number].placement
        if placement is None:
            return None
        total += placement.covariance_at(origin)
        tied_to = epochs[number].tied_to
        roots.append(epochs[number if tied_to is None else tied_to])
    one, other = roots
    if one.registration is None or other.registration is None:
        return total
    if one is other:
        return total - 2 * one.registration.covariance_at(origin)
    difference = _difference_by_surveyed(one, other, origin)
    if difference is None:
        return total
    return total - one.registration.covariance_at(origin) - other.registration.covariance_at(origin) + difference


def _difference_by_surveyed(first: TrackedEpoch, second: TrackedEpoch, origin: FloatArray) -> FloatArray | None:
    """(7, 7) covariance of the difference of two registrations whose targets were surveyed once; None where they were not.

    The error of those coordinates is in the residuals of both epochs alike: how large the rest is, their differences say, of which
    the factor of the stated deviations is taken, never below one.
    """
    one, other = (_registering(epoch.targets) for epoch in (first, second))
    if one is None or other is None:
        return None
    differences = difference_of_shared(one, other)
    if differences is None:
        return None
    a, b = numbers_of_shared(one, other)
    scaled = [bool(epoch.registration is not None and epoch.registration.covariance[6, 6] > 0) for epoch in (first, second)]
    gains = [_gain(own, scale, origin) for own, scale in zip((one, other), scaled, strict=True)]
    shared = (one.variances[a] + other.variances[b] - differences.variances) / 2
    cross = np.einsum("inj,nj,knj->ik", gains[0][:, a], shared, gains[1][:, b])
    own = np.sum([np.einsum("inj,nj,knj->ik", g, t.variances, g) for g, t in zip(gains, (one, other), strict=True)], axis=0)
    redundancy = 3 * len(a) - (7 if any(scaled) else 6)
    squares = float(np.sum(differences.residuals**2 / differences.variances))
    factor = max(1.0, squares / redundancy) if redundancy > 0 else 1.0
    return np.asarray(factor * (own - cross - cross.T))


def _registering(targets: TargetShifts | None) -> TargetShifts | None:
    """Those that took part in the registration."""
    return targets if targets is None or targets.used is None else targets.chosen(targets.used)


def _gain(targets: TargetShifts, scaled: bool, origin: FloatArray) -> FloatArray:
    """(7, k, 3) effect of the coordinates of targets on the registration's seven parameters about ``origin`` (least squares)."""
    free = 7 if scaled else 6
    rows = rigid_jacobian(targets.positions - origin)[:, :, :free]
    weighted = rows / targets.variances[:, :, None]
    gain = np.zeros((7, len(targets.ids), 3))
    gain[:free] = np.einsum("ij,ncj->inc", np.linalg.inv(np.einsum("nci,ncj->ij", rows, weighted)), weighted)
    return gain
