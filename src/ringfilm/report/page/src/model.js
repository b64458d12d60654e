// The payload made handy: quantities by name, cases with short names, curves on the axis of the charts.
import { display, shortPath, typeset, wrapped } from './units.js';

/** Titles are divided where a comma, colon or semicolon, or a dash between blanks, ends a part. */
const kDivider = /[,:;]\s+|\s+[–-]\s+/g;

/**
 * Splits titles into the parts that they share and those that distinguish them; null where they do not differ.
 * No part is divided: "ring 1" and "ring 2" keep their word.
 */
export function shortNames(titles) {
  if (new Set(titles).size < titles.length) return null;
  const ends = [...titles[0].matchAll(kDivider)].map((found) => found.index + found[0].length);
  const cut = Math.max(
    0,
    ...ends.filter((end) => titles.every((t) => t.startsWith(titles[0].slice(0, end)))),
  );
  const names = titles.map((t) => t.slice(cut).trim());
  if (names.some((name) => name === '')) return { shared: '', names: titles };
  return { shared: titles[0].slice(0, cut).replace(/[\s,:;–-]+$/, ''), names };
}

/** Inputs of the method or of files, not of the engine: no case is named after them. */
const kNoName = /^(output|solver)\.|\.(file|name)$|file$/;

/** A key as a name of a case has it: "end gap", of a ring of a pack "ring 1 end gap". */
function keyWords(key) {
  const [, ring, own] = /^ring\.(\d+)\.(.*)$/.exec(key) ?? [];
  const words = (own ?? key).split('.').pop().replace(/_/g, ' ');
  return ring ? `ring ${ring} ${words}` : words;
}

