const headerBytes = 352;

/** @type {Map<number, Uint8Array>} */
const cache = new Map();

/**
 * A cube of 16-bit samples as a NIfTI-1 file that is stored nowhere: a ball with a lattice of holes in empty space, so
 * that there is as much to skip and to see at every size.
 * @param {number} edge - voxels
 * @returns {Uint8Array} 352 + 2 * edge^3 bytes; the same object for the same edge
 */
export function makeNifti(edge) {
  let file = cache.get(edge);
  if (!file) cache.set(edge, (file = buildNifti(edge)));
  return file;
}

/** @param {number} edge */
function buildNifti(edge) {
  const bytes = new ArrayBuffer(headerBytes + 2 * edge ** 3);
  writeHeader(new DataView(bytes), edge);
  const samples = new Int16Array(bytes, headerBytes);
  const shares = Float64Array.from({ length: edge }, (_, i) => (2 * i + 1) / edge - 1);
  const waves = shares.map((x) => Math.cos(8 * Math.PI * x));
  for (let k = 0, at = 0; k < edge; k++) {
    for (let j = 0; j < edge; j++) {
      const [apart, wave] = [shares[j] ** 2 + shares[k] ** 2, waves[j] * waves[k]];
      for (let i = 0; i < edge; i++) {
        const inside = 0.6 - shares[i] ** 2 - apart;
        samples[at++] = inside > 0 ? 1000 * inside * (1.2 + waves[i] * wave) : 0;
      }
    }
  }
  return new Uint8Array(bytes);
}

/**
 * Source: the NIfTI-1 standard, nifti1.h
 * @param {DataView} view
 * @param {number} edge
 */
function writeHeader(view, edge) {
  view.setInt32(0, 348, true);
  [3, edge, edge, edge, 1, 1, 1, 1].forEach((n, i) => view.setInt16(40 + 2 * i, n, true)); // dim
  view.setInt16(70, 4, true); // datatype: signed 16 bit
  view.setInt16(72, 16, true); // bitpix
  [1, 1, 1, 1].forEach((size, i) => view.setFloat32(76 + 4 * i, size, true)); // pixdim, mm
  view.setFloat32(108, headerBytes, true); // vox_offset
  view.setUint8(123, 2); // xyzt_units: mm
  [0x6e, 0x2b, 0x31, 0].forEach((byte, i) => view.setUint8(344 + i, byte)); // magic: n+1
}
