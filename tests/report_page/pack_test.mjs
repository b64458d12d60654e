// The pressures of the drawing of a ring pack, without a browser
// usage: node pack_test.mjs SOURCE_FOLDER_OF_THE_PAGE
import assert from 'node:assert/strict';
import { join } from 'node:path';
import { pathToFileURL } from 'node:url';

const load = (name) => import(pathToFileURL(join(process.argv[2], 'src', name)).href);
const { Model } = await load('model.js');
const { byFace, comparisonFigures } = await load('pack/pack_comparison.js');
const { PackModel, packOfGas } = await load('pack/pack_model.js');
const { pressuresAt } = await load('pack/pack_drawing.js');

const { sectionCorners, twistAt } = await load('pack/ring_outline.js');

const kAngles = [0, 180, 360, 540];
const constant = (p) => kAngles.map(() => p);

/** A face between two constant pressures. */
const face = (above, below, kind = 'compression') => ({
  inputs: [{ key: 'ring.kind', shown: kind }],
  curves: { crank_angle: kAngles, gas_pressure: constant(above), crankcase_pressure: constant(below) },
});

const packOf = (cases, numbers, gas = null) =>
  new PackModel({ first_case: 0, ring_numbers: numbers, gas }, { cases });

// Given pressures: the rails of the oil ring have the crankcase between them.
{
  const packed = packOf([face(50, 9), face(9, 3), face(3, 1, 'oil'), face(1, 1, 'oil')], [1, 2, 3, 3]);
  assert.deepEqual(
    packed.regions.map((region) => region.name),
    ['chamber', 'land 2', 'land 3', 'crankcase'],
  );
  assert.deepEqual(pressuresAt(packed, 0), [
    { above: 50, groove: 50, below: 9 },
    { above: 9, groove: 9, below: 3 },
    { above: 3, groove: 1, below: 1 },
    { above: 1, groove: 1, below: 1 },
  ]);
}

// Given pressures that are the same on both sides keep their names and are drawn once.
{
  const packed = packOf([face(50, 1), face(1, 1)], [1, 2]);
  assert.equal(packed.regionBelow(0).name, 'land 2');
  assert.equal(packed.regionBelow(1).name, 'crankcase');
  assert.deepEqual(
    packed.differentRegions.map((region) => region.name),
    ['chamber', 'land 2'],
  );
}

// Computed: a piston land without a volume is the region below it.
{
  const gas = {
    crank_angle: kAngles,
    regions: ['chamber', 'groove 1', 'groove 2', 'land 3', 'crankcase'].map((name) => ({ name })),
    pressure: [50, 45, 20, 4, 1].map(constant),
    rings: [],
  };
  const packed = packOf([face(50, 4), face(4, 4), face(4, 1, 'oil')], [1, 2, 3], gas);
  assert.equal(packed.regionBelow(0).name, 'land 3');
  assert.deepEqual(pressuresAt(packed, 0), [
    { above: 50, groove: 45, below: 4 },
    { above: 4, groove: 20, below: 4 },
    { above: 4, groove: 1, below: 1 },
  ]);
}

