// The maps around the ring and the curves of the gap, as plain data for drawing.
import { bandSentence, cyclePanel, ofEachCycle, valueWithUnit } from './cycle_figures.js';
import { FieldMaps } from './field_maps.js';
import { axisTitle, kStrokeBands } from '../plot/scales.js';
import { crankAxis, faceAxis, ringAxis } from './unrolled.js';
import { angleInWords, crankTicks, number, tickText, withUnit, wrapped } from '../units.js';

const kHeight = { low: 118, usual: 150, high: 230, overCrank: 260 };

/** A range of values for colours, whose ends always differ. */
function spread([low, high]) {
  if (high > low) return [low, high];
  return [low - (Math.abs(low) || 1), high + (Math.abs(high) || 1)];
}

/** Degrees around the bore above the whole ring, the gap between its enlarged ends. */
function above(data, axis) {
  if (axis.gap !== undefined) {
    return { title: '', marks: () => [{ at: 0, label: `gap ${withUnit(axis.gap, 'mm', 2)}` }] };
  }
  return {
    title: 'around the bore [°]',
    marks: (width) => {
      const { values, step } = crankTicks(0, 359, width / 70);
      return values
        .map((turned) => {
          // The gap lies between the end of the ring and its beginning.
          const from = (((turned - data.gapPosition) % 360) + 360) % 360;
          return { at: (from / 360) * data.circumference - data.gap / 2, label: tickText(turned, step) };
        })
        .filter(({ at }) => at >= 0 && at <= data.length);
    },
  };
}

/** The strokes above a map over the crank angle; its dead centres have their names under their numbers. */
const kStrokesAbove = {
  title: '',
  marks: () => kStrokeBands.map(({ from, to, name }) => ({ at: (from + to) / 2, label: name, tick: false })),
};

/**
 * Film pressure over liquid share at one angle.
 * @param ends the ends of the gap enlarged, not the whole ring; @param own colours of this angle alone
 */
export function fieldMaps(data, k, { ends, own }) {
  const columns = ringAxis(data, { ends, face: data.face });
  const { film_pressure: pressure, film_content: content } = data.fields;
  const range = (name) => (own ? data.rangeAt(name, k) : data.fields[name].range);
  const upToFull = ([low]) => (low < 1 ? [low, 1] : [0, 1]);
  const maps = [
    {
      title: pressure.longName,
      unit: pressure.unit,
      range: spread(range('film_pressure')),
      value: (j, i) => data.value('film_pressure', k, j, i),
      hatched: (j, i) => data.isCavity(k, j, i),
      hatchLabel: content || data.hasNoFilmContent ? 'cavity' : '',
    },
  ];
  if (content)
    maps.push({
      title: content.longName,
      unit: '',
      range: upToFull(range('film_content')),
      value: (j, i) => data.value('film_content', k, j, i),
    });
  const shown = columns.to - columns.from;
  return new FieldMaps({
    title: `Around the ring ${angleInWords(data.angles[k])}`,
    columns,
    rows: faceAxis(data),
    maps,
    height: (width) =>
      ends
        ? Math.min(kHeight.high, Math.max(kHeight.low, (width * data.face) / shown))
        : width < 400
          ? kHeight.low
          : kHeight.usual,
    above: above(data, columns),
    edgeWords: ['chamber edge', 'crankcase edge'],
  });
}

/** Does a number of the strips differ around the ring by more than rounding? */
function variesAround(data, name) {
  const kRounding = 1e-3;
  const [low, high] = data.strips[name].range;
  const first = data.y.map((_, j) => data.stripValue(name, 0, j));
  return high > low && Math.max(...first) - Math.min(...first) > kRounding * Math.max(...first);
}

