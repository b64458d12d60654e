// The figures that are not drawn over crank angle.
import { angle as shownAngle, converted, display, nearestAngle, number, wrapped } from '../units.js';
import { kRegimes } from '../plot/palette.js';
import { ofEachCycle, valueWithUnit } from './cycle_figures.js';

const kStribeckWindow = 90;

/**
 * Friction coefficient against Stribeck number, in the order of time. Log axis: the dead centre itself, U =
 * 0, has no place.
 */
export function stribeckFigure(model) {
  const friction = display(model.curveQuantity.get('friction_coefficient'));
  const stribeck = display(model.curveQuantity.get('stribeck_number'));
  const series = model.cases.map((c) => {
    const points = c.curves.crank_angle
      .map((angle, k) => ({
        angle: wrapped(angle),
        x: stribeck.convert(c.curves.stribeck_number[k]),
        y: friction.convert(c.curves.friction_coefficient[k]),
      }))
      .filter((p) => Math.abs(p.angle) <= kStribeckWindow)
      .sort((a, b) => a.angle - b.angle)
      .map((p) => (p.x > 0 ? p : { ...p, x: null, y: null }));
    return {
      caseIndex: c.series,
      part: null,
      label: c.name,
      x: points.map((p) => p.x),
      y: points.map((p) => p.y),
      angle: points.map((p) => p.angle),
    };
  });
  return {
    id: 'stribeck',
    title: 'Friction coefficient against Stribeck number',
    paper: 'Fig. 10',
    panels: [
      {
        id: 'stribeck',
        inOrderOfTime: true,
        xScale: 'log',
        fromZero: true,
        yLabel: 'friction coefficient',
        yUnit: friction.unit,
        xLabel: 'Stribeck number η|U|/(pσ)',
        xUnit: stribeck.unit,
        series,
      },
    ],
    caption:
      'From −90° to 90° around firing TDC; arrows give the direction of time, the dead centre lies ' +
      'far out on the left. Highest within ±60° of firing TDC: ' +
      ofEachCycle(model, (c) => valueWithUnit(model, c, 'peak_friction_coefficient_firing')) +
      '. To the left asperities carry more of the load, to the right the oil film.',
  };
}

export function faceFigure(model) {
  const series = model.cases
    .filter((c) => c.fields.x.length > 1 && c.fields.face_height.length === c.fields.x.length)
    .map((c) => ({
      caseIndex: c.series,
      part: null,
      label: c.name,
      x: converted(c.fields.x, 'mm'),
      y: converted(c.fields.face_height, 'um'),
    }));
  if (series.length === 0) return null;
  const edge = (s) =>
    `${number(s.y[0], 3)} µm at the chamber edge, ${number(s.y[s.y.length - 1], 3)} µm at the crankcase edge`;
  return {
    id: 'ring-faces',
    long: true,
    title: series.length > 1 ? 'Ring faces' : 'Ring face',
    paper: 'Fig. 4',
    panels: [
      {
        id: 'face',
        fromZero: true,
        yLabel: 'gap of the unloaded face',
        yUnit: 'µm',
        xLabel: 'distance from the chamber edge',
        xUnit: 'mm',
        series,
        xRange: [Math.min(...series.map((s) => s.x[0])), Math.max(...series.map((s) => s.x[s.x.length - 1]))],
      },
    ],
    caption:
      'Shape of the face as installed, its lowest point at zero. The vertical scale is stretched ' +
      'many times. At the edges: ' +
      (new Set(series.map(edge)).size === 1
        ? edge(series[0])
        : series.map((s) => `${s.label} ${edge(s)}`).join('; ')) +
      '.',
  };
}

/** Oil on the liner ahead of the ring and behind it, stroke by stroke; null where no case follows it. */
export function linerFilmFigure(model) {
  const strokes = [
    ['power', 'power stroke, down'],
    ['exhaust', 'exhaust stroke, up'],
    ['intake', 'intake stroke, down'],
    ['compression', 'compression stroke, up'],
  ];
  const cases = model.cases.filter((c) => c.stroke.film_ahead_power?.length > 1);
  if (cases.length === 0) return null;
  const line = (c, stroke, where, part) => ({
    caseIndex: c.series,
    part,
    label: `${model.cases.length > 1 ? `${c.name}, ` : ''}${where} the ring`,
    x: converted(c.stroke.liner_position, 'mm'),
    y: converted(c.stroke[`film_${where === 'behind' ? 'behind' : 'ahead'}_${stroke}`], 'um'),
  });
  const panel = ([stroke, words]) => {
    const series = cases.flatMap((c) => [
      line(c, stroke, 'ahead of', 'viscous'),
      line(c, stroke, 'behind', null),
    ]);
    return {
      id: `film-${stroke}`,
      fromZero: true,
      yLabel: `oil film, ${words}`,
      yUnit: 'µm',
      xLabel: 'distance of the ring below TDC',
      xUnit: 'mm',
      series,
      xRange: [0, Math.max(...series.map((s) => s.x[s.x.length - 1]))],
    };
  };
  return {
    id: 'film-on-liner',
    title: 'Oil on the liner along the stroke',
    layout: 'row',
    panels: strokes.map(panel),
    caption:
      'What the ring meets on each stroke (dashed) and what it leaves (full line), by its position. Left is TDC, ' +
      'right is BDC. On downstrokes the oil ring replenishes the liner below its reach.',
  };
}

