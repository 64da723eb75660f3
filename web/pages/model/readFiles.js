/** Files that a program wrote: any P2 or P5 picture, and log-odds as SPEC.md section 7 has them. */

const MOST_CELLS = 25000000;

/** A file that is no map; its message is for the reader. */
export class FileError extends Error {}

/** @typedef {{width: number, height: number, pixels: Uint16Array, top: number}} Picture rows from the top; the file's maximum */
/** @typedef {{width: number, height: number, values: Float64Array}} LogOdds rows from the bottom */

/**
 * @param {Uint8Array} bytes
 * @returns {{picture: Picture} | {logOdds: LogOdds}}
 * @throws {FileError}
 */
export function readMapFile(bytes) {
  const magic = String.fromCharCode(...bytes.subarray(0, 2));
  if (magic === "P2" || magic === "P5") return { picture: readPgm(bytes) };
  const text = new TextDecoder("latin1").decode(bytes);
  if (text.startsWith("#")) return { logOdds: readLogOdds(text) };
  throw new FileError(
    `${kindOf(bytes)} neither a PGM picture (it would begin with P2 or P5) nor a .logodds file (it would begin with # logodds).`,
  );
}

/** How files begin that are easily taken for a map. @type {[number[], string][]} */
const OTHERS = [
  [[0xff, 0xfe], "text in UTF-16, as PowerShell's > writes it"],
  [[0xfe, 0xff], "text in UTF-16"],
  [[0xef, 0xbb, 0xbf], "text with a byte order mark"],
  [[0x89, 0x50, 0x4e, 0x47], "a PNG picture"],
  [[0xff, 0xd8, 0xff], "a JPEG picture"],
  [[0x47, 0x49, 0x46], "a GIF picture"],
  [[0x42, 0x4d], "a BMP picture"],
  [[0x50, 0x31], "a PBM picture, of black and white only"],
  [[0x50, 0x34], "a PBM picture, of black and white only"],
  [[0x50, 0x33], "a PPM picture, with colours"],
  [[0x50, 0x36], "a PPM picture, with colours"],
];

/** What a file is that is no map. @param {Uint8Array} bytes */
function kindOf(bytes) {
  if (bytes.length === 0) return "The file is empty,";
  const other = OTHERS.find(([start]) =>
    start.every((byte, i) => byte === bytes[i]),
  );
  return other ? `This is ${other[1]},` : "This is";
}

/**
 * Any valid picture of 8 or 16 bits, comments included; other maxima are scaled to 255, rounded half up.
 *
 * @param {Uint8Array} bytes
 * @returns {Picture}
 */
export function readPgm(bytes) {
  const raw = bytes[1] === 0x35;
  let at = 2;
  const number = (/** @type {string} */ what) => {
    for (;;) {
      const byte = bytes[at];
      if (byte === 0x23) {
        while (at < bytes.length && bytes[at] !== 10 && bytes[at] !== 13) at++;
      } else if (byte === 32 || (byte >= 9 && byte <= 13)) {
        at++;
      } else {
        break;
      }
    }
    let value = 0;
    const start = at;
    for (; bytes[at] >= 0x30 && bytes[at] <= 0x39; at++) {
      value = 10 * value + bytes[at] - 0x30;
    }
    if (at === start) {
      throw new FileError(
        at >= bytes.length
          ? `The picture ends before ${what}.`
          : `${what} is not a number.`,
      );
    }
    return value;
  };
  const width = number("the width");
  const height = number("the height");
  const top = number("the maximum");
  if (!(width > 0 && height > 0 && width * height <= MOST_CELLS)) {
    throw new FileError(`A picture of ${width} x ${height} pixels is no map.`);
  }
  if (!(top > 0 && top < 65536)) {
    throw new FileError(`The maximum ${top} is not from 1 to 65535.`);
  }
  const pixels = new Uint16Array(width * height);
  const wide = top > 255 ? 2 : 1;
  at += raw ? 1 : 0;
  if (raw && bytes.length - at < wide * pixels.length) {
    throw new FileError("The picture ends before its last pixel.");
  }
  for (let i = 0; i < pixels.length; i++) {
    let level = 0;
    if (!raw) level = number(`pixel ${i + 1} of ${pixels.length}`);
    else if (wide === 1) level = bytes[at + i];
    else level = 256 * bytes[at + 2 * i] + bytes[at + 2 * i + 1];
    if (level > top) throw new FileError(`A pixel is ${level}, above ${top}.`);
    pixels[i] =
      top === 255 ? level : Math.floor((level * 510 + top) / (2 * top));
  }
  return { width, height, pixels, top };
}

/**
 * @param {string} text
 * @returns {LogOdds}
 */
function readLogOdds(text) {
  const lines = text.split("\n");
  const size = /^# logodds ([0-9]{1,9}) ([0-9]{1,9})\r?$/.exec(lines[0]);
  if (size === null) {
    throw new FileError(
      `The first line is '${lines[0].slice(0, 40)}', not '# logodds WIDTH HEIGHT'.`,
    );
  }
  const [width, height] = [Number(size[1]), Number(size[2])];
  if (!(width > 0 && height > 0 && width * height <= MOST_CELLS)) {
    throw new FileError(`A map of ${width} x ${height} cells is none.`);
  }
  const values = new Float64Array(width * height);
  for (let gy = 0; gy < height; gy++) {
    const row = (lines[gy + 1] ?? "").trim().split(/\s+/);
    if (row.length !== width) {
      throw new FileError(
        `Line ${gy + 2} has ${row[0] === "" ? 0 : row.length} values, not ${width}.`,
      );
    }
    row.forEach((token, gx) => {
      const value = /^[+-]?[0-9.]+([eE][+-]?[0-9]+)?$/.test(token)
        ? Number(token)
        : NaN;
      if (Number.isNaN(value)) {
        throw new FileError(`Line ${gy + 2}: '${token}' is not a number.`);
      }
      values[gy * width + gx] = value;
    });
  }
  return { width, height, values };
}
