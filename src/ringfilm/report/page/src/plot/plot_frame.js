// Axes and the rest that drawn figures share.
import { caseColour, caseMark, markPath } from './palette.js';
import { axisTitle } from './scales.js';
import { kFaint, kInk, px, rule, scaler, text } from './svg_shapes.js';
import { logTicks, ticks, tickText } from '../units.js';

export const kGrid = '#e3e6ea';
/** A letter is at most about so wide: a drawing cannot measure its text [pixel]. */
export const kLetter = 6.4;
const kBoldLetter = 0.6;

/** A drawing as an SVG document, with a title where it leaves the page. */
export function document({ shapes, height }, width, { title = '', subtitle = '' } = {}) {
  const top = title ? (subtitle ? 50 : 30) : 0;
  const head = title
    ? [text(8, 20, title, { size: Math.min(16, (width - 16) / (kBoldLetter * title.length)), weight: 600 })]
    : [];
  if (title && subtitle)
    head.push(
      text(8, 38, subtitle, { fill: kFaint, size: Math.min(12, (width - 16) / (0.55 * subtitle.length)) }),
    );
  return (
    `<svg xmlns="http://www.w3.org/2000/svg" width="${width}" height="${px(height + top)}" ` +
    `viewBox="0 0 ${width} ${px(height + top)}" font-family="'Segoe UI', 'Helvetica Neue', Arial, ` +
    `'Liberation Sans', sans-serif">` +
    `<rect width="100%" height="100%" fill="#fff"/>${head.join('')}<g transform="translate(0 ` +
    `${top})">${shapes.join('')}</g></svg>`
  );
}

/** Lowest and highest of the numbers among `values`; null without one. */
export function extent(values) {
  let [low, high] = [Infinity, -Infinity];
  for (const v of values) {
    if (v === null || v === undefined || !Number.isFinite(v)) continue;
    low = Math.min(low, v);
    high = Math.max(high, v);
  }
  return low <= high ? [low, high] : null;
}

/** A range with air around the values. */
export function airy(values, { log = false, fromZero = false } = {}) {
  const found = extent(values) ?? [0, 1];
  let [low, high] = found;
  if (log) return { low: low / 1.25, high: high * 1.25, log };
  if (fromZero && low > 0) low = 0;
  const span = high - low || Math.abs(high) || 1;
  return { low: low === 0 && fromZero ? 0 : low - 0.05 * span, high: high + 0.07 * span, log };
}

const kMargins = { left: 58, right: 16, top: 26, bottom: 46 };

/**
 * Axes in a box { x, y, width, height }.
 * @param across, up { low, high, log, label, unit, bare: without numbers }; @returns { plot, x, y, shapes,
 * edges } the scales, grid and labels,
 * and the lines that are drawn over the content
 */
export function frame(box, across, up, margins = {}) {
  const m = { ...kMargins, ...margins };
  const plot = {
    left: box.x + m.left,
    right: box.x + box.width - m.right,
    top: box.y + m.top,
    bottom: box.y + box.height - m.bottom,
  };
  const x = scaler(across.log, across.low, across.high, plot.left, plot.right);
  const y = scaler(up.log, up.low, up.high, plot.bottom, plot.top);
  const shapes = [];
  const onX = across.log
    ? thinned(logTicks(across.low, across.high), x, 40)
    : readableTicks(across.low, across.high, (plot.right - plot.left) / 75);
  const onY = up.bare
    ? { values: [] }
    : up.log
      ? logTicks(up.low, up.high)
      : ticks(up.low, up.high, Math.max(2, (plot.bottom - plot.top) / 36));
  for (const v of onY.values)
    shapes.push(
      rule(plot.left, y(v), plot.right, y(v), kGrid),
      text(plot.left - 6, y(v) + 4, tickText(v, onY.step), { anchor: 'end' }),
    );
  for (const v of onX.values)
    shapes.push(
      rule(x(v), plot.top, x(v), plot.bottom, kGrid),
      rule(x(v), plot.bottom, x(v), plot.bottom + 5, kInk),
      text(x(v), plot.bottom + 18, tickText(v, onX.step), { anchor: 'middle' }),
    );
  const title = axisTitle(up.label, up.unit);
  shapes.push(
    text(box.x + 4, box.y + 14, title, {
      weight: 600,
      size: Math.min(12, (box.width - 8) / (kBoldLetter * title.length)),
    }),
  );
  shapes.push(
    text((plot.left + plot.right) / 2, plot.bottom + 36, axisTitle(across.label, across.unit), {
      anchor: 'middle',
      fill: kFaint,
    }),
  );
  const edges = [
    rule(plot.left, plot.bottom, plot.right, plot.bottom, kInk),
    rule(plot.left, plot.top, plot.left, plot.bottom, kInk),
  ];
  return { plot, x, y, shapes, edges };
}

/** At least two: one alone does not make a scale. */
function readableTicks(low, high, count) {
  const found = ticks(low, high, Math.max(2, count));
  return found.values.length < 2 ? ticks(low, high, 2 * Math.max(2, count)) : found;
}

/** Ticks that are at least so many pixels apart. */
function thinned({ values, step }, x, least) {
  let last = -Infinity;
  return { step, values: values.filter((v) => x(v) - last >= least && ((last = x(v)), true)) };
}

export function line(points, stroke, { width = 1.8, dash = '' } = {}) {
  let path = '';
  let pen = false;
  for (const p of points) {
    const there = p && Number.isFinite(p[0]) && Number.isFinite(p[1]);
    if (there) path += `${pen ? 'L' : 'M'}${px(p[0])} ${px(p[1])}`;
    pen = there;
  }
  return (
    `<path d="${path}" fill="none" stroke="${stroke}" stroke-width="${width}" ` +
    `stroke-linejoin="round"${dash ? ` stroke-dasharray="${dash}"` : ''}/>`
  );
}

export function area(points, fill, opacity, tooltip = '') {
  if (points.length < 3) return '';
  return (
    `<path d="M${points.map(([a, b]) => `${px(a)} ${px(b)}`).join('L')}Z" fill="${fill}" ` +
    `fill-opacity="${opacity}">${tooltip && `<title>${tooltip}</title>`}</path>`
  );
}

export function mark(
  caseIndex,
  x,
  y,
  r = 4,
  { fill = '#fff', stroke = caseColour(caseIndex), tooltip = '' } = {},
) {
  return (
    `<path d="${markPath(caseMark(caseIndex), x, y, r)}" fill="${fill}" stroke="${stroke}" ` +
    `stroke-width="1.5">${tooltip && `<title>${tooltip}</title>`}</path>`
  );
}

/** Names beside samples, in rows. @param entries { label, swatch(x, y) }, each sample 28 pixels wide */
export function legend(entries, width, top) {
  const shapes = [];
  let [x, y] = [8, top + 12];
  for (const { label, swatch } of entries) {
    const needed = 54 + kLetter * label.length;
    if (x + needed > width && x > 8) [x, y] = [8, y + 19];
    shapes.push(swatch(x, y - 4), text(x + 34, y, label));
    x += needed;
  }
  return { shapes, height: entries.length ? y + 10 - top : 0 };
}

export function baseSwatch(caseIndex) {
  return (x, y) =>
    `<rect x="${px(x + 6)}" y="${px(y - 6)}" width="16" height="12" fill="${caseColour(caseIndex)}"/>`;
}

/** A text of at most so many pixels. */
export function fitted(words, width, letter = kLetter) {
  const most = Math.max(4, Math.floor(width / letter));
  return words.length <= most ? words : `${words.slice(0, most - 1)}…`;
}
