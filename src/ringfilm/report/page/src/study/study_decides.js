// Which input decides: indices of Sobol, one-at-a-time sensitivity (tornado), elementary effects of Morris.
import { caseColour } from '../plot/palette.js';
import { frame } from '../plot/plot_frame.js';
import { axisTitle, extent } from '../plot/scales.js';
import {
  fitted,
  kFaint,
  kGrid,
  kInk,
  kLetter,
  legend,
  line,
  mark,
  rectangle,
  rule,
  scaler,
  text,
} from '../plot/svg_shapes.js';
import { baseEntries } from './study_spread.js';
import { number, percent, ticks, tickText, withUnit } from '../units.js';

const kBar = 10;
const kHead = 20;

/**
 * Rows of lying bars with a name above each: @param rows { name, bars: how many, shapes(x, top) },
 * range of the axis.
 */
function lyingRows(rows, axis, width, top) {
  const [left, right] = [12, width - 46];
  const x = scaler(false, axis.low, axis.high, left, right);
  const tops = [top];
  rows.forEach((row) => tops.push(tops[tops.length - 1] + kHead + row.bars * kBar + 6));
  const bottom = tops[rows.length] + 4;
  const onX = ticks(axis.low, axis.high, Math.max(2, (right - left) / 75));
  const out = onX.values.flatMap((v) => [
    rule(x(v), top, x(v), bottom, kGrid),
    text(x(v), bottom + 16, tickText(v, onX.step), { anchor: 'middle' }),
  ]);
  out.push(
    text((left + right) / 2, bottom + 34, axisTitle(axis.label, axis.unit), {
      anchor: 'middle',
      fill: kFaint,
    }),
  );
  rows.forEach((row, i) => {
    const y = tops[i];
    out.push(
      text(left, y + 14, fitted(row.name, right - left), { halo: '#fff' }),
      ...row.shapes(x, y + kHead),
    );
  });
  out.push(rule(x(axis.zero ?? axis.low), top, x(axis.zero ?? axis.low), bottom, kInk));
  return { shapes: out, bottom: bottom + 44 };
}

const kSolid = (colour) => `fill="${colour}"`;
const kLight = (colour) => `fill="${colour}" fill-opacity="0.3" stroke="${colour}" stroke-width="0.8"`;
const sample = (look) => (x, y) => rectangle(x + 2, y - 5, 24, 9, look(kInk));

/** Names of the bases and of the two looks of the bars, above rows of lying bars. */
function namedRows(model, light, solid, rows, axis, width) {
  const named = legend([...baseEntries(model), light, solid], width);
  const drawn = lyingRows(rows, axis, width, named.height + 6);
  return { shapes: [...named.shapes, ...drawn.shapes], height: drawn.bottom };
}

/** A bar from zero to a value. */
const lyingBar = (x, value, y, height, look, words = '') =>
  rectangle(Math.min(x(0), x(value)), y, Math.max(0.8, Math.abs(x(value) - x(0))), height, look, words);

/** A confidence interval across a bar. */
const interval = (low, high, y) => [
  rule(low, y + kBar / 2, high, y + kBar / 2, kInk, 1.2),
  ...[low, high].map((end) => rule(end, y + 1, end, y + kBar - 1, kInk, 1.2)),
];

/** The name of a base in front of a text on it, where there are several. */
const ofBase = (model, b) => (model.several ? `${model.bases[b].name} ` : '');

