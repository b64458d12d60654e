// Ranges and ticks, the same on the screen and in the SVG.
import { isOneOfSeveral } from './palette.js';
import { crankTicks, logTicks, ticks } from '../units.js';

export const kStrokeBands = [
  { from: -360, to: -180, name: 'intake' },
  { from: -180, to: 0, name: 'compression' },
  { from: 0, to: 180, name: 'power' },
  { from: 180, to: 360, name: 'exhaust' },
];

export const kPeakLabel = 'peak';
/** From the line of the peak to the middle of "power" both labels need so much [pixel]. */
export const kRoomForPeak = 70;

export const kDeadCentres = [
  { at: -360, name: 'TDC' },
  { at: -180, name: 'BDC' },
  { at: 0, name: 'firing TDC' },
  { at: 180, name: 'BDC' },
  { at: 360, name: 'TDC' },
];

/** The name of the dead centre at an angle, '' elsewhere. */
export function deadCentre(panel, at) {
  return (panel.crank && kDeadCentres.find((centre) => centre.at === at)?.name) || '';
}

/** Lowest and highest of the numbers among `values`; null without one. */
export function extent(values) {
  let [low, high] = [Infinity, -Infinity];
  for (const v of values) {
    if (v === null || v === undefined || !Number.isFinite(v)) continue;
    if (v < low) low = v;
    if (v > high) high = v;
  }
  return low <= high ? [low, high] : null;
}

export function xRange(panel) {
  if (panel.xRange) return panel.xRange;
  const found = extent(panel.series.flatMap((s) => s.x)) ?? [0, 1];
  return panel.xScale === 'log' ? [found[0] / 1.15, found[1] * 1.15] : found;
}

/** A logarithmic axis reaches down to this part of the largest value at most. */
const kWidestRatio = 1e5;

/** The figure with logarithmic y axes: values that are not positive have no place there. */
export function logarithmic(figure) {
  const positive = (list) => list.map((v) => (v > 0 ? v : null));
  const panels = figure.panels.map((panel) => ({
    ...panel,
    yScale: 'log',
    series: panel.series.map((s) => ({
      ...s,
      y: positive(s.y),
      error: s.error?.map((e, k) => (s.y[k] > e ? e : null)),
    })),
  }));
  return { ...figure, panels };
}

/** Range of y over the visible series within the x window, with some air. */
export function yRange(panel, visible, [low, high]) {
  if (panel.yRange) return panel.yRange;
  const found = extent(
    panel.series.filter(visible).flatMap((s) => {
      const isInside = (_, k) => s.x[k] === null || (s.x[k] >= low && s.x[k] <= high);
      const edges = (s.bands ?? []).flatMap(({ low: under, high: over }) => [under, over]);
      return [s.y, ...edges].flatMap((list) => list.filter(isInside));
    }),
  );
  if (!found) return panel.yScale === 'log' ? [0.1, 10] : [0, 1];
  let [bottom, top] = found;
  if (panel.yScale === 'log') return [Math.max(bottom, top / kWidestRatio) / 1.3, top * 1.3];
  if (panel.fromZero && bottom >= 0) bottom = 0;
  if (panel.zeroLine) {
    bottom = Math.min(bottom, 0);
    top = Math.max(top, 0);
  }
  const span = top - bottom || Math.abs(top) || 1;
  return [
    bottom === 0 && (panel.fromZero || panel.zeroLine) && found[0] >= 0 ? 0 : bottom - 0.06 * span,
    top === 0 ? 0 : top + 0.08 * span,
  ];
}

/** Ticks of an axis { low, high, log, crank }, about `count` of them. */
export function axisTicks({ low, high, log, crank }, count) {
  if (crank) return crankTicks(low, high, count);
  return log ? logTicks(low, high) : ticks(low, high, count);
}

/**
 * Where the marks of a case are on its line: a few, at places of its own so that they do not hide each other; at all
 * points of a series of single values.
 */
export function markIndices(series, low, high, nSeries, xScale = 'linear') {
  if (series.part === 'points' || series.isSampled)
    return [...series.x.keys()].filter((k) => series.x[k] !== null && series.y[k] !== null);
  if (!isOneOfSeveral(series.caseIndex) || nSeries < 2) return [];
  const kMarks = 7;
  const found = [];
  if (series.angle) {
    const step = Math.max(1, Math.floor(series.x.length / kMarks));
    for (let k = Math.floor((step * (series.caseIndex + 0.5)) / nSeries); k < series.x.length; k += step)
      if (series.x[k] !== null) found.push(k);
    return found;
  }
  let k = 0;
  for (let m = 0; m < kMarks; m++) {
    const share = (m + (series.caseIndex + 0.5) / nSeries) / kMarks;
    const target = xScale === 'log' ? low * (high / low) ** share : low + (high - low) * share;
    while (k < series.x.length && series.x[k] < target) k++;
    if (k < series.x.length && series.y[k] !== null) found.push(k);
  }
  return found;
}

/** Room that a label keeps from curves, more is no better [pixel]. */
const kRoomAround = 30;

/**
 * An upright line behind a label is as bad as so much less room [pixel]: better than a curve, worse than
 * nothing.
 */
const kCrossing = 4;

/**
 * Where a label of `width` pixels, set close above or below the level `at`, is most free of curves and
 * upright lines.
 * @param box the plot in pixels, with its scales x and y; @returns left end and base line of the label
 */
