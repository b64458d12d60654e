// A ring in its bore in polar coordinates, deviations from a circle enlarged.
import { area, kFaint, kInk, line, px, rule, text } from './svg_shapes.js';
import { number } from '../units.js';

const kBore = '#8a93a0';
const kRing = '#003f7d';
const kApart = '#d1490a';
/** Largest deviation of the bore in the drawing, of its radius. */
export const kShown = 0.22;

/** A length that is easy to read, below so many micrometres. */
function roundLength(most) {
  const power = 10 ** Math.floor(Math.log10(most));
  return [5, 2, 1].map((n) => n * power).find((length) => length <= most) ?? power;
}

/** Lines and their names in a row. */
export function key(entries, left, top) {
  return entries.flatMap(({ words, colour }, n) => [
    rule(left + 76 * n, top - 4, left + 76 * n + 18, top - 4, colour, 2.4),
    text(left + 76 * n + 23, top, words, { size: 11 }),
  ]);
}

/** The parts of a line at which something holds. */
function parts(points, holds) {
  const all = [];
  let part = [];
  points.forEach((point, j) => {
    if (holds[j]) part.push(point);
    if (part.length && (!holds[j] || j + 1 === points.length)) {
      if (part.length === 1) part.push([part[0][0] + 0.5, part[0][1]]);
      all.push(part);
      part = [];
    }
  });
  return all;
}

/**
 * Angles grow counterclockwise from the right.
 * @param of turns of the places [degree], bore and clearance there [um], isApart where the ring is apart from the
 * bore, and apart, what that is called; most: the deviation that has to be shown at most [um]; gap: where the middle of
 * the end gap is [degree], null: there is none
 */
export function polarBore({ turns, bore, clearance, isApart, apart, most, gap }, width) {
  const size = Math.min(width, 430);
  const radius = size / 2 / (1 + kShown) - 26;
  const centre = { x: width / 2, y: radius * (1 + kShown) + 30 };
  const scale = (kShown * radius) / most;
  const at = (degrees, r) => {
    const turn = (degrees * Math.PI) / 180;
    return [centre.x + r * Math.cos(turn), centre.y - r * Math.sin(turn)];
  };
  const boreLine = turns.map((turn, j) => at(turn, radius + scale * bore[j]));
  const ringLine = turns.map((turn, j) => at(turn, radius + scale * (bore[j] - clearance[j])));
  const shapes = [
    `<circle cx="${px(centre.x)}" cy="${px(centre.y)}" r="${px(radius)}" fill="none" stroke="#d5d9df" ` +
      `stroke-dasharray="4 4"/>`,
    area([...boreLine, ...[...ringLine].reverse()], '#f6d9c8', 1),
    line([...boreLine, boreLine[0]], kBore, { width: 1.6 }), // it continues across the gap of the ring
    line(ringLine, kRing, { width: 2.2 }),
    ...parts(ringLine, isApart).map((part) => line(part, kApart, { width: 4 })),
  ];
  const named = (words, degrees, r) => {
    const [x, y] = at(degrees, r);
    shapes.push(text(x, y + 4, words, { anchor: 'middle', fill: kFaint }));
  };
  for (const degrees of [0, 90, 180, 270]) named(`${degrees}°`, degrees, radius * (1 + kShown) + 10);
  if (gap !== null) named('gap', gap, radius * (1 - kShown) - 14);
  const length = roundLength((0.5 * radius) / scale);
  const bar = { y: centre.y + 8, half: (scale * length) / 2 };
  shapes.push(
    rule(centre.x - bar.half, bar.y, centre.x + bar.half, bar.y, kInk, 1.6),
    rule(centre.x - bar.half, bar.y - 4, centre.x - bar.half, bar.y + 4, kInk, 1.6),
    rule(centre.x + bar.half, bar.y - 4, centre.x + bar.half, bar.y + 4, kInk, 1.6),
    text(centre.x, bar.y - 9, `${number(length, 3)} µm`, { anchor: 'middle' }),
    text(centre.x, bar.y + 22, `largest clearance ${number(Math.max(...clearance), 3)} µm`, {
      anchor: 'middle',
      size: 11,
    }),
  );
  const words = [
    { words: 'bore', colour: kBore },
    { words: 'ring', colour: kRing },
    { words: apart, colour: kApart },
  ];
  const top = centre.y + radius * (1 + kShown) + 42;
  shapes.push(...key(words, centre.x - 105, top));
  return { shapes, height: top + 16 };
}
