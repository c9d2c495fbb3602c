// Makes a case smaller that was found, as long as the finding stays the same.

/** @typedef {import('./fuzz-case.ts').FuzzCase} FuzzCase */
/** @typedef {import('./verdict.ts').Verdict} Verdict */
/** @typedef {import('./oracle.mjs').Oracle} Oracle */

/** Cases that are tried at most, and milliseconds. */
const maxTries = 300;
const maxMs = 40_000;

/**
 * @param {Oracle} oracle
 * @param {FuzzCase} made
 * @param {Verdict} verdict
 * @returns {Promise<{ made: FuzzCase, verdict: Verdict }>}
 */
export async function minimise(oracle, made, verdict) {
  let best = { made, verdict };
  const start = Date.now();
  let tries = 0;
  /** @param {FuzzCase} candidate @returns {Promise<boolean>} whether it shows the same */
  const improve = async (candidate) => {
    if (tries++ >= maxTries || Date.now() - start > maxMs) return false;
    const { verdict } = await oracle.run({ type: 'given', made: candidate });
    if (verdict.finding?.kind !== best.verdict.finding?.kind) return false;
    best = { made: candidate, verdict };
    return true;
  };
  if (!('files' in made)) {
    for (const part of /** @type {const} */ (['before', 'after']))
      await improve({ .../** @type {import('./fuzz-case.ts').TextCase} */ (best.made), [part]: '' });
    return best;
  }
  await improve({
    files: made.files,
    ...(made.stack ? { stack: true } : {}),
    ...(made.folder ? { folder: true } : {}),
    settings: 'mosaic' in (made.settings ?? {}) ? { mosaic: made.settings?.mosaic } : {},
  });
  for (let file = 0; file < made.files.length; file++) {
    for (let step = 1 << Math.floor(Math.log2(Math.max(1, made.files[file].bytes.length))); step >= 8; step >>= 1) {
      for (let at = 0; at < bytesOf(best.made, file).length; at += step) {
        if (await improve(withBytes(best.made, file, cut(bytesOf(best.made, file), at, step)))) at -= step;
        else if (
          bytesOf(best.made, file)
            .subarray(at, at + step)
            .some((byte) => byte !== 0)
        )
          await improve(withBytes(best.made, file, blank(bytesOf(best.made, file), at, step)));
      }
    }
  }
  return best;
}

/** @param {FuzzCase} made @param {number} file @returns {Uint8Array<ArrayBuffer>} */
const bytesOf = (made, file) => /** @type {import('./fuzz-case.ts').FilesCase} */ (made).files[file].bytes;

/** @param {FuzzCase} made @param {number} file @param {Uint8Array<ArrayBuffer>} bytes @returns {FuzzCase} */
function withBytes(made, file, bytes) {
  const { files, ...rest } = /** @type {import('./fuzz-case.ts').FilesCase} */ (made);
  return { ...rest, files: files.map((one, i) => (i === file ? { ...one, bytes } : one)) };
}

/** @param {Uint8Array} bytes @param {number} at @param {number} length */
function cut(bytes, at, length) {
  const end = Math.min(bytes.length, at + length);
  const rest = new Uint8Array(bytes.length - end + at);
  rest.set(bytes.subarray(0, at));
  rest.set(bytes.subarray(end), at);
  return rest;
}

/** @param {Uint8Array} bytes @param {number} at @param {number} length */
function blank(bytes, at, length) {
  const other = Uint8Array.from(bytes);
  other.fill(0, at, at + length);
  return other;
}
