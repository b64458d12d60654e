// One colour and one mark for each ring, one line style for each contribution, through the whole page.

/**
 * Distinct for colour-blind readers and of different lightness in grey print; the marks settle what is left.
 */
const kColours = ['#003f7d', '#d1490a', '#159a7a', '#a04fa0', '#7a6a00', '#4a4a4a', '#5b8dd6', '#8c2d1a'];
const kMarks = ['circle', 'square', 'triangle', 'diamond', 'cross', 'circle', 'square', 'triangle'];

const kNeutral = '#30343b';

/**
 * @param index number of the case; null for what belongs to all cases, negative for the only case of a page
 */
export function caseColour(index) {
  return index === null ? kNeutral : kColours[Math.max(0, index) % kColours.length];
}

export function caseMark(index) {
  return isOneOfSeveral(index) ? kMarks[index % kMarks.length] : null;
}

/** Is this one of several cases, with a mark of its own, to be hidden and shown? */
export function isOneOfSeveral(index) {
  return index !== null && index >= 0;
}

/** Regimes of lubrication by the load share of asperities, with the first words of their values. */
export const kRegimes = [
  { name: 'boundary', value: 'boundary_regime', colour: '#8c2d1a' },
  { name: 'mixed', value: 'mixed_regime', colour: '#e8b65a', isLight: true },
  { name: 'full film', value: 'full_film', colour: '#4a7fc8' },
];

/** Load shares of asperities at which the regimes meet [%]. */
export const kRegimeLimits = [
  { at: 90, label: 'boundary above 90 %' },
  { at: 1, label: 'full film below 1 %' },
];

/** How much of a case's colour the band of its error has. */
export const kBandOpacity = 0.22;

const kPartDash = {
  boundary: '9 4',
  viscous: '2 3',
  across: '9 4',
  sliding: '2 3',
};

/** Dashes of the line of a part, '' for a full line. */
export function partDash(part) {
  return kPartDash[part] ?? '';
}

/** Outline of a mark of radius r around (x, y) as SVG path data. */
export function markPath(shape, x, y, r) {
  const at = (dx, dy) => `${(x + dx).toFixed(2)} ${(y + dy).toFixed(2)}`;
  switch (shape) {
    case 'square':
      return `M${at(-r, -r)}L${at(r, -r)}L${at(r, r)}L${at(-r, r)}Z`;
    case 'triangle':
      return `M${at(0, -1.25 * r)}L${at(1.15 * r, 0.85 * r)}L${at(-1.15 * r, 0.85 * r)}Z`;
    case 'diamond':
      return `M${at(0, -1.3 * r)}L${at(1.3 * r, 0)}L${at(0, 1.3 * r)}L${at(-1.3 * r, 0)}Z`;
    case 'cross':
      return `M${at(-r, -r)}L${at(r, r)}M${at(-r, r)}L${at(r, -r)}`;
    default:
      return `M${at(-r, 0)}A${r} ${r} 0 1 0 ${at(r, 0)}A${r} ${r} 0 1 0 ${at(-r, 0)}Z`;
  }
}
