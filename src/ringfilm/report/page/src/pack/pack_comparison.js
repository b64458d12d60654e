// Several ring packs beside each other: one colour for each pack, one row for each ring.
import { crankPanel } from '../cycle/cycle_figures.js';
import { onCycleAxis } from '../model.js';
import { right, table } from '../tables.js';
import { converted, display, number } from '../units.js';
import { blowByWords, gasSum, kBlowBy, kStandard } from './gas_words.js';
import { PackModel, regionWords } from './pack_model.js';

/** The packs of a page that compares them, each with its cases and its colour. */
export function comparedPacks(model) {
  return model.allPacks.map((pack, series) => ({
    name: pack.name,
    series,
    pack,
    packed: new PackModel(pack, model),
  }));
}

/** "ring 2", of an oil ring of several rails "ring 3, rail 1", for the faces of a pack from the chamber down. */
function faceNames({ ring_numbers: numbers }) {
  return numbers.map((n, i) => {
    const rails = numbers.filter((one) => one === n).length;
    return rails === 1 ? `ring ${n}` : `ring ${n}, rail ${i - numbers.indexOf(n) + 1}`;
  });
}

/** The faces of all packs by their names: a model of each with one case for each pack that has it. */
function faceModels(model) {
  const names = [...new Set(model.allPacks.flatMap(faceNames))];
  return names.map((name) => {
    const cases = model.allPacks.flatMap((pack) => {
      const at = faceNames(pack).indexOf(name);
      return at < 0 ? [] : [{ ...model.cases[pack.first_case + at], name: pack.name }];
    });
    return { name, model: Object.assign(model.withCases(cases), { several: true, allCases: 'all packs' }) };
  });
}

/**
 * A figure of the cases of a page; of compared packs it has one row a ring, or all rings among its bars.
 * @param make makes the figure of a model, or null
 */
export function byFace(model, make) {
  if (!model.comparesPacks) return make(model);
  const whole = make(model);
  if (!whole || whole.panels.some((panel) => panel.bars)) return whole;
  const panels = faceModels(model).flatMap(({ name, model: own }, i) =>
    (make(own)?.panels ?? []).map((panel) => ({
      ...panel,
      id: `${panel.id}-${i + 1}`,
      yLabel: `${name}: ${panel.yLabel}`,
    })),
  );
  return { ...whole, panels };
}

/** One row a ring and what the packs come to, one column a pack. */
export function comparisonTable(model) {
  const packs = comparedPacks(model);
  const unitOf = (name) => model.value({ values: {} }, name).unit;
  const shown = (values, name) => (values ? number(model.value({ values }, name).value, 4) : '–');
  const rings = [...new Set(packs.flatMap(({ pack }) => pack.by_ring.map(({ ring }) => ring)))];
  const ofRing = (pack, ring) =>
    pack.complete ? pack.by_ring.find((one) => one.ring === ring)?.values : null;
  const row = (what, cell) => [what, ...packs.map(({ pack }) => right(cell(pack)))];
  const someGas = packs.find(({ pack }) => pack.gas)?.pack.gas;
  const someOil = packs.find(({ pack }) => pack.oil)?.pack.oil;
  const ofGas = (words, name) =>
    someGas
      ? [
          row(words(gasSum(someGas, name).unit), ({ gas }) =>
            gas ? number(gasSum(gas, name).value, 4) : '–',
          ),
        ]
      : [];
  const power = `mean friction power [${unitOf('mean_power_loss')}]`;
  const rows = [
    ...rings.map((ring) =>
      row(`ring ${ring}, ${power}`, (pack) => shown(ofRing(pack, ring), 'mean_power_loss')),
    ),
    row(`pack, ${power}`, (pack) => shown(pack.complete && pack.values, 'mean_power_loss')),
    row(`pack, friction mean effective pressure [${unitOf('fmep')}]`, (pack) =>
      shown(pack.complete && pack.values, 'fmep'),
    ),
    ...ofGas((unit) => `blow-by [${unit} per cycle and cylinder]`, kBlowBy.mass),
    ...ofGas((unit) => `blow-by [${unit} per cylinder, ${kStandard}]`, kBlowBy.flow),
    ...(someOil?.quantities ?? []).map((quantity) => {
      const { unit, convert } = display(quantity);
      return row(`${quantity.long_name} [${unit}]`, ({ oil }) =>
        oil ? number(convert(oil[quantity.name]), 3) : '–',
      );
    }),
  ];
  return table('Friction and blow-by of the packs', ['what', ...packs.map(({ name }) => right(name))], rows, {
    folds: true,
  });
}

