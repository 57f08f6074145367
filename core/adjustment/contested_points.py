"""Conditions of the points that several parts of a unit may own, each with its share of membership; one by one."""

from __future__ import annotations

import math

from numba import njit

from .condition_records import CLEAR, CONTESTED, PSI_SQUARES, SCORE, SINGLE, SINGLES, SLOPES, SQUARES, WEIGHT, WEIGHTS, X, Y, Z
from .normal_sums import add_disc, add_outer, add_products_of_scores
from .residual_weights import IMPOSSIBLE, NO_WEIGHT, SCALE_NARROWING, inside_probability, ramp, robust_weight


@njit(**CONTESTED)
def to_body(px, py, pz, centre, rotation):  # type: ignore[no-untyped-def]
    """Coordinates of a point in the frame of the body."""
    dx, dy, dz = px - centre[0], py - centre[1], pz - centre[2]
    x = rotation[0, 0] * dx + rotation[1, 0] * dy + rotation[2, 0] * dz
    y = rotation[0, 1] * dx + rotation[1, 1] * dy + rotation[2, 1] * dz
    z = rotation[0, 2] * dx + rotation[1, 2] * dy + rotation[2, 2] * dz
    return x, y, z


@njit(**CONTESTED)
def blurred_points(points, first, count, solid, block):  # type: ignore[no-untyped-def]
    """Read ``count`` points with covariances of their own: none is clear beyond doubt, an inclined noise ellipsoid needs the slower way."""
    block[CLEAR, :count] = 0.0
    block[WEIGHT, :count] = 0.0
    block[SCORE, :count] = 0.0
    block[SINGLE, :count] = 0.0
    for i in range(count):
        j = first + i
        block[X, i], block[Y, i], block[Z, i] = to_body(points[0, j], points[1, j], points[2, j], solid.centre, solid.rotation)


@njit(**CONTESTED)
def turned_covariance(cov, j, rotation, body_cov):  # type: ignore[no-untyped-def]
    """Covariance of a point into the axes of the body."""
    for a in range(3):
        for b in range(3):
            total = 0.0
            for p in range(3):
                for q in range(3):
                    total += rotation[p, a] * cov[j, p, q] * rotation[q, b]
            body_cov[a, b] = total


@njit(**CONTESTED)
def foot(place, leg, disc, solid, cone, noise, near, found):  # type: ignore[no-untyped-def]
    """Adjusted observation of one point (body frame) on the lateral surface or end disc of one leg.

    A row of ``found``, the leg's or four below it the end disc's, receives the outward normal (0:3), signed distance (3), standard
    deviation along it for unit noise (4), axial coordinate of the foot (5), second-order bias for unit noise (6), distance of the foot
    inside the creases or, on a disc, inside the rim (7), and the foot itself (8:11). The distance to a crease is measured within the
    surface where it is below ``near``; beyond, it is a lower bound.
    """
    x, y, z = place
    axes, creases, cov = solid.legs.directions, solid.legs.creases, noise.cov
    has_cov = noise.has_cov
    r, c, cosine = cone
    j = leg + 4 * disc
    end = solid.leg_lengths[leg]
    ax, ay, az = axes[leg, 0], axes[leg, 1], axes[leg, 2]
    fz, fx, fy = z, x, y
    nx = ny = nz = ux = uy = uz = e = 0.0
    variance = 1.0
    # with equal noise the first perpendicular is exact; an inclined noise ellipsoid needs the iteration of the adjusted observation
    turns = 8 if has_cov and not disc else 1
    for _ in range(turns):
        axial = fx * ax + fy * ay + fz * az
        ux, uy, uz = fx - axial * ax, fy - axial * ay, fz - axial * az
        rho = math.sqrt(ux * ux + uy * uy + uz * uz) + 1e-300
        inverse = 1.0 / rho
        ux *= inverse
        uy *= inverse
        uz *= inverse
        if disc:
            nx, ny, nz = ax, ay, az
            f = axial - end
        else:
            nx, ny, nz = (ux + c * ax) * cosine, (uy + c * ay) * cosine, (uz + c * az) * cosine
            f = (rho - r + c * axial) * cosine
        e = f + nx * (x - fx) + ny * (y - fy) + nz * (z - fz)
        if not has_cov:
            fx, fy, fz = x - nx * e, y - ny * e, z - nz * e
            break
        gx = cov[0, 0] * nx + cov[0, 1] * ny + cov[0, 2] * nz
        gy = cov[1, 0] * nx + cov[1, 1] * ny + cov[1, 2] * nz
        gz = cov[2, 0] * nx + cov[2, 1] * ny + cov[2, 2] * nz
        variance = gx * nx + gy * ny + gz * nz + 1e-300
        step = e / variance
        moved = abs(x - gx * step - fx) + abs(y - gy * step - fy) + abs(z - gz * step - fz)
        fx, fy, fz = x - gx * step, y - gy * step, z - gz * step
        if moved < 1e-7 * r:
            break
    axial = fx * ax + fy * ay + fz * az
    bias = 0.0
    if disc:
        inside = r - c * end - math.sqrt(max(fx * fx + fy * fy + fz * fz - axial * axial, 0.0))
    else:
        curvature = cosine / max(r - c * axial, 0.05 * r)
        if has_cov:
            # of the noise only the part that is independent of the residual moves the point along the curved surface
            tx, ty, tz = ay * uz - az * uy, az * ux - ax * uz, ax * uy - ay * ux
            sx = cov[0, 0] * tx + cov[0, 1] * ty + cov[0, 2] * tz
            sy = cov[1, 0] * tx + cov[1, 1] * ty + cov[1, 2] * tz
            sz = cov[2, 0] * tx + cov[2, 1] * ty + cov[2, 2] * tz
            across = sx * nx + sy * ny + sz * nz
            bias = 0.5 * curvature * (sx * tx + sy * ty + sz * tz - across * across / variance)
        else:
            bias = 0.5 * curvature
        inside = 1e300
        for m in range(4):
            if m == leg:
                continue
            qx, qy, qz = creases[leg, m, 0], creases[leg, m, 1], creases[leg, m, 2]
            away = fx * qx + fy * qy + fz * qz
            if away < near:
                # from the distance to the crease's plane to the distance within the surface
                slope = nx * qx + ny * qy + nz * qz
                away /= math.sqrt(max(1.0 - slope * slope, 0.05))
            inside = min(inside, away)
    found[j, 0], found[j, 1], found[j, 2], found[j, 3] = nx, ny, nz, e
    found[j, 4], found[j, 5], found[j, 6], found[j, 7] = math.sqrt(variance), axial, bias, inside
    found[j, 8], found[j, 9], found[j, 10] = fx, fy, fz


