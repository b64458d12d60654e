"""A film between a fixed pad and a flat surface in two dimensions, solved another way than the program does: the oracle
of those verifications of pads with a width that no closed form answers. Needs numpy and scipy.

Finite volumes with the unknowns in the middle of the cells (the program has them at nodes), jumps of the gap on faces,
where pressure and flux are continuous between the two half cells; cavitation with mass conserved by active sets on
pressure and missing fill, each step solved directly; properties of the oil by repeated substitution.
SI; pressures count from that of cavitation."""

import numpy as np
from scipy.sparse import csr_matrix
from scipy.sparse.linalg import splu


class Film:
    """x, y: edges of the cells. gap(x, y): thickness, called inside cells only, with arrays, so that jumps on edges
    need no care. Sides: pressure, or None where nothing flows through."""

    def __init__(
        self,
        x,
        y,
        gap,
        eta,
        U=0.0,
        left=None,
        right=None,
        front=None,
        back=None,
        viscosity=lambda p: 1.0,
        density=lambda p: 1.0,
    ):
        self.x, self.y, self.gap, self.eta, self.U = np.asarray(x), np.asarray(y), gap, eta, U
        self.sides = left, right, front, back
        self.viscosity, self.density = viscosity, density
        self.dx, self.dy = np.diff(self.x), np.diff(self.y)
        self.shape = len(self.dx), len(self.dy)
        self.area = np.outer(self.dx, self.dy)
        self.p = np.zeros(self.shape)
        self.missing = np.zeros(self.shape)  # 1 - theta
        self.set_separation(0.0)

    def set_separation(self, s):
        xc, yc = 0.5 * (self.x[1:] + self.x[:-1]), 0.5 * (self.y[1:] + self.y[:-1])
        dx, dy = self.dx, self.dy
        at = lambda xs, ys: self.gap(*np.meshgrid(xs, ys, indexing="ij")) + s
        quarter = 0.25
        self.h_west, self.h_east = at(xc - quarter * dx, yc), at(xc + quarter * dx, yc)
        self.h_south, self.h_north = at(xc, yc - quarter * dy), at(xc, yc + quarter * dy)
        self.h = 0.25 * (self.h_west + self.h_east + self.h_south + self.h_north)

    def _balance(self, dt, content_before):
        """Matrices A, B and b of A p + B missing = b, the balance of every cell at the oil of the present pressures."""
        nx, ny = self.shape
        index = np.arange(nx * ny).reshape(nx, ny)
        rho = self.density(self.p) * np.ones(self.shape)
        fluidity = rho / (12 * self.eta * self.viscosity(self.p))
        rows_p, cols_p, vals_p, rows_c, cols_c, vals_c = [], [], [], [], [], []
        b = np.zeros(nx * ny)

        def leaves(out_of, into, unknown, value, kind):
            """value * unknown flows out of one cell into the other."""
            rows, cols, vals = (rows_p, cols_p, vals_p) if kind == "p" else (rows_c, cols_c, vals_c)
            for cells, sign in ((out_of, 1), (into, -1)):
                if cells is not None:
                    rows.append(cells.ravel()), cols.append(unknown.ravel()), vals.append((sign * value).ravel())

        def constant(out_of, into, value):
            if out_of is not None:
                np.subtract.at(b, out_of.ravel(), value.ravel())
            if into is not None:
                np.add.at(b, into.ravel(), value.ravel())

        # faces in x between cells
        L, R = index[:-1], index[1:]
        width = self.dy[None, :]
        rho_face = 0.5 * (rho[:-1] + rho[1:])
        f = 0.5 * (fluidity[:-1] + fluidity[1:])
        kl = f * self.h_east[:-1] ** 3 / (0.5 * self.dx[:-1, None])
        kr = f * self.h_west[1:] ** 3 / (0.5 * self.dx[1:, None])
        hl, hr = self.h_east[:-1], self.h_west[1:]
        up_cell, up_missing = (L, self.missing[:-1]) if self.U >= 0 else (R, self.missing[1:])
        drag = 0.5 * self.U * rho_face
        p_face = self.p_face = (drag * (1 - up_missing) * (hl - hr) + kl * self.p[:-1] + kr * self.p[1:]) / (kl + kr)
        # Where the gap opens along the motion the pressure at the face would fall below that of cavitation: it is that.
        torn = (p_face < 0) & ((hr > hl) if self.U >= 0 else (hl > hr))
        k_series, h_mixed = kl * kr / (kl + kr), (kr * hl + kl * hr) / (kl + kr)
        h_drag = np.where(torn, hl if self.U >= 0 else hr, h_mixed)
        k_left = np.where(torn, kl if self.U >= 0 else 0 * kl, k_series)
        k_right = np.where(torn, 0 * kr if self.U >= 0 else kr, k_series)
        leaves(L, R, L, k_left * width, "p")
        leaves(L, R, R, -k_right * width, "p")
        constant(L, R, drag * h_drag * width)
        leaves(L, R, up_cell, -drag * h_drag * width, "c")

        # faces in y
        S, N = index[:, :-1], index[:, 1:]
        f = 0.5 * (fluidity[:, :-1] + fluidity[:, 1:])
        ks = f * self.h_north[:, :-1] ** 3 / (0.5 * self.dy[None, :-1])
        kn = f * self.h_south[:, 1:] ** 3 / (0.5 * self.dy[None, 1:])
        k = ks * kn / (ks + kn) * self.dx[:, None]
        leaves(S, N, S, k, "p")
        leaves(S, N, N, -k, "p")

        # edges
        left, right, front, back = self.sides
        self.edge = {}
        for name, side, cell, h, half, length, outward in (
            ("left", left, np.s_[0, :], self.h_west, 0.5 * self.dx[0], self.dy, -1),
            ("right", right, np.s_[-1, :], self.h_east, 0.5 * self.dx[-1], self.dy, 1),
            ("front", front, np.s_[:, 0], self.h_south, 0.5 * self.dy[0], self.dx, 0),
            ("back", back, np.s_[:, -1], self.h_north, 0.5 * self.dy[-1], self.dx, 0),
        ):
            if side is None:
                continue
            cells, hs = index[cell], h[cell]
            k = fluidity[cell] * hs**3 / half * length
            drag = outward * 0.5 * self.U * self.density(side) * hs * length
            leaves(cells, None, cells, k, "p")
            constant(cells, None, drag - k * side)
            if np.all(drag >= 0) and outward * self.U > 0:
                leaves(cells, None, cells, -drag, "c")
            self.edge[name] = (cells, k, drag, side, outward * self.U > 0)

        if dt is not None:
            held = rho * self.h * self.area / dt
            leaves(index, None, index, -held, "c")
            b += (content_before * self.area / dt - held).ravel()
        n = nx * ny
        sparse = (
            lambda rows, cols, vals: csr_matrix(
                (np.concatenate(vals), (np.concatenate(rows), np.concatenate(cols))), shape=(n, n)
            )
            if vals
            else csr_matrix((n, n))
        )
        return sparse(rows_p, cols_p, vals_p), sparse(rows_c, cols_c, vals_c), b

    def content(self):
        return self.density(self.p) * (1 - self.missing) * self.h

    def solve(self, dt=None, content_before=None, scale=1e5, tolerance=1e-9, most=400):
        """Steady, or one step of backward Euler. Returns the number of linear systems."""
        for k in range(1, most + 1):
            A, B, b = self._balance(dt, content_before)
            cavity = (self.p / scale - self.missing < 0).ravel()
            keep = csr_matrix((np.ones(cavity.size) * ~cavity, (range(cavity.size), range(cavity.size))))
            drop = csr_matrix((np.ones(cavity.size) * cavity, (range(cavity.size), range(cavity.size))))
            z = splu((A @ keep + B @ drop).tocsc()).solve(b)
            p = np.where(cavity, 0, z).reshape(self.shape)
            missing = np.where(cavity, z, 0).reshape(self.shape)
            change = max(np.abs(p - self.p).max() / max(np.abs(p).max(), 1e-300), np.abs(missing - self.missing).max())
            self.p, self.missing = p, missing
            settled = not np.any((p / scale - missing < 0).ravel() != cavity)
            if settled and change < tolerance:
                return k
        raise RuntimeError(f"not settled: {change}")

    def load(self):
        return float((self.p * self.area).sum())

    def peak(self):
        """Where the gap jumps pressure has its edge on a face."""
        return float(max(self.p.max(), self.p_face.max()))

    def cavitated(self):
        return float((self.area * (self.missing > 0)).sum() / self.area.sum())

    def flows(self):
        """Mass flow out through each side [kg/s]."""
        out = {}
        for name, (cells, k, drag, side, leaves) in self.edge.items():
            p, missing = self.p.ravel()[cells], self.missing.ravel()[cells]
            out[name] = float((k * (p - side) + drag * (1 - missing * leaves)).sum())
        return out


def limit(values, ratio=2.0, order=None):
    """Of three values on grids refined by `ratio` each time: what they run to, and with which order."""
    import math

    a, b, c = values[-3:]
    seen = math.log(abs((b - a) / (c - b))) / math.log(ratio) if (b - a) * (c - b) > 0 else float("nan")
    use = order or seen
    return c + (c - b) / (ratio**use - 1), seen
