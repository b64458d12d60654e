// The figures of a ring pack over the engine cycle.
import { crankPanel, pressurePeaks } from '../cycle/cycle_figures.js';
import { onCycleAxis } from '../model.js';
import { angleInWords, converted, number, wrapped } from '../units.js';
import { blowByWords } from './gas_words.js';
import { inputOf, regionWords } from './pack_model.js';

function panel(packed, id, { yLabel, yUnit, ...more }, series) {
  const { model } = packed;
  const peaks = pressurePeaks({
    cases: packed.cases.slice(0, 1),
    several: false,
    peakAngle: (c) => model.peakAngle(c),
  });
  return crankPanel(id, yLabel, yUnit, series, { ...more, peaks });
}

/** Friction of the faces one upon the other: the highest line is that of the pack. */
export function stackedFriction(packed) {
  const { cases, model } = packed;
  const curves = cases.map((c) => model.curve(c, 'total_friction'));
  const [first] = curves;
  if (!first || curves.some((curve) => curve.x.length !== first.x.length)) return null;
  let below = first.x.map(() => 0);
  const series = curves.map((curve, i) => {
    const y = curve.y.map((v, k) => (v === null ? null : v + below[k]));
    const band = { low: below, high: y, words: ['rings above it', 'with this ring'] };
    below = y.map((v) => v ?? 0);
    return { caseIndex: cases[i].series, part: null, label: cases[i].name, x: first.x, y, bands: [band] };
  });
  const peak = below.reduce((best, v, k) => (v > below[best] ? k : best), 0);
  return {
    id: 'pack-friction',
    title: 'Friction of the pack, stacked by ring',
    group: 'cycle',
    panels: [
      panel(
        packed,
        'pack-friction',
        { yLabel: 'friction, rings added up', yUnit: 'N', fromZero: true },
        series,
      ),
    ],
    caption:
      'Boundary plus viscous friction without sign; each band is one ring or rail, the one next to the ' +
      'chamber at the bottom, and the upper line is the whole pack. Its peak: ' +
      `${number(below[peak], 3)} N ${angleInWords(first.x[peak])}.`,
  };
}

/** Pressures between the rings and that of the cylinder. */
export function gasPressures(packed) {
  const series = packed.differentRegions.map((region) => ({
    caseIndex: packed.seriesOf(region),
    part: region.name.startsWith('groove') ? 'viscous' : region.name === 'crankcase' ? 'boundary' : null,
    label: regionWords(region.name),
    ...packed.pressureCurve(region),
  }));
  const { gas } = packed.pack;
  const peaks = gas
    ? gas.regions
        .filter((region) => /^land/.test(region.name))
        .map(
          (region) =>
            `${regionWords(region.name)} ${number(converted(region.peak_pressure, 'bar'), 3)} bar ` +
            angleInWords(region.peak_pressure_angle),
        )
        .join('; ')
    : '';
  return {
    id: 'pack-pressures',
    title: 'Gas pressures in cylinder and ring pack',
    group: 'cycle',
    panels: [
      panel(packed, 'pack-pressures', { yLabel: 'absolute pressure', yUnit: 'bar', yScale: 'log' }, series),
    ],
    caption: gas
      ? 'Computed by the gas path, on a logarithmic axis; grooves dotted. ' +
        `Peaks: ${peaks || 'no piston land has a volume'}. ` +
        'Where a piston land holds more than the cylinder, its ring may leave the lower flank.'
      : 'Pressures as the case gives them, on a logarithmic axis.',
  };
}

/** Gas into the crankcase, and what passes each end gap. */
export function blowBy(packed) {
  const { gas, ring_numbers: numbers } = packed.pack;
  if (!gas) return null;
  const onAxis = (values) => onCycleAxis(gas.crank_angle, converted(values, 'mg/s'));
  const passages = gas.paths
    .map((path, i) => ({ found: /^(end gap|face of ring) (\d+)$/.exec(path.name), i }))
    .filter(({ found }) => found !== null);
  const series = passages.map(({ found: [, kind, n], i }) => ({
    caseIndex: packed.cases[n - 1]?.series ?? null,
    part: kind === 'end gap' ? null : 'viscous',
    label: `${kind === 'end gap' ? 'end gap' : 'face'} of ring ${numbers[n - 1] ?? n}`,
    ...onAxis(gas.flow[i]),
  }));
  const faces = passages.some(({ found }) => found[1] !== 'end gap');
  return {
    id: 'pack-blow-by',
    title: 'Blow-by',
    group: 'cycle',
    panels: [
      panel(
        packed,
        'pack-blow-by',
        { yLabel: 'gas flow to the crankcase', yUnit: 'mg/s', zeroLine: true },
        series,
      ),
    ],
    caption:
      `Mass flow through the end gaps${faces ? ' and, dotted, over the faces where films do not hold the gas' : ''}, ` +
      `positive to the crankcase; that past the last ring is the blow-by, per cylinder: ${blowByWords(gas)}.`,
  };
}

