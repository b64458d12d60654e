// One panel of curves: the same drawing on the screen, in files and in print.
import { frame } from './plot_frame.js';
import { caseColour, isOneOfSeveral, kBandOpacity, partDash } from './palette.js';
import {
  arrowHeads,
  arrowPath,
  bandOutlines,
  freePlace,
  kDeadCentres,
  kPeakLabel,
  kRoomForPeak,
  kSpanHeight,
  kStrokeBands,
  markIndices,
  markPlaces,
  spanBars,
  xRange,
  yRange,
} from './scales.js';
import {
  area,
  clipped,
  dot,
  kFaint,
  kInk,
  kLetter,
  line,
  mark,
  rectangle,
  rule,
  text,
} from './svg_shapes.js';

/** Over the cycle the names of the strokes are above the plot. */
const kMargins = { crank: { top: 44, bottom: 56 }, plain: { top: 26, bottom: 46 } };

/** @returns { shapes, plot, x, y } what is drawn in the box, the edges of the plot and its scales [pixel] */
export function linePanel(panel, box, visible, window = xRange(panel)) {
  const [bottom, top] = yRange(panel, visible, window);
  const axes = frame(
    box,
    {
      low: window[0],
      high: window[1],
      log: panel.xScale === 'log',
      crank: panel.crank,
      label: panel.xLabel,
      unit: panel.xUnit,
    },
    { low: bottom, high: top, log: panel.yScale === 'log', label: panel.yLabel, unit: panel.yUnit },
    panel.crank ? kMargins.crank : kMargins.plain,
  );
  const { plot, x, y } = axes;
  const series = panel.series.filter(visible).map((s) => ({ s, points: pointsOf(s, x, y) }));
  const shapes = [
    ...(panel.crank ? strokes(panel, window, visible, axes) : []),
    ...axes.shapes,
    ...clipped(plot, [
      ...series.flatMap(({ s }) => bands(s, x, y)),
      ...series.map(({ s, points }) => curve(panel, s, points)),
    ]),
    panel.zeroLine && bottom < 0 && top > 0 ? rule(plot.left, y(0), plot.right, y(0), kInk) : '',
    ...series.map(({ s, points }) => caseMarks(panel, s, points, window)),
    ...uprightMarks(panel, axes),
    ...levelMarks(panel, visible, axes, [bottom, top]),
    ...axes.edges,
  ];
  return { shapes, plot, x, y };
}

function pointsOf(s, x, y) {
  return s.x.map((v, k) => {
    if (v === null || s.y[k] === null) return null;
    const p = [x(v), y(s.y[k])];
    return Number.isFinite(p[1]) ? p : null;
  });
}

/** Stroke bands, stretches, dead centres, the peak of the pressure. */
function strokes(panel, window, visible, { plot, x }) {
  const [from, to] = window;
  const out = [];
  const isShown = (at) => at >= from && at <= to;
  const widest = Math.max(...kStrokeBands.map((band) => band.name.length)) * kLetter;
  const size = Math.min(11, Math.max(8, (12 * (x(180) - x(0) - 4)) / widest));
  kStrokeBands.forEach((band, i) => {
    const [a, b] = [Math.max(band.from, from), Math.min(band.to, to)];
    if (b <= a) return;
    const room = x(b) - x(a);
    if (i % 2 === 1) out.push(rectangle(x(a), plot.top, room, plot.bottom - plot.top, 'fill="#f4f6f8"'));
    if (room > (band.name.length * kLetter * size) / 12 - 2)
      out.push(text((x(a) + x(b)) / 2, plot.top - 8, band.name, { anchor: 'middle', size, fill: kFaint }));
  });
  for (const bar of spanBars(panel, window, visible))
    out.push(
      rectangle(
        x(bar.from),
        plot.top + bar.top,
        Math.max(1, x(bar.to) - x(bar.from)),
        kSpanHeight,
        `class="span" fill="${caseColour(bar.caseIndex)}"`,
      ),
    );
  for (const { at } of kDeadCentres.filter((centre) => centre.at > from && centre.at < to))
    out.push(rule(x(at), plot.bottom, x(at), plot.top - (at === 0 ? 6 : 0), '#aab1bb'));
  const peaks = (panel.peaks ?? []).filter(({ at }) => isShown(at));
  for (const { at, caseIndex } of peaks)
    out.push(rule(x(at), plot.bottom, x(at), plot.top - 4, caseColour(caseIndex), 1, '3 3'));
  const [first] = panel.peaks ?? [];
  if (first && isShown(first.at) && (x(180) - x(0)) / 2 - (x(first.at) - x(0)) > kRoomForPeak)
    out.push(text(x(first.at) + 3, plot.top - 8, kPeakLabel, { size: 11, fill: kFaint }));
  return out;
}

