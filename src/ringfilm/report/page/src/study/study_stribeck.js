// One point a scenario: friction coefficient against Stribeck number, by the regime of its film.
import { caseMark, markPath } from '../plot/palette.js';
import { airy, extent, frame, legend, mark } from '../plot/plot_frame.js';
import { kInk, px, safe } from '../plot/svg_shapes.js';
import { number, percent } from '../units.js';

/** By the lambda ratio, weighted with the load. */
const kRegimes = [
  { name: 'boundary (λ below 1)', from: -Infinity, to: 1, colour: '#8c2d1a' },
  { name: 'mixed (λ 1 to 3)', from: 1, to: 3, colour: '#e0a21b' },
  { name: 'hydrodynamic (λ above 3)', from: 3, to: Infinity, colour: '#2f6fc4' },
];
/** From so many times on a logarithmic axis shows more. */
const kManyTimes = 15;

export function stribeckFigure(model) {
  const { stribeck: s } = model;
  const all = s.scenario
    .map((scenario, k) => ({
      scenario,
      base: s.base[k],
      x: s.mean_stribeck_number[k],
      y: s.mean_friction_coefficient[k],
      film: s.mean_lambda_ratio[k],
    }))
    .filter((p) => p.x > 0 && p.y > 0);
  if (all.length < 3) return null;
  const regime = (p) => kRegimes.find((r) => p.film >= r.from && p.film < r.to) ?? kRegimes[0];
  const there = kRegimes.filter((r) => all.some((p) => regime(p) === r));
  const [low, high] = extent(all.map((p) => p.y));
  const log = high > kManyTimes * low;
  const span = extent(all.map((p) => p.x));
  return {
    id: 'stribeck',
    title: 'Stribeck curve of all scenarios',
    draw(width) {
      const bases = model.several
        ? model.bases.map((b) => ({
            label: b.name,
            swatch: (x, y) => mark(b.index, x + 14, y, 4.4, { stroke: kInk }),
          }))
        : [];
      const named = legend(
        [
          ...there.map((r) => ({
            label: r.name,
            swatch: (x, y) => `<circle cx="${px(x + 14)}" cy="${px(y)}" r="5" fill="${r.colour}"/>`,
          })),
          ...bases,
        ],
        width,
        0,
      );
      const height = Math.min(460, Math.max(320, 0.5 * width));
      const { x, y, shapes, edges } = frame(
        { x: 0, y: named.height, width, height },
        {
          ...airy(
            all.map((p) => p.x),
            { log: true },
          ),
          label: 'Stribeck number η|U|/(pσ), weighted with the load',
          unit: '',
        },
        {
          ...airy(
            all.map((p) => p.y),
            { log, fromZero: !log },
          ),
          label: 'friction coefficient, weighted with the load',
          unit: '',
        },
      );
      const r = all.length > 500 ? 2.6 : 4;
      const points = all.map(
        (p) =>
          `<path d="${markPath(model.several ? caseMark(p.base) : 'circle', x(p.x), y(p.y), r)}" ` +
          `fill="${regime(p).colour}" fill-opacity="0.75" ` +
          `stroke="${caseMark(p.base) === 'cross' && model.several ? regime(p).colour : '#fff'}" ` +
          'stroke-width="0.5"><title>' +
          safe(
            `scenario ${p.scenario}, ${model.bases[p.base].name}: S ${number(p.x, 3)}, µ ` +
              `${number(p.y, 3)}, λ ${number(p.film, 3)}`,
          ) +
          '</title></path>',
      );
      return { shapes: [...named.shapes, ...shapes, ...points, ...edges], height: named.height + height };
    },
    caption: () =>
      'Each point is one scenario' +
      `${s.of > s.scenario.length ? `, ${all.length} of ${s.of} evenly picked` : ''}: mean ` +
      'friction over mean load against the Stribeck number of mean speed and mean load pressure. ' +
      'Colours: lambda ratio λ = thinnest film over σ, weighted with the load; it is a mean of ' +
      'the cycle, and near the dead centres asperities may carry in any of them. ' +
      there
        .map(
          (r) =>
            `${r.name}: ` +
            percent(all.filter((p) => regime(p) === r).length / all.length, 0).replace('+', ''),
        )
        .join('; ') +
      `. Stribeck number ${number(span[0], 2)} to ${number(span[1], 2)}, friction coefficient ` +
      `${number(low, 2)} to ${number(high, 2)}.`,
    columns: () => [
      { title: 'scenario', values: all.map((p) => p.scenario) },
      { title: 'base', values: all.map((p) => model.bases[p.base].name) },
      { title: 'Stribeck number', values: all.map((p) => p.x) },
      { title: 'friction coefficient', values: all.map((p) => p.y) },
      { title: 'lambda ratio', values: all.map((p) => p.film) },
      { title: 'regime', values: all.map((p) => regime(p).name) },
    ],
  };
}
