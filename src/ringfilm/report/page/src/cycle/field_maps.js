// Maps of fields one under the other over the same two axes: axes and colour bars as SVG, the fields as
// pixels.
import { heightColour } from '../plot/colour_map.js';
import { kNameRow, numbersAcross, numbersUp, titleAcross } from '../plot/plot_frame.js';
import { axisTitle } from '../plot/scales.js';
import { colourBar, numbersBelow, numbersBeside } from '../plot/svg_colour_bar.js';
import { hatching, kFaint, kInk, kLetter, px, rectangle, rule, scaler, text } from '../plot/svg_shapes.js';
import { number } from '../units.js';

const kLeft = 58;
const kBarRoom = 96;
const kRight = 16;
/** Below this width of the drawing colour bars lie under their maps. */
const kWide = 560;
/** Room of the axis above the first map [pixel]. */
const kAbove = 30;

/** Dark lines on white: no colour of a map, on paper neither. */
const kHatch = { dark: [48, 52, 59], light: [255, 255, 255], period: 6, width: 1.6 };

function hatchSample(left, top) {
  const { id, pattern } = hatching(5, 1.5, `rgb(${kHatch.dark})`);
  return (
    pattern +
    rectangle(left, top, 18, 12, `class="hatch" fill="url(#${id})" stroke="${kInk}" stroke-width="0.8"`)
  );
}

export class FieldMaps {
  /**
   * @param columns, rows axes (unrolled.js); rows go down the page
   * @param maps { title, unit, range, value(column, row), hatched(column, row), hatchLabel }
   * @param height height of a map for the width of its plot [pixel]
   */
  constructor({ title, columns, rows, maps, height, above = null, edgeWords = null }) {
    Object.assign(this, { title, columns, rows, maps, height, above, edgeWords });
  }

  /** Where everything is in a drawing of that width. */
  layout(width) {
    const beside = width >= kWide;
    const w = width - kLeft - (beside ? kBarRoom : kRight);
    const h = this.height(w);
    const names = this.columns.crank ? kNameRow : 0;
    let y = 0;
    const plots = this.maps.map((map, n) => {
      y += 24 + (n === 0 && this.above ? kAbove : 0);
      const plot = { left: kLeft, top: y, width: w, height: h };
      y += h + 24 + names + (n === this.maps.length - 1 ? 20 : 0);
      const bar = beside
        ? { left: kLeft + w + 16, top: plot.top, width: 14, height: h }
        : { left: kLeft, top: y + 4, width: w, height: 12 };
      if (!beside) y += 44;
      return { ...plot, bar };
    });
    return { plots, beside, bottom: y + 4 };
  }

  scales(plot) {
    return {
      x: scaler(false, this.columns.from, this.columns.to, plot.left, plot.left + plot.width),
      y: scaler(false, this.rows.from, this.rows.to, plot.top, plot.top + plot.height),
    };
  }

  /** @param pictures whether the fields themselves are drawn too; on the screen they lie under the drawing */
  draw(width, pictures) {
    const { plots, beside, bottom } = this.layout(width);
    return {
      shapes: this.maps.flatMap((map, n) => this.map(map, plots[n], n, beside, pictures)),
      height: bottom,
    };
  }

  map(map, plot, n, beside, pictures) {
    const { x, y } = this.scales(plot);
    const [right, low] = [plot.left + plot.width, plot.top + plot.height];
    const head = plot.top - 9 - (n === 0 && this.above ? kAbove : 0);
    const out = [text(4, head, axisTitle(map.title, map.unit), { weight: 600 })];
    if (map.hatchLabel) {
      const left = right - 24 - kLetter * map.hatchLabel.length;
      out.push(hatchSample(left, head - 10), text(left + 24, head, map.hatchLabel, { fill: kFaint }));
    }
    if (pictures)
      out.push(
        `<image href="${this.picture(map, plot)}" x="${px(plot.left)}" y="${px(plot.top)}" ` +
          `width="${px(plot.width)}" height="${px(plot.height)}" preserveAspectRatio="none"/>`,
      );
    for (const [from, to] of this.columns.pieces)
      for (const [upper, lower] of this.rows.pieces)
        out.push(
          rectangle(x(from), y(upper), x(to) - x(from), y(lower) - y(upper), `fill="none" stroke="${kInk}"`),
        );
    out.push(
      ...numbersAcross(this.columns.ticks(plot.width / 70), this.columns, x, low),
      ...numbersUp(this.rows.ticks(Math.max(2, plot.height / 36)), y, plot.left),
      `<text transform="translate(13 ${px((plot.top + low) / 2)}) rotate(-90)" ` +
        'text-anchor="middle" font-size="12" ' +
        `fill="${kFaint}">${axisTitle(this.rows.label, this.rows.unit)}</text>`,
    );
    if (n === 0 && this.above) out.push(...this.axisAbove(plot, x));
    if (this.edgeWords) {
      out.push(
        text(plot.left + 5, plot.top + 13, this.edgeWords[0], { size: 11, halo: '#fff' }),
        text(plot.left + 5, low - 5, this.edgeWords[1], { size: 11, halo: '#fff' }),
      );
    }
    if (n === this.maps.length - 1) out.push(titleAcross(this.columns, (plot.left + right) / 2, low));
    out.push(
      ...colourBar(plot.bar, beside),
      ...(beside ? numbersBeside(plot.bar, map.range) : numbersBelow(plot.bar, map.range)),
    );
    return out;
  }

