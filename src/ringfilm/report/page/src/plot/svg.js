// A figure as a static SVG: to take away, and in print. Drawn from the same plain data as the charts on the
// screen.
import {
  arrowHeads,
  arrowPath,
  axisTitle,
  bandOutlines,
  deadCentre,
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
  xTicks,
  yRange,
  yTicks,
} from './scales.js';
import { caseColour, caseMark, isOneOfSeveral, kBandOpacity, markPath, partDash } from './palette.js';
import { barPanel, rankedHeight, rankedPanel } from './svg_bars.js';
import { kFaint, kInk, kMargin, px, rule, scaler, text } from './svg_shapes.js';
import { tickText } from '../units.js';

const kPanelHeight = 262;
/** A letter of a label is at most about so wide: a drawing cannot measure its text [pixel]. */
const kLetter = 6.6;
/** The same of a bold letter, as a share of its size. */
const kBoldLetter = 0.6;

function linePanel(panel, box, visible, window, clip) {
  const range = window ?? xRange(panel);
  const [bottom, top] = yRange(panel, visible, range);
  const [left, right] = [box.x + kMargin.left, box.x + box.width - kMargin.right];
  const [high, low] = [box.y + marginTop(panel), box.y + box.height - kMargin.bottom];
  const x = scaler(panel.xScale === 'log', range[0], range[1], left, right);
  const y = scaler(panel.yScale === 'log', bottom, top, low, high);
  const out = [];
  if (panel.crank) out.push(...crankFurniture(panel, range, visible, x, high, low));
  const across = xTicks(panel, range[0], range[1], (right - left) / 70);
  const up = yTicks(panel, bottom, top, (low - high) / 32);
  for (const v of up.values) {
    out.push(
      rule(left, y(v), right, y(v), '#e3e6ea'),
      text(left - 6, y(v) + 4, tickText(v, up.step), { anchor: 'end' }),
    );
  }
  for (const v of across.values) {
    if (!panel.crank) out.push(rule(x(v), low, x(v), high, '#e3e6ea'));
    out.push(
      rule(x(v), low, x(v), low + 5, kInk),
      text(x(v), low + 18, tickText(v, across.step), { anchor: 'middle' }),
    );
    out.push(text(x(v), low + 31, deadCentre(panel, v), { anchor: 'middle', size: 11, fill: kFaint }));
  }
  if (panel.zeroLine && bottom < 0 && top > 0) out.push(rule(left, y(0), right, y(0), kInk, 1));
  for (const mark of panel.yMarks ?? []) {
    if (mark.at < bottom || mark.at > top) continue;
    const place = freePlace(panel, visible, mark.at, kLetter * mark.label.length, {
      x,
      y,
      left,
      top: high,
      width: right - left,
      height: low - high,
    });
    out.push(
      rule(left, y(mark.at), right, y(mark.at), kFaint, 1, '2 3'),
      text(place.x, place.y, mark.label, { size: 11, fill: kFaint, halo: '#fff' }),
    );
  }
  out.push(`<g clip-path="url(#${clip})">`);
  panel.series.filter(visible).forEach((s) => out.push(...seriesShapes(panel, s, x, y, range)));
  out.push('</g>');
  for (const mark of markPlaces(panel.xMarks ?? [], x, (label) => kLetter * label.length, left, right)) {
    out.push(
      rule(mark.line, low, mark.line, high, kFaint, 1, '4 3'),
      text(mark.left, high + 11 + 13 * mark.row, mark.label, { size: 11, fill: kFaint, halo: '#fff' }),
    );
  }
  out.push(rule(left, low, right, low, kInk), rule(left, low, left, high, kInk));
  out.push(text(box.x + 4, box.y + 14, axisTitle(panel.yLabel, panel.yUnit), { weight: 600 }));
  out.push(
    text((left + right) / 2, low + (panel.crank ? 47 : 36), axisTitle(panel.xLabel, panel.xUnit), {
      anchor: 'middle',
      fill: kFaint,
    }),
  );
  const define =
    `<clipPath id="${clip}"><rect x="${px(left)}" y="${px(high - 2)}" width="${px(right - left)}" ` +
    `height="${px(low - high + 4)}"/></clipPath>`;
  return define + out.join('');
}