export function indicesFigure(model, chosen) {
  const all = () => model.indices[chosen.value] ?? [];
  const order = () =>
    model.groups
      .map((name, g) => ({ name, g, size: Math.max(...all().map((found) => found?.total[g]?.[0] ?? 0)) }))
      .sort((a, b) => b.size - a.size);
  return {
    id: 'sobol',
    title: 'Which input decides: shares in the variance',
    half: true,
    draw(width) {
      const ends = extent(
        all().flatMap((found) => (found ? [...found.first, ...found.total].filter(Boolean).flat() : [])),
      ) ?? [0, 1];
      const axis = {
        low: Math.min(0, Math.max(ends[0], -0.2)),
        high: Math.max(1, Math.min(ends[1], 1.3)),
        zero: 0,
        label: 'share in the variance',
        unit: '',
      };
      const rows = order().map(({ name, g }) => ({
        name,
        bars: 2 * all().filter((found) => found?.total[g]).length,
        shapes: (x, top) =>
          all()
            .map((found, b) => ({ found, b }))
            .filter(({ found }) => found?.total[g])
            .flatMap(({ found, b }, place) =>
              ['first', 'total'].flatMap((which, i) => {
                const [value, low, high] = found[which][g];
                const y = top + (2 * place + i) * kBar;
                const inside = (v) => x(Math.min(axis.high, Math.max(axis.low, v)));
                const words =
                  `${model.bases[b].name}, ${name}: ${which} index ${number(value, 2)} ` +
                  `(${number(low, 2)} to ${number(high, 2)})`;
                return [
                  lyingBar(x, value, y, kBar - 2, (i ? kLight : kSolid)(caseColour(b)), words),
                  ...interval(inside(low), inside(high), y - 1),
                ];
              }),
            ),
      }));
      return namedRows(
        model,
        { label: 'alone (first index)', swatch: sample(kSolid) },
        { label: 'with interactions (total)', swatch: sample(kLight) },
        rows,
        axis,
        width,
      );
    },
    caption() {
      const q = model.quantity.get(chosen.value);
      const first = all().find(Boolean);
      if (!first) return `No indices of ${q.short_name}: too few rows, or it does not vary.`;
      const [strongest] = order();
      const rest = model.bases
        .map((b) =>
          all()[b.index] ? 1 - all()[b.index].first.reduce((sum, t) => sum + (t?.[0] ?? 0), 0) : null,
        )
        .filter((v) => v !== null);
      return `Sobol indices of ${q.short_name} from ${first.rows} rows${
        first.omitted
          ? ` (${first.omitted} with a \
scenario that was not solved omitted)`
          : ''
      }; thin lines: 95 % confidence intervals by the bootstrap. First index: share of the variance that would go if \
the factor were known; total index: what would stay if all others were. Strongest: ${strongest.name}. What no factor \
does alone: ${rest.map((v) => percent(Math.max(0, v), 0).replace(/[+±]/, '')).join(', ')} of the \
variance.${model.groups.length < model.factors.length ? ' Correlated factors share one index.' : ''}`;
    },
    columns: () => [
      { title: 'factor', values: model.groups },
      ...all().flatMap((found, b) =>
        found
          ? ['first', 'total'].flatMap((which) =>
              ['', ', low', ', high'].map((end, i) => ({
                title: `${model.bases[b].name}: ${which} index${end}`,
                values: found[which].map((t) => t?.[i] ?? null),
              })),
            )
          : [],
      ),
    ],
  };
}

/** Tornado: where the value lies when one factor is low and when it is high. */
export function sensitivityFigure(model, chosen) {
  const q = () => model.quantity.get(chosen.value);
  const all = () => model.sensitivities[chosen.value] ?? [];
  const relative = () => all().every((s) => s.middle) && all().length > 0;
  const change = (s, v) =>
    relative() ? (100 * (v - s.middle)) / Math.abs(s.middle) : q().convert(v - s.middle);
  const order = () =>
    model.factors
      .map((f) => ({
        f,
        ends: all().map((s) => (s.factors[f.index] ? s.factors[f.index].map((v) => change(s, v)) : null)),
      }))
      .filter(({ ends }) => ends.some(Boolean))
      .map((row) => ({
        ...row,
        size: Math.max(
          ...row.ends.filter(Boolean).map(([a, b]) => Math.max(Math.abs(a), Math.abs(b), Math.abs(a - b))),
        ),
      }))
      .sort((a, b) => b.size - a.size);
  return {
    id: 'tornado',
    title: 'Which input moves it how far',
    half: true,
    draw(width) {
      const found = extent(order().flatMap(({ ends }) => ends.filter(Boolean).flat())) ?? [-1, 1];
      const air = 0.12 * (Math.max(0, found[1]) - Math.min(0, found[0]) || 1);
      const axis = {
        low: Math.min(0, found[0]) - air,
        high: Math.max(0, found[1]) + air,
        zero: 0,
        label: `change of ${q().short_name}`,
        unit: relative() ? '%' : q().shown,
      };
      const rows = order().map(({ f, ends }) => ({
        name: f.name,
        bars: 1.3 * ends.filter(Boolean).length,
        shapes: (x, top) =>
          ends
            .map((pair, b) => ({ pair, b }))
            .filter(({ pair }) => pair)
            .flatMap(({ pair, b }, place) => {
              const y = top + place * (kBar + 3);
              const isOneSided = Math.sign(pair[0]) === Math.sign(pair[1]);
              const label = (v) => (relative() ? percent(v / 100) : number(v, 3));
              const bar = (v, high) => {
                const words = relative() ? percent(v / 100) : withUnit(v, q().shown);
                const within = high && isOneSided ? 3 : 0;
                return lyingBar(
                  x,
                  v,
                  y + within,
                  kBar - 2 * within,
                  (high ? kSolid : kLight)(caseColour(b)),
                  `${model.bases[b].name}, ${f.name} ${high ? 'high' : 'low'}: ${words}`,
                );
              };
              const [least, most] = [Math.min(...pair, 0), Math.max(...pair, 0)];
              return [
                bar(pair[0], false),
                bar(pair[1], true),
                text(x(most) + 4, y + 9, label(most), { size: 10.5, halo: '#fff' }),
                ...(least < 0
                  ? [text(x(least) - 4, y + 9, label(least), { size: 10.5, anchor: 'end', halo: '#fff' })]
                  : []),
              ];
            }),
      }));
      return namedRows(
        model,
        { label: 'factor low', swatch: sample(kLight) },
        { label: 'factor high', swatch: sample(kSolid) },
        rows,
        axis,
        width,
      );
    },
    caption: () =>
      model.has_sample
        ? `Median of ${q().short_name} over the scenarios with the lowest third of each factor (light) and with its \
highest third (solid)${
            model.factors.some((f) => f.listed)
              ? ', of listed values and choices with the lowest (first) \
and the highest (last) of them,'
              : ','
          } against the median of all (${all()
            .map((s, b) => `${ofBase(model, b)}${model.valueText(q(), s.middle)}`)
            .join(
              ', ',
            )}); all other factors vary as they do. Of correlated factors it holds what comes with them.`
        : `${q().short_name} with each factor alone at its lowest value (light) and at its highest (solid), against \
the scenario that moves none (${all()
            .map((s, b) => `${ofBase(model, b)}${model.valueText(q(), s.middle)}`)
            .join(', ')}); a distribution at its quantiles of 5 % and 95 %.`,
    columns: () => [
      { title: 'factor', values: model.factors.map((f) => f.name) },
      ...all().flatMap((s, b) =>
        ['low', 'high'].map((end, i) => ({
          title: axisTitle(`${model.bases[b].name}: ${q().short_name}, factor ${end}`, q().shown),
          values: model.factors.map((f) => (s.factors[f.index] ? q().convert(s.factors[f.index][i]) : null)),
        })),
      ),
    ],
  };
}

