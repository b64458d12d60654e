// Contours of values on a rectangular grid: bands to fill and lines to draw, straight within triangles.

/** The four triangles of a cell about its middle; corners { x, y, v }. */
function triangles(corners) {
  const middle = { x: 0, y: 0, v: 0 };
  for (const c of corners) for (const key of ['x', 'y', 'v']) middle[key] += c[key] / 4;
  return corners.map((c, i) => [c, corners[(i + 1) % 4], middle]);
}

const between = (a, b, level) => {
  const t = (level - a.v) / (b.v - a.v);
  return { x: a.x + t * (b.x - a.x), y: a.y + t * (b.y - a.y), v: level };
};

/** The part of a polygon at which v is not below (or not above) a level. */
function cut(polygon, level, keepAbove) {
  const inside = (p) => (keepAbove ? p.v >= level : p.v <= level);
  const out = [];
  polygon.forEach((p, i) => {
    const next = polygon[(i + 1) % polygon.length];
    if (inside(p)) out.push(p);
    if (inside(p) !== inside(next)) out.push(between(p, next, level));
  });
  return out;
}

const bandOf = (v, levels) => levels.filter((level) => v >= level).length;

/** Cells whose four corners have values: { corners, column, row }. @param value (i, j) */
function cells(xs, ys, value) {
  const found = [];
  for (let j = 0; j + 1 < ys.length; j++) {
    for (let i = 0; i + 1 < xs.length; i++) {
      const corners = [
        [i, j],
        [i + 1, j],
        [i + 1, j + 1],
        [i, j + 1],
      ].map(([a, b]) => ({ x: xs[a], y: ys[b], v: value(a, b) }));
      if (corners.every((c) => c.v !== null)) found.push({ corners, i, j });
    }
  }
  return found;
}

/**
 * Polygons of each band, from below the lowest level to above the highest: bands[k] is a list of polygons of
 * { x, y }.
 * @param xs, ys pixels of the grid lines; @param value (i, j) to a number, null where there is none
 */
export function filledBands(xs, ys, value, levels) {
  const bands = Array.from({ length: levels.length + 1 }, () => []);
  for (const { corners } of cells(xs, ys, value)) {
    const [low, high] = [Math.min(...corners.map((c) => c.v)), Math.max(...corners.map((c) => c.v))];
    const [first, last] = [bandOf(low, levels), bandOf(high, levels)];
    if (first === last) {
      bands[first].push(corners);
      continue;
    }
    for (const triangle of triangles(corners)) {
      for (let k = first; k <= last; k++) {
        let part = triangle;
        if (k > 0) part = cut(part, levels[k - 1], true);
        if (k < levels.length && part.length) part = cut(part, levels[k], false);
        if (part.length > 2) bands[k].push(part);
      }
    }
  }
  return bands;
}

/** Lines at a level, each a list of [x, y], pieces joined end to end. */
export function contourLines(xs, ys, value, level) {
  const pieces = [];
  for (const { corners } of cells(xs, ys, value)) {
    if (Math.min(...corners.map((c) => c.v)) > level || Math.max(...corners.map((c) => c.v)) < level)
      continue;
    for (const triangle of triangles(corners)) {
      const ends = [];
      triangle.forEach((a, i) => {
        const b = triangle[(i + 1) % 3];
        if (a.v < level !== b.v < level) ends.push(between(a, b, level));
      });
      // Through a corner that has just this value the piece has no length.
      if (ends.length === 2 && Math.hypot(ends[0].x - ends[1].x, ends[0].y - ends[1].y) > 1e-3)
        pieces.push(ends.map((p) => [p.x, p.y]));
    }
  }
  return joined(pieces);
}

/** The part of a polygon of { x, y, values } in which a linear excess is not below zero. */
function keptWhere(polygon, excess) {
  const out = [];
  polygon.forEach((a, i) => {
    const b = polygon[(i + 1) % polygon.length];
    const [from, to] = [excess(a), excess(b)];
    if (from >= 0) out.push(a);
    if (from >= 0 === to >= 0) return;
    const t = from / (from - to);
    const mixed = (u, v) => u + t * (v - u);
    out.push({
      x: mixed(a.x, b.x),
      y: mixed(a.y, b.y),
      values: a.values.map((v, n) => mixed(v, b.values[n])),
    });
  });
  return out;
}