/** Sums of strips over crank angle and y, where the result holds no more. */
export function stripMaps(data, { ends, face }) {
  const rows = { ...ringAxis(data, { ends, face }), label: ends ? 'y from the gap' : 'y' };
  const bends = data.strips.strip_min_film_thickness && variesAround(data, 'strip_min_film_thickness');
  const names = ['strip_hydrodynamic_load', 'strip_peak_film_pressure'];
  if (bends) names.push('strip_min_film_thickness', 'strip_asperity_load');
  const maps = names
    .filter((name) => data.strips[name])
    .map((name) => ({
      title: data.strips[name].longName,
      unit: data.strips[name].unit,
      range: spread(data.strips[name].range),
      value: (k, j) => data.stripValue(name, k, j),
    }));
  return new FieldMaps({
    title: 'Around the ring over the cycle',
    columns: crankAxis(data.stripAngles),
    rows,
    maps,
    height: () => kHeight.overCrank,
    above: kStrokesAbove,
  });
}

/** States which share of the stored fields the page shows. */
function thinning(data) {
  const { angles, y, x } = data.stored;
  const of = (drawn, stored, things) => (drawn < stored ? [`${drawn} of ${stored} ${things}`] : []);
  const parts = [
    ...of(data.angles.length, angles, 'crank angles'),
    ...of(data.y.length, y, 'strips'),
    ...of(data.x.length, x, 'nodes across'),
  ];
  return parts.length
    ? ` This page carries ${parts.join(', ')}, none of them a mean; the result file holds all.`
    : '';
}

export function fieldCaption(data, name) {
  const best = data.highestPressure.reduce(
    (found, point, k) => (point.value > data.highestPressure[found].value ? k : found),
    0,
  );
  const { value, x, y } = data.highestPressure[best];
  const reach = data.endReach(best);
  const cavities = data.angles.filter((_, k) => data.hasCavity(k)).length;
  const inCavities = data.hasNoFilmContent
    ? "where the pressure is that of a cavity; the model, Reynolds' exit, does not define how much " +
      'oil is there'
    : 'where oil fills less than the whole space';
  const alike = reach !== null && Math.min(y, data.length - y) > reach;
  const felt =
    reach === null
      ? ''
      : ' At that angle the gap changes the pressure by more than 1 % of the highest up to ' +
        `${withUnit(reach, 'mm', 2)} from its ends (${number(reach / data.face, 2)} face widths); ` +
        'further on the strips are alike.';
  return (
    `${name ? `${name}: a` : 'A'}bsolute pressure of the oil` +
    (data.hasNoFilmContent ? '' : ' and liquid share of the space between ring and liner') +
    ', ' +
    (data.closed
      ? 'around a ring without a gap'
      : `from one end of the ring's gap of ${withUnit(data.gap, 'mm', 2)} around to the other`) +
    '; in the view of the whole ring the face is drawn much wider than it is. Highest: ' +
    `${withUnit(value, 'bar', 3)} ${angleInWords(data.angles[best])}, at x = ` +
    `${withUnit(x, 'mm', 3)}${alike ? '' : `, y = ${withUnit(y, 'mm', 4)}`}.${felt} ` +
    (cavities
      ? `Hatched: cavities, ${inCavities} (at ${cavities} of the ${data.angles.length} angles).`
      : 'No angle has a cavity.') +
    `${thinning(data)}`
  );
}

export function stripCaption(data, name) {
  return (
    `${name ? `${name}: l` : 'L'}oad carried by the film per length of ring and highest pressure ` +
    'across the face, at each place around the ring; the result holds sums over the strips, no ' +
    'fields along the face.' +
    (data.closed
      ? ''
      : ' Strips that differ from those opposite the gap do so within a few face widths of its ends.') +
    (data.stripAngles.length < data.stored.angles
      ? ` This page carries ${data.stripAngles.length} of ${data.stored.angles} crank angles; the ` +
        'result file holds all.'
      : '')
  );
}

const titleOf = ({ longName, unit }) => axisTitle(longName, unit);

/** Columns with one row a point that is drawn, for a spreadsheet. */
export function fieldColumns(data, k) {
  const each = (of) => data.y.flatMap((_, j) => data.x.map((__, i) => of(j, i)));
  return [
    { title: 'x [mm]', values: each((j, i) => data.x[i]) },
    { title: 'y [mm]', values: each((j) => data.y[j]) },
    ...Object.entries(data.fields).map(([name, field]) => ({
      title: titleOf(field),
      values: each((j, i) => data.value(name, k, j, i)),
    })),
  ];
}

