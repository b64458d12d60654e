// The unrolled film as the page carries it: fields at some crank angles, strips and nodes, and the axes they
// lie on.
import { kMissing, unpacked } from '../plot/packed.js';
import { converted, crankTicks, display, inDegrees, ticks, wrapped } from '../units.js';

/** Less liquid than this is a cavity: a full gap may miss 1 by what the numbers were rounded to. */
const kFull = 0.9995;

/** So many face widths of the ring on each side of its gap are enlarged. */
const kEndWidths = 3;

/** One crank angle alone is drawn this wide [degree]. */
const kLoneAngle = 5;

/**
 * A strip differs from the one opposite the gap where a pressure in it does by this share of the highest
 * there.
 */
const kFelt = 0.01;

/** Bounds of what belongs to each node: halfway to its neighbours, the outer ones at `from` and `to`. */
export function cellEdges(nodes, from, to) {
  return [from, ...nodes.slice(1).map((v, k) => (v + nodes[k]) / 2), to];
}

/** Which cell holds v; -1 outside. */
export function cellAt(edges, v) {
  if (!(v >= edges[0] && v <= edges[edges.length - 1])) return -1;
  let [low, high] = [0, edges.length - 1];
  while (high - low > 1) {
    const middle = (low + high) >> 1;
    if (edges[middle] <= v) low = middle;
    else high = middle;
  }
  return low;
}

/** The values of one field in display units; null where there is none. */
function decoded(packed, quantity) {
  const words = unpacked(packed.data);
  const { unit, convert } = display(quantity);
  const value = (at) =>
    words[at] === kMissing || words[at] === undefined
      ? null
      : convert(packed.low + ((packed.high - packed.low) * words[at]) / (kMissing - 1));
  return { unit, longName: quantity.long_name, value, range: [convert(packed.low), convert(packed.high)] };
}

function decodedAll(fields, quantities) {
  const known = new Map(quantities.map((q) => [q.name, q]));
  return Object.fromEntries(
    Object.entries(fields)
      .filter(([name]) => known.has(name))
      .map(([name, packed]) => [name, decoded(packed, known.get(name))]),
  );
}

/** Lengths in mm, fields in their display units. */
export class Unrolled {
  /** @param payload what the page carries of one case; @param quantities those of fields and of strips */
  constructor(payload, { fields, strips }) {
    this.stored = payload.stored;
    this.gap = converted(payload.end_gap, 'mm');
    this.closed = payload.end_gap === 0;
    this.circumference = converted(payload.circumference, 'mm');
    this.gapPosition = inDegrees(payload.gap_position);
    this.x = converted(payload.x, 'mm');
    this.angles = payload.crank_angle;
    this.fields = decodedAll(payload.fields, fields);
    this.stripAngles = payload.strips.crank_angle;
    this.strips = decodedAll(payload.strips.fields, strips);
    this.hasFields = this.angles.length > 0 && Boolean(this.fields.film_pressure);
    this.y = converted(this.hasFields ? payload.y : payload.strips.y, 'mm');
    this.length = this.closed ? this.circumference : this.y[this.y.length - 1];
    this.face = this.x.length ? this.x[this.x.length - 1] : 0;
    const inMm = ({ x, y, value }) => ({ x: converted(x, 'mm'), y: converted(y, 'mm'), value });
    this.highestPressure = payload.highest_pressure.map((p) => ({
      ...inMm(p),
      value: this.fields.film_pressure ? converted(p.value, 'bar') : null,
    }));
    this.lowestFilmContent = payload.lowest_film_content.map(inMm);
    // Reynolds' exit has no film content: what is stored of it is 1 everywhere, and cavities are where the
    // pressure is theirs.
    const pressure = payload.fields.film_pressure;
    const isStated = payload.rupture_pressure !== undefined && payload.rupture_pressure !== null;
    this.hasNoFilmContent = isStated;
    // Half a step of what was rounded.
    this.ruptureBelow =
      isStated && pressure
        ? converted(
            payload.rupture_pressure + ((0.5 + 1e-6) * (pressure.high - pressure.low)) / (kMissing - 1),
            'bar',
          )
        : null;
    if (isStated) delete this.fields.film_content;
    // A closed ring: what is nearer to the joint than to the last strip belongs to the first again.
    this.yEdges = cellEdges(this.closed ? [...this.y, this.circumference] : this.y, 0, this.length);
    this.xEdges = cellEdges(this.x, 0, this.face);
  }

  /** Value of a field at an angle, strip and node by their numbers; null where there is none. */
  value(name, k, j, i) {
    return this.fields[name]?.value((k * this.y.length + j) * this.x.length + i) ?? null;
  }

  stripValue(name, k, j) {
    return this.strips[name]?.value(k * this.y.length + j) ?? null;
  }