/** Cases of one title, named after the inputs in which they differ (at most two), else by their number. */
export function namesByInputs(cases) {
  const shown = (c, key) => c.inputs.find((entry) => entry.key === key)?.shown;
  const keys = [...new Set(cases.flatMap((c) => c.inputs.map((entry) => entry.key)))].filter(
    (key) => !kNoName.test(key),
  );
  const differing = keys.filter((key) => new Set(cases.map((c) => shown(c, key))).size > 1).slice(0, 2);
  const names = cases.map((c) =>
    differing
      .map(
        (key) =>
          `${keyWords(key)} ` +
          (shown(c, key) === undefined ? 'not used' : shownInput({ shown: shown(c, key).replace(/"/g, '') })),
      )
      .join(', '),
  );
  const areDistinct = names.every((name) => name !== '') && new Set(names).size === names.length;
  return areDistinct ? names : names.map((name, i) => (name ? `${i + 1}: ${name}` : `case ${i + 1}`));
}

function named(cases) {
  if (cases.length === 1) return { shared: cases[0].title, names: ['computed'] };
  const titles = cases.map((c) => c.title);
  const byTitle = shortNames(titles);
  if (byTitle) return byTitle;
  return { shared: new Set(titles).size === 1 ? titles[0] : '', names: namesByInputs(cases) };
}

/** The inputs of a ring pack: those that its rings share once, those of a ring by its number. */
export function packInputs(pack, cases) {
  const rings = cases.slice(pack.first_case, pack.first_case + pack.ring_numbers.length);
  const inputs = new Map([['rings', { key: 'rings', shown: String(new Set(pack.ring_numbers).size) }]]);
  const isCommon = ({ key, shown }) =>
    !key.startsWith('ring.') &&
    rings.every((c) => c.inputs.every((one) => one.key !== key || one.shown === shown));
  rings.forEach((c, i) => {
    for (const entry of c.inputs) {
      const key = isCommon(entry)
        ? entry.key
        : `ring.${pack.ring_numbers[i]}.${entry.key.replace(/^ring\./, '')}`;
      if (!inputs.has(key)) inputs.set(key, { ...entry, key });
    }
  });
  return [...inputs.values()];
}

/** Ring packs beside each other, named by their titles or by the inputs in which they differ. */
function namedPacks(packs, cases) {
  const titles = packs.map((pack) => pack.title);
  const byTitle = shortNames(titles);
  if (byTitle) return byTitle;
  const names = namesByInputs(packs.map((pack) => ({ inputs: packInputs(pack, cases) })));
  return { shared: new Set(titles).size === 1 ? titles[0] : '', names };
}

/** The rings of ring packs: each has the name of its pack and its own. @returns as named(), with the names of packs */
function namedRings(packs, cases) {
  const { shared, names: packNames } = namedPacks(packs, cases);
  const names = packs.flatMap((pack, p) => {
    const titles = cases
      .slice(pack.first_case, pack.first_case + pack.ring_numbers.length)
      .map((c) => c.title);
    const own =
      shortNames(titles)?.names ?? pack.ring_numbers.map((number, i) => `face ${i + 1}, ring ${number}`);
    return own.map((name) => `${packNames[p]}, ${titles.length > 1 ? name : 'the ring'}`);
  });
  return { shared, names, packNames };
}

/** Stands for the only case of a page in place of its number: it needs no mark and cannot be hidden. */
export const kOnlyCase = -1;

/** An input as people write it: no quotes around names, micro and degree signs, no folders of one machine. */
export function shownInput(entry) {
  return typeset(shortPath(entry.shown.replace(/^"(.*)"$/, '$1')));
}

/** A text in which the files that a case read have their short paths. */
export function withShortPaths(oneCase, text) {
  return oneCase.files
    .filter((file) => file.path)
    .reduce((out, { path }) => out.split(path).join(shortPath(path)), text);
}

/**
 * The last crank angle of an integration that stopped in its first cycle: that before the gap in the samples.
 * Null where samples cover the whole cycle, or are too uneven to find it.
 */
export function stoppedAt(angles) {
  if (angles.length < 2) return angles[0] ?? null;
  const sorted = [...angles].sort((a, b) => a - b);
  const gaps = sorted
    .map((angle, k) => ({ angle, size: (sorted[k + 1] ?? sorted[0] + 720) - angle }))
    .sort((a, b) => b.size - a.size);
  const usual = gaps[Math.floor(gaps.length / 2)].size;
  return gaps[0].size > 1.5 * usual && gaps[1].size <= 1.5 * usual ? gaps[0].angle : null;
}

export class Model {
  constructor(payload) {
    this.payload = payload;
    this.curveQuantities = payload.curve_quantities;
    const byName = (list) => new Map(list.map((q) => [q.name, q]));
    this.curveQuantity = byName([...payload.curve_quantities, ...payload.unrolled_quantities]);
    this.cycleQuantity = byName([...payload.cycle_quantities, ...payload.unrolled_cycle_quantities]);
    this.derivedQuantity = byName(payload.derived_quantities);
    const packs = payload.packs ?? [];
    const packOf = packs.flatMap((pack, p) => pack.ring_numbers.map(() => p));
    // Several ring packs and nothing else are compared as packs: one colour for each.
    this.comparesPacks = packs.length > 1 && packOf.length === payload.cases.length;
    const { shared, names, packNames } = this.comparesPacks
      ? namedRings(packs, payload.cases)
      : named(payload.cases);
    this.sharedTitle = shared;
    this.several = payload.cases.length > 1;
    this.cases = payload.cases.map((c, index) => ({
      ...c,
      index,
      series: this.comparesPacks ? packOf[index] : this.several ? index : kOnlyCase,
      name: names[index],
      // Sums and extremes of an integration that stopped early are not those of a cycle: they are omitted.
      values: c.complete ? { ...c.values, ...c.unrolled_values } : {},
    }));
    // A pack that stopped early has no sum, either.
    this.allPacks = packs.map((pack, p) => ({ ...pack, name: packNames?.[p] ?? pack.title }));
    this.packs = this.allPacks.filter((pack) => pack.complete);
    /** What readers may hide and show: each has a colour of its own. */
    this.entries = this.comparesPacks
      ? packNames.map((name, series) => ({ series, name }))
      : this.cases.map(({ series, name }) => ({ series, name }));
    this.allCases = payload.cases.length === 2 ? 'both cases' : `all ${payload.cases.length} cases`;
  }

  /** This page with some of its cases. */
  withCases(cases) {
    const { allCases } =
      cases.length === this.cases.length ? this : { allCases: `these ${cases.length} cases` };
    return Object.assign(Object.create(Object.getPrototypeOf(this)), this, {
      cases,
      several: cases.length > 1,
      allCases,
    });
  }

  /** Name, unit and values of one cycle value of one case as shown. */
  value(caseOrValues, name) {
    const quantity = this.cycleQuantity.get(name);
    if (!quantity) return { value: null, unit: '', longName: name };
    const values = caseOrValues.values ?? caseOrValues;
    const { unit, convert } = display(quantity);
    let value = convert(values[name] ?? null);
    if (quantity.unit === 'degree') value = wrapped(value);
    return { value, unit, longName: quantity.long_name };
  }

  /** Discretisation error of a cycle value in its display unit; null without an estimate. */
  error(oneCase, name) {
    const quantity = this.cycleQuantity.get(name);
    if (!quantity || !oneCase.errors) return null;
    return display(quantity).convert(oneCase.errors.values[name] ?? null);
  }

  /** Discretisation errors along a curve, on its axis; null without an estimate or where every error is 0. */
  curveError(oneCase, name) {
    const errors = oneCase.errors?.curves[name];
    if (!errors?.some((v) => v > 0)) return null;
    const { convert } = display(this.curveQuantity.get(name));
    return onCycleAxis(oneCase.curves.crank_angle, errors.map(convert));
  }

  /** One input of a case by key, or undefined. */
  input(oneCase, key) {
    return oneCase.inputs.find((entry) => entry.key === key);
  }

  /** Has the inlet as much oil as the film takes? */
  hasFloodedInlet(oneCase) {
    return (this.input(oneCase, 'film.supply')?.shown ?? 'flooded') === 'flooded';
  }

  isSynthetic(oneCase) {
    return this.input(oneCase, 'gas.trace_origin')?.shown === 'synthetic';
  }

  /** Where the gas pressure above the ring of a case peaks, on the axis of the charts; null where it is constant. */
  peakAngle(oneCase) {
    const pressures = oneCase.curves.gas_pressure ?? [];
    const isConstant = Math.max(...pressures) - Math.min(...pressures) <= 1e-9 * Math.max(...pressures);
    return isConstant ? null : wrapped(oneCase.values.peak_gas_pressure_angle ?? null);
  }

  /** A curve over the cycle in display units: sorted from -360 to 360, null where samples are missing. */
  curve(oneCase, name) {
    const quantity = this.curveQuantity.get(name);
    const { convert } = display(quantity);
    return onCycleAxis(oneCase.curves.crank_angle, oneCase.curves[name].map(convert));
  }
}

/**
 * Steps wider than this many degrees, and three times the usual one, are missing samples: no line is drawn
 * there.
 */
const kWidestStep = 20;

/**
 * Turns angles to -360..360; closes a full cycle at both ends; missing samples become null.
 */
export function onCycleAxis(angles, values) {
  const points = angles.map((angle, k) => [wrapped(angle), values[k]]).sort((a, b) => a[0] - b[0]);
  if (points.length === 0) return { x: [], y: [] };
  const steps = points
    .slice(1)
    .map((p, k) => p[0] - points[k][0])
    .filter((step) => step > 0)
    .sort((a, b) => a - b);
  const usual = steps.length ? steps[Math.floor(steps.length / 2)] : 0;
  const around = points[0][0] + 720 - points[points.length - 1][0];
  if (usual > 0 && around <= 1.5 * usual && points[points.length - 1][0] === 360)
    points.unshift([-360, points[points.length - 1][1]]);
  const x = [];
  const y = [];
  points.forEach(([angle, value], k) => {
    if (k > 0 && angle - points[k - 1][0] > Math.max(3 * usual, kWidestStep)) {
      x.push((angle + points[k - 1][0]) / 2);
      y.push(null);
    }
    x.push(angle);
    y.push(value);
  });
  return { x, y };
}

/** Share of boundary friction in the mean friction power [%]; null without friction. */
export function boundaryPowerShare({ mean_boundary_power: boundary, mean_power_loss: power }) {
  return power > 0 && Number.isFinite(boundary) ? (100 * boundary) / power : null;
}

/** The part of a curve between two angles. */
export function window(curve, low, high) {
  const x = [];
  const y = [];
  curve.x.forEach((angle, k) => {
    if (angle >= low && angle <= high) {
      x.push(angle);
      y.push(curve.y[k]);
    }
  });
  return { x, y };
}
