/** Lines of a source of bytes, as they are needed: a log may be larger than memory. */

/**
 * Where bytes come from: a file, or what was dropped on a page.
 *
 * @typedef {object} Source
 * @property {string} name as it is printed in messages
 * @property {(offset: number) => Iterable<Uint8Array>} chunks the bytes from an offset on; it throws where they cannot
 *   be read, or not from there
 */

const LF = 10;

/**
 * A source of bytes in memory.
 *
 * @param {string} name
 * @param {Uint8Array | string} content
 * @returns {Source}
 */
export function memorySource(name, content) {
  const bytes =
    typeof content === "string" ? new TextEncoder().encode(content) : content;
  return { name, chunks: (offset) => [bytes.subarray(offset)] };
}

/**
 * The lines from an offset on, without their ends LF or CRLF. A byte is a character.
 *
 * @param {Source} source
 * @param {number} start the offset of a line's first byte
 * @returns {Generator<{text: string, offset: number}>} offset: of the line's first byte
 */
export function* readLines(source, start) {
  const decoder = new TextDecoder("latin1");
  let offset = start;
  /** @type {string[]} what was read of a line that goes on in the next chunk */
  let parts = [];
  let length = 0;
  for (const chunk of source.chunks(start)) {
    let from = 0;
    for (;;) {
      const end = chunk.indexOf(LF, from);
      const piece = chunk.subarray(from, end < 0 ? chunk.length : end);
      if (piece.length > 0) parts.push(decoder.decode(piece));
      length += piece.length;
      if (end < 0) break;
      yield { text: withoutReturn(parts.join("")), offset };
      offset += length + 1;
      parts = [];
      length = 0;
      from = end + 1;
    }
  }
  if (length > 0) yield { text: withoutReturn(parts.join("")), offset };
}

/** @param {string} line */
function withoutReturn(line) {
  return line.endsWith("\r") ? line.slice(0, -1) : line;
}
