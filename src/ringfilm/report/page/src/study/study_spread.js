// How the values of a sample are spread, and how certain their statistics are by the number of points.
import { caseColour, kBandOpacity } from '../plot/palette.js';
import { swatch } from '../plot/line_panel.js';
import { airy, frame } from '../plot/plot_frame.js';
import { axisTitle, extent } from '../plot/scales.js';
import { area, dot, fitted, kInk, legend, line, rule, titled } from '../plot/svg_shapes.js';
import { short } from './study_model.js';
import { number, percent } from '../units.js';

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

const kConvergenceHeight = 300;

/** @param chosen.value name of the value that is drawn */
export function convergenceFigure(model, chosen) {
  const found = () => model.convergence[chosen.value];
  const of = () => model.quantity.get(chosen.value);
  const parts = [
    { title: 'mean', list: (c) => [{ label: 'mean', triples: c.mean }] },
    {
      title: 'quantiles',
      list: (c) =>
        c.quantiles.map((triples, i) => ({ label: shareText(model.converging_shares[i]), triples })),
    },
  ];
  const dashes = ['2 3', '', '9 4'];
  const panel = (part, box) => {
    const q = of();
    const curves = found().flatMap((c, b) =>
      c
        ? part.list(c).map((one, i, all) => ({
            ...one,
            b,
            n: c.n,
            dash: all.length > 1 ? dashes[i] : '',
            triples: one.triples.map((t) => (t ? model.interval(q, t) : null)),
          }))
        : [],
    );
    // The widest intervals, of the fewest points, may leave the picture: the last ones are the result.
    const framed = curves.flatMap((c) =>
      c.triples.flatMap((t, k) => (t ? (c.n[k] >= 32 || c.n.length < 3 ? t : [t[0]]) : [])),
    );
    const range = airy(framed);
    const counts = extent(curves.flatMap((c) => c.n)) ?? [1, 10];
    const { plot, x, y, shapes, edges } = frame(
      box,
      { low: counts[0] / 1.15, high: counts[1] * 1.15, log: true, label: 'points', unit: '' },
      { ...range, label: `${q.short_name}: ${part.title}`, unit: q.shown },
    );
    const clipped = (v) => Math.min(plot.bottom, Math.max(plot.top, v));
    const out = [...shapes];
    for (const c of curves) {
      const whole = c.triples
        .map((t, k) => ({ t, k }))
        .filter(({ t }) => t && t[1] !== null && t[2] !== null);
      out.push(
        area(
          [
            ...whole.map(({ t, k }) => [x(c.n[k]), clipped(y(t[2]))]),
            ...whole.map(({ t, k }) => [x(c.n[k]), clipped(y(t[1]))]).reverse(),
          ],
          caseColour(c.b),
          kBandOpacity,
        ),
      );
    }
    for (const c of curves) {
      out.push(
        line(
          c.triples.map((t, k) => (t ? [x(c.n[k]), clipped(y(t[0]))] : null)),
          caseColour(c.b),
          { dash: c.dash },
        ),
      );
      c.triples.forEach(
        (t, k) =>
          t &&
          out.push(
            dot(
              x(c.n[k]),
              clipped(y(t[0])),
              2.4,
              `fill="${caseColour(c.b)}"`,
              `${model.bases[c.b].name}, ${c.n[k]} points: ${c.label} ${number(t[0])} ` +
                `(${number(t[1])} to ${number(t[2])})`,
            ),
          ),
      );
    }
    return [...out, ...edges];
  };
  return {
    id: 'convergence',
    title: 'How the statistics settle with the number of points',
    draw(width) {
      const lines = model.converging_shares.map((share, i) => ({
        label: shareText(share),
        swatch: (x, y) => rule(x, y, x + 28, y, kInk, 2, dashes[i]),
      }));
      const named = legend([...baseEntries(model), ...lines], width);
      const grid = panelGrid(2, Math.min(width, 959), kConvergenceHeight, named.height + 4);
      const wide = grid.columns === 2 ? width / 2 : width;
      return {
        shapes: [
          ...named.shapes,
          ...parts.flatMap((part, i) =>
            panel(part, { ...grid.at(i), x: grid.columns === 2 ? i * wide : 0, width: wide }),
          ),
        ],
        height: grid.bottom,
      };
    },
    caption: () => {
      const q = of();
      const last = (b) => {
        const c = found()[b];
        const t = c?.mean[c.mean.length - 1];
        return t
          ? `${model.several ? `${model.bases[b].name} ` : ''}±\u00a0` +
              `${percent((t[2] - t[1]) / 2 / Math.abs(t[0])).replace('+', '')}`
          : '';
      };
      return (
        `Mean and quantiles of ${q.short_name} of the first 16, 32, 64, ... points and of all of ` +
        'them, with their 95 % confidence intervals (bands); an end that so few points do not determine ' +
        'is omitted. Interval of the mean at the end: ' +
        model.bases
          .map((b) => last(b.index))
          .filter(Boolean)
          .join(', ') +
        '. Intervals presume independent points; those of Sobol points and Latin hypercubes are ' +
        'wider than need be.'
      );
    },
    columns: () =>
      found().flatMap((c, b) => {
        if (!c) return [];
        const q = of();
        const columnsOf = (words, triples) =>
          ['', ', low', ', high'].map((end, i) => ({
            title: axisTitle(`${model.bases[b].name}: ${words} of ${q.short_name}${end}`, q.shown),
            values: triples.map((t) => (t ? q.convert(t[i]) : null)),
          }));
        return [
          { title: `${model.bases[b].name}: points`, values: c.n },
          ...columnsOf('mean', c.mean),
          ...c.quantiles.flatMap((triples, i) => columnsOf(`${100 * model.converging_shares[i]} %`, triples)),
        ];
      }),
  };
}
