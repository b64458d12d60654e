// Files to take away: SVG and PNG of a figure as it is shown, CSV of the numbers behind it.
import { element } from './dom.js';
import { axisTitle } from './plot/scales.js';
import { plain } from './units.js';

export function save(name, type, content) {
  const link = document.createElement('a');
  link.download = name;
  link.href = URL.createObjectURL(new Blob([content], { type }));
  document.body.append(link);
  link.click();
  link.remove();
  setTimeout(() => URL.revokeObjectURL(link.href), 10000);
}

/** A button that takes something away. @param spoken its name where the label does not suffice */
export function saveButton(label, onclick, spoken = null) {
  return element('button', { type: 'button', class: 'download', 'aria-label': spoken, onclick }, label);
}

export function fileStem(title, id) {
  const words = title
    .toLowerCase()
    .replace(/[^a-z0-9]+/g, '-')
    .replace(/^-|-$/g, '')
    .slice(0, 60);
  return words ? `${words}-${id}` : id;
}

export function savePng(name, svg) {
  const image = new Image();
  image.onload = () => {
    const kPixels = 2;
    const canvas = document.createElement('canvas');
    canvas.width = image.width * kPixels;
    canvas.height = image.height * kPixels;
    const context = canvas.getContext('2d');
    context.scale(kPixels, kPixels);
    context.drawImage(image, 0, 0);
    canvas.toBlob((blob) => save(name, 'image/png', blob), 'image/png');
  };
  image.src = `data:image/svg+xml;charset=utf-8,${encodeURIComponent(svg)}`;
}

/** A column name that a spreadsheet reads as text, never as a formula. */
export function heading(text) {
  const harmless = /^[=+\-@\t]/.test(text) ? `'${text}` : text;
  return `"${harmless.replace(/"/g, '""')}"`;
}

const equal = (a, b) => a.length === b.length && a.every((v, k) => v === b[k]);

function barColumns(figure) {
  const first = figure.panels[0];
  const columns = [{ title: 'case', values: first.groups.map((g) => g.label) }];
  for (const panel of figure.panels) {
    panel.categories.forEach((category, i) => {
      if (panel.parts) {
        panel.parts.forEach(({ name }, k) =>
          columns.push({
            title: axisTitle(`${panel.yLabel}, ${category}, ${name}`, panel.yUnit),
            values: panel.groups.map((g) => g.stacks[i][k].value),
          }),
        );
        return;
      }
      const total = (g) => g.stacks[i].reduce((sum, part) => sum + (part.value ?? 0), 0);
      columns.push({
        title: axisTitle(`${panel.yLabel}, ${category}`, panel.yUnit),
        values: panel.groups.map(total),
      });
    });
  }
  return columns;
}

function lineColumns(figure) {
  const all = figure.panels.flatMap((panel) => panel.series.map((s) => ({ panel, s })));
  const oneAxis = all.every(({ panel, s }) => !panel.inOrderOfTime && equal(s.x, all[0].s.x));
  const columns = [];
  all.forEach(({ panel, s }, i) => {
    if (!oneAxis || i === 0) {
      const whose = oneAxis ? '' : `${s.label}: `;
      if (s.angle) columns.push({ title: `${whose}crank angle [degree]`, values: s.angle });
      columns.push({
        title: axisTitle(whose + panel.xLabel, panel.xUnit === '°' ? 'degree' : panel.xUnit),
        values: s.x,
      });
    }
    columns.push({ title: axisTitle(`${s.label}: ${panel.yLabel}`, panel.yUnit), values: s.y });
    if (s.error)
      columns.push({
        title: axisTitle(`${s.label}: error of ${panel.yLabel}`, panel.yUnit),
        values: s.error,
      });
    for (const band of s.bands ?? []) {
      columns.push({
        title: axisTitle(`${s.label}: ${panel.yLabel}, ${band.words[0]}`, panel.yUnit),
        values: band.low,
      });
      columns.push({
        title: axisTitle(`${s.label}: ${panel.yLabel}, ${band.words[1]}`, panel.yUnit),
        values: band.high,
      });
    }
  });
  return columns;
}

/** One x column where all series share it, else a pair of columns a series. */
export function figureCsv(figure) {
  return columnsCsv(figure.panels[0].bars ? barColumns(figure) : lineColumns(figure));
}

/** @param columns { title, values }, numbers or texts */
export function columnsCsv(columns) {
  const rows = Math.max(0, ...columns.map((c) => c.values.length));
  const lines = [columns.map((c) => heading(c.title)).join(',')];
  for (let k = 0; k < rows; k++) {
    lines.push(
      columns
        .map(({ values }) => (typeof values[k] === 'string' ? heading(values[k]) : plain(values[k])))
        .join(','),
    );
  }
  return `${lines.join('\r\n')}\r\n`;
}