export function wearFigure(model) {
  const series = model.cases
    .filter((c) => c.stroke.liner_position.length > 1)
    .map((c) => ({
      caseIndex: c.series,
      part: null,
      label: c.name,
      x: converted(c.stroke.liner_position, 'mm'),
      y: [...c.stroke.archard_wear_load_density],
    }));
  if (series.length === 0) return null;
  const worst = (s) => {
    const k = s.y.reduce((best, v, i) => (v > s.y[best] ? i : best), 0);
    return `${number(s.y[k], 3)} J/m at ${number(s.x[k], 3)} mm`;
  };
  return {
    id: 'archard-wear-load-stroke',
    title: 'Archard wear load along the stroke',
    panels: [
      {
        id: 'wear',
        fromZero: true,
        yLabel: 'asperity load times sliding, per length of liner',
        yUnit: 'J/m',
        xLabel: 'distance below the TDC position of the ring',
        xUnit: 'mm',
        series,
        xRange: [0, Math.max(...series.map((s) => s.x[s.x.length - 1]))],
      },
    ],
    caption:
      'Where on the liner the asperities rub, summed over one cycle (all four passes). Left is ' +
      'TDC, right is BDC. Most: ' +
      series.map((s) => (series.length > 1 ? `${s.label} ` : '') + worst(s)).join('; ') +
      '.',
  };
}

const kStrokes = [
  ['intake_stroke_energy', 'intake'],
  ['compression_stroke_energy', 'compression'],
  ['power_stroke_energy', 'power'],
  ['exhaust_stroke_energy', 'exhaust'],
];

export function energyFigure(model) {
  if (model.cases.every((c) => !c.complete)) return null;
  const unit = model.value(model.cases[0], 'energy_per_cycle').unit;
  return {
    id: 'energy-by-stroke',
    title: 'Friction energy by stroke, mean power by its cause',
    layout: 'row',
    panels: [
      {
        id: 'strokes',
        bars: true,
        weight: 1.7,
        yLabel: 'friction energy',
        yUnit: unit,
        categories: kStrokes.map(([, label]) => label),
        groups: model.cases.map((c) => ({
          caseIndex: c.series,
          label: c.name,
          stacks: kStrokes.map(([name]) => [{ part: 'total', value: model.value(c, name).value }]),
        })),
      },
      {
        id: 'causes',
        bars: true,
        weight: 1,
        yLabel: 'mean friction power',
        yUnit: model.value(model.cases[0], 'mean_power_loss').unit,
        categories: ['boundary', 'viscous'],
        groups: model.cases.map((c) => ({
          caseIndex: c.series,
          label: c.name,
          stacks: [
            [{ part: 'boundary', value: model.value(c, 'mean_boundary_power').value }],
            [{ part: 'viscous', value: model.value(c, 'mean_viscous_power').value }],
          ],
        })),
      },
    ],
    caption:
      'Energy lost to friction in each stroke, and the mean power of the cycle split into rubbing ' +
      'asperities and sheared oil. Whole cycle: ' +
      ofEachCycle(
        model,
        (c) =>
          `${valueWithUnit(model, c, 'energy_per_cycle')}, ` +
          `${valueWithUnit(model, c, 'mean_power_loss')}`,
      ) +
      '.',
  };
}

/** What the regimes have a share in, with the last words of its values. */
const kSharedOut = [
  ['cycle', 'cycle'],
  ['distance', 'sliding distance'],
  ['energy', 'friction energy'],
];