function crankFurniture(panel, [from, to], visible, x, high, low) {
  const out = [];
  kStrokeBands.forEach((band, i) => {
    const [a, b] = [Math.max(band.from, from), Math.min(band.to, to)];
    if (b <= a) return;
    if (i % 2 === 1)
      out.push(
        `<rect x="${px(x(a))}" y="${px(high)}" width="${px(x(b) - x(a))}" ` +
          `height="${px(low - high)}" fill="#f4f6f8"/>`,
      );
    if (x(b) - x(a) > 60)
      out.push(text((x(a) + x(b)) / 2, high - 8, band.name, { anchor: 'middle', size: 11, fill: kFaint }));
  });
  for (const bar of spanBars(panel, [from, to], visible))
    out.push(
      `<rect class="span" x="${px(x(bar.from))}" y="${px(high + bar.top)}" ` +
        `width="${px(Math.max(1, x(bar.to) - x(bar.from)))}" height="${kSpanHeight}" ` +
        `fill="${caseColour(bar.caseIndex)}"/>`,
    );
  for (const centre of kDeadCentres) {
    if (centre.at > from && centre.at < to)
      out.push(rule(x(centre.at), low, x(centre.at), high - (centre.at === 0 ? 6 : 0), '#aab1bb'));
  }
  for (const peak of panel.peaks ?? []) {
    if (peak.at < from || peak.at > to) continue;
    out.push(rule(x(peak.at), low, x(peak.at), high - 4, caseColour(peak.caseIndex), 1, '3 3'));
  }
  const [first] = panel.peaks ?? [];
  const roomForPeak = (x(180) - x(0)) / 2 - (x(first?.at ?? 0) - x(0)) > kRoomForPeak;
  if (first && first.at >= from && first.at <= to && roomForPeak)
    out.push(text(x(first.at) + 3, high - 8, kPeakLabel, { size: 11, fill: kFaint }));
  return out;
}

function seriesShapes(panel, s, x, y, range) {
  const colour = caseColour(s.caseIndex);
  const points = s.x
    .map((v, k) => (v === null || s.y[k] === null ? null : [x(v), y(s.y[k])]))
    .map((p) => (p && Number.isFinite(p[1]) ? p : null));
  if (s.part === 'measured') {
    return points
      .filter(Boolean)
      .map(
        ([a, b]) =>
          `<circle cx="${px(a)}" cy="${px(b)}" r="1.8" fill="none" stroke="#000" stroke-width="0.9"/>`,
      );
  }
  let path = '';
  let pen = false;
  for (const p of points) {
    if (p) path += `${pen ? 'L' : 'M'}${px(p[0])} ${px(p[1])}`;
    pen = p !== null;
  }
  const dash = partDash(s.part);
  const bands = bandOutlines(s).map(
    (outline) =>
      `<path class="band" d="M${outline.map(([a, b]) => `${px(x(a))} ${px(y(b))}`).join('L')}Z" ` +
      `fill="${colour}" fill-opacity="${kBandOpacity}"/>`,
  );
  const out =
    s.part === 'points'
      ? []
      : [
          ...bands,
          `<path d="${path}" fill="none" stroke="${colour}" stroke-width="1.8" ` +
            `stroke-linejoin="round"${dash.length ? ` stroke-dasharray="${dash.join(' ')}"` : ''}/>`,
        ];
  const count = panel.series.filter((other) => other.caseIndex !== null).length;
  for (const k of markIndices(s, range[0], range[1], count, panel.xScale)) {
    if (points[k])
      out.push(
        `<path d="${markPath(caseMark(s.caseIndex), points[k][0], points[k][1], 3.2)}" ` +
          `fill="#fff" stroke="${colour}" stroke-width="1.4"/>`,
      );
  }
  if (panel.inOrderOfTime)
    out.push(...arrowHeads(points, 6).map((head) => `<path d="${arrowPath(head, 6)}" fill="${colour}"/>`));
  return out;
}

/** Over the cycle the names of the strokes are above the plot. */
function marginTop(panel) {
  return panel.crank ? kMargin.top : kMargin.top - 16;
}

function panelHeight(panel) {
  return panel.ranked ? rankedHeight(panel) : kPanelHeight;
}

function drawnPanel(panel, box, visible, window) {
  if (panel.ranked) return rankedPanel(panel, box, visible);
  if (panel.bars) return barPanel(panel, box, visible);
  return linePanel(panel, box, visible, window, `clip${drawn++}`);
}