export function stripColumns(data) {
  const each = (of) => data.stripAngles.flatMap((_, k) => data.y.map((__, j) => of(k, j)));
  return [
    { title: 'crank angle [degree]', values: each((k) => wrapped(data.stripAngles[k])) },
    { title: 'y [mm]', values: each((k, j) => data.y[j]) },
    ...Object.entries(data.strips).map(([name, field]) => ({
      title: titleOf(field),
      values: each((k, j) => data.stripValue(name, k, j)),
    })),
  ];
}

/** Less flow than this share of the largest has no meaningful shares. */
const kFlowWorthAShare = 0.1;

/** The case with the share in the flow only where there is a flow to speak of. */
function withoutTurning(c) {
  const flow = c.curves.oil_flow_middle;
  const least = kFlowWorthAShare * Math.max(...flow.map((v) => Math.abs(v ?? 0)));
  return {
    ...c,
    curves: {
      ...c.curves,
      ends_share_flow: c.curves.ends_share_flow.map((v, k) => (Math.abs(flow[k] ?? 0) < least ? null : v)),
    },
  };
}

/** Leakage and the shares of the gap's ends over the cycle; null where no ring has a gap. */
export function gapFigure(model) {
  const names = ['gap_leakage', 'ends_share_load', 'ends_share_friction', 'ends_share_flow'];
  const unrolled = model.cases.filter(
    (c) => names.every((name) => c.curves[name]) && c.curves.gap_leakage.some((v) => v),
  );
  if (unrolled.length === 0) return null;
  const shown = model.withCases(unrolled.map(withoutTurning));
  const panels = names.map((name) => cyclePanel(shown, name, { zeroLine: true }));
  const valueText = (name) => ofEachCycle(shown, (c) => valueWithUnit(shown, c, name, 2));
  return {
    id: 'gap-of-the-ring',
    title: 'What the ends of the gap do',
    group: 'cycle',
    layout: 'row',
    panels,
    caption:
      'Oil that leaves the film through both ends of the ring, and by which share its ends change ' +
      'load, friction and oil flow of the ring against one whose strips were all like the one ' +
      'opposite the gap; negative where the ends do less. The share in the flow is omitted where ' +
      'less than a tenth of the largest flow passes. Mean flow between film and gap: ' +
      `${valueText('mean_absolute_gap_leakage')}; its share of the flow under the ring: ` +
      `${valueText('gap_leakage_share')}. Shares of the ends in the mean load: ` +
      `${valueText('ends_share_mean_load')}; in the friction power: ` +
      `${valueText('ends_share_friction_power')}; in the mean flow without sign: ` +
      `${valueText('ends_share_absolute_flow')}.${bandSentence(panels)}`,
  };
}

/** Clearance and open area of rings that bend over the cycle; null where no ring does. */
export function clearanceFigure(model) {
  const names = ['max_clearance', 'min_film_thickness', 'open_area', 'lifted_angle'];
  const kRigid = 1e-3;
  const bends = (c) =>
    names.every((name) => c.curves[name]) &&
    c.curves.max_clearance.some((v, k) => v > (1 + kRigid) * c.curves.min_film_thickness[k]);
  const bent = model.cases.filter(bends);
  if (bent.length === 0) return null;
  const shown = model.withCases(bent);
  const panels = names.map((name) => cyclePanel(shown, name, { zeroLine: true }));
  const valueText = (name) => ofEachCycle(shown, (c) => valueWithUnit(shown, c, name, 2));
  return {
    id: 'clearance-of-the-ring',
    title: 'How the ring follows the bore',
    group: 'cycle',
    layout: 'row',
    panels,
    caption:
      'Largest and smallest film thickness around the ring, each at the lowest place of the face, and ' +
      'area and angle where film and contact carry less than a tenth of the mean load: there the ring ' +
      `is lifted off. Largest clearance: ${valueText('peak_clearance')}; largest open area: ` +
      `${valueText('peak_open_area')}, on average ${valueText('mean_open_area')}.${bandSentence(panels)}`,
  };
}