/** Shares of the regimes in time, sliding distance and friction energy, by the load that asperities carry. */
export function regimeFigure(model) {
  if (model.cases.every((c) => !c.complete)) return null;
  const share = (c, regime, of) => model.value(c, `${regime.value}_${of}_share`);
  const shown = (c, of) =>
    kRegimes.map((regime) => `${regime.name} ${number(share(c, regime, of).value, 2)}\u00a0%`).join(', ');
  return {
    id: 'regimes',
    title: 'Regimes of lubrication',
    panels: [
      {
        id: 'regimes',
        bars: true,
        parts: kRegimes,
        yLabel: 'share',
        yUnit: '%',
        categories: kSharedOut.map(([, label]) => label),
        groups: model.cases.map((c) => ({
          caseIndex: c.series,
          label: c.name,
          stacks: kSharedOut.map(([of]) =>
            kRegimes.map((regime) => ({ part: regime.name, value: share(c, regime, of).value })),
          ),
        })),
      },
    ],
    caption:
      'By the share of asperities in the load that they and the oil carry beyond the gas: boundary above 90\u00a0%, ' +
      'mixed, full film below 1\u00a0% (a convention). Friction energy: ' +
      `${ofEachCycle(model, (c) => shown(c, 'energy'))}.`,
  };
}

/** The panels along the face at one crank angle; every case that has fields near that angle. */
export function fieldFigure(model, angle) {
  const near = (c) => {
    const k = nearestAngle(c.fields.crank_angle, angle);
    return k >= 0 && Math.abs(wrapped(c.fields.crank_angle[k] - angle)) < 1e-6 ? k : -1;
  };
  const shown = model.cases.map((c) => [c, near(c)]).filter(([, k]) => k >= 0);
  const series = (name, unit, part = null) =>
    shown
      .filter(([c]) => c.fields[name].length > 0)
      .map(([c, k]) => ({
        caseIndex: c.series,
        part,
        label: c.name,
        x: converted(c.fields.x, 'mm'),
        y: converted(c.fields[name][k], unit),
      }));
  const widest = Math.max(...shown.map(([c]) => converted(c.fields.x[c.fields.x.length - 1], 'mm')));
  const common = { xLabel: 'distance from the chamber edge', xUnit: 'mm', xRange: [0, widest] };
  return {
    id: 'along-the-face',
    title: `Along the face at ${shownAngle(angle)}°`,
    layout: 'row',
    panels: [
      {
        ...common,
        id: 'pressure',
        fromZero: true,
        yLabel: 'film pressure',
        yUnit: 'bar',
        series: series('film_pressure', 'bar'),
      },
      {
        ...common,
        id: 'film',
        yScale: 'log',
        yLabel: 'film thickness',
        yUnit: 'µm',
        series: series('film_thickness', 'um'),
      },
      {
        ...common,
        id: 'asperities',
        fromZero: true,
        yLabel: 'asperity pressure',
        yUnit: 'bar',
        series: series('asperity_pressure', 'bar', 'boundary'),
      },
      // Where the film is full everywhere at every angle, the picture would show nothing.
      shown.some(([c]) => c.fields.film_content.some((list) => list.some((v) => v !== null && v < 1))) && {
        ...common,
        id: 'film_content',
        yRange: [0, 1.05],
        yLabel: 'liquid share of the gap',
        yUnit: '',
        series: series('film_content', '1'),
      },
    ].filter((panel) => panel && panel.series.length > 0),
    caption:
      `${thinned(model)}Absolute pressure of the oil, film thickness (logarithmic), asperity ` +
      'contact pressure and, where the model has a film content, the liquid share; ' +
      'chamber edge on the left. Where the oil pressure lies flat at the cavitation pressure the ' +
      'film has ruptured.',
  };
}

/** A sentence for a caption where the page has only some of the angles of the result file. */
function thinned(model) {
  const some = model.cases.filter((c) => c.fields.stored_angles > c.fields.crank_angle.length);
  return some.length
    ? `This page carries ${some[0].fields.crank_angle.length} of the ` +
        `${some[0].fields.stored_angles} crank angles stored in the result file. `
    : '';
}

/** So many angles that all cases share are enough to do without those that only some have. */
const kEnoughAngles = 8;

/**
 * Angles with fields, on the axis of the charts: those that all cases share if there are enough, else all.
 */
export function fieldAngles(model) {
  const sets = model.cases
    .map((c) => new Set(c.fields.crank_angle.map(wrapped)))
    .filter((set) => set.size > 0);
  const all = [...new Set(sets.flatMap((set) => [...set]))].sort((a, b) => a - b);
  const shared = all.filter((a) => sets.every((set) => set.has(a)));
  return shared.length >= kEnoughAngles ? shared : all;
}
