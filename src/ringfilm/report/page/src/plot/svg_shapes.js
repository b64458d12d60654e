// The shapes of which every drawing is made, on the screen, in files and in print.
import { caseColour, caseMark, markPath } from './palette.js';

export const kInk = '#30343b';
export const kFaint = '#5c6470';
export const kGrid = '#e3e6ea';
/** A letter is at most about so wide: a drawing cannot measure its text [pixel at a size of 12]. */
export const kLetter = 6.4;
/** Width of a bold letter as a share of its size. */
const kBoldLetter = 0.6;

let made = 0;

/** An id of its own for what a drawing refers to: a page has several drawings. */
export const newId = (name) => `${name}-${made++}`;

const safe = (content) =>
  String(content)
    .replace(/&/g, '&amp;')
    .replace(/</g, '&lt;')
    .replace(/>/g, '&gt;')
    .replace(/"/g, '&quot;')
    .replace(/[\u0000-\u0008\u000b\u000c\u000e-\u001f\ufffe\uffff]/g, '\ufffd');
export const px = (v) => v.toFixed(2);

/** What a pointer over a shape shows, '' without words. */
export const titled = (words) => words && `<title>${safe(words)}</title>`;

export function text(
  x,
  y,
  content,
  { anchor = 'start', size = 12, fill = kInk, weight = 400, halo = '', more = '' } = {},
) {
  return (
    `<text x="${px(x)}" y="${px(y)}" text-anchor="${anchor}" font-size="${size}" fill="${fill}" ` +
    `font-weight="${weight}"${halo && ` stroke="${halo}" stroke-width="3" paint-order="stroke"`}${more}>` +
    `${safe(content)}</text>`
  );
}

/** A title in bold, smaller where it would be wider than `width`. */
export function boldText(x, y, content, width, { size = 12, more = '' } = {}) {
  const fitting = Math.min(size, width / (kBoldLetter * content.length));
  return text(x, y, content, { weight: 600, size: fitting, more });
}

export function rule(x1, y1, x2, y2, stroke, width = 1, dash = '') {
  return (
    `<line x1="${px(x1)}" y1="${px(y1)}" x2="${px(x2)}" y2="${px(y2)}" stroke="${stroke}" ` +
    `stroke-width="${width}"${dash ? ` stroke-dasharray="${dash}"` : ''}/>`
  );
}

/** @param look attributes of the shape @param tooltip what a pointer over it shows */
export function rectangle(x, y, width, height, look, tooltip = '') {
  return (
    `<rect x="${px(x)}" y="${px(y)}" width="${px(Math.max(0, width))}" height="${px(Math.max(0, height))}" ` +
    `${look}${tooltip ? `>${titled(tooltip)}</rect>` : '/>'}`
  );
}

/** Two points of a path are so far apart, or they share a column [pixel]. */
const kColumn = 0.5;

/** The first, the lowest, the highest and the last of the points that share a column. */
function thinned(points) {
  const kept = [];
  let first = 0;
  for (let k = 1; k <= points.length; k++) {
    const isSame =
      k < points.length && Math.floor(points[k][0] / kColumn) === Math.floor(points[first][0] / kColumn);
    if (isSame) continue;
    if (k - first <= 4) for (let n = first; n < k; n++) kept.push(points[n]);
    else {
      let [low, high] = [first, first];
      for (let n = first; n < k; n++) {
        if (points[n][1] < points[low][1]) low = n;
        if (points[n][1] > points[high][1]) high = n;
      }
      kept.push(...[first, Math.min(low, high), Math.max(low, high), k - 1].map((n) => points[n]));
    }
    first = k;
  }
  return kept;
}

const joined = (points) => points.map(([x, y]) => `${px(x)} ${px(y)}`).join('L');

/** Path data of a line through points, with a gap where one is null or not finite. */
function linePath(points) {
  const pieces = [[]];
  for (const p of points) {
    if (p && Number.isFinite(p[0]) && Number.isFinite(p[1])) pieces[pieces.length - 1].push(p);
    else if (pieces[pieces.length - 1].length) pieces.push([]);
  }
  return pieces
    .filter((piece) => piece.length)
    .map((piece) => `M${joined(thinned(piece))}`)
    .join('');
}

export function line(points, stroke, { width = 1.8, dash = '' } = {}) {
  return (
    `<path d="${linePath(points)}" fill="none" stroke="${stroke}" stroke-width="${width}" ` +
    `stroke-linejoin="round"${dash ? ` stroke-dasharray="${dash}"` : ''}/>`
  );
}

export function area(points, fill, opacity, more = '') {
  return points.length < 3
    ? ''
    : `<path${more} d="M${joined(points)}Z" fill="${fill}" fill-opacity="${opacity}"/>`;
}

/** Marks of a case at one or several places, as one shape. */
export function mark(
  caseIndex,
  places,
  r = 4,
  { fill = '#fff', opacity = 1, stroke = caseColour(caseIndex), width = 1.5, tooltip = '' } = {},
) {
  const outlines = places.map(([x, y]) => markPath(caseMark(caseIndex), x, y, r)).join('');
  return (
    `<path d="${outlines}" fill="${fill}" fill-opacity="${opacity}" stroke="${stroke}" ` +
    `stroke-width="${width}">${titled(tooltip)}</path>`
  );
}

export function dot(x, y, r, look, tooltip = '') {
  return `<circle cx="${px(x)}" cy="${px(y)}" r="${r}" ${look}>${titled(tooltip)}</circle>`;
}

/** Slanting lines to fill a shape with: the pattern and its id. */
export function hatching(size, width, stroke) {
  const id = newId('hatch');
  const pattern =
    `<pattern id="${id}" width="${size}" height="${size}" patternUnits="userSpaceOnUse" ` +
    `patternTransform="rotate(45)"><rect width="${size}" height="${size}" fill="#fff"/>` +
    `<rect width="${width}" height="${size}" fill="${stroke}"/></pattern>`;
  return { id, pattern };
}

/** The shapes as far as they lie within the edges of a plot. */
export function clipped({ left, right, top, bottom }, shapes) {
  const id = newId('clip');
  const edge = rectangle(left, top - 2, right - left, bottom - top + 4, '');
  return [`<clipPath id="${id}">${edge}</clipPath><g clip-path="url(#${id})">`, ...shapes, '</g>'];
}

export function scaler(log, low, high, from, to) {
  if (log) {
    const [a, b] = [Math.log10(low), Math.log10(high)];
    return (v) => (v > 0 ? from + ((Math.log10(v) - a) / (b - a)) * (to - from) : NaN);
  }
  return (v) => from + ((v - low) / (high - low)) * (to - from);
}

/** A text of at most so many pixels. */
export function fitted(words, width, letter = kLetter) {
  const most = Math.max(4, Math.floor(width / letter));
  return words.length <= most ? words : `${words.slice(0, most - 1)}…`;
}

/** Names beside samples, in rows. @param entries { label, swatch(x, y) }, each sample 28 pixels wide */
export function legend(entries, width, top = 0) {
  const shapes = [];
  let [x, y] = [8, top + 12];
  for (const { label, swatch } of entries) {
    const needed = 54 + kLetter * label.length;
    if (x + needed > width && x > 8) [x, y] = [8, y + 19];
    shapes.push(swatch(x, y - 4), text(x + 34, y, label));
    x += needed;
  }
  return { shapes, height: entries.length ? y + 10 - top : 0 };
}

/**
 * A drawing { shapes, height } as an SVG document, with a title where it leaves the page.
 * @param background 'none' where something lies under it
 */
export function svgDocument(
  { shapes, height },
  width,
  { title = '', subtitle = '', background = '#fff' } = {},
) {
  const top = title ? (subtitle ? 50 : 30) : 0;
  const head = title ? [boldText(8, 20, title, width - 16, { size: 16 })] : [];
  if (title && subtitle)
    head.push(
      text(8, 38, subtitle, { fill: kFaint, size: Math.min(12, (width - 16) / (0.55 * subtitle.length)) }),
    );
  return (
    `<svg xmlns="http://www.w3.org/2000/svg" width="${width}" height="${px(height + top)}" ` +
    `viewBox="0 0 ${width} ${px(height + top)}" font-family="'Segoe UI', 'Helvetica Neue', Arial, ` +
    `'Liberation Sans', sans-serif">` +
    `<rect width="100%" height="100%" fill="${background}"/>${head.join('')}` +
    `<g transform="translate(0 ${top})">${shapes.join('')}</g></svg>`
  );
}
