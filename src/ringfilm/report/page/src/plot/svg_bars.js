// Bars with their values written on them; contributions and cases look as they do on the lines.
import { axisTitle, yTicks } from './scales.js';
import { caseColour } from './palette.js';
import { kFaint, kInk, kMargin, px, rule, safe, scaler, text } from './svg_shapes.js';
import { number, percent, tickText } from '../units.js';

/** Upright bars, grouped by category. */
export function barPanel(panel, box, visible) {
  const groups = panel.groups.filter(visible);
  const [left, right] = [box.x + kMargin.left, box.x + box.width - kMargin.right];
  const [high, low] = [box.y + kMargin.top - 16, box.y + box.height - 28];
  const total = (stack) => stack.reduce((sum, part) => sum + (part.value ?? 0), 0);
  const top = 1.12 * Math.max(1e-300, ...groups.flatMap((g) => g.stacks.map(total)));
  const y = scaler(false, 0, top, low, high);
  const out = [];
  const up = yTicks(panel, 0, top, (low - high) / 36);
  for (const v of up.values)
    out.push(
      rule(left, y(v), right, y(v), '#e3e6ea'),
      text(left - 6, y(v) + 4, tickText(v, up.step), { anchor: 'end' }),
    );
  const slot = (right - left) / panel.categories.length;
  const width = Math.min(46, (0.9 * slot) / Math.max(1, groups.length));
  const narrow = width < 30;
  panel.categories.forEach((category, i) => {
    const middle = left + slot * (i + 0.5);
    out.push(text(middle, low + 18, category, { anchor: 'middle' }));
    groups.forEach((group, g) => {
      const x = middle + (g - groups.length / 2) * width;
      let base = 0;
      for (const part of group.stacks[i]) {
        const size = Math.max(0, part.value ?? 0);
        const colour = caseColour(group.caseIndex);
        const look =
          part.part === 'viscous'
            ? `fill="${colour}" fill-opacity="0.35" stroke="${colour}"`
            : `fill="${colour}" stroke="${colour}"`;
        const tooltip = safe(`${group.label}, ${category}: ${number(part.value, 4)} ${panel.yUnit}`);
        out.push(
          `<rect x="${px(x + 1)}" y="${px(y(base + size))}" width="${px(width - 2)}" ` +
            `height="${px(Math.max(0, y(base) - y(base + size)))}" ` +
            `${look}><title>${tooltip}</title></rect>`,
        );
        base += size;
      }
      out.push(
        text(x + width / 2, y(base) - 4, number(base, narrow ? 2 : 3), {
          anchor: 'middle',
          size: narrow ? 9 : 11,
        }),
      );
    });
  });
  out.push(rule(left, low, right, low, kInk), rule(left, low, left, high, kInk));
  out.push(text(box.x + 4, box.y + 14, axisTitle(panel.yLabel, panel.yUnit), { weight: 600 }));
  return out.join('');
}

const kBar = 11;
const kBetween = 27;
/** Room for the name above its bars. */
const kName = 19;

const rowHeight = (panel) => kBetween + kBar * panel.groups.length;

export function rankedHeight(panel) {
  return 30 + panel.categories.length * rowHeight(panel);
}

/** Lying bars of a signed change around a zero line, one row a category, its name above the bars. */
export function rankedPanel(panel, box, visible) {
  const groups = panel.groups.filter(visible);
  const kRoom = 56;
  const [left, right] = [box.x + 8 + kRoom, box.x + box.width - 8 - kRoom];
  const all = groups
    .flatMap((g) => g.stacks.map(([part]) => part.value))
    .filter((v) => v !== null && Number.isFinite(v));
  const [bottom, top] = [Math.min(0, ...all), Math.max(0, ...all)];
  const x = scaler(false, bottom, top === bottom ? bottom + 1 : top, left, right);
  const out = [text(box.x + 4, box.y + 14, axisTitle(panel.yLabel, panel.yUnit), { weight: 600 })];
  const first = box.y + 28;
  panel.categories.forEach((category, i) => {
    const y = first + i * rowHeight(panel);
    out.push(text(box.x + 8, y + 11, category, { size: 11.5 }));
    out.push(rule(x(0), y + kName - 1, x(0), y + kName + kBar * groups.length, kInk));
    groups.forEach((group, g) => {
      const { value } = group.stacks[i][0];
      const at = y + kName + g * kBar;
      if (value === null || !Number.isFinite(value)) {
        out.push(text(x(0) + 4, at + 9, `${group.label}: no value`, { size: 10, fill: kFaint }));
        return;
      }
      const [from, to] = [Math.min(x(0), x(value)), Math.max(x(0), x(value))];
      out.push(
        `<rect x="${px(from)}" y="${px(at)}" width="${px(Math.max(0.8, to - from))}" ` +
          `height="${kBar - 2}" fill="${caseColour(group.caseIndex)}"><title>` +
          `${safe(`${group.label}, ${category}: ${percent(value / 100)}`)}</title></rect>`,
      );
      out.push(
        text(value < 0 ? from - 4 : to + 4, at + 8.5, percent(value / 100), {
          anchor: value < 0 ? 'end' : 'start',
          size: 10.5,
        }),
      );
    });
  });
  return out.join('');
}