/** Two values are equal on a border but for rounding. */
const kRounding = 1e-9;

/**
 * Where each of several values is the lowest: { regions, borders }; regions[k] is a list of polygons of { x, y },
 * borders are pieces [a, b] of the lines at which the lowest changes.
 * @param values a list of (i, j) to a number, null where there is none: no cell next to it has a region
 */
export function lowestRegions(xs, ys, values) {
  const regions = values.map(() => []);
  const borders = [];
  const all = (i, j) => values.map((value) => value(i, j));
  for (const { corners, i, j } of cells(xs, ys, (a, b) => (all(a, b).includes(null) ? null : 0))) {
    const valued = [all(i, j), all(i + 1, j), all(i + 1, j + 1), all(i, j + 1)];
    const points = corners.map(({ x, y }, n) => ({ x, y, values: valued[n] }));
    const mean = (of) => points.reduce((sum, p) => sum + of(p), 0) / points.length;
    const middle = {
      x: mean((p) => p.x),
      y: mean((p) => p.y),
      values: values.map((_, n) => mean((p) => p.values[n])),
    };
    points.forEach((point, n) => {
      for (let k = 0; k < values.length; k++) {
        let part = [point, points[(n + 1) % points.length], middle];
        for (let other = 0; other < values.length && part.length; other++)
          if (other !== k) part = keptWhere(part, (p) => p.values[other] - p.values[k]);
        if (part.length < 3) continue;
        regions[k].push(part);
        const isEqual = (p, other) => Math.abs(p.values[other] / p.values[k] - 1) < kRounding;
        part.forEach((a, m) => {
          const b = part[(m + 1) % part.length];
          const isBorder = values.some((_, other) => other > k && isEqual(a, other) && isEqual(b, other));
          if (isBorder) borders.push([a, b]);
        });
      }
    });
  }
  return { regions, borders };
}

function joined(pieces) {
  const key = ([x, y]) => `${x.toFixed(3)} ${y.toFixed(3)}`;
  const at = new Map();
  pieces.forEach((piece, k) => piece.forEach((end) => at.set(key(end), [...(at.get(key(end)) ?? []), k])));
  const used = new Set();
  const grown = (points) => {
    for (;;) {
      const end = points[points.length - 1];
      const next = (at.get(key(end)) ?? []).find((k) => !used.has(k));
      if (next === undefined) return points;
      used.add(next);
      const [a, b] = pieces[next];
      points.push(key(a) === key(end) ? b : a);
    }
  };
  const lines = [];
  pieces.forEach((piece, k) => {
    if (used.has(k)) return;
    used.add(k);
    const forward = grown([...piece]);
    lines.push(grown(forward.reverse()));
  });
  return lines;
}

/**
 * The best place of a label: the middle of the longest straight-ish stretch: { x, y, angle } in degrees, null
 * on short lines.
 */
export function labelPlace(points, room) {
  const lengths = [0];
  for (let k = 1; k < points.length; k++)
    lengths.push(
      lengths[k - 1] + Math.hypot(points[k][0] - points[k - 1][0], points[k][1] - points[k - 1][1]),
    );
  const total = lengths[lengths.length - 1];
  if (total < 1.6 * room) return null;
  let best = null;
  for (let share = 0.2; share <= 0.8; share += 0.1) {
    const [from, to] = [share * total - room / 2, share * total + room / 2];
    const a = points[lengths.findIndex((l) => l >= Math.max(0, from))];
    const k = lengths.findIndex((l) => l >= Math.min(total, to));
    const b = points[k < 0 ? points.length - 1 : k];
    const straight = Math.hypot(b[0] - a[0], b[1] - a[1]);
    if (!best || straight > best.straight)
      best = {
        straight,
        x: (a[0] + b[0]) / 2,
        y: (a[1] + b[1]) / 2,
        angle: (Math.atan2(b[1] - a[1], b[0] - a[0]) * 180) / Math.PI,
      };
  }
  if (best.angle > 90) best.angle -= 180;
  if (best.angle < -90) best.angle += 180;
  return best;
}
