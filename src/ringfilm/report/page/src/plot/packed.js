// Numbers of maps and fields as the program packs them: 16-bit words in base64, low byte first.

/** The word that stands for no number. */
export const kMissing = 65535;

export function unpacked(data) {
  const bytes = atob(data);
  return Uint16Array.from(
    { length: bytes.length / 2 },
    (_, k) => bytes.charCodeAt(2 * k) | (bytes.charCodeAt(2 * k + 1) << 8),
  );
}
