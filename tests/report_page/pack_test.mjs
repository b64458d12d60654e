// The pressures of the drawing of a ring pack, without a browser
// usage: node pack_test.mjs SOURCE_FOLDER_OF_THE_PAGE
import assert from 'node:assert/strict';
import { join } from 'node:path';
import { pathToFileURL } from 'node:url';

const load = (name) => import(pathToFileURL(join(process.argv[2], 'src', name)).href);
const { PackModel } = await load('pack/pack_model.js');
const { pressuresAt } = await load('pack/pack_drawing.js');

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
