// The few shapes of which a static drawing is made.

export const kMargin = { left: 58, right: 16, top: 44, bottom: 54 };
export const kInk = '#30343b';
export const kFaint = '#5c6470';

export const safe = (content) =>
  String(content)
    .replace(/&/g, '&amp;')
    .replace(/</g, '&lt;')
    .replace(/>/g, '&gt;')
    .replace(/"/g, '&quot;')
    .replace(/[\u0000-\u0008\u000b\u000c\u000e-\u001f\ufffe\uffff]/g, '\ufffd');
export const px = (v) => v.toFixed(2);

export function text(
  x,
  y,
  content,
  { anchor = 'start', size = 12, fill = kInk, weight = 400, halo = '' } = {},
) {
  return (
    `<text x="${px(x)}" y="${px(y)}" text-anchor="${anchor}" font-size="${size}" fill="${fill}" ` +
    `font-weight="${weight}"${halo && ` stroke="${halo}" stroke-width="3" paint-order="stroke"`}>` +
    `${safe(content)}</text>`
  );
}

export function rule(x1, y1, x2, y2, stroke, width = 1, dash = '') {
  return (
    `<line x1="${px(x1)}" y1="${px(y1)}" x2="${px(x2)}" y2="${px(y2)}" stroke="${stroke}" ` +
    `stroke-width="${width}"${dash ? ` stroke-dasharray="${dash}"` : ''}/>`
  );
}

export function scaler(log, low, high, from, to) {
  if (log) {
    const [a, b] = [Math.log10(low), Math.log10(high)];
    return (v) => (v > 0 ? from + ((Math.log10(v) - a) / (b - a)) * (to - from) : NaN);
  }
  return (v) => from + ((v - low) / (high - low)) * (to - from);
}