@njit(**CONTESTED)
def candidates(place, known, solid, cone, noise, edge, work):  # type: ignore[no-untyped-def]
    """Parts (0..3 lateral, 4..7 end discs) that may own a point into ``work.which``, the logarithm of its density under each into
    ``work.density``.

    ``known`` is the leg where it is given, else -1. Returns how many parts there are and the place of the likeliest among them; of the
    only one in question the density is not computed.
    """
    x, y, z = place
    axes, ends, opened, discs = solid.legs.directions, solid.leg_lengths, solid.opened, solid.discs
    found, lean, which, density = work.found, work.lean, work.which, work.density
    r, c, cosine = cone
    has_cov, scale = noise.has_cov, noise.scale
    for k in range(4):
        lean[k] = x * axes[k, 0] + y * axes[k, 1] + z * axes[k, 2]
    nearest = known
    if known < 0:
        highest = -1e300
        for k in range(4):
            if opened[k] and lean[k] > highest:
                highest = lean[k]
                nearest = k
    # the creases are the planes of equal lean: a leg further off than the noise reaches cannot own the point
    least = lean[nearest] - 8.0 * noise.reach
    # a distance to a crease beyond which neither membership nor the fillet depends on it
    near = min(max(1.25 * edge, 6.0 * noise.reach), 0.5 * r)
    alone = not discs[nearest]
    for k in range(4):
        if known < 0 and k != nearest and opened[k] and lean[k] >= least:
            alone = False
    if alone:
        foot(place, nearest, False, solid, cone, noise, near, found)
        which[0] = nearest
        density[0] = 0.0
        return (0 if known < 0 and found[nearest, 7] < -IMPOSSIBLE * scale * found[nearest, 4] else 1), 0
    square = x * x + y * y + z * z
    best = -1
    count = 0
    # a part this much further off in standard deviations, squared and halved, has no share in the point
    furthest = 1e300
    for turn in range(4):
        # the nearest leg first
        k = (nearest + turn) % 4
        if turn > 0:
            if known >= 0 or not opened[k] or lean[k] < least:
                continue
            if not has_cov and not discs[k]:
                rho = math.sqrt(max(square - lean[k] * lean[k], 0.0))
                u = (rho - r + c * lean[k]) * cosine / scale
                if 0.5 * u * u > furthest:
                    continue
        for disc in range(2):
            if disc == 1 and not discs[k]:
                continue
            j = k + 4 * disc
            foot(place, k, disc == 1, solid, cone, noise, near, found)
            spread = max(scale * found[j, 4], 1e-300)
            share = 1.0
            if disc == 1 or known < 0:
                share = inside_probability(found[j, 7] / spread)
            if disc == 0 and discs[k]:
                share *= inside_probability((ends[k] - found[j, 5]) / spread)
            if share == 0.0:
                continue
            u = found[j, 3] / spread
            which[count] = j
            density[count] = -0.5 * u * u
            if share < 1.0:
                density[count] += math.log(share)
            if has_cov:
                # equal noise divides all densities by the same
                density[count] -= math.log(spread)
            if best < 0 or density[count] > density[best]:
                best = count
                furthest = 8.0 - density[count]
            count += 1
    return count, best