/** The errors about a curve, light and behind everything that is drawn. */
function bands(s, x, y) {
  return bandOutlines(s).map((outline) =>
    area(
      outline.map(([a, b]) => [x(a), y(b)]),
      caseColour(s.caseIndex),
      kBandOpacity,
      ' class="band"',
    ),
  );
}

function curve(panel, s, points) {
  // Drawn over all lines, with the marks.
  if (s.part === 'points') return '';
  const colour = caseColour(s.caseIndex);
  if (s.part === 'measured') return mark(null, points.filter(Boolean), 2, { stroke: '#000', width: 0.9 });
  const heads = panel.inOrderOfTime ? arrowHeads(points, 6) : [];
  return (
    line(points, colour, { dash: s.dash ?? partDash(s.part) }) +
    heads.map((head) => `<path d="${arrowPath(head, 6)}" fill="${colour}"/>`).join('')
  );
}

/** The marks of a case on its line. */
function caseMarks(panel, s, points, window) {
  const count = panel.series.filter((other) => other.caseIndex !== null).length;
  const places = markIndices(s, ...window, count, panel.xScale)
    .filter((k) => points[k] && s.x[k] >= window[0] && s.x[k] <= window[1])
    .map((k) => points[k]);
  return places.length ? mark(s.caseIndex, places, 3.3, { width: 1.4 }) : '';
}

function uprightMarks(panel, { plot, x }) {
  const width = (label) => kLetter * label.length;
  return markPlaces(panel.xMarks ?? [], x, width, plot.left, plot.right).flatMap((one) => [
    rule(one.line, plot.bottom, one.line, plot.top, kFaint, 1, '4 3'),
    text(one.left, plot.top + 11 + 13 * one.row, one.label, { size: 11, fill: kFaint, halo: '#fff' }),
  ]);
}

function levelMarks(panel, visible, { plot, x, y }, [bottom, top]) {
  const box = {
    x,
    y,
    left: plot.left,
    top: plot.top,
    width: plot.right - plot.left,
    height: plot.bottom - plot.top,
  };
  return (panel.yMarks ?? [])
    .filter(({ at }) => at >= bottom && at <= top)
    .flatMap(({ at, label }) => {
      const place = freePlace(panel, visible, at, kLetter * label.length, box);
      return [
        rule(plot.left, y(at), plot.right, y(at), kFaint, 1, '2 3'),
        text(place.x, place.y, label, { size: 11, fill: kFaint, halo: '#fff' }),
      ];
    });
}

/** The sample of a line (or bar) next to its name, 28 pixels wide. */
export function swatch({ caseIndex, part = null, dash = partDash(part), bars = false }, x, y) {
  const colour = caseColour(caseIndex);
  if (bars) return rectangle(x + 8, y - 6, 12, 12, `fill="${colour}"`);
  if (part === 'measured')
    return [6, 14, 22].map((dx) => dot(x + dx, y, 2, 'fill="none" stroke="#000"')).join('');
  const isMarked = part === 'points' || isOneOfSeveral(caseIndex);
  return (
    (part === 'points' ? '' : rule(x, y, x + 28, y, colour, 2, dash)) +
    (isMarked ? mark(caseIndex, [[x + 14, y]], 3.4, { width: 1.4 }) : '')
  );
}

export function swatchSvg(entry) {
  return (
    '<svg xmlns="http://www.w3.org/2000/svg" width="28" height="14" viewBox="0 0 28 14" ' +
    `aria-hidden="true">${swatch(entry, 0, 7)}</svg>`
  );
}
