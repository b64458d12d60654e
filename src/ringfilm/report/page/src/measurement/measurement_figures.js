// Curves of a measurement as the plain data that charts, SVG and CSV are drawn from.
import { kOnlyCase } from '../model.js';
import { typeset, typesetUnit } from '../units.js';

/** A profile of so many points needs the whole width. */
const kLong = 400;
const kLengths = ['m', 'mm', 'um', 'nm'];

/** A point that has a place on these axes, else a gap. */
function placed(curve, series) {
  const onAxis = (axis, v) => (axis.logarithmic && !(v > 0) ? null : v);
  const points = series.x
    .map((v, k) => [onAxis(curve.x, v), onAxis(curve.y, series.y[k])])
    .filter(([x]) => x !== null);
  return points.sort((a, b) => a[0] - b[0]);
}

/** null where nothing of the curve can be drawn. */
export function curveFigure(curve) {
  const several = curve.series.length > 1;
  const series = curve.series
    .map((s, i) => {
      const points = placed(curve, s);
      return {
        caseIndex: several ? i : kOnlyCase,
        part: s.points ? 'points' : null,
        label: typeset(s.label || curve.y.long_name),
        x: points.map((p) => p[0]),
        y: points.map((p) => p[1]),
      };
    })
    .filter((s) => s.y.some((v) => v !== null));
  if (series.length === 0) return null;
  const all = series.flatMap((s) => s.y.filter((v) => v !== null));
  const thinned =
    curve.drawn < curve.points
      ? ` Drawn from ${curve.drawn} of ${curve.points} points, the lowest and highest of each ` +
        'stretch among them.'
      : '';
  return {
    id: curve.name,
    title: typeset(curve.title),
    long: !curve.x.logarithmic && kLengths.includes(curve.x.unit) && curve.points > kLong,
    panels: [
      {
        id: curve.name,
        xScale: curve.x.logarithmic ? 'log' : 'linear',
        yScale: curve.y.logarithmic ? 'log' : 'linear',
        xLabel: curve.x.long_name,
        xUnit: typesetUnit(curve.x.unit),
        yLabel: curve.y.long_name,
        yUnit: typesetUnit(curve.y.unit),
        zeroLine: !curve.y.logarithmic && all.some((v) => v < 0) && all.some((v) => v > 0),
        xMarks: curve.marks
          .filter((mark) => mark.at !== null)
          .map((mark) => ({ at: mark.at, label: typeset(mark.label) })),
        series,
      },
    ],
    caption: `${typeset(curve.caption)}${thinned}`.trim(),
  };
}

/** Curves that have no point to draw, listed as text. */
export function withoutPoints(curves) {
  return curves
    .filter((curve) => curveFigure(curve) === null)
    .map((curve) => `${curve.title}: no point of it can be drawn (${curve.points} given).`);
}