  /** A second axis on top of the first map: other words for the same places. */
  axisAbove(plot, x) {
    const out = [];
    for (const { at, label, anchor = 'middle', tick = true } of this.above.marks(plot.width)) {
      out.push(
        tick ? rule(x(at), plot.top - 5, x(at), plot.top, kInk) : '',
        text(x(at), plot.top - 9, label, { anchor }),
      );
    }
    if (this.above.title)
      out.push(
        text(plot.left + plot.width / 2, plot.top - 24, this.above.title, { anchor: 'middle', fill: kFaint }),
      );
    return out;
  }

  /** Colours the pixels of one map; white where there is nothing. */
  paint(context, map, width, height, ratio) {
    const pixels = context.createImageData(width, height);
    const share = (axis, k, n) => axis.index(axis.from + ((axis.to - axis.from) * (k + 0.5)) / n);
    const columns = Array.from({ length: width }, (_, k) => share(this.columns, k, width));
    const rows = Array.from({ length: height }, (_, k) => share(this.rows, k, height));
    const [from, to] = map.range;
    const [nColumns, nRows] = [Math.max(...columns) + 1, Math.max(...rows) + 1];
    // A cell is wider than a pixel: its colour is found once, when it is first met.
    const kUnknown = -1;
    const kHatched = -2;
    const cells = new Int32Array(nColumns * nRows).fill(kUnknown);
    const packedColour = ([r, g, b]) => r | (g << 8) | (b << 16);
    const [white, light, dark] = [[255, 255, 255], kHatch.light, kHatch.dark].map(packedColour);
    const colour = (c, r) => {
      const value = map.value(c, r);
      if (value === null) return white;
      return map.hatched?.(c, r) ? kHatched : packedColour(heightColour((value - from) / (to - from)));
    };
    const { data } = pixels;
    for (let py = 0, at = 0; py < height; py++) {
      for (let qx = 0; qx < width; qx++, at += 4) {
        let found = white;
        if (columns[qx] >= 0 && rows[py] >= 0) {
          const cell = rows[py] * nColumns + columns[qx];
          if (cells[cell] === kUnknown) cells[cell] = colour(columns[qx], rows[py]);
          found = cells[cell];
        }
        if (found === kHatched) found = ((qx + py) / ratio) % kHatch.period < kHatch.width ? dark : light;
        data[at] = found & 255;
        data[at + 1] = (found >> 8) & 255;
        data[at + 2] = (found >> 16) & 255;
        data[at + 3] = 255;
      }
    }
    context.putImageData(pixels, 0, 0);
  }

  canvas(map, plot, ratio, canvas = document.createElement('canvas')) {
    const [width, height] = [
      Math.max(1, Math.round(plot.width * ratio)),
      Math.max(1, Math.round(plot.height * ratio)),
    ];
    if (canvas.width !== width) canvas.width = width;
    if (canvas.height !== height) canvas.height = height;
    this.paint(canvas.getContext('2d'), map, width, height, ratio);
    return canvas;
  }

  picture(map, plot) {
    const kSavedRatio = 2;
    return this.canvas(map, plot, kSavedRatio).toDataURL('image/png');
  }

  /**
   * The place under a pixel of a drawing of that width: { map, column, row, atColumn, atRow }; null outside
   * the maps.
   */
  at(px0, py0, width) {
    for (const [n, plot] of this.layout(width).plots.entries()) {
      const [a, b] = [(px0 - plot.left) / plot.width, (py0 - plot.top) / plot.height];
      if (a < 0 || a > 1 || b < 0 || b > 1) continue;
      const atColumn = this.columns.from + a * (this.columns.to - this.columns.from);
      const atRow = this.rows.from + b * (this.rows.to - this.rows.from);
      return { map: n, atColumn, atRow, column: this.columns.index(atColumn), row: this.rows.index(atRow) };
    }
    return null;
  }

  /** For people who cannot see the maps. */
  spoken() {
    return this.maps
      .map(
        (map) =>
          `${axisTitle(map.title, map.unit)}, colours from ${number(map.range[0], 3)} to ` +
          `${number(map.range[1], 3)}`,
      )
      .join('; ');
  }
}