/**
 * Factors of one base, strongest first: { factor, rank, mean_absolute, half_width, deviation, mean }
 * in shown units.
 */
function rankedEffects(model, chosen, base) {
  const q = model.quantity.get(chosen.value);
  const effects = model.effects[chosen.value]?.[base] ?? [];
  const inUnit = (e) =>
    Object.fromEntries(
      ['mean', 'mean_absolute', 'half_width', 'deviation'].map((key) => [key, q.convert(e[key])]),
    );
  return effects
    .map((e, j) =>
      e ? { ...inUnit(e), count: e.count, omitted: e.omitted, factor: model.factors[j] } : null,
    )
    .filter(Boolean)
    .sort((a, b) => b.mean_absolute - a.mean_absolute)
    .map((e, i) => ({ ...e, rank: i + 1 }));
}

export function effectsFigure(model, chosen) {
  const q = () => model.quantity.get(chosen.value);
  const list = () => rankedEffects(model, chosen, chosen.base);
  return {
    id: 'morris',
    title: 'Screening: effects and how they vary',
    half: true,
    draw(width) {
      const effects = list();
      const most = 1.12 * Math.max(1e-300, ...effects.map((e) => e.mean_absolute + e.half_width));
      const height = Math.min(420, Math.max(300, 0.7 * width));
      const { plot, x, y, shapes, edges } = frame(
        { x: 0, y: 0, width, height },
        { low: 0, high: most, label: 'µ*: mean size of the effect', unit: q().shown },
        {
          low: 0,
          high: 1.12 * Math.max(1e-300, ...effects.map((e) => e.deviation)),
          label: 'σ: how much it varies',
          unit: q().shown,
        },
      );
      const out = [...shapes];
      const top = Math.min(most, 1.12 * Math.max(...effects.map((e) => e.deviation)));
      out.push(
        line(
          [
            [x(0), y(0)],
            [x(top), y(top)],
          ],
          kFaint,
          { width: 1, dash: '4 3' },
        ),
      );
      const taken = effects.map((e) => [
        x(e.mean_absolute) - 6,
        y(e.deviation) - 6,
        x(e.mean_absolute) + 6,
        y(e.deviation) + 6,
      ]);
      const free = (box) =>
        box[0] >= plot.left + 2 &&
        box[2] <= plot.right + 8 &&
        box[1] >= plot.top - 8 &&
        box[3] <= plot.bottom - 1 &&
        taken.every((t) => box[2] < t[0] || box[0] > t[2] || box[3] < t[1] || box[1] > t[3]);
      for (const e of effects) {
        const at = y(e.deviation);
        out.push(
          rule(
            x(Math.max(0, e.mean_absolute - e.half_width)),
            at,
            x(e.mean_absolute + e.half_width),
            at,
            caseColour(chosen.base),
            1.2,
          ),
          mark(chosen.base, [[x(e.mean_absolute), at]], 4.2, {
            fill: caseColour(chosen.base),
            tooltip:
              `${e.factor.name}: µ* ${withUnit(e.mean_absolute, q().shown)} ± ${number(e.half_width, 2)}, ` +
              `σ ${number(e.deviation)}`,
          }),
        );
      }
      for (const e of effects) {
        const at = [x(e.mean_absolute), y(e.deviation)];
        for (const words of [e.factor.name, String(e.rank)]) {
          const w = kLetter * words.length;
          const places = [
            [at[0] + 8, at[1] - 7],
            [at[0] - 8 - w, at[1] - 7],
            [at[0] + 8, at[1] + 14],
            [at[0] - 8 - w, at[1] + 14],
            [at[0] - w / 2, at[1] - 14],
            [at[0] - w / 2, at[1] + 22],
          ];
          const place = places.find(([px0, py0]) => free([px0, py0 - 10, px0 + w, py0 + 2]));
          if (!place) continue;
          taken.push([place[0], place[1] - 10, place[0] + w, place[1] + 2]);
          out.push(text(place[0], place[1], words, { halo: '#fff' }));
          break;
        }
      }
      return { shapes: [...out, ...edges], height };
    },
    caption: () =>
      `Elementary effects on ${q().short_name}${model.several ? ` of ${model.bases[chosen.base].name}` : ''} over the \
whole range of each factor, of ${Math.max(0, ...list().map((e) => e.count))} trajectories; thin lines: 95 % \
confidence interval of µ*. Far right: the factor matters. Above the dashed line (σ = µ*): its effect is curved or \
depends on the others. Factors without room for their name have their rank.`,
    columns: () => effectColumns(model, chosen, list()),
  };
}

