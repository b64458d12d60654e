// The indicator diagram: cylinder pressure over volume, both logarithmic.
import { converted, display, number, wrapped } from '../units.js';

/** Where the case states no compression ratio; assumed. */
const kAssumedRatio = 12;
/** Curves that differ by less than this share are drawn once. */
const kSame = 1e-6;

/** Volumes above the piston at the crank angles of a case [cm3]; null where an input of the engine is missing. */
function volumes(model, c) {
  const value = (key) => model.input(c, key)?.value_si ?? null;
  const [bore, stroke, rod] = ['bore', 'stroke', 'connecting_rod_length'].map((key) =>
    value(`engine.${key}`),
  );
  if (![bore, stroke, rod].every((v) => v > 0)) return null;
  const stated = value('gas.compression_ratio');
  const clearance = stroke / ((stated ?? kAssumedRatio) - 1);
  const r = stroke / 2;
  const volume = (degree) => {
    const angle = (degree * Math.PI) / 180;
    const below = r + rod - r * Math.cos(angle) - Math.sqrt(rod * rod - (r * Math.sin(angle)) ** 2);
    return ((Math.PI * bore * bore) / 4) * (clearance + below) * 1e6;
  };
  return { isAssumed: stated === null, volume: c.curves.crank_angle.map(volume) };
}

/** Has the ring of a case the pressure of the cylinder above it? */
function isOfCylinder(model, c) {
  if (model.input(c, 'ring.pressure_above') !== undefined) return false;
  return model.allPacks.every(
    ({ first_case: first, ring_numbers: rings }) => c.index <= first || c.index >= first + rings.length,
  );
}

/** Slope of ln p over ln V between two crank angles, by least squares. */
export function polytropicIndex(angles, volume, pressure, from, to) {
  let [n, x, y, xx, xy] = [0, 0, 0, 0, 0];
  angles.forEach((angle, k) => {
    const at = wrapped(angle);
    if (at < from || at > to || !(pressure[k] > 0)) return;
    const [u, v] = [-Math.log(volume[k]), Math.log(pressure[k])];
    n += 1;
    x += u;
    y += v;
    xx += u * u;
    xy += u * v;
  });
  const variance = n * xx - x * x;
  return n > 2 && variance > 0 ? (n * xy - x * y) / variance : null;
}

/** Null where no case shows a compression, or an input of the engine is missing. */
export function indicatorFigure(model) {
  const pressure = display(model.curveQuantity.get('gas_pressure'));
  const drawn = [];
  for (const c of model.cases) {
    const p = c.curves.gas_pressure ?? [];
    if (p.length < 2 || !isOfCylinder(model, c) || Math.max(...p) < 2 * Math.min(...p)) continue;
    const geometry = volumes(model, c);
    if (geometry === null) continue;
    const isSame = (other) =>
      other.p.length === p.length &&
      other.p.every((v, k) => Math.abs(v - p[k]) <= kSame * p[k]) &&
      other.volume.every((v, k) => Math.abs(v - geometry.volume[k]) <= kSame * v);
    const known = drawn.find(isSame);
    if (known) known.isShared = true;
    else drawn.push({ c, p, ...geometry, isShared: false });
  }
  if (drawn.length === 0) return null;
  const closed = (list) => [...list, list[0]];
  const series = drawn.map(({ c, p, volume, isShared }) => ({
    caseIndex: isShared && drawn.length === 1 ? null : c.series,
    part: null,
    label: isShared && drawn.length === 1 ? model.allCases : c.name,
    x: closed(volume),
    y: closed(p).map(pressure.convert),
    angle: closed(c.curves.crank_angle),
  }));
  const indices = drawn.map(({ c, p, volume }) => {
    const index = polytropicIndex(c.curves.crank_angle, volume, p, -90, -45);
    return index === null ? null : `${drawn.length > 1 ? `${c.name} ` : ''}${number(index, 3)}`;
  });
  const imep = drawn
    .filter(({ c }) => c.derived?.imep !== undefined)
    .map(
      ({ c }) => `${drawn.length > 1 ? `${c.name} ` : ''}${number(converted(c.derived.imep, 'bar'), 4)} bar`,
    );
  return {
    id: 'indicator-diagram',
    long: true,
    title: 'Indicator diagram, ln p over ln V',
    panels: [
      {
        id: 'indicator',
        inOrderOfTime: true,
        xScale: 'log',
        yScale: 'log',
        yLabel: 'cylinder pressure, absolute',
        yUnit: pressure.unit,
        xLabel: 'volume above the piston',
        xUnit: 'cm³',
        series,
      },
    ],
    caption:
      'Straight compression and expansion lines speak for the zero of the pressure and for TDC. A compression that ' +
      'bends at low pressure has an offset; lines that cross, or a top that leans over, a wrong TDC.' +
      (imep.length ? ` Indicated mean effective pressure: ${imep.join('; ')}.` : '') +
      (indices.some((v) => v !== null)
        ? ` Polytropic index of compression from −90° to −45°: ${indices.filter((v) => v !== null).join('; ')}` +
          ' (1.25 to 1.4 in engines that seal).'
        : '') +
      (drawn.some((d) => d.isAssumed)
        ? ` The compression ratio of ${kAssumedRatio} is assumed: state gas.compression_ratio.`
        : ''),
  };
}
