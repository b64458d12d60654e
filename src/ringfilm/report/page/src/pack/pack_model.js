// A ring pack of the payload with its cases, and the gas between its rings: computed, or the pressures that are given.
import { kOnlyCase, onCycleAxis } from '../model.js';
import { converted, nearestAngle, wrapped } from '../units.js';

/** Value of an input of a case in SI; null where it is not in use. */
export function inputOf(c, key) {
  return c.inputs.find((entry) => entry.key === key)?.value_si ?? null;
}

/** Name of the piston land below the ring of that index: "land 2" below the first. */
const landBelow = (ring) => 'land 2'.replace('2', ring + 2);

/** Are two lists of numbers the same? */
const alike = (a, b) => a.length === b.length && a.every((v, k) => v === b[k]);

/** Pressures as the films have them: above the first ring, then below each ring; between rails there is no region. */
function givenRegions(cases, numbers) {
  const curve = (c, name) => ({ angle: c.curves.crank_angle, pressure: c.curves[name] });
  const regions = [{ name: 'chamber', ring: null, ...curve(cases[0], 'gas_pressure') }];
  cases.forEach((c, i) => {
    if (numbers[i] === numbers[i + 1]) return;
    const isLast = i + 1 === cases.length;
    regions.push({
      name: isLast ? 'crankcase' : landBelow(i),
      ring: isLast ? null : i,
      ...curve(c, 'crankcase_pressure'),
    });
  });
  return regions;
}

/** The ring that borders a region: of groove n and of the piston land below ring n its index. */
function ringOf(name) {
  const [, kind, number] = /^(groove|land) (\d+)$/.exec(name) ?? [];
  if (!kind) return null;
  return kind === 'groove' ? number - 1 : number - 2;
}

export class PackModel {
  constructor(pack, model) {
    this.pack = pack;
    this.model = model;
    this.cases = model.cases.slice(pack.first_case, pack.first_case + pack.ring_numbers.length);
    const { gas } = pack;
    this.regions = gas
      ? gas.regions.map((region, i) => ({
          name: region.name,
          ring: ringOf(region.name),
          angle: gas.crank_angle,
          pressure: gas.pressure[i],
        }))
      : givenRegions(this.cases, pack.ring_numbers);
  }

  get hasCurves() {
    return this.cases.every((c) => c.curves.crank_angle.length > 1);
  }

  /** The region below a ring: a piston land without a volume is the region below it. */
  regionBelow(ring) {
    const names = this.cases.slice(ring).map((c, i) => landBelow(ring + i));
    const land = names
      .slice(0, -1)
      .map((name) => this.regions.find((one) => one.name === name))
      .find(Boolean);
    return land ?? this.regions[this.regions.length - 1];
  }

  /** The regions whose pressures are not those of the one above. */
  get differentRegions() {
    return this.regions.filter((one, i, all) => i === 0 || !alike(one.pressure, all[i - 1].pressure));
  }

  /** Pressure of a region in bar on the axis of the charts. */
  pressureCurve(region) {
    return onCycleAxis(region.angle, converted(region.pressure, 'bar'));
  }

  /** Pressure of a region [Pa] at a crank angle of the charts. */
  pressureAt(region, angle) {
    return region.pressure[nearestAngle(region.angle, angle)];
  }

  /** Height of a ring above its lower flank [m] at a crank angle; null where it is not computed. */
  positionAt(ring, angle) {
    const { gas } = this.pack;
    const k = gas ? gas.rings.indexOf(this.pack.ring_numbers[ring]) : -1;
    if (k < 0) return null;
    const at = Math.round(((angle % 720) + 720) % 720) % 720;
    return gas.position[k][at] ?? null;
  }

  /** The case that a region of gas is drawn with. */
  seriesOf(region) {
    return region.ring === null ? null : (this.cases[region.ring]?.series ?? null);
  }
}

/** "piston land 2" for the names of the gas path, which count the piston lands alone. */
export function regionWords(name) {
  return name.replace(/^land /, 'piston land ').replace(/^chamber$/, 'cylinder');
}

/** Inputs of the ring of that number under the keys of a case of one ring. */
function inputsOfRing(inputs, ring) {
  const own = `ring.${ring}.`;
  return inputs.flatMap((entry) => {
    if (entry.key.startsWith(own)) return [{ ...entry, key: `ring.${entry.key.slice(own.length)}` }];
    return /^ring\.\d+\./.test(entry.key) ? [] : [entry];
  });
}

/** The gas as the figures of a pack take it: a case for each ring, without a film. */
export function packOfGas(payload) {
  const { gas, inputs } = payload;
  const numbers = gas.paths.flatMap((path) => {
    const [, ring] = /^end gap (\d+)$/.exec(path.name) ?? [];
    return ring ? [Number(ring)] : [];
  });
  const several = numbers.length > 1;
  const cases = numbers.map((n, index) => ({
    name: `ring ${n}`,
    index,
    series: several ? index : kOnlyCase,
    inputs: inputsOfRing(inputs, n),
    curves: { crank_angle: [] },
  }));
  const chamber = gas.regions[0];
  const peakAngle = () => (chamber ? wrapped(chamber.peak_pressure_angle) : null);
  const pack = { first_case: 0, ring_numbers: numbers, gas };
  return new PackModel(pack, { cases, several, peakAngle });
}