  isCavity(k, j, i) {
    if (this.hasNoFilmContent) {
      const pressure = this.value('film_pressure', k, j, i);
      // At the edges of the face the film is full, whatever its pressure.
      return i > 0 && i + 1 < this.x.length && pressure !== null && pressure <= this.ruptureBelow;
    }
    const fill = this.value('film_content', k, j, i);
    return fill !== null && fill < kFull;
  }

  hasCavity(k) {
    if (this.hasNoFilmContent) return this.y.some((_, j) => this.x.some((__, i) => this.isCavity(k, j, i)));
    return this.lowestFilmContent[k]?.value < kFull;
  }

  /** Place around the bore [degree] of a place along the ring. */
  around(y) {
    const turn = this.gapPosition + (360 * (this.gap / 2 + y)) / this.circumference;
    return ((turn % 360) + 360) % 360;
  }

  /** Lowest and highest value of one angle. */
  rangeAt(name, k) {
    let [low, high] = [Infinity, -Infinity];
    for (let j = 0; j < this.y.length; j++) {
      for (let i = 0; i < this.x.length; i++) {
        const v = this.value(name, k, j, i);
        if (v === null) continue;
        low = Math.min(low, v);
        high = Math.max(high, v);
      }
    }
    return [low, high];
  }

  /**
   * How far from the gap it is felt in the pressure anywhere across the face [mm]; null for a closed ring.
   */
  endReach(k) {
    if (this.closed || !this.hasFields) return null;
    const strip = (j) => this.x.map((_, i) => this.value('film_pressure', k, j, i) ?? 0);
    const opposite = strip(cellAt(this.yEdges, this.length / 2));
    const least = kFelt * Math.max(...opposite);
    let reach = 0;
    this.y.forEach((y, j) => {
      if (strip(j).some((p, i) => Math.abs(p - opposite[i]) > least))
        reach = Math.max(reach, Math.min(y, this.length - y));
    });
    return reach;
  }

  /** Length of ring on each side of the gap that the enlarged view shows [mm]. */
  endLength(face) {
    return Math.min(kEndWidths * face, this.length / 2);
  }
}

/**
 * An axis of a map. Its numbers are those drawn: `from`, `to`, `pieces` with something between them;
 * `index(v)` is the number of the node there, -1 where there is none.
 */
export function faceAxis(data) {
  return {
    label: 'x',
    unit: 'mm',
    from: 0,
    to: data.face,
    pieces: [[0, data.face]],
    index: (v) => cellAt(data.xEdges, v),
    ticks: (count) => ticks(0, data.face, count),
  };
}

export function ringAxis(data, { ends, face }) {
  const index = (y) => {
    const j = cellAt(data.yEdges, y);
    return j < 0 ? -1 : j % data.y.length;
  };
  if (!ends) {
    return {
      label: 'y, along the ring',
      unit: 'mm',
      from: 0,
      to: data.length,
      pieces: [[0, data.length]],
      index,
      y: (v) => v,
      ticks: (count) => ticks(0, data.length, count),
    };
  }
  const half = data.gap / 2;
  const reach = half + data.endLength(face);
  const y = (v) => (v < 0 ? data.length + half + v : v - half);
  return {
    label: 'along the ring, from the middle of the gap',
    unit: 'mm',
    from: -reach,
    to: reach,
    pieces: [
      [-reach, -half],
      [half, reach],
    ],
    index: (v) => (Math.abs(v) < half ? -1 : index(y(v))),
    y: (v) => (Math.abs(v) < half ? null : y(v)),
    ticks: (count) => ticks(-reach, reach, count),
    gap: data.gap,
  };
}

/** Crank angles as on every chart of the cycle, whatever their order in the file. */
export function crankAxis(angles) {
  const sorted = angles.map((angle, k) => ({ at: wrapped(angle), k })).sort((a, b) => a.at - b.at);
  const widest =
    sorted.length === 1 ? kLoneAngle : Math.max(...sorted.slice(1).map(({ at }, n) => at - sorted[n].at));
  // Angles all around the cycle: the first follows the last.
  const around = sorted[0].at + 720 - sorted[sorted.length - 1].at <= 1.5 * widest;
  const shown = around
    ? [
        { ...sorted[sorted.length - 1], at: sorted[sorted.length - 1].at - 720 },
        ...sorted,
        { ...sorted[0], at: sorted[0].at + 720 },
      ]
    : sorted;
  const edges = cellEdges(
    shown.map(({ at }) => at),
    shown[0].at - widest / 2,
    shown[shown.length - 1].at + widest / 2,
  );
  return {
    label: 'crank angle, firing TDC = 0',
    unit: '°',
    from: -360,
    to: 360,
    pieces: [[-360, 360]],
    crank: true,
    index: (v) => {
      const n = cellAt(edges, v);
      return n < 0 ? -1 : shown[n].k;
    },
    ticks: (count) => crankTicks(-360, 360, count),
  };
}
