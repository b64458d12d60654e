// The colours of a map beside their numbers.
import { colourText, kHeightColours } from './colour_map.js';
import { kInk, px, rule, scaler, text } from './svg_shapes.js';
import { ticks, tickText } from '../units.js';

/** Numbers the gradients: a page has several drawings. */
let drawn = 0;

function gradient(id, upright) {
  const stops = kHeightColours
    .filter((_, k) => k % 15 === 0)
    .map(
      (colour, k, all) =>
        `<stop offset="${px((100 * k) / (all.length - 1))}%" stop-color="${colourText(colour)}"/>`,
    );
  return (
    `<linearGradient id="${id}" ` +
    `${upright ? 'x1="0" y1="1" x2="0" y2="0"' : 'x1="0" y1="0" x2="1" y2="0"'}>${stops.join('')}` +
    '</linearGradient>'
  );
}

/** The bar alone; a pointed end where values lie above or below the colours. */
export function colourBar({ left, top, width, height }, upright, { above = false, below = false } = {}) {
  const id = `map-colours-${drawn++}`;
  const kPoint = 9;
  const [first, last] = [
    colourText(kHeightColours[0]),
    colourText(kHeightColours[kHeightColours.length - 1]),
  ];
  const out = [
    gradient(id, upright),
    `<rect class="colour-bar" x="${px(left)}" y="${px(top)}" width="${px(width)}" ` +
      `height="${px(height)}" fill="url(#${id})" stroke="${kInk}" stroke-width="0.8"/>`,
  ];
  const point = (a, b, c, fill) =>
    `<path d="M${a.map(px).join(' ')}L${b.map(px).join(' ')}L${c.map(px).join(' ')}Z" ` +
    `fill="${fill}" stroke="${kInk}" stroke-width="0.8"/>`;
  const [right, low] = [left + width, top + height];
  if (above)
    out.push(
      upright
        ? point([left, top], [right, top], [left + width / 2, top - kPoint], last)
        : point([right, top], [right, low], [right + kPoint, top + height / 2], last),
    );
  if (below)
    out.push(
      upright
        ? point([left, low], [right, low], [left + width / 2, low + kPoint], first)
        : point([left, top], [left, low], [left - kPoint, top + height / 2], first),
    );
  return out;
}

/** Numbers along an upright bar, to its right. */
export function numbersBeside(box, [from, to]) {
  const y = scaler(false, from, to, box.top + box.height, box.top);
  const { values, step } = ticks(from, to, box.height / 40);
  const right = box.left + box.width;
  return values.flatMap((v) => [
    rule(right, y(v), right + 5, y(v), kInk),
    text(right + 8, y(v) + 4, tickText(v, step)),
  ]);
}

/** Numbers under a lying bar. */
export function numbersBelow(box, [from, to]) {
  const x = scaler(false, from, to, box.left, box.left + box.width);
  const { values, step } = ticks(from, to, box.width / 60);
  const low = box.top + box.height;
  return values.flatMap((v) => [
    rule(x(v), low, x(v), low + 4, kInk),
    text(x(v), low + 16, tickText(v, step), { anchor: 'middle' }),
  ]);
}
