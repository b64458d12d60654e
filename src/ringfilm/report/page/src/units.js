// From SI to the units in which engineers read, and numbers as text.

/** Sizes in SI of the symbols of which units are made, and of the prefixes before them. */
const kSymbols = {
  ...{
    1: 1,
    '%': 0.01,
    m: 1,
    s: 1,
    min: 60,
    h: 3600,
    l: 1e-3,
    g: 1e-3,
    K: 1,
    N: 1,
    J: 1,
    W: 1,
    Pa: 1,
    bar: 1e5,
  },
  ...{ rad: 1, rpm: Math.PI / 30, degree: 1, deg: 1, P: 0.1, St: 1e-4 },
};
const kPrefixes = { n: 1e-9, u: 1e-6, m: 1e-3, c: 1e-2, k: 1e3, M: 1e6, G: 1e9 };

/** Size of one symbol with its power: of "um-2" 1e12. */
function symbolSize(text) {
  const [, symbol, power = '1'] = /^(1|%|[A-Za-z]+)(-?\d+)?$/.exec(text) ?? [];
  const size = kSymbols[symbol] ?? kPrefixes[symbol?.[0]] * kSymbols[symbol?.slice(1)];
  return size ** Number(power);
}

/** Size in SI of a unit such as "kg/(m s)"; NaN where it is not known. */
function sizeInSi(unit) {
  const product = (text) =>
    text
      .replace(/[()]/g, '')
      .split(/[ .]/)
      .reduce((size, symbol) => size * symbolSize(symbol), 1);
  const [above, ...below] = unit.split('/');
  return below.reduce((size, text) => size / product(text), product(above));
}

/** A value in SI, or a list of them, in another unit; null stays null. */
export function converted(value, unit) {
  const size = sizeInSi(unit);
  const one = (v) => (v === null || v === undefined ? null : v / size);
  return Array.isArray(value) ? value.map(one) : one(value);
}

/** Units that are printed otherwise than by the rules of typesetUnit(). */
const kShownUnit = {
  1: '',
  degree: '°',
  deg: '°',
  degC: '°C',
  'mPa.s': 'mPa s',
  'Pa.s': 'Pa s',
  'Pa-1': '1/Pa',
  'GPa-1': '1/GPa',
};

/** A unit in the spelling of the program as it is printed: "um3" is µm³, "nN V-1" is nN V⁻¹; '' of a plain number. */
export function typesetUnit(unit) {
  if (unit in kShownUnit) return kShownUnit[unit];
  return unit
    .replace(/\bu(?=[A-Za-z])/g, 'µ')
    .replace(/(?<=[A-Za-z])-?\d+/g, superscript)
    .replace(/\./g, '\u202f');
}

/** How to show a quantity: { unit, convert }. Without a known display unit in SI. */
export function display({ unit, display_unit: shown }) {
  const kept = (convert) => (v) => (v === null ? null : convert(v));
  if (unit === 'K' && shown === 'degC') return { unit: '°C', convert: kept((v) => v - 273.15) };
  if (unit === 'rad' && shown === 'degree') return { unit: '°', convert: kept(inDegrees) };
  const size = shown ? sizeInSi(shown) : NaN;
  if (Number.isNaN(size)) return { unit: typesetUnit(unit), convert: (v) => v };
  return { unit: typesetUnit(shown), convert: kept((v) => v / size) };
}

/** An angle in radian in degree. */
export function inDegrees(radian) {
  return (radian * 180) / Math.PI;
}

const kSuperscript = {
  '-': '⁻',
  0: '⁰',
  1: '¹',
  2: '²',
  3: '³',
  4: '⁴',
  5: '⁵',
  6: '⁶',
  7: '⁷',
  8: '⁸',
  9: '⁹',
};

const superscript = (text) => [...String(text)].map((c) => kSuperscript[c]).join('');

/**
 * Four significant digits, powers of ten outside 0.001..100000, a true minus sign, an en dash where there is
 * no number.
 */
export function number(value, digits = 4) {
  if (value === null || value === undefined || !Number.isFinite(value)) return '–';
  if (Math.abs(value) < 1e-14) return '0'; // in units of people: what rounding leaves of zero
  const size = Math.abs(value);
  let text;
  if (size < 1e-3 || size >= 1e6) {
    const [mantissa, exponent] = value.toExponential(digits - 1).split('e');
    text = `${mantissa}\u202f·\u202f10${superscript(Number(exponent))}`;
  } else if (size >= 10 ** digits) {
    text = value.toFixed(0);
  } else {
    text = value.toPrecision(digits);
    if (text.includes('e')) text = Number(text).toFixed(0); // 999.97 to three digits
  }
  return text.replace(/^-/, '−').replace(/(\s|·)-/g, '$1−');
}

