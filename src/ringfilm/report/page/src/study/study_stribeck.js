// One point a scenario: friction coefficient against Stribeck number, by its share of boundary friction.
import { caseMark } from '../plot/palette.js';
import { airy, frame } from '../plot/plot_frame.js';
import { extent } from '../plot/scales.js';
import { dot, kInk, legend, mark } from '../plot/svg_shapes.js';
import { number, percent } from '../units.js';

/** Steps of the share of boundary friction in the friction power, in per cent. */
const kSteps = [
  { name: '75 to 100 %', from: 75, colour: '#8c2d1a' },
  { name: '50 to 75 %', from: 50, colour: '#d9821f' },
  { name: '25 to 50 %', from: 25, colour: '#7fa8d9' },
  { name: '0 to 25 %', from: 0, colour: '#1f4e9c' },
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
      boundary: 100 * s.boundary_power_share[k],
    }))
    .filter((p) => p.x > 0 && p.y > 0);
  if (all.length < 3) return null;
  const step = (p) => kSteps.find((r) => p.boundary >= r.from) ?? kSteps[kSteps.length - 1];
  const there = kSteps.filter((r) => all.some((p) => step(p) === r));
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
            swatch: (x, y) => mark(b.index, [[x + 14, y]], 4.4, { stroke: kInk }),
          }))
        : [];
      const named = legend(
        [
          ...there.map((r) => ({
            label: `boundary friction ${r.name} of the power`,
            swatch: (x, y) => dot(x + 14, y, 5, `fill="${r.colour}"`),
          })),
          ...bases,
        ],
        width,
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
      const points = all.map((p) =>
        mark(model.several ? p.base : null, [[x(p.x), y(p.y)]], r, {
          fill: step(p).colour,
          opacity: 0.75,
          stroke: model.several && caseMark(p.base) === 'cross' ? step(p).colour : '#fff',
          width: 0.5,
          tooltip:
            `scenario ${p.scenario}, ${model.bases[p.base].name}: S ${number(p.x, 3)}, µ ` +
            `${number(p.y, 3)}, λ ${number(p.film, 3)}, boundary friction ${number(p.boundary, 3)} % of the power`,
        }),
      );
      return { shapes: [...named.shapes, ...shapes, ...points, ...edges], height: named.height + height };
    },
    caption: () =>
      'Each point is one scenario' +
      `${s.of > s.scenario.length ? `, ${all.length} of ${s.of} evenly picked` : ''}: mean ` +
      'friction over mean load against the Stribeck number of mean speed and mean load pressure. ' +
      'Colours: share of boundary friction in the friction power. Scenarios by this share: ' +
      there
        .map(
          (r) =>
            `${r.name}: ` + percent(all.filter((p) => step(p) === r).length / all.length, 0).replace('+', ''),
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
      { title: 'boundary friction in the power [%]', values: all.map((p) => p.boundary) },
    ],
  };
}