export function rankingFigure(model, chosen) {
  const q = () => model.quantity.get(chosen.value);
  const list = () => rankedEffects(model, chosen, chosen.base);
  return {
    id: 'ranking',
    title: 'Screening: the ranking',
    half: true,
    draw(width) {
      const effects = list();
      const axis = {
        low: 0,
        high: 1.05 * Math.max(1e-300, ...effects.map((e) => e.mean_absolute + e.half_width)),
        label: 'µ*: mean size of the effect',
        unit: q().shown,
      };
      const rows = effects.map((e) => ({
        name: `${e.rank}  ${e.factor.name}`,
        bars: 1,
        shapes: (x, y) => {
          const [low, high] = [
            x(Math.max(0, e.mean_absolute - e.half_width)),
            x(e.mean_absolute + e.half_width),
          ];
          return [
            lyingBar(x, e.mean_absolute, y, kBar, kSolid(caseColour(chosen.base))),
            ...interval(low, high, y),
            text(
              high + 5,
              y + 9,
              `${number(e.mean_absolute, 3)} \
${Math.abs(e.mean) > 0.9 * e.mean_absolute ? (e.mean > 0 ? '↑' : '↓') : '↕'}`,
              { size: 11, halo: '#fff' },
            ),
          ];
        },
      }));
      const drawn = lyingRows(rows, axis, width, 4);
      return { shapes: drawn.shapes, height: drawn.bottom };
    },
    caption: () =>
      `µ* with its 95 % confidence interval, strongest first. ↑: ${q().short_name} rises with the factor, ↓: it \
falls, ↕: both, depending on the values of the factors. Intervals that overlap leave the order open.`,
    columns: () => effectColumns(model, chosen, list()),
  };
}

function effectColumns(model, chosen, effects) {
  const q = model.quantity.get(chosen.value);
  return [
    { title: 'factor', values: effects.map((e) => e.factor.name) },
    ...[
      ['mean_absolute', 'mu*'],
      ['half_width', 'half of the 95 % interval of mu*'],
      ['mean', 'mu'],
      ['deviation', 'sigma'],
    ].map(([key, words]) => ({
      title: axisTitle(`${words} of ${q.short_name}`, q.shown),
      values: effects.map((e) => e[key]),
    })),
    { title: 'steps', values: effects.map((e) => e.count) },
  ];
}