const line = ({ name, series }, curve) => ({ caseIndex: series, part: null, label: name, ...curve });

/** Friction of all faces of each pack. */
function packFriction(packs, model) {
  const series = packs.flatMap((one) => {
    const curves = one.packed.cases.map((c) => model.curve(c, 'total_friction'));
    const [first] = curves;
    if (!first?.x.length || curves.some((curve) => curve.x.length !== first.x.length)) return [];
    const y = first.x.map((_, k) =>
      curves.some((curve) => curve.y[k] === null) ? null : curves.reduce((sum, curve) => sum + curve.y[k], 0),
    );
    return [line(one, { x: first.x, y })];
  });
  if (series.length === 0) return null;
  return {
    id: 'pack-friction',
    title: 'Friction of each pack',
    group: 'cycle',
    panels: [crankPanel('pack-friction', 'friction, all rings', 'N', series, { fromZero: true })],
    caption: 'Boundary plus viscous friction without sign, the rings and rails of a pack added up.',
  };
}

/** Names that any of the packs has, in the order of the first that has them. */
const namesOf = (packs, names) => [
  ...new Set(packs.flatMap(({ pack }) => (pack.gas ? names(pack.gas) : []))),
];

function landPressures(packs) {
  const lands = namesOf(packs, (gas) =>
    gas.regions.map((region) => region.name).filter((name) => /^land/.test(name)),
  );
  if (lands.length === 0) return null;
  return {
    id: 'pack-pressures',
    title: 'Gas pressures on the piston lands',
    group: 'cycle',
    panels: lands.map((name) =>
      crankPanel(
        `pack-${name.replace(' ', '-')}`,
        `${regionWords(name)}, absolute pressure`,
        'bar',
        packs.flatMap((one) => {
          const region = one.packed.regions.find((r) => r.name === name);
          return region ? [line(one, one.packed.pressureCurve(region))] : [];
        }),
        { fromZero: true },
      ),
    ),
    caption: 'Computed by the gas path; piston lands count from the chamber, 2 is below the first ring.',
  };
}

function packBlowBy(packs) {
  const gaps = namesOf(packs, (gas) =>
    gas.paths.map((path) => path.name).filter((name) => /^(end gap|face of ring) \d+$/.test(name)),
  );
  if (gaps.length === 0) return null;
  const flow = ({ gas }, i) => onCycleAxis(gas.crank_angle, converted(gas.flow[i], 'mg/s'));
  return {
    id: 'pack-blow-by',
    title: 'Blow-by',
    group: 'cycle',
    panels: gaps.map((name) =>
      crankPanel(
        `pack-${name.replaceAll(' ', '-')}`,
        `${name.replace('end gap', 'end gap of ring')}, gas flow to the crankcase`,
        'mg/s',
        packs.flatMap((one) => {
          const i = one.pack.gas?.paths.findIndex((path) => path.name === name) ?? -1;
          return i < 0 ? [] : [line(one, flow(one.pack, i))];
        }),
        { zeroLine: true },
      ),
    ),
    caption:
      'Mass flow past each ring, positive to the crankcase; that past the last ring is the blow-by of a cylinder: ' +
      packs
        .filter(({ pack }) => pack.gas)
        .map(({ name, pack }) => `${name} ${blowByWords(pack.gas)}`)
        .join('; ') +
      '.',
  };
}

function packPositions(packs) {
  const moves = (gas, n) => gas.events.some((event) => event.ring === n);
  const rings = namesOf(packs, (gas) => gas.rings.filter((n) => moves(gas, n)));
  if (rings.length === 0) return null;
  return {
    id: 'pack-positions',
    title: 'Rings in their grooves',
    group: 'cycle',
    panels: rings.map((n) =>
      crankPanel(
        `pack-position-${n}`,
        `ring ${n}, height above the lower flank`,
        'µm',
        packs.flatMap((one) => {
          const i = one.pack.gas?.rings.indexOf(n) ?? -1;
          if (i < 0) return [];
          const { gas } = one.pack;
          return [line(one, onCycleAxis(gas.crank_angle, converted(gas.position[i], 'um')))];
        }),
        { fromZero: true },
      ),
    ),
    caption: 'Positions of the rings that leave the lower flanks of their grooves, which are at 0.',
  };
}

/** The figures of the section on the packs. */
export function comparisonFigures(model) {
  const packs = comparedPacks(model);
  return [packFriction(packs, model), landPressures(packs), packBlowBy(packs), packPositions(packs)].filter(
    (figure) => figure && figure.panels.every((one) => one.series.length > 0),
  );
}