function legend(figure, visible, width, y) {
  const entries = [];
  for (const panel of figure.panels) {
    for (const s of panel.bars ? panel.groups : panel.series) {
      if (visible(s) && !entries.some((e) => e.label === s.label && e.part === (s.part ?? null))) {
        entries.push({ label: s.label, caseIndex: s.caseIndex, part: s.part ?? null, bars: panel.bars });
      }
    }
  }
  const out = [];
  let x = 8;
  let row = y;
  for (const e of entries) {
    const label =
      e.part && !['measured', 'total', 'points'].includes(e.part) && !e.label.includes(e.part)
        ? `${e.label}, ${e.part}`
        : e.label;
    const needed = 50 + 7 * label.length;
    if (x + needed > width && x > 8) {
      x = 8;
      row += 18;
    }
    out.push(swatch(e, x, row - 4), text(x + 32, row, label));
    x += needed;
  }
  return { shapes: out.join(''), bottom: row + 10 };
}

/** The sample of a line (or bar) next to its name. */
function swatch({ caseIndex, part, bars }, x, y) {
  const colour = caseColour(caseIndex);
  if (bars) return `<rect x="${x + 8}" y="${y - 6}" width="12" height="12" fill="${colour}"/>`;
  if (part === 'measured')
    return [6, 14, 22]
      .map((dx) => `<circle cx="${x + dx}" cy="${y}" r="2" fill="none" stroke="#000"/>`)
      .join('');
  const dash = partDash(part);
  const mark =
    part !== 'points' && !isOneOfSeveral(caseIndex)
      ? ''
      : `<path d="${markPath(caseMark(caseIndex), x + 14, y, 3.4)}" fill="#fff" stroke="${colour}" ` +
        'stroke-width="1.4"/>';
  if (part === 'points') return mark;
  return (
    `<line x1="${x}" y1="${y}" x2="${x + 28}" y2="${y}" stroke="${colour}" ` +
    `stroke-width="2"${dash.length ? ` stroke-dasharray="${dash.join(' ')}"` : ''}/>${mark}`
  );
}

export function swatchSvg(entry) {
  return (
    '<svg xmlns="http://www.w3.org/2000/svg" width="28" height="14" viewBox="0 0 28 14" ' +
    `aria-hidden="true">${swatch(entry, 0, 7)}</svg>`
  );
}

let drawn = 0;

/**
 * The figure as an SVG document.
 * @param visible which series are shown; @param options width, heading (title and legend inside), windows: x
 * window by panel id
 */
export function figureSvg(
  figure,
  visible,
  { width = 760, heading = true, windows = {}, subtitle = '' } = {},
) {
  const side = figure.layout === 'row' && width >= 600;
  const out = [];
  let y = 4;
  if (heading) {
    out.push(
      text(8, 20, figure.title, {
        size: Math.min(16, (width - 16) / (kBoldLetter * figure.title.length)),
        weight: 600,
      }),
    );
    y = 26;
    if (subtitle) {
      out.push(text(8, 37, subtitle, { fill: kFaint }));
      y = 44;
    }
    const drawnLegend = legend(figure, visible, width - 8, y + 14);
    out.push(drawnLegend.shapes);
    y = drawnLegend.bottom + 2;
  }
  const perRow = side ? Math.min(2, figure.panels.length) : 1;
  for (let first = 0; first < figure.panels.length; first += perRow) {
    const row = figure.panels.slice(first, first + perRow);
    const whole = row.reduce((sum, panel) => sum + (panel.weight ?? 1), 0);
    const tall = Math.max(...row.map(panelHeight));
    let x = 0;
    for (const panel of row) {
      const box = { x, y, width: (width * (panel.weight ?? 1)) / whole, height: tall };
      out.push(drawnPanel(panel, box, visible, windows[panel.id]));
      x += box.width;
    }
    y += tall;
  }
  const height = y + 4;
  return (
    `<svg xmlns="http://www.w3.org/2000/svg" width="${width}" height="${px(height)}" viewBox="0 0 ` +
    `${width} ${px(height)}" font-family="'Segoe UI', 'Helvetica Neue', Arial, 'Liberation Sans', ` +
    'sans-serif">' +
    `<rect width="100%" height="100%" fill="#fff"/>${out.join('')}</svg>`
  );
}