/** Mass shares of fuel and water in the regions of the pack. */
export function gasComposition(packed) {
  const { gas } = packed.pack;
  if (!gas?.fuel_share) return null;
  const fuel = gas.composition[3].name;
  const shares = (columns) =>
    packed.regions.map((region, i) => ({
      caseIndex: packed.seriesOf(region),
      part: region.name.startsWith('groove') ? 'viscous' : region.name === 'crankcase' ? 'boundary' : null,
      label: regionWords(region.name),
      ...onCycleAxis(gas.crank_angle, converted(columns[i], '%')),
    }));
  return {
    id: 'pack-composition',
    title: `${fuel[0].toUpperCase()}${fuel.slice(1)} and water in the gas`,
    group: 'cycle',
    panels: [
      panel(packed, 'pack-fuel', { yLabel: `${fuel}, by mass`, yUnit: '%' }, shares(gas.fuel_share)),
      panel(packed, 'pack-water', { yLabel: 'water, by mass', yUnit: '%' }, shares(gas.water_share)),
    ],
    caption:
      'What the flow carries from the cylinder through the mixed volumes of the pack, grooves dotted; nothing burns, ' +
      'diffuses or condenses there. The crankcase has the share of what reaches it and of its air.',
  };
}

/** Where the rings are in their grooves, with their changes of flank contact. */
export function ringPositions(packed) {
  const { gas } = packed.pack;
  if (!gas || gas.rings.length === 0) return null;
  const clearance = (n) => converted(inputOf(packed.cases[n - 1], 'ring.side_clearance') ?? 0, 'um');
  const series = gas.rings.flatMap((n, i) => {
    const caseIndex = packed.cases[n - 1]?.series ?? null;
    const events = gas.events.filter((event) => event.ring === n);
    const curve = onCycleAxis(gas.crank_angle, converted(gas.position[i], 'um'));
    const points = events
      .map((event) => [wrapped(event.crank_angle), event.event.endsWith('upper') ? clearance(n) : 0])
      .sort((a, b) => a[0] - b[0]);
    const marks = { caseIndex, part: 'points', x: points.map((p) => p[0]), y: points.map((p) => p[1]) };
    return [
      { caseIndex, part: null, label: `ring ${n}`, ...curve },
      ...(points.length ? [{ ...marks, label: `ring ${n} reaches or leaves a flank` }] : []),
    ];
  });
  const widest = Math.max(...gas.rings.map(clearance), 1e-3);
  const still = gas.events.length === 0;
  const flanks = [...new Set(gas.rings.map(clearance))].filter((c) => c > 0);
  return {
    id: 'pack-positions',
    title: 'Rings in their grooves',
    group: 'cycle',
    panels: [
      {
        ...panel(packed, 'pack-positions', { yLabel: 'height above the lower flank', yUnit: 'µm' }, series),
        yRange: [-0.08 * widest, 1.15 * widest],
        yMarks: [
          { at: 0, label: 'on the lower flank' },
          ...flanks.map((at) => ({ at, label: 'on the upper flank' })),
        ],
      },
    ],
    caption: still
      ? 'The rings stay on the lower flanks of their grooves.'
      : `Position of each compression ring in its groove; marks where it reaches or leaves a flank ` +
        `(${gas.events.length} changes in a cycle).`,
  };
}

export function packFigures(packed) {
  return [
    packed.hasCurves ? stackedFriction(packed) : null,
    packed.hasCurves || packed.pack.gas ? gasPressures(packed) : null,
    blowBy(packed),
    gasComposition(packed),
    ringPositions(packed),
  ].filter(Boolean);
}
