// A height map as plain SVG: the picture in true proportions, axes, colour bar, scale bar, framed regions.
import { heightColour, kMissingColour } from './colour_map.js';
import { axisTitle } from './scales.js';
import { colourBar, numbersBelow, numbersBeside } from './svg_colour_bar.js';
import { kFaint, kInk, px, rule, scaler, text } from './svg_shapes.js';
import { kMissing, unpacked } from './packed.js';
import { number, ticks, tickText, typesetUnit, withUnit } from '../units.js';

/** Numbers the parts that one drawing refers to: a page has two drawings of one map. */
let drawn = 0;
const kTallest = 560;
/** A letter is at most about so wide: a drawing cannot measure its text [pixel]. */
const kLetter = 6.4;

/** The unit in which lengths of this size are read, from `from` of it on: { unit, size in m }. */
export function lengthUnit(metres, from) {
  const units = [
    { unit: 'mm', size: 1e-3 },
    { unit: 'µm', size: 1e-6 },
  ];
  return units.find(({ size }) => metres >= from * size) ?? { unit: 'nm', size: 1e-9 };
}

export class MapFigure {
  constructor(map) {
    Object.assign(this, map, { unit: typesetUnit(map.unit) });
    this.width = map.points_x * map.step_x;
    this.height = map.points_y * map.step_y;
    this.lengths = lengthUnit(Math.max(this.width, this.height), 2);
    if (!map.empty) this.words = unpacked(map.data);
    // A map of one height has the middle colour.
    const spread = map.colour_high > map.colour_low ? 0 : Math.abs(map.colour_low) || 1;
    [this.from, this.to] = [map.colour_low - spread, map.colour_high + spread];
  }

  /** Value of one point of the picture in its unit; null where there is none. */
  value(column, row) {
    const word = this.words[row * this.columns + column];
    return word === kMissing || word === undefined
      ? null
      : this.low + ((this.high - this.low) * word) / (kMissing - 1);
  }

  /** The pixels as a PNG in a data URL, drawn once. */
  image() {
    if (this.url) return this.url;
    const canvas = document.createElement('canvas');
    [canvas.width, canvas.height] = [this.columns, this.rows];
    const context = canvas.getContext('2d');
    const pixels = context.createImageData(this.columns, this.rows);
    const missing = kMissingColour.match(/[0-9a-f]{2}/g).map((hex) => parseInt(hex, 16));
    for (let k = 0; k < this.words.length; k++) {
      const value = this.value(k % this.columns, Math.floor(k / this.columns));
      const colour = value === null ? missing : heightColour((value - this.from) / (this.to - this.from));
      pixels.data.set([...colour, 255], 4 * k);
    }
    context.putImageData(pixels, 0, 0);
    this.url = canvas.toDataURL('image/png');
    return this.url;
  }

  /** Where everything is in a drawing of that width, true proportions. */
  layout(width, top) {
    const kLeft = 58;
    const kBarRoom = 104;
    const beside = width >= 560;
    let w = width - kLeft - (beside ? kBarRoom : 16);
    let h = (w * this.height) / this.width;
    if (h > kTallest) [w, h] = [(w * kTallest) / h, kTallest];
    const tall = h >= 130;
    const plot = { left: kLeft, top: top + 22, width: w, height: h };
    const below = plot.top + h + 46;
    const scaleBarInside = h >= 70;
    const lastRow = scaleBarInside ? (this.missing_points > 0 ? 24 : 0) : 40;
    return {
      plot,
      scaleBarInside,
      barBeside: beside && tall,
      below,
      bottom: below + (beside && tall ? 0 : 40) + lastRow,
    };
  }

