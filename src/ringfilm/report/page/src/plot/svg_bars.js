// Bars with their values written on them; contributions and cases look as they do on the lines.
import { frame } from './plot_frame.js';
import { axisTitle, extent } from './scales.js';
import { caseColour } from './palette.js';
import { boldText, kFaint, kInk, kLetter, legend, rectangle, rule, scaler, text } from './svg_shapes.js';
import { number, percent } from '../units.js';

/** Upright bars, grouped by category. */
export function barPanel(panel, box, visible) {
  const groups = panel.groups.filter(visible);
  const total = (stack) => stack.reduce((sum, part) => sum + (part.value ?? 0), 0);
  const high = 1.12 * Math.max(1e-300, ...groups.flatMap((g) => g.stacks.map(total)));
  const { plot, y, shapes, edges } = frame(
    box,
    { bare: true, low: 0, high: 1 },
    { low: 0, high, label: panel.yLabel, unit: panel.yUnit },
    { bottom: 28 },
  );
  const out = [...shapes];
  const slot = (plot.right - plot.left) / panel.categories.length;
  const width = Math.min(46, (0.9 * slot) / Math.max(1, groups.length));
  const narrow = width < 30;
  panel.categories.forEach((category, i) => {
    const middle = plot.left + slot * (i + 0.5);
    out.push(text(middle, plot.bottom + 18, category, { anchor: 'middle' }));
    groups.forEach((group, g) => {
      const x = middle + (g - groups.length / 2) * width;
      const colour = caseColour(group.caseIndex);
      let base = 0;
      for (const { part, value } of group.stacks[i]) {
        const size = Math.max(0, value ?? 0);
        out.push(
          rectangle(
            x + 1,
            y(base + size),
            width - 2,
            y(base) - y(base + size),
            `fill="${colour}" stroke="${colour}"${part === 'viscous' ? ' fill-opacity="0.35"' : ''}`,
            `${group.label}, ${category}: ${number(value, 4)} ${panel.yUnit}`,
          ),
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
  return [...out, ...edges];
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
  const [bottom, top] = extent([0, ...groups.flatMap((g) => g.stacks.map(([part]) => part.value))]);
  const x = scaler(false, bottom, top === bottom ? bottom + 1 : top, left, right);
  const out = [boldText(box.x + 4, box.y + 14, axisTitle(panel.yLabel, panel.yUnit), box.width)];
  panel.categories.forEach((category, i) => {
    const y = box.y + 28 + i * rowHeight(panel);
    out.push(text(box.x + 8, y + 11, category, { size: 11.5 }));
    out.push(rule(x(0), y + kName - 1, x(0), y + kName + kBar * groups.length, kInk));
    groups.forEach((group, g) => {
      const { value } = group.stacks[i][0];
      const at = y + kName + g * kBar;
      if (value === null || !Number.isFinite(value)) {
        out.push(text(x(0) + 4, at + 9, `${group.label}: no value`, { size: 10, fill: kFaint }));
        return;
      }
      const words = percent(value / 100);
      const [from, to] = [Math.min(x(0), x(value)), Math.max(x(0), x(value))];
      const look = `fill="${caseColour(group.caseIndex)}"`;
      out.push(
        rectangle(
          from,
          at,
          Math.max(0.8, to - from),
          kBar - 2,
          look,
          `${group.label}, ${category}: ${words}`,
        ),
        text(value < 0 ? from - 4 : to + 4, at + 8.5, words, {
          anchor: value < 0 ? 'end' : 'start',
          size: 10.5,
        }),
      );
    });
  });
  return out;
}

const kShareBar = 20;
const kShareRow = kShareBar + 6;
/** Room for the legend and for the name of a case. */
const kShareLegend = 30;
const kShareName = 20;

export function sharesHeight(panel) {
  const { categories, groups } = panel;
  return (
    kShareLegend + groups.length * (categories.length * kShareRow + (groups.length > 1 ? kShareName : 4))
  );
}

/** Lying bars that add up to the whole, one a category; of several cases below the name of each. */
export function sharesPanel(panel, box, visible) {
  const { categories, parts } = panel;
  const left = box.x + 16 + kLetter * Math.max(...categories.map((category) => category.length));
  const wide = box.x + box.width - 8 - left;
  const names = parts.map(({ name, colour }) => ({
    label: name,
    swatch: (x, y) => rectangle(x + 8, y - 6, 12, 12, `fill="${colour}"`),
  }));
  const out = [...legend(names, box.width, box.y).shapes];
  let y = box.y + kShareLegend;
  for (const group of panel.groups.filter(visible)) {
    if (panel.groups.length > 1) {
      out.push(boldText(box.x + 8, y + 11, group.label, box.width - 16));
      y += kShareName;
    }
    categories.forEach((category, i) => {
      out.push(text(left - 8, y + 14, category, { anchor: 'end' }));
      let from = left;
      group.stacks[i].forEach(({ value }, k) => {
        const size = (wide * Math.max(0, value ?? 0)) / 100;
        const words = `${number(value, 2)} %`;
        const { name, colour, isLight } = parts[k];
        out.push(
          rectangle(
            from,
            y,
            size,
            kShareBar,
            `fill="${colour}" stroke="#fff" stroke-width="0.6"`,
            `${group.label}, ${category}, ${name}: ${number(value, 3)} %`,
          ),
        );
        if (size > kLetter * words.length + 6)
          out.push(
            text(from + size / 2, y + 14, words, {
              anchor: 'middle',
              size: 11.5,
              fill: isLight ? '#000' : '#fff',
            }),
          );
        from += size;
      });
      y += kShareRow;
    });
  }
  return out;
}
