// One point a scenario: friction coefficient against Stribeck number, by its regime of lubrication.
import { caseMark, kRegimes } from '../plot/palette.js';
import { airy, frame } from '../plot/plot_frame.js';
import { extent } from '../plot/scales.js';
import { dot, kInk, legend, mark } from '../plot/svg_shapes.js';
import { number, percent } from '../units.js';

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
      regime: kRegimes.find(({ name }) => name === s.regime[k]),
      boundary: 100 * s.boundary_power_share[k],
    }))
    .filter((p) => p.x > 0 && p.y > 0);
  if (all.length < 3) return null;
  const there = kRegimes.filter((regime) => all.some((p) => p.regime === regime));
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
            label: `mostly ${r.name}`,
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
          fill: p.regime.colour,
          opacity: 0.75,
          stroke: model.several && caseMark(p.base) === 'cross' ? p.regime.colour : '#fff',
          width: 0.5,
          tooltip:
            `scenario ${p.scenario}, ${model.bases[p.base].name}: S ${number(p.x, 3)}, µ ` +
            `${number(p.y, 3)}, λ ${number(p.film, 3)}, mostly ${p.regime.name}, boundary friction ` +
            `${number(p.boundary, 3)} % of the power`,
        }),
      );
      return { shapes: [...named.shapes, ...shapes, ...points, ...edges], height: named.height + height };
    },
    caption: () =>
      'Each point is one scenario' +
      `${s.of > s.scenario.length ? `, ${all.length} of ${s.of} evenly picked` : ''}: mean ` +
      'friction over mean load against the Stribeck number of mean speed and mean load pressure. ' +
      'Colours: regime of lubrication by the load share of asperities, boundary or full film where it has more than ' +
      'half of the friction energy, else mixed; not full film where more than half of the power is boundary ' +
      'friction. Scenarios: ' +
      there
        .map(
          (r) =>
            `${r.name} ` + percent(all.filter((p) => p.regime === r).length / all.length, 0).replace('+', ''),
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
      { title: 'regime', values: all.map((p) => p.regime.name) },
      { title: 'boundary friction in the power [%]', values: all.map((p) => p.boundary) },
    ],
  };
}