  svg({ width = 760, heading = true, subtitle = '' } = {}) {
    const out = [];
    let top = 0;
    if (heading) {
      out.push(text(8, 20, this.title, { size: 16, weight: 600 }));
      top = 26;
      if (subtitle) out.push(text(8, 39, subtitle, { fill: kFaint }));
      if (subtitle) top = 46;
    }
    const layout = this.layout(width, top);
    const { plot } = layout;
    const clip = `map-clip-${drawn++}`;
    out.push(
      `<clipPath id="${clip}"><rect x="${px(plot.left)}" y="${px(plot.top)}" ` +
        `width="${px(plot.width)}" height="${px(plot.height)}"/></clipPath>`,
      `<g clip-path="url(#${clip})">`,
      this.picture(plot),
      ...this.frameShapes(plot),
      '</g>',
      ...this.axes(plot),
    );
    if (layout.scaleBarInside)
      out.push(...this.scaleBar(plot, plot.left + plot.width - 10, plot.top + plot.height - 12, true));
    out.push(...(layout.barBeside ? this.barBeside(plot) : this.barBelow(plot, layout.below)));
    const last = layout.bottom - 10;
    if (this.missing_points > 0) {
      out.push(
        `<rect x="${px(plot.left)}" y="${px(last - 10)}" width="14" height="12" ` +
          `fill="${kMissingColour}" stroke="${kFaint}"/>`,
        text(plot.left + 20, last, 'not measured'),
      );
    }
    if (!layout.scaleBarInside) out.push(...this.scaleBar(plot, plot.left + plot.width, last, false));
    const height = layout.bottom + 4;
    return (
      `<svg xmlns="http://www.w3.org/2000/svg" width="${width}" height="${px(height)}" viewBox="0 ` +
      `0 ${width} ${px(height)}" font-family="'Segoe UI', 'Helvetica Neue', Arial, 'Liberation ` +
      `Sans', sans-serif">` +
      `<rect width="100%" height="100%" fill="#fff"/>${out.join('')}</svg>`
    );
  }

  picture(plot) {
    const w = (plot.width * this.columns * this.block_x) / this.points_x;
    const h = (plot.height * this.rows * this.block_y) / this.points_y;
    const sharp = w >= this.columns ? ' style="image-rendering:pixelated"' : '';
    return (
      `<image href="${this.image()}" x="${px(plot.left)}" y="${px(plot.top)}" width="${px(w)}" ` +
      `height="${px(h)}" preserveAspectRatio="none"${sharp}/>`
    );
  }

  frameShapes(plot) {
    const [sx, sy] = [plot.width / this.width, plot.height / this.height];
    return this.frames.flatMap((frame) => {
      const box =
        `x="${px(plot.left + frame.x * sx)}" y="${px(plot.top + frame.y * sy)}" ` +
        `width="${px(frame.width * sx)}" height="${px(frame.height * sy)}" fill="none"`;
      return [
        `<rect class="frame" ${box} stroke="#fff" stroke-width="3.5" ` +
          `stroke-opacity="0.85"/><rect ${box} stroke="#000" stroke-width="1.3"/>`,
        text(plot.left + frame.x * sx + 4, plot.top + frame.y * sy + 13, frame.label, {
          size: 12,
          weight: 600,
          fill: '#000',
          halo: '#fff',
        }),
      ];
    });
  }

  axes(plot) {
    const { unit, size } = this.lengths;
    const [right, low] = [plot.left + plot.width, plot.top + plot.height];
    const x = scaler(false, 0, this.width / size, plot.left, right);
    const y = scaler(false, 0, this.height / size, plot.top, low);
    const out = [
      `<rect x="${px(plot.left)}" y="${px(plot.top)}" width="${px(plot.width)}" ` +
        `height="${px(plot.height)}" fill="none" stroke="${kInk}"/>`,
    ];
    const across = ticks(0, this.width / size, Math.max(2, plot.width / 70));
    for (const v of across.values)
      out.push(
        rule(x(v), low, x(v), low + 5, kInk),
        text(x(v), low + 18, tickText(v, across.step), { anchor: 'middle' }),
      );
    const up = ticks(0, this.height / size, plot.height / 40);
    for (const v of up.values)
      out.push(
        rule(plot.left - 5, y(v), plot.left, y(v), kInk),
        text(plot.left - 8, y(v) + 4, tickText(v, up.step), { anchor: 'end' }),
      );
    out.push(
      text(plot.left + plot.width / 2, low + 35, axisTitle('x', unit), { anchor: 'middle', fill: kFaint }),
    );
    out.push(text(4, plot.top - 8, axisTitle('y', unit), { fill: kFaint }));
    return out;
  }

