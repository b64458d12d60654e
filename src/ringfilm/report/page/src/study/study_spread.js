// How the values of a sample are spread, and how certain their statistics are by the number of points.
import { caseColour, kBandOpacity } from '../plot/palette.js';
import { kOnlyCase } from '../model.js';
import { swatch } from '../plot/line_panel.js';
import { airy, frame } from '../plot/plot_frame.js';
import { axisTitle } from '../plot/scales.js';
import { area, dot, fitted, legend, line, rule, titled } from '../plot/svg_shapes.js';
import { short } from './study_model.js';
import { percent } from '../units.js';

export const shareText = (share) => `${short(100 * share)}\u00a0%`;

/** Panels side by side where there is room: { columns, at(i) to a box, rows }. */
export function panelGrid(count, roomFor, height, top, width = roomFor) {
  const columns = Math.min(count, roomFor >= 960 ? 3 : roomFor >= 640 ? 2 : 1);
  const w = width / columns;
  return {
    columns,
    bottom: top + Math.ceil(count / columns) * height,
    at: (i) => ({ x: (i % columns) * w, y: top + Math.floor(i / columns) * height, width: w, height }),
  };
}

/** The names of the bases for a legend, where there are several. */
export function baseEntries(model) {
  if (!model.several) return [];
  return model.bases.map((b) => ({
    label: fitted(b.name, 300),
    swatch: (x, y) => swatch({ caseIndex: b.index, bars: true }, x, y),
  }));
}

export function histogramFigure(model) {
  const shown = model.mainValues.filter((q) => model.histograms[q.name]?.edges.length > 1);
  if (shown.length === 0) return null;
  const kHeight = 236;
  const boxRow = 10;
  const panel = (q, box) => {
    const h = model.histograms[q.name];
    const edges = h.edges.map(q.convert);
    const total = (b) => h.counts[b].reduce((sum, n) => sum + n, h.below[b] + h.above[b]) || 1;
    const heights = h.counts.map((counts, b) => counts.map((n) => (100 * n) / total(b)));
    const most = Math.max(...heights.flat());
    const {
      plot,
      x,
      y,
      shapes,
      edges: lines,
    } = frame(
      box,
      { low: edges[0], high: edges[edges.length - 1], label: q.short_name, unit: q.shown },
      { low: 0, high: 1.08 * most, label: 'share of the scenarios', unit: '%' },
      { top: 30 + boxRow * model.bases.length },
    );
    const out = [...shapes];
    heights.forEach((bins, b) => {
      const points = bins.flatMap((v, k) => [
        [x(edges[k]), y(v)],
        [x(edges[k + 1]), y(v)],
      ]);
      const whole = [[x(edges[0]), y(0)], ...points, [x(edges[edges.length - 1]), y(0)]];
      out.push(area(whole, caseColour(b), kBandOpacity), line(whole, caseColour(b), { width: 1.4 }));
    });
    model.statistics[q.name].forEach((s, b) => {
      if (!s) return;
      const [low, , middle, , high] = s.quantiles.map(([v]) =>
        Math.min(plot.right, Math.max(plot.left, x(q.convert(v)))),
      );
      const at = plot.top - 4 - boxRow * (model.bases.length - b - 0.5);
      const [fifth, median, last] = [0, 2, 4].map((i) => model.valueText(q, s.quantiles[i][0]));
      out.push(
        `<g>${titled(`${model.bases[b].name}: 5 % ${fifth}, median ${median}, 95 % ${last}`)}`,
        rule(low, at, high, at, caseColour(b), 3),
        dot(middle, at, 4, `fill="#fff" stroke="${caseColour(b)}" stroke-width="2"`),
        '</g>',
      );
    });
    return [...out, ...lines];
  };
  const beyond = shown.some((q) =>
    [...model.histograms[q.name].below, ...model.histograms[q.name].above].some((n) => n > 0),
  );
  return {
    id: 'histograms',
    title: 'How the values of the cycle are spread',
    draw(width) {
      const named = legend(baseEntries(model), width);
      const grid = panelGrid(shown.length, width, kHeight, named.height + 4);
      return {
        shapes: [...named.shapes, ...shown.flatMap((q, i) => panel(q, grid.at(i)))],
        height: grid.bottom,
      };
    },
    caption: () =>
      `Share of the scenarios in each bin${model.several ? ', one colour for each base' : ''}. ` +
      'The bar above spans 5 % to 95 % of the scenarios, the ring on it is the ' +
      'median.' +
      `${beyond ? ' A few outermost scenarios lie beyond the drawn range; the statistics count them.' : ''}`,
    columns: () =>
      shown.flatMap((q) => [
        {
          title: axisTitle(`${q.short_name}: from`, q.shown),
          values: model.histograms[q.name].edges.slice(0, -1).map(q.convert),
        },
        {
          title: axisTitle(`${q.short_name}: to`, q.shown),
          values: model.histograms[q.name].edges.slice(1).map(q.convert),
        },
        ...model.bases.map((b) => ({
          title: `${q.short_name}: scenarios of ${b.name}`,
          values: model.histograms[q.name].counts[b.index],
        })),
      ]),
  };
}

