// A height map as plain SVG: the picture in true proportions, axes, colour bar, scale bar, framed regions.
import { heightColour, kMissingColour } from './colour_map.js';
import { element } from '../dom.js';
import { numbersAcross, numbersUp, titleAcross } from './plot_frame.js';
import { axisTitle } from './scales.js';
import { colourBar, numbersBelow, numbersBeside } from './svg_colour_bar.js';
import { clipped, kFaint, kInk, kLetter, px, rectangle, scaler, text } from './svg_shapes.js';
import { kMissing, unpacked } from './packed.js';
import { number, ticks, typesetUnit, withUnit } from '../units.js';

const kTallest = 560;

/** The unit in which lengths of this size are read, from `from` of it on: { unit, size in m }. */
export function lengthUnit(metres, from) {
  const units = [
    { unit: 'mm', size: 1e-3 },
    { unit: 'µm', size: 1e-6 },
  ];
  return units.find(({ size }) => metres >= from * size) ?? { unit: 'nm', size: 1e-9 };
}

class MapFigure {
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
  layout(width) {
    const kLeft = 58;
    const kBarRoom = 104;
    const beside = width >= 560;
    let w = width - kLeft - (beside ? kBarRoom : 16);
    let h = (w * this.height) / this.width;
    if (h > kTallest) [w, h] = [(w * kTallest) / h, kTallest];
    const tall = h >= 130;
    const plot = { left: kLeft, right: kLeft + w, top: 22, bottom: 22 + h, width: w, height: h };
    const below = plot.bottom + 46;
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

  draw(width) {
    const layout = this.layout(width);
    const { plot } = layout;
    const last = layout.bottom - 10;
    const isGrey = this.missing_points > 0;
    const shapes = [
      ...clipped(plot, [this.picture(plot), ...this.frameShapes(plot)]),
      ...this.axes(plot),
      ...(layout.scaleBarInside ? this.scaleBar(plot, plot.right - 10, plot.bottom - 12, true) : []),
      ...(layout.barBeside ? this.barBeside(plot) : this.barBelow(plot, layout.below)),
      isGrey ? rectangle(plot.left, last - 10, 14, 12, `fill="${kMissingColour}" stroke="${kFaint}"`) : '',
      isGrey ? text(plot.left + 20, last, 'not measured') : '',
      ...(layout.scaleBarInside ? [] : this.scaleBar(plot, plot.right, last, false)),
    ];
    return { shapes, height: layout.bottom + 4 };
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
      const [left, top] = [plot.left + frame.x * sx, plot.top + frame.y * sy];
      const framed = (look) =>
        rectangle(left, top, frame.width * sx, frame.height * sy, `fill="none" ${look}`);
      return [
        framed('class="frame" stroke="#fff" stroke-width="3.5" stroke-opacity="0.85"'),
        framed('stroke="#000" stroke-width="1.3"'),
        text(left + 4, top + 13, frame.label, { weight: 600, fill: '#000', halo: '#fff' }),
      ];
    });
  }

  axes(plot) {
    const { unit, size } = this.lengths;
    const x = scaler(false, 0, this.width / size, plot.left, plot.right);
    const y = scaler(false, 0, this.height / size, plot.top, plot.bottom);
    const across = { label: 'x', unit };
    const up = ticks(0, this.height / size, plot.height / 40);
    return [
      rectangle(plot.left, plot.top, plot.width, plot.height, `fill="none" stroke="${kInk}"`),
      ...numbersAcross(ticks(0, this.width / size, Math.max(2, plot.width / 70)), across, x, plot.bottom),
      ...numbersUp(up, y, plot.left),
      titleAcross(across, plot.left + plot.width / 2, plot.bottom),
      text(4, plot.top - 8, axisTitle('y', unit), { fill: kFaint }),
    ];
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
    const middle = x - wide / 2;
    return [
      onPicture ? rectangle(x - wide, y - 22, wide, 30, 'fill="#fff" fill-opacity="0.88"') : '',
      rectangle(middle - w / 2, y - 1, w, 4, 'class="scale-bar" fill="#000"'),
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
    const { plot } = this.layout(width);
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
    const words = value === null ? 'not measured' : withUnit(value, this.unit, 4);
    return [`${place}: `, element('b', {}, words)];
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

/** A height map as a figure of the page. */
export function mapFigure(map) {
  const drawn = new MapFigure(map);
  return {
    id: map.name,
    title: map.title,
    host: 'map',
    draw: (width) => drawn.draw(width),
    at: (x, y, width) => drawn.at(x, y, width),
    caption: () => [map.caption, drawn.description()].filter(Boolean).join(' '),
    spoken: `${map.title}: ${drawn.description()}`,
  };
}