/** A number in these digits; a count in all its digits and no more. */
export function numberOrCount(value, unit, digits = 4) {
  return !unit && Number.isInteger(value) && Math.abs(value) < 1e6
    ? String(value).replace(/^-/, '−')
    : number(value, digits);
}

/** An angle to a tenth of a degree, without idle zeros. */
export function angle(value) {
  return value === null || !Number.isFinite(value)
    ? '–'
    : String(Number(value.toFixed(1))).replace(/^-/, '−');
}

/** A number in the digits that suit its unit. */
export function inUnit(value, unit, digits = 4) {
  return unit === '°' ? angle(value) : number(value, digits);
}

/** Plain decimal text for CSV. */
export function plain(value) {
  return value === null || value === undefined || !Number.isFinite(value)
    ? ''
    : String(Number(value.toPrecision(8)));
}

/** "62.00 bar"; a percent sign or degree sign follows without a blank. */
export function withUnit(value, unit, digits = 4) {
  const text = number(value, digits);
  if (!unit || text === '–') return text;
  return unit === '°' ? text + unit : `${text}\u00a0${unit}`;
}

/**
 * "19.09 ± 0.02": the error rounded up to one digit (two where the first is 1), the value to the same place.
 * Without an error, or with that of an input, the value alone.
 */
export function withError(value, error, unit, digits = 4) {
  if (!(error > 0) || !Number.isFinite(value) || !Number.isFinite(error)) return inUnit(value, unit, digits);
  const kMostDigits = 7;
  const first = Math.floor(Math.log10(error));
  const rounded = error < 2 * 10 ** first ? 1 - first : -first;
  // A peak that may be another one is still at an angle.
  const shown = unit === '°' ? Math.max(0, rounded) : rounded;
  const most = value === 0 ? shown : kMostDigits - 1 - Math.floor(Math.log10(Math.abs(value)));
  const places = Math.min(shown, most);
  if (places > 12 || Math.abs(value) >= 1e9) return `${number(value, digits)} ± ${number(error, 1)}`;
  const step = 10 ** -places;
  const text = (v) => v.toFixed(Math.max(0, places)).replace(/^-/, '−');
  return `${text(Math.round(value / step) * step)} ± ${text(Math.ceil((error / step) * (1 - 1e-9)) * step)}`;
}

/** An error rounded up to one digit; '' without one. */
export function errorText(error) {
  if (!(error > 0) || !Number.isFinite(error)) return '';
  const power = Math.floor(Math.log10(error) + 1e-9);
  const digit = Math.ceil((error / 10 ** power) * (1 - 1e-9));
  return power < -9 || power > 8
    ? number(digit * 10 ** power, 1)
    : (digit * 10 ** power).toFixed(Math.max(0, -power));
}

/** A value in three significant digits, or fewer where its error leaves fewer: what a reader can use. */
export function meaningful(value, error) {
  const kDigits = 3;
  if (!(error > 0) || !Number.isFinite(value) || value === 0) return number(value, kDigits);
  const digits = 1 + Math.floor(Math.log10(Math.abs(value))) - Math.floor(Math.log10(error));
  return number(value, Math.max(1, Math.min(kDigits, digits)));
}

/** A value with its error, both with one power of ten far from one: "(8.1 ± 0.4) · 10⁻⁸". */
export function withErrorAndPower(value, error, unit, digits = 4) {
  const size = Math.max(Math.abs(value ?? NaN), error > 0 ? error : 0);
  if (!(error > 0) || !(size > 0) || (size >= 1e-3 && size < 1e6))
    return withError(value, error, unit, digits);
  const exponent = Math.floor(Math.log10(size));
  const size10 = 10 ** exponent;
  return `(${withError(value / size10, error / size10, unit, digits)})\u202f·\u202f10${superscript(exponent)}`;
}

/** A stated value in the digits it was stated with, at most four. */
export function asStated(value, unit) {
  const text = number(value, 4);
  const shown = /^[−\d.]+$/.test(text) && text.includes('.') ? text.replace(/\.?0+$/, '') : text;
  if (!unit || text === '–') return shown;
  return unit === '°' ? shown + unit : `${shown}\u00a0${unit}`;
}

