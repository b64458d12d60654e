// Values, tables and the fragment of a measurement.
import { element } from '../dom.js';
import { fileStem, save, saveButton } from '../downloads.js';
import { axisTitle } from '../plot/scales.js';
import { right, table, withCsv } from '../tables.js';
import { numberOrCount, typeset, typesetSymbol, typesetUnit, withErrorAndPower } from '../units.js';

/** "0.412 ± 0.013", without its unit. */
export function shownNumber(value) {
  return value.error > 0
    ? withErrorAndPower(value.value, value.error, '', 4)
    : numberOrCount(value.value, typesetUnit(value.unit), 4);
}

function shownValue(value) {
  const text = shownNumber(value);
  const unit = typesetUnit(value.unit);
  return !unit || text === '–' ? text : `${text}\u00a0${unit}`;
}

/** "mean radius, β [µm]"; a symbol that only repeats a word of the name is omitted. */
function columnHead(column) {
  const name = column.long_name || column.name;
  const addsSymbol = column.symbol && !name.toLowerCase().split(/\W+/).includes(column.symbol.toLowerCase());
  return axisTitle(addsSymbol ? `${name}, ${typesetSymbol(column.symbol)}` : name, typesetUnit(column.unit));
}

const headed = (title, context, id, columns) =>
  withCsv(element('h3', {}, typeset(title)), title, context, id, () => columns);

export function groupTable(group, index, context) {
  const rows = group.values.map((value) => [
    value.long_name || value.name,
    typesetSymbol(value.symbol),
    right(shownValue(value)),
    typeset(value.remark) || '–',
  ]);
  const columns = [
    { title: 'quantity', values: group.values.map((v) => v.long_name || v.name) },
    { title: 'symbol', values: group.values.map((v) => v.symbol) },
    { title: 'value', values: group.values.map((v) => v.value) },
    { title: 'standard error', values: group.values.map((v) => v.error) },
    { title: 'unit', values: group.values.map((v) => v.unit) },
    { title: 'holds for', values: group.values.map((v) => v.remark) },
  ];
  return [
    headed(group.title, context, `values-${index + 1}`, columns),
    table(group.title, ['quantity', 'symbol', right('value'), 'holds for'], rows, {
      folds: true,
      classes: 'values titled',
    }),
  ];
}

function remarks(columns) {
  const remarked = columns.filter((column) => column.remark);
  if (remarked.length === 0) return null;
  const [first] = remarked;
  if (columns.every((column) => column.remark === first.remark))
    return element('p', { class: 'how' }, `${typeset(first.remark)}.`);
  return element(
    'p',
    { class: 'how' },
    remarked.map((column) => `${column.long_name || column.name}: ${typeset(column.remark)}`).join('; '),
    '.',
  );
}

export function numbersTable(given, context) {
  const count = given.columns[0]?.values.length ?? 0;
  const labels = given.row_labels.length
    ? given.row_labels
    : Array.from({ length: count }, (_, k) => String(k + 1));
  const rows = labels.map((label, k) => [
    typeset(label),
    ...given.columns.map((column) => right(numberOrCount(column.values[k], typesetUnit(column.unit), 4))),
  ]);
  const columns = [
    { title: '', values: labels },
    ...given.columns.map((column) => ({
      title: axisTitle(column.name, column.unit === '1' ? '' : column.unit),
      values: column.values,
    })),
  ];
  return [
    headed(given.title, context, given.name, columns),
    remarks(given.columns),
    table(
      given.title,
      [given.row_labels.length ? '' : 'row', ...given.columns.map((column) => right(columnHead(column)))],
      rows,
      { folds: given.columns.length > 3, classes: 'titled' },
    ),
  ];
}

/** A page on a disk may not have the clipboard of its own. */
function copied(text, block) {
  const selected = () => {
    const range = document.createRange();
    range.selectNodeContents(block);
    getSelection().removeAllRanges();
    getSelection().addRange(range);
    return document.execCommand('copy');
  };
  return navigator.clipboard
    ? navigator.clipboard.writeText(text).then(() => true, selected)
    : Promise.resolve(selected());
}

export function fragmentBlock(fragment, context) {
  const block = element('pre', { tabindex: '0' }, fragment);
  const copy = element(
    'button',
    {
      type: 'button',
      class: 'download copy',
      onclick: () =>
        copied(fragment, block).then((done) => {
          copy.textContent = done ? 'Copied' : 'Select and copy by hand';
          setTimeout(() => {
            copy.textContent = 'Copy';
          }, 2500);
        }),
    },
    'Copy',
  );
  return [
    element(
      'p',
      {},
      'These lines, or the file that holds them, give the numbers above to a case. ',
      element(
        'span',
        { class: 'fragment-buttons' },
        copy,
        saveButton('TOML', () =>
          save(`${fileStem(context.stem, 'fragment')}.toml`, 'application/toml', fragment),
        ),
      ),
    ),
    block,
  ];
}