@njit(**CONTESTED)
def _gate(task, k, known):  # type: ignore[no-untyped-def]
    """How far a part may be used where a point's foot lies: edges are judged at the foot, which says nothing about the residual."""
    found, discs, edge, leg = task.work.found, task.solid.discs, task.weighting.edge, k % 4
    gate = 1.0
    if edge > 0.0 and (k >= 4 or known < 0):
        gate = ramp(found[k, 7] / edge)
    if k < 4:
        if discs[leg] and edge > 0.0:
            gate *= ramp((task.solid.leg_lengths[leg] - found[k, 5]) / edge)
        elif not discs[leg]:
            gate *= min(max(0.5 + (task.weighting.tip - found[k, 5]) / task.weighting.fade, 0.0), 1.0)
    return gate


@njit(**CONTESTED)
def _derivatives(place, k, found, cosine, per_noise, row):  # type: ignore[no-untyped-def]
    """Row of the standardised condition of a point on one part."""
    x, y, z = place
    nx, ny, nz = found[k, 0] * per_noise, found[k, 1] * per_noise, found[k, 2] * per_noise
    row[0], row[1], row[2] = -nx, -ny, -nz
    row[3], row[4], row[5] = ny * z - nz * y, nz * x - nx * z, nx * y - ny * x
    row[6] = -cosine * per_noise if k < 4 else 0.0
    row[7] = found[k, 5] * cosine * per_noise if k < 4 else 0.0
    if k >= 4:
        row[k + 4] = -per_noise


@njit(**CONTESTED)
def contested_point(task, place, noise, j, known, columns):  # type: ignore[no-untyped-def]
    """Linearise one point that several parts may own, each with its share, into columns of the block; returns the next free column."""
    solid, weighting, states, work = task.solid, task.weighting, task.states, task.work
    found, which, density, final = work.found, work.which, work.density, weighting.final
    count, likeliest = candidates(place, known, solid, task.cone, noise, weighting.edge, work)
    if count == 0:
        return columns
    best = which[likeliest]
    states.legs[j] = best % 4
    states.parts[j] = best // 4
    states.residuals[j] = found[best, 3]
    states.sds[j] = found[best, 4]
    states.biases[j] = found[best, 6] * task.variance
    if best < 4 and not solid.discs[best] and found[best, 5] > weighting.tip:
        beyond = NO_WEIGHT * weighting.scale * found[best, 4]
        states.at_tip[j] = work.lean[best] < solid.leg_lengths[best] + beyond and found[best, 3] < beyond
    total = 1.0
    for m in range(count):
        if m != likeliest and density[m] > density[likeliest] - 30.0:
            total += math.exp(density[m] - density[likeliest])
    alone = total < 1.001
    if final:
        states.feet[j, 0], states.feet[j, 1], states.feet[j, 2] = found[best, 8], found[best, 9], found[best, 10]
        work.mean_score[:] = 0.0
    for candidate in range(count):
        if density[candidate] < density[likeliest] - 7.0:
            continue
        k = which[candidate]
        share = 1.0 / total if k == best else math.exp(density[candidate] - density[likeliest]) / total
        gate = _gate(task, k, known)
        if gate == 0.0:
            continue
        share *= gate
        per_noise = 1.0 / (weighting.scale * found[k, 4])
        u = (found[k, 3] - found[k, 6] * task.variance) * per_noise
        robust = 1.0
        slope = 1.0
        narrow = 1.0
        if weighting.redescend:
            robust, slope = robust_weight(u)
            if robust == 0.0:
                continue
            narrow = robust_weight(u / SCALE_NARROWING)[0]
        w = share * robust
        _derivatives(place, k, found, task.cone.cosine, per_noise, work.row)
        if k >= 4:
            task.equations.rhs[k + 4] += w * u * per_noise
            add_disc(task.equations.normal, work.row, w, k)
        if k == best:
            states.weights[j] = w
            if final:
                for m in range(8):
                    states.rows[j, m] = work.row[m]
                if k >= 4:
                    states.rows[j, k + 4] = work.row[k + 4]
        work.sums[SQUARES] += share * narrow * u * u
        work.sums[WEIGHTS] += share * narrow
        if gate < 1.0:
            alone = False
        for m in range(8):
            work.block[m, columns] = work.row[m]
        work.block[WEIGHT, columns] = w
        work.block[SCORE, columns] = w * u
        work.block[SINGLE, columns] = 1.0 if alone else 0.0
        columns += 1
        if final:
            _add_scores(task.equations, work, k, alone, (u, w, share, robust, slope))
    if final and not alone:
        add_products_of_scores(task.equations, work.mean_score)
    return columns


@njit(**CONTESTED)
def _add_scores(equations, work, k, alone, weighted):  # type: ignore[no-untyped-def]
    """Add what the covariance needs of one part's share in a point."""
    u, w, share, robust, slope = weighted
    if alone:
        work.sums[SINGLES] += 1.0
        work.sums[PSI_SQUARES] += robust * robust * u * u
        work.sums[SLOPES] += slope
        add_disc(equations.plain, work.row, 1.0, k)
        return
    for a in range(8):
        work.mean_score[a] += w * u * work.row[a]
    if k >= 4:
        work.mean_score[k + 4] += w * u * work.row[k + 4]
    add_outer(equations.shared, work.row, share * slope - w * robust * u * u, k)