// Two packs of one title that differ in the end gap of a ring: named by it, one colour a pack, one row a ring.
{
  const gasOf = (blowBy, flow) => ({
    quantities: {
      sums: [
        { name: 'blow_by_per_cycle', unit: 'kg', display_unit: 'mg' },
        { name: 'blow_by_flow', unit: 'm3/s', display_unit: 'l/min' },
      ],
    },
    crank_angle: kAngles,
    blow_by_per_cycle: blowBy,
    blow_by_flow: blowBy,
    regions: ['chamber', 'land 2', 'crankcase'].map((name) => ({ name })),
    pressure: [50, 4, 1].map(constant),
    paths: [{ name: 'end gap 1' }, { name: 'above ring 1' }, { name: 'end gap 2' }],
    flow: [flow, 0, flow].map(constant),
    rings: [1],
    position: [[0, 0, 50e-6, 0]],
    events: [{ ring: 1, crank_angle: 300, event: 'leaves-lower' }],
  });
  const ring = (title, friction, inputs) => ({
    title,
    complete: true,
    inputs: [
      { key: 'operating.speed', shown: '1500 rpm' },
      { key: 'contact.roughness', shown: '0.4 um' },
      ...inputs,
    ],
    curves: { crank_angle: kAngles, total_friction: constant(friction), gas_pressure: constant(1) },
    values: {},
    unrolled_values: {},
  });
  const oil = (rail) => ring(`a pack, oil ring, ${rail} rail`, 20, [{ key: 'ring.kind', shown: 'oil' }]);
  const top = (gap) => ring('a pack, top ring', 10, [{ key: 'ring.end_gap', shown: gap }]);
  const packOfThree = (first_case, gas) => ({
    title: 'a pack',
    complete: true,
    first_case,
    ring_numbers: [1, 2, 2],
    gas,
  });
  const payload = (gaps, packs) => ({
    curve_quantities: [{ name: 'total_friction', unit: 'N', display_unit: 'N', long_name: 'friction' }],
    cycle_quantities: [],
    derived_quantities: [],
    unrolled_quantities: [],
    unrolled_cycle_quantities: [],
    cases: gaps.flatMap((gap) => [top(gap), oil('upper'), oil('lower')]),
    packs,
  });
  const two = new Model(
    payload(['0.4 mm', '0.2 mm'], [packOfThree(0, gasOf(2e-6, 1e-6)), packOfThree(3, gasOf(1e-6, 5e-7))]),
  );
  assert.ok(two.comparesPacks);
  assert.equal(two.sharedTitle, 'a pack');
  assert.deepEqual(two.entries, [
    { series: 0, name: 'ring 1 end gap 0.4 mm' },
    { series: 1, name: 'ring 1 end gap 0.2 mm' },
  ]);
  assert.deepEqual(
    two.cases.map((c) => c.series),
    [0, 0, 0, 1, 1, 1],
  );
  assert.equal(two.cases[0].name, 'ring 1 end gap 0.4 mm, top ring');
  assert.equal(new Set(two.cases.map((c) => c.name)).size, 6);

  const rows = byFace(two, (model) => ({
    id: 'x',
    panels: [
      {
        id: 'x',
        yLabel: 'friction',
        series: model.cases.map((c) => ({ caseIndex: c.series, label: c.name })),
      },
    ],
  }));
  assert.deepEqual(
    rows.panels.map((panel) => panel.yLabel),
    ['ring 1: friction', 'ring 2, rail 1: friction', 'ring 2, rail 2: friction'],
  );
  for (const { series } of rows.panels)
    assert.deepEqual(
      series.map(({ caseIndex, label }) => [caseIndex, label]),
      [
        [0, 'ring 1 end gap 0.4 mm'],
        [1, 'ring 1 end gap 0.2 mm'],
      ],
    );

  const figures = new Map(comparisonFigures(two).map((figure) => [figure.id, figure]));
  assert.deepEqual(
    [...figures.keys()],
    ['pack-friction', 'pack-pressures', 'pack-blow-by', 'pack-positions'],
  );
  assert.deepEqual(
    figures.get('pack-friction').panels[0].series.map((one) => one.y[0]),
    [50, 50], // 10 + 20 + 20
  );
  assert.deepEqual(
    figures.get('pack-blow-by').panels.map((panel) => panel.series.map((one) => one.y[0])),
    [
      [1, 0.5],
      [1, 0.5],
    ],
  );
  assert.match(
    figures.get('pack-blow-by').caption,
    /0\.4 mm 2\.00\u00a0mg per cycle.*0\.2 mm 1\.00\u00a0mg per cycle/,
  );

  // Titles that differ name packs; what all rings have alike is stated once; a pack next to a ring alone is not
  // compared.
  const named = payload(
    ['0.4 mm', '0.4 mm'],
    [packOfThree(0, null), { ...packOfThree(3, null), title: 'another pack' }],
  );
  assert.deepEqual(
    new Model(named).entries.map(({ name }) => name),
    ['a pack', 'another pack'],
  );
  const rough = payload(['0.4 mm', '0.4 mm'], [packOfThree(0, null), packOfThree(3, null)]);
  for (const c of rough.cases.slice(3)) c.inputs[1] = { key: 'contact.roughness', shown: '0.5 um' };
  assert.deepEqual(
    new Model(rough).entries.map(({ name }) => name),
    ['roughness 0.4 µm', 'roughness 0.5 µm'],
  );
  const mixed = payload(['0.4 mm', '0.2 mm'], [packOfThree(0, null)]);
  assert.ok(!new Model(mixed).comparesPacks);

  // The gas alone: a case for each ring, with the inputs of that ring.
  const alone = packOfGas({
    gas: { ...gasOf(2e-6, 1e-6), regions: [{ name: 'chamber', peak_pressure_angle: 700 }] },
    inputs: [
      { key: 'engine.bore', value_si: 0.089 },
      { key: 'ring.1.side_clearance', value_si: 50e-6 },
      { key: 'ring.2.kind', shown: 'oil' },
    ],
  });
  assert.deepEqual(alone.pack.ring_numbers, [1, 2]);
  assert.deepEqual(
    alone.cases.map((c) => c.inputs.map((entry) => entry.key)),
    [
      ['engine.bore', 'ring.side_clearance'],
      ['engine.bore', 'ring.kind'],
    ],
  );
  assert.equal(alone.model.peakAngle(alone.cases[0]), -20);
}

// Sections by their corners, by their form, and none; the twist at the nearest angle.
{
  const numbers = { 'ring.radial_thickness': 3e-3, 'ring.face_width': 1.2e-3, 'ring.step_height': 0.5e-3 };
  const inputs = Object.entries({ ...numbers, 'ring.step_depth': 0.4e-3 }).map(([key, value_si]) => ({
    key,
    value_si,
  }));
  const ring = (key, shown) => ({ inputs: [...inputs, { key, shown }], curves: {} });
  const stated = sectionCorners(ring('ring.section', '[[0 mm, 0 mm], [1.2 mm, 0 mm], [600 um, 3 mm]]'));
  assert.equal(stated.length, 3);
  assert.ok(Math.abs(stated[2][0] - 0.6e-3) < 1e-12 && Math.abs(stated[2][1] - 3e-3) < 1e-12);
  const napier = sectionCorners(ring('ring.section_form', 'napier'));
  assert.equal(Math.max(...napier.map(([axial]) => axial)), 1.7e-3);
  assert.deepEqual(napier[2], [1.2e-3, 0.4e-3]);
  assert.equal(sectionCorners(ring('ring.section_form', 'none')), null);
  assert.equal(sectionCorners({ inputs: [], curves: {} }), null);
  assert.equal(twistAt({ curves: { crank_angle: kAngles, twist: [1, 2, 3, 4] } }, 190), 2);
  assert.equal(twistAt({ curves: { crank_angle: kAngles } }, 190), null);
}
