// Figures of the contact law: pressure, real area and flow factors against the separation.

import { converted } from '../units.js';

/** Below it nothing is drawn [MPa]. */
const kLeastPressure = 0.1;

const separations = (c) => converted(c.contact.separation, 'um');

/** A pressure on a logarithmic axis, or a gap. */
function shown(pressure) {
  const p = converted(pressure, 'MPa');
  return p !== null && p >= kLeastPressure ? p : null;
}

/** One standard deviation about a law to both sides, as charts draw it; none where it is not known. */
function bands(law) {
  const edge = (sign) =>
    law.pressure.map((p, k) =>
      shown(p) === null || law.log_deviation[k] === null
        ? null
        : Math.max(shown(p) * Math.exp(sign * law.log_deviation[k]), kLeastPressure),
    );
  return law.log_deviation.some((d) => d !== null) ? { bands: [{ low: edge(-1), high: edge(1) }] } : {};
}

function lawSeries(c, law, caseIndex, label) {
  return { caseIndex, part: null, label, x: separations(c), y: law.pressure.map(shown), ...bands(law) };
}

function panel(id, yLabel, yUnit, series) {
  return { id, xLabel: 'separation of the mean planes', xUnit: 'µm', yLabel, yUnit, series };
}

/** Cases with contact; a film of a pad may have none. */
function touching(model) {
  return model.cases.filter((c) => c.contact);
}

/** Contact pressure by all laws of the surfaces of one case, or by the law of each of several cases. */
export function contactPressureFigure(model) {
  const cases = touching(model);
  if (cases.length === 0) return null;
  const isAlone = !model.several;
  const series = isAlone
    ? cases[0].contact.laws.map((law, k) =>
        lawSeries(cases[0], law, k === 0 ? cases[0].series : k, law.label),
      )
    : cases.map((c) => lawSeries(c, c.contact.laws[0], c.series, c.name));
  const hasBands = series.some((s) => s.bands);
  const others = isAlone && series.length > 1 ? ' Other laws have the same surfaces.' : '';
  return {
    id: 'contact-pressure',
    title: 'Contact pressure',
    panels: [{ ...panel('contact-pressure', 'contact pressure', 'MPa', series), yScale: 'log' }],
    caption:
      'Pressure of the asperities on the nominal area against the separation of the mean planes.' +
      others +
      (hasBands
        ? ' Bands: one standard deviation of what was measured, regions and relative positions of the surfaces.'
        : ' Without a band: the case has no scatter of its surfaces.'),
  };
}

export function realAreaFigure(model) {
  const series = touching(model).map((c) => ({
    caseIndex: c.series,
    part: null,
    label: model.several ? c.name : 'law of the case',
    x: separations(c),
    y: c.contact.real_area.map((share) => (share === null ? null : share * 100)),
  }));
  if (series.length === 0) return null;
  return {
    id: 'real-contact-area',
    title: 'Real contact area',
    panels: [{ ...panel('real-contact-area', 'real contact area', '%', series), fromZero: true }],
    caption: 'Share of the nominal area that touches, against the separation of the mean planes.',
  };
}

const kFactors = [
  ['phi_x', null, 'φx, pressure flow along the motion'],
  ['phi_y', 'across', 'φy, pressure flow across it'],
  ['phi_s', 'sliding', 'φs, shear flow, first surface at rest'],
];

/** null between smooth walls. */
export function flowFactorFigure(model) {
  const series = touching(model).flatMap((c) =>
    kFactors
      .filter(([name]) => c.contact[name].length > 0)
      .map(([name, part, label]) => ({
        caseIndex: c.series,
        part,
        label: model.several ? `${label}, ${c.name}` : label,
        x: separations(c),
        y: c.contact[name],
      })),
  );
  if (series.length === 0) return null;
  return {
    id: 'flow-factors',
    title: 'Flow factors of the rough walls',
    panels: [{ ...panel('flow-factors', 'flow factor', '', series), fromZero: true }],
    caption:
      'Flow between rough walls over that of a smooth gap of the same separation. A factor φy above φx lets oil ' +
      'pass around the ring more easily than across its face.',
  };
}