/** A signed change in per cent; where it makes more than 11 times a positive reference, that factor. */
export function percent(ratio, digits = 1, ofPositive = true) {
  if (ratio === null || !Number.isFinite(ratio)) return '–';
  if (ratio >= 10 && ofPositive) return `×\u00a0${number(1 + ratio, 3)}`;
  const value = 100 * ratio;
  const places = Math.abs(value) >= 100 ? 0 : digits;
  const text = Math.abs(value).toFixed(places);
  const sign = Number(text) === 0 ? '±' : value < 0 ? '−' : '+';
  return `${sign}${text}\u00a0%`;
}

/** An angle on the axis of the charts: firing TDC in the middle, -360 < angle <= 360. */
export function wrapped(degrees) {
  if (degrees === null || degrees === undefined) return null;
  const turned = ((((degrees + 360) % 720) + 720) % 720) - 360;
  return turned === -360 ? 360 : turned;
}

/** Index of the angle of a list that is nearest to another around the cycle, -1 in an empty list. */
export function nearestAngle(angles, target) {
  const away = (k) => Math.abs(wrapped(angles[k] - target));
  return angles.reduce((best, _, k) => (best < 0 || away(k) < away(best) ? k : best), -1);
}

/** "20° after firing TDC" */
export function angleInWords(degrees) {
  if (!Number.isFinite(degrees ?? NaN)) return 'at an angle not known';
  const a = wrapped(degrees);
  const size = `${angle(Math.abs(a))}°`;
  if (a === 0) return 'at firing TDC';
  if (Math.abs(a) === 360) return 'at gas-exchange TDC';
  return a > 0 ? `${size} after firing TDC` : `${size} before firing TDC`;
}

/** The path of a file that is shipped with the program is shown from these folders on. */
const kShippedIn = ['cases', 'data'];

/**
 * A path without the folders of one machine: from cases/ or data/ on, else its last two parts. A relative
 * path stays.
 */
export function shortPath(path) {
  if (!/^([/\\]|[A-Za-z]:[/\\])/.test(path)) return path;
  const parts = path.split(/[/\\]+/).filter(Boolean);
  const home = Math.max(...kShippedIn.map((name) => parts.lastIndexOf(name)));
  // Deeper down such a folder is more likely the reader's own.
  const kept = home >= 0 && parts.length - home <= 4 ? parts.slice(home) : parts.slice(-2);
  return kept.join('/');
}

/** "634 of 720 crank angles", "634 times", "once" */
export function howOften(count, whole) {
  if (whole) return `${count} of ${whole} crank angles`;
  return count === 1 ? 'once' : `${count} times`;
}

/** Steps of 1, 2 or 5 times a power of ten, about `count` of them. */
export function ticks(low, high, count) {
  const raw = (high - low) / Math.max(1, count);
  const power = 10 ** Math.floor(Math.log10(raw));
  const step = [1, 2, 5, 10].map((m) => m * power).find((s) => s >= raw * 0.999);
  return stepped(low, high, step);
}

/** Steps that divide a turn. */
export function crankTicks(low, high, count) {
  const raw = (high - low) / Math.max(1, count);
  const step = [0.1, 0.2, 0.5, 1, 2, 5, 10, 15, 30, 45, 90, 180].find((s) => s >= raw * 0.999) ?? 180;
  return stepped(low, high, step);
}

function stepped(low, high, step) {
  const list = [];
  for (let k = Math.ceil(low / step - 1e-9); k * step <= high + 1e-9 * step; k++)
    list.push(Number((k * step).toPrecision(12)));
  return { values: list, step };
}

export function logTicks(low, high) {
  const decades = Math.log10(high / low);
  const factors = decades > 2.2 ? [1] : decades > 1.2 ? [1, 3] : [1, 2, 5];
  const values = [];
  for (let e = Math.floor(Math.log10(low)); e <= Math.ceil(Math.log10(high)); e++) {
    for (const f of factors) {
      const v = f * 10 ** e;
      if (v >= low * 0.999 && v <= high * 1.001) values.push(v);
    }
  }
  return { values, step: 0 };
}

export function tickText(value, step) {
  if (step === 0)
    return value >= 1e4 || value < 1e-3 ? number(value, 1) : String(Number(value.toPrecision(3)));
  const size = Math.abs(value);
  if (size >= 1e6 || (size > 0 && step < 1e-4)) return number(value, 3);
  const places = Math.max(0, Math.min(6, -Math.floor(Math.log10(step) + 1e-9)));
  return value.toFixed(places).replace(/^-/, '−');
}