const kQuantileDashes = ['2 3', '', '9 4'];
/** The widest intervals, of fewer points, may leave the picture: the last ones are the result. */
const kFramedFrom = 32;

/** Mean and quantiles over the number of points. @param chosen.value name of the value that is drawn */
export function convergenceFigure(model, chosen) {
  const found = model.convergence[chosen.value];
  const q = model.quantity.get(chosen.value);
  /** @param lists (c) to lists of triples of a base, each with its name and dash */
  const panel = (title, lists) => {
    const curves = found.flatMap((c, b) =>
      c
        ? lists(c).map((one) => ({
            ...one,
            b,
            n: c.n,
            triples: one.triples.map((t) => model.interval(q, t)),
          }))
        : [],
    );
    const framed = curves.flatMap((c) =>
      c.triples.flatMap((t, k) => (c.n[k] >= kFramedFrom || c.n.length < 3 ? t : [t[0]])),
    );
    const { low, high } = airy(framed);
    return {
      id: `convergence-${title}`,
      xScale: 'log',
      xLabel: 'points',
      xUnit: '',
      yLabel: `${q.short_name}: ${title}`,
      yUnit: q.shown,
      yRange: [low, high],
      series: curves.map(({ label, dash, b, n, triples }) => ({
        caseIndex: model.several ? b : kOnlyCase,
        label: model.several ? `${model.bases[b].name}, ${label}` : label,
        dash,
        isSampled: true,
        x: n,
        y: triples.map((t) => t[0]),
        bands: [{ low: triples.map((t) => t[1]), high: triples.map((t) => t[2]), words: ['low', 'high'] }],
      })),
    };
  };
  const last = (b) => {
    const c = found[b];
    const t = c?.mean[c.mean.length - 1];
    const width = t && percent((t[2] - t[1]) / 2 / Math.abs(t[0])).replace('+', '');
    return t ? `${model.several ? `${model.bases[b].name} ` : ''}±\u00a0${width}` : '';
  };
  return {
    id: 'convergence',
    title: 'How the statistics settle with the number of points',
    layout: 'row',
    panels: [
      panel('mean', (c) => [{ label: 'mean', dash: '', triples: c.mean }]),
      panel('quantiles', (c) =>
        c.quantiles.map((triples, i) => ({
          label: shareText(model.converging_shares[i]),
          dash: kQuantileDashes[i],
          triples,
        })),
      ),
    ],
    caption:
      `Mean and quantiles of ${q.short_name} of the first 16, 32, 64, ... points and of all of ` +
      'them, with their 95 % confidence intervals (bands); an end that so few points do not determine ' +
      'is omitted. Interval of the mean at the end: ' +
      model.bases
        .map((b) => last(b.index))
        .filter(Boolean)
        .join(', ') +
      '. Intervals presume independent points; those of Sobol points and Latin hypercubes are ' +
      'wider than need be.',
  };
}
