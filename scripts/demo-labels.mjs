// Makes Brodmann's areas for the demo of labels: a label file of 2 mm and a table of names. The areas come from a package (see
// demos/data/LICENSES.md) with voxels of 1 mm; we take every second one along each axis. Names and colours are our own.
import { readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { gunzipSync, gzipSync } from 'node:zlib';

/** Number of voxels of the file, along each axis, that become one. */
const step = 2;

/** The areas by function. The hue depends on the part of the brain, so that neighbours have different colours. */
const areas = /** @type {const} */ ([
  [1, 'Primary somatosensory cortex, middle', 'S1', '#f6a04d'],
  [2, 'Primary somatosensory cortex, back', 'S1', '#f7c069'],
  [3, 'Primary somatosensory cortex, front', 'S1', '#ef8238'],
  [4, 'Primary motor cortex', 'M1', '#e5483f'],
  [5, 'Somatosensory association cortex', 'SPL', '#ffd98a'],
  [6, 'Premotor and supplementary motor cortex', 'PM, SMA', '#f2797a'],
  [7, 'Superior parietal lobule', 'SPL', '#e6d14f'],
  [8, 'Frontal eye fields', 'FEF', '#c774d4'],
  [9, 'Dorsolateral prefrontal cortex, upper', 'DLPFC', '#9c6bdc'],
  [10, 'Frontal pole', 'FP', '#7f7fe6'],
  [11, 'Orbitofrontal cortex', 'OFC', '#b18cf0'],
  [17, 'Primary visual cortex', 'V1', '#3f7fe0'],
  [18, 'Secondary visual cortex', 'V2', '#63a5f2'],
  [19, 'Visual association cortex', 'V3, V4, V5', '#8fc9f7'],
  [20, 'Inferior temporal gyrus', 'ITG', '#4fae6a'],
  [21, 'Middle temporal gyrus', 'MTG', '#7cc85c'],
  [22, 'Superior temporal gyrus', 'STG', '#a9d86e'],
  [23, 'Posterior cingulate cortex, lower', 'PCC', '#c9a36a'],
  [24, 'Anterior cingulate cortex, lower', 'ACC', '#d98f5f'],
  [25, 'Subgenual area', 'sgACC', '#b9705a'],
  [26, 'Ectosplenial area', '', '#a88a78'],
  [27, 'Presubiculum', '', '#c0b080'],
  [28, 'Entorhinal cortex, lower', 'EC', '#d6c65a'],
  [29, 'Retrosplenial cortex, granular', 'RSC', '#b39b54'],
  [30, 'Retrosplenial cortex, agranular', 'RSC', '#cfb878'],
  [32, 'Anterior cingulate cortex, upper', 'ACC', '#e7a981'],
  [34, 'Entorhinal cortex, upper', 'EC', '#bfb046'],
  [35, 'Perirhinal cortex', 'PRC', '#8f9f4a'],
  [36, 'Parahippocampal cortex', 'PHC', '#aab95e'],
  [37, 'Fusiform gyrus', 'FG', '#45bfa8'],
  [38, 'Temporal pole', 'TP', '#2f9c7c'],
  [39, 'Angular gyrus', 'AG', '#f2e17a'],
  [40, 'Supramarginal gyrus', 'SMG', '#d9b637'],
  [41, 'Primary auditory cortex', 'A1', '#3fd0d6'],
  [42, 'Secondary auditory cortex', 'A2', '#7fe3e2'],
  [43, 'Gustatory cortex', '', '#f48fb8'],
  [44, 'Broca’s area, opercular part', 'IFG', '#d9569a'],
  [45, 'Broca’s area, triangular part', 'IFG', '#ee7fc0'],
  [46, 'Dorsolateral prefrontal cortex, lower', 'DLPFC', '#8a55c8'],
  [47, 'Inferior frontal gyrus, orbital part', 'IFG', '#d3a3f5'],
  [48, 'Retrosubicular area, with insula and putamen', '', '#9db4c0'],
]);

/**
 * Write both files.
 * @param {string} source - the atlas of the package: NIfTI-1 of 8 bits, little-endian
 * @param {string} target - folder
 */
export function writeDemoLabels(source, target) {
  const from = gunzipSync(readFileSync(source));
  const size = [0, 1, 2].map((axis) => from.readInt16LE(42 + 2 * axis));
  const first = from.readFloatLE(108);
  const to = size.map((n) => Math.ceil(n / step));
  const file = Buffer.alloc(352 + to[0] * to[1] * to[2]);
  from.copy(file, 0, 0, 348);
  file.writeFloatLE(352, 108);
  file.fill(0, 148, 228); // The description in the header.
  file.write('Brodmann areas, 2 mm, from mricron-data', 148, 'latin1');
  to.forEach((n, axis) => {
    file.writeInt16LE(n, 42 + 2 * axis);
    file.writeFloatLE(from.readFloatLE(80 + 4 * axis) * step, 80 + 4 * axis);
  });
  // The first voxel keeps its place: only the columns of the affine change, not the offset.
  for (const row of [280, 296, 312])
    for (const axis of [0, 1, 2]) file.writeFloatLE(from.readFloatLE(row + 4 * axis) * step, row + 4 * axis);
  file.write('n+1\0', 344, 'latin1');
  for (let k = 0, at = 352; k < to[2]; k++) {
    for (let j = 0; j < to[1]; j++) {
      for (let i = 0; i < to[0]; i++) file[at++] = from[first + step * (i + size[0] * (j + size[1] * k))];
    }
  }
  const packed = gzipSync(file, { level: 9 });
  packed[9] = 255; // The byte for the operating system is set, so that all systems write the same bytes.
  writeFileSync(join(target, 'brodmann-2mm.nii.gz'), packed);
  const rows = areas.map(([index, name, abbreviation, color]) =>
    [index, `${name} (area ${index})`, abbreviation || 'n/a', color].join('\t'),
  );
  writeFileSync(join(target, 'brodmann-dseg.tsv'), ['index\tname\tabbreviation\tcolor', ...rows, ''].join('\n'));
  console.log(`brodmann-2mm.nii.gz: ${to.join(' x ')}, ${packed.length} bytes`);
}
