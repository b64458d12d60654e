// The axes of every drawing over two scales.
import { axisTicks, axisTitle, deadCentre, extent } from './scales.js';
import { boldText, kFaint, kGrid, kInk, rule, scaler, text } from './svg_shapes.js';
import { tickText } from '../units.js';

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
/** The names of dead centres under the numbers of a crank axis are so high [pixel]. */
export const kNameRow = 13;

/** Numbers under an axis across at `bottom`, with the names of dead centres below those of a crank axis. */
export function numbersAcross({ values, step }, axis, x, bottom) {
  return values.flatMap((v) => [
    rule(x(v), bottom, x(v), bottom + 5, kInk),
    text(x(v), bottom + 18, tickText(v, step), { anchor: 'middle' }),
    deadCentre(axis, v) &&
      text(x(v), bottom + 18 + kNameRow, deadCentre(axis, v), { anchor: 'middle', size: 11, fill: kFaint }),
  ]);
}

/** Numbers to the left of an axis up at `left`. */
export function numbersUp({ values, step }, y, left) {
  return values.flatMap((v) => [
    rule(left - 5, y(v), left, y(v), kInk),
    text(left - 8, y(v) + 4, tickText(v, step), { anchor: 'end' }),
  ]);
}

/** The title of an axis across, under its numbers. */
export function titleAcross(axis, middle, bottom) {
  if (!axis.label) return '';
  return text(middle, bottom + 35 + (axis.crank ? kNameRow : 0), axisTitle(axis.label, axis.unit), {
    anchor: 'middle',
    fill: kFaint,
    more: ' class="axis-title"',
  });
}

/**
 * Axes in a box { x, y, width, height }.
 * @param across, up { low, high, log, label, unit, bare: without numbers, crank: over the crank angle }
 * @returns { plot, x, y, shapes, edges } the scales, grid and labels, and the lines that are drawn over the content
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
  const onX = apart(readable(across, (plot.right - plot.left) / 70), x, across.log ? 40 : 0);
  const onY = readable(up, (plot.bottom - plot.top) / 32);
  const shapes = [
    ...onY.values.flatMap((v) => [
      rule(plot.left, y(v), plot.right, y(v), kGrid),
      text(plot.left - 6, y(v) + 4, tickText(v, onY.step), { anchor: 'end' }),
    ]),
    ...(across.crank ? [] : onX.values.map((v) => rule(x(v), plot.top, x(v), plot.bottom, kGrid))),
    ...numbersAcross(onX, across, x, plot.bottom),
    boldText(box.x + 4, box.y + 14, axisTitle(up.label, up.unit), box.width - 8, {
      size: 13,
      more: ' class="axis-title"',
    }),
    titleAcross(across, (plot.left + plot.right) / 2, plot.bottom),
  ];
  const edges = [
    rule(plot.left, plot.bottom, plot.right, plot.bottom, kInk),
    rule(plot.left, plot.top, plot.left, plot.bottom, kInk),
  ];
  return { plot, x, y, shapes, edges };
}

/** At least two ticks, for one alone does not make a scale; none of a bare axis. */
function readable(axis, count) {
  if (axis.bare) return { values: [] };
  const found = axisTicks(axis, Math.max(2, count));
  return found.values.length < 2 ? axisTicks(axis, 2 * Math.max(2, count)) : found;
}

/** Ticks that are at least so many pixels apart. */
function apart({ values, step }, x, least) {
  let last = -Infinity;
  return { step, values: values.filter((v) => x(v) - last >= least && ((last = x(v)), true)) };
}
