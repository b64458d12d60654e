// Colours for heights: evenly spaced to the eye and of steadily rising lightness, so that grey print keeps
// the order.

/** Where nothing was measured: a grey, which the map itself never comes near. */
export const kMissingColour = '#c3c6cb';

const kColours = 256;
const kLightness = [0.27, 0.95];
/** From violet blue over green to yellow [degree]. */
const kHue = [288, 104];
const kChroma = [0.085, 0.125];

/** OKLab (Ottosson 2020) to linear sRGB. */
function linear([lightness, a, b]) {
  const l = (lightness + 0.3963377774 * a + 0.2158037573 * b) ** 3;
  const m = (lightness - 0.1055613458 * a - 0.0638541728 * b) ** 3;
  const s = (lightness - 0.0894841775 * a - 1.291485548 * b) ** 3;
  return [
    4.0767416621 * l - 3.3077115913 * m + 0.2309699292 * s,
    -1.2684380046 * l + 2.6097574011 * m - 0.3413193965 * s,
    -0.0041960863 * l - 0.7034186147 * m + 1.707614701 * s,
  ];
}

function byte(v) {
  const part = Math.min(1, Math.max(0, v));
  return Math.round(255 * (part <= 0.0031308 ? 12.92 * part : 1.055 * part ** (1 / 2.4) - 0.055));
}

function place(t) {
  const mix = ([from, to]) => from + t * (to - from);
  const hue = (mix(kHue) * Math.PI) / 180;
  const chroma = mix(kChroma);
  return [mix(kLightness), chroma * Math.cos(hue), chroma * Math.sin(hue)];
}

/** [red, green, blue] of 256 colours, equal distances in OKLab apart. */
function evenColours() {
  const kFine = 4096;
  const fine = Array.from({ length: kFine + 1 }, (_, k) => place(k / kFine));
  const length = [0];
  for (let k = 1; k <= kFine; k++)
    length.push(length[k - 1] + Math.hypot(...fine[k].map((v, i) => v - fine[k - 1][i])));
  const colours = [];
  let at = 0;
  for (let k = 0; k < kColours; k++) {
    const target = (length[kFine] * k) / (kColours - 1);
    while (at < kFine && length[at] < target) at++;
    colours.push(linear(fine[at]).map(byte));
  }
  return colours;
}

export const kHeightColours = evenColours();

export function colourText([r, g, b]) {
  return `rgb(${r},${g},${b})`;
}

/** Colour of a share of the range; beyond it the colours of its ends. */
export function heightColour(share) {
  return kHeightColours[Math.min(kColours - 1, Math.max(0, Math.round(share * (kColours - 1))))];
}