  /** A bar of 1, 2 or 5 times a power of ten, at most a quarter of the width, that ends at x. */
  scaleBar(plot, x, y, onPicture) {
    const { unit, size } = this.lengths;
    const most = this.width / size / 4;
    const power = 10 ** Math.floor(Math.log10(most));
    const length = [5, 2, 1].map((m) => m * power).find((v) => v <= most) ?? power;
    const label = `${String(Number(length.toPrecision(1)))}\u202f${unit}`;
    const w = (length * size * plot.width) / this.width;
    const wide = Math.max(w, kLetter * label.length) + 12;
    const out = onPicture
      ? [
          `<rect x="${px(x - wide)}" y="${px(y - 22)}" width="${px(wide)}" height="30" ` +
            'fill="#fff" fill-opacity="0.88"/>',
        ]
      : [];
    const middle = x - wide / 2;
    return [
      ...out,
      `<rect class="scale-bar" x="${px(middle - w / 2)}" y="${px(y - 1)}" width="${px(w)}" ` +
        'height="4" fill="#000"/>',
      text(middle, y - 7, label, { anchor: 'middle', fill: '#000', weight: 600 }),
    ];
  }

  /** Pointed ends where values lie beyond the colours. */
  barShape(box, upright) {
    return colourBar(box, upright, {
      above: this.highest.value > this.to,
      below: this.lowest.value < this.from,
    });
  }

  barBeside(plot) {
    const kPoint = 10;
    const box = {
      left: plot.left + plot.width + 18,
      top: plot.top + kPoint,
      width: 15,
      height: plot.height - 2 * kPoint,
    };
    return [
      ...this.barShape(box, true),
      ...numbersBeside(box, [this.from, this.to]),
      text(box.left - 4, plot.top - 8, axisTitle(this.long_name, this.unit), { weight: 600 }),
    ];
  }

  barBelow(plot, top) {
    const box = { left: plot.left + 10, top: top + 12, width: Math.max(120, plot.width - 20), height: 13 };
    return [
      ...this.barShape(box, false),
      ...numbersBelow(box, [this.from, this.to]),
      text(4, box.top - 5, axisTitle(this.long_name, this.unit), { weight: 600 }),
    ];
  }

  /** What lies under a place in pixels of a drawing of that width; null outside the picture. */
  at(x, y, width) {
    const { plot } = this.layout(width, 0);
    const [a, b] = [(x - plot.left) / plot.width, (y - plot.top) / plot.height];
    if (a < 0 || a >= 1 || b < 0 || b >= 1) return null;
    const value = this.value(
      Math.floor((a * this.points_x) / this.block_x),
      Math.floor((b * this.points_y) / this.block_y),
    );
    const { unit, size } = this.lengths;
    const place =
      `x ${withUnit((a * this.width) / size, unit, 3)}, y ` +
      `${withUnit((b * this.height) / size, unit, 3)}`;
    return { place, value: value === null ? 'not measured' : withUnit(value, this.unit, 4) };
  }

  description() {
    const { unit, size } = this.lengths;
    const step = lengthUnit(Math.max(this.step_x, this.step_y), 0.0999);
    const short = (v) => String(Number(v.toPrecision(4)));
    const spot = (point) =>
      `${withUnit(point.value, this.unit, 3)} at x = ${withUnit(point.x / size, unit, 3)}, y = ` +
      `${withUnit(point.y / size, unit, 3)}`;
    const share = (100 * this.missing_points) / (this.points_x * this.points_y);
    const sentences = [
      `${this.points_x} × ${this.points_y} points of ${short(this.step_x / step.size)} × ` +
        `${short(this.step_y / step.size)}\u00a0${step.unit}, first row at the top.`,
      this.block_x * this.block_y > 1
        ? `Drawn as means over blocks of ${this.block_x} × ${this.block_y} points, in which single ` +
          'peaks look lower than they are.'
        : '',
      `Highest single point ${spot(this.highest)}; lowest ${spot(this.lowest)}.`,
      `The colours span ${number(this.colour_low, 3)} to ` +
        `${withUnit(this.colour_high, this.unit, 3)}, where 0.1\u00a0% of what is drawn lie below ` +
        `and 0.1\u00a0% above.`,
      share > 0 ? `Grey: ${withUnit(share, '%', 2)} of the points were not measured.` : '',
    ];
    return sentences.filter(Boolean).join(' ');
  }
}