export function freePlace(panel, visible, at, width, box) {
  const kHeight = 11;
  const points = panel.series
    .filter(visible)
    .flatMap((s) =>
      s.x.map((v, k) => (v === null || s.y[k] === null ? null : [box.x(v), box.y(s.y[k])])).filter(Boolean),
    );
  const upright = panel.crank ? [...kDeadCentres, ...(panel.peaks ?? [])].map((line) => box.x(line.at)) : [];
  const level = box.y(at);
  let best = { x: box.left + box.width - width - 4, y: level - 5, room: -Infinity };
  for (const y of [level - 5, level + 14]) {
    if (y - kHeight < box.top || y > box.top + box.height) continue;
    for (let x = box.left + box.width - width - 4; x >= box.left + 4; x -= 4) {
      const beside = points.filter(([px]) => px > x - 4 && px < x + width + 4);
      const crossed = upright.filter((u) => u > x - 3 && u < x + width + 3).length;
      const clear = Math.min(kRoomAround, ...beside.map(([, py]) => Math.max(y - kHeight - py, py - y)));
      const room = (clear > 0 ? clear : -kRoomAround) - kCrossing * crossed;
      if (room > best.room) best = { x, y, room };
    }
  }
  return best;
}

/**
 * The labels of upright lines: beside their line, in rows so that none covers another.
 * @param marks { at, label }; @param x scale to pixels; @param widthOf width of a label; @returns { at,
 * label, line, left, row }, pixels
 */
export function markPlaces(marks, x, widthOf, left, right) {
  const kGap = 4;
  const rows = [];
  return marks
    .map((mark) => ({ ...mark, line: x(mark.at), width: widthOf(mark.label) }))
    .filter(({ line }) => line >= left - 0.5 && line <= right + 0.5)
    .sort((a, b) => a.line - b.line)
    .map(({ at, label, line, width }) => {
      const start = line + kGap + width > right ? line - kGap - width : line + kGap;
      let row = 0;
      while (rows[row]?.some(([from, to]) => start < to + kGap && start + width > from - kGap)) row++;
      (rows[row] ??= []).push([start, start + width]);
      return { at, label, line, left: start, row };
    });
}

export const kSpanHeight = 4;

/**
 * Bars at the upper edge of a chart over crank angle for its stretches { from, to, caseIndex }, a row for each case;
 * one that passes gas-exchange TDC is two bars. @returns { from, to, caseIndex, top }, top in pixels
 */
export function spanBars(panel, [low, high], visible) {
  const spans = (panel.spans ?? []).filter(visible);
  const rows = [...new Set(spans.map((span) => span.caseIndex))];
  return spans
    .flatMap(({ from, to, caseIndex }) => {
      const pieces =
        from <= to
          ? [[from, to]]
          : [
              [from, 360],
              [-360, to],
            ];
      return pieces.map(([a, b]) => ({
        from: Math.max(a, low),
        to: Math.min(b, high),
        caseIndex,
        top: rows.indexOf(caseIndex) * (kSpanHeight + 1),
      }));
    })
    .filter((bar) => bar.to >= bar.from);
}

/** Outlines of the bands about a curve, one for each piece without a gap, in the units of the axes. */
export function bandOutlines(series) {
  const bands = series.error
    ? [
        {
          low: series.y.map((v, k) => away(v, series.error[k], -1)),
          high: series.y.map((v, k) => away(v, series.error[k], 1)),
        },
      ]
    : (series.bands ?? []);
  const pieces = [];
  for (const { low, high } of bands) {
    let piece = null;
    series.x.forEach((x, k) => {
      if (low[k] === null || high[k] === null) {
        piece = null;
        return;
      }
      if (!piece) pieces.push((piece = []));
      piece.push({ x, low: low[k], high: high[k] });
    });
  }
  return pieces
    .filter((p) => p.length > 1)
    .map((p) => [...p.map(({ x, high }) => [x, high]), ...p.map(({ x, low }) => [x, low]).reverse()]);
}

function away(value, error, sign) {
  return value === null || error === null ? null : value + sign * error;
}

export function axisTitle(label, unit) {
  return unit ? `${label} [${unit}]` : label;
}

/**
 * Arrowheads along a curve in the order of time: { x, y, angle } in pixels, spaced by the length of the
 * curve.
 */
export function arrowHeads(points, count) {
  const lengths = [0];
  for (let k = 1; k < points.length; k++) {
    const [a, b] = [points[k - 1], points[k]];
    lengths.push(lengths[k - 1] + (a && b ? Math.hypot(b[0] - a[0], b[1] - a[1]) : 0));
  }
  const total = lengths[lengths.length - 1];
  const heads = [];
  let k = 1;
  for (let n = 1; n <= count; n++) {
    const target = (total * n) / (count + 1);
    while (k < points.length - 1 && lengths[k] < target) k++;
    const [a, b] = [points[k - 1], points[k]];
    if (a && b && (a[0] !== b[0] || a[1] !== b[1]))
      heads.push({ x: b[0], y: b[1], angle: Math.atan2(b[1] - a[1], b[0] - a[0]) });
  }
  return heads;
}

export function arrowPath({ x, y, angle }, size) {
  const at = (r, turn) =>
    `${(x + r * Math.cos(angle + turn)).toFixed(2)} ${(y + r * Math.sin(angle + turn)).toFixed(2)}`;
  return `M${at(size, 0)}L${at(size, 2.5)}L${at(size, -2.5)}Z`;
}