const kTypeset = [
  [/\bdegC\b/g, '°C'],
  [/(\d) degrees?\b/g, '$1°'],
  [/\bum-2\b/g, 'µm⁻²'],
  [/\bum\b/g, 'µm'],
  [/\bmm2\b/g, 'mm²'],
  [/\bmm-2\b/g, 'mm⁻²'],
  [/ \+- /g, ' ± '],
  [/\bm3\b/g, 'm³'],
  [/\bPa-1\b/g, 'Pa⁻¹'],
];

/**
 * Units and powers of ten in running text as they are printed: "120 degC" is 120 °C. Not for text that one would copy
 * into a case.
 */
export function typeset(text) {
  const powers = text.replace(
    /(?<![\w.])(\d+(?:\.\d+)?)e\+?(-?)0*(\d+)\b/g,
    (_, mantissa, sign, digits) => `${mantissa}\u202f·\u202f10${superscript(sign + digits)}`,
  );
  return kTypeset.reduce((out, [plainUnit, printed]) => out.replace(plainUnit, printed), powers);
}

const kGreek = {
  alpha: 'α',
  beta: 'β',
  gamma: 'γ',
  delta: 'δ',
  epsilon: 'ε',
  zeta: 'ζ',
  eta: 'η',
  theta: 'θ',
  kappa: 'κ',
  lambda: 'λ',
  mu: 'µ',
  nu: 'ν',
  rho: 'ρ',
  sigma: 'σ',
  tau: 'τ',
  phi: 'φ',
  psi: 'ψ',
  omega: 'ω',
};

/** Greek letters of a symbol as such: "N beta sigma" is N β σ. */
export function typesetSymbol(symbol) {
  return symbol.replace(/(?<![A-Za-z])[a-z]+(?![a-z])/g, (word) =>
    Object.hasOwn(kGreek, word) ? kGreek[word] : word,
  );
}

const kSubscript = [...'₀₁₂₃₄₅₆₇₈₉'];

/** Formulas in running text as far as plain letters allow: "sum (1 - nu^2)/E_1" is Σ (1 − ν²)/E₁. */
export function typesetFormula(text) {
  // The lambda ratio is a word of the field, not a formula.
  return text
    .split(/(lambda ratio)/)
    .map((piece) => (piece === 'lambda ratio' ? piece : typesetSymbol(piece)))
    .join('')
    .replace(/\bsum \(/g, 'Σ (')
    .replace(/\bsqrt\(pi\/2\)/g, '√(π/2)')
    .replace(/\(1 - /g, '(1 − ')
    .replace(/\^2\b/g, '²')
    .replace(/(?<=\p{L})_(\d)/gu, (_, digit) => kSubscript[Number(digit)]);
}

const kCommands = { sqrt: '√', le: '≤', ge: '≥', cdot: '·', times: '×', int: '∫', infty: '∞', partial: '∂' };
const kRaised = { ...kSuperscript, '+': '⁺', '/': 'ᐟ' };
const raised = (text) =>
  [...text].every((c) => c in kRaised) ? [...text].map((c) => kRaised[c]).join('') : `^(${text})`;
const lowered = (text) =>
  /^\d+$/.test(text) ? [...text].map((digit) => kSubscript[Number(digit)]).join('') : `_${text}`;

/** Formulas between dollar signs as far as plain letters allow: "$\\eta U^2/(12k)$" is ηU²/(12k). */
export function typesetMath(text) {
  return text.replace(/\$([^$]+)\$/g, (_, formula) =>
    formula
      .replace(/\\[,;: !]/g, '\u2009')
      .replace(/\\([A-Za-z]+) ?/g, (whole, name) => kGreek[name] ?? kCommands[name] ?? name)
      .replace(/\^(?:\{([^}]*)\}|(.))/g, (whole, group, one) => raised(group ?? one))
      .replace(/_(?:\{([^}]*)\}|(.))/g, (whole, group, one) => lowered(group ?? one))
      .replace(/[{}]/g, '')
      .replace(/(?<=[ηµβρσαλ]) (?=[A-Za-z])/g, ''),
  );
}

/** Absolute paths in running text without the folders of one machine, see shortPath(). */
export function withoutFolders(text) {
  return text.replace(
    /(?<![\w.:/\\])(?:\/|[A-Za-z]:[/\\])(?:[^\s:;,"'()/\\]+[/\\])+[^\s:;,"'()/\\]+/g,
    (path) => shortPath(path),
  );
}

/** A statement as a sentence of its own. */
export function sentence(given) {
  if (!given) return '';
  const text = typeset(given);
  const begun = /^[a-z][a-z ]/.test(text) ? text[0].toUpperCase() + text.slice(1) : text;
  return /[.!?]$/.test(begun) ? begun : `${begun}.`;
}
