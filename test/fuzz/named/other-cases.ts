import { concat, latin1, little } from '../bytes.ts';
import { oneFile } from '../fuzz-case.ts';
import type { FilesCase, FuzzCase } from '../fuzz-case.ts';
import { grayPng } from '../grammars/manifest.ts';

function manifestOf(fields: object): FilesCase {
  return {
    files: [
      { name: 'scan.json', bytes: new TextEncoder().encode(JSON.stringify(fields)) },
      { name: 'image.png', bytes: grayPng(12, 12) },
    ],
  };
}

/** A NIfTI-2 file of 2 x 2 x 2 bytes. */
function nifti2(affine: readonly number[], units: number): FuzzCase {
  const head = little()
    .u32(540)
    .text('n+2\0\r\n\x1a\n')
    .u16(2, 8)
    .u64(3, 2, 2, 2, 1, 1, 1, 1)
    .zeros(24)
    .f64(1, 1, 1, 1, 1, 1, 1, 1)
    .u64(544)
    .f64(1, 0);
  head
    .zeros(344 - head.length)
    .u32(0, 1)
    .f64(0, 0, 0, 0, 0, 0, ...affine);
  return oneFile(
    'a.nii',
    concat([
      head
        .zeros(500 - head.length)
        .u32(units)
        .zeros(40)
        .finish(),
      new Uint8Array([1, 2, 3, 4, 5, 6, 7, 8]),
    ]),
  );
}

const pumped = (attribute: string, pump: string, after = ''): FuzzCase => ({ attribute, before: '', pump, after });

export const otherCases: Readonly<Record<string, () => FuzzCase>> = {
  'manifest: 3,000 scans times 3,000 sweeps': () =>
    manifestOf({
      sweeps: Array.from({ length: 3000 }, () => ({ rays: 1 })),
      scans: Array.from({ length: 3000 }, () => ({ image: 'image.png' })),
    }),
  'manifest: gates of 1e308 metres': () =>
    manifestOf({ image: 'image.png', mosaic: '1x1', elevations: [0.5], range: [0, 1e308] }),
  'manifest: a spacing of 1e308': () => manifestOf({ image: 'image.png', mosaic: '1x1', spacing: [1e308, 1, 1e308] }),
  'manifest: values that are not finite after their slope': () =>
    manifestOf({ image: 'image.png', mosaic: '1x1', slope: 1e308 }),
  'manifest: an image that is the manifest': () => manifestOf({ image: 'scan.json' }),
  'nifti: an affine that is finite, but in metres': () => nifti2([1e306, 0, 0, 0, 0, 1e306, 0, 0, 0, 0, 1e306, 0], 1),
  'nrrd: a direction of 1e308': () =>
    oneFile(
      'a.nrrd',
      latin1(
        'NRRD0004\ntype: uchar\ndimension: 3\nsizes: 2 2 2\nencoding: raw\nspace: RAS\nspace directions: (1e308,0,0) (0,1,0) (0,0,1)\n\n12345678',
      ),
    ),
  'nrrd: a name of 100 MB that a pattern asks for': () =>
    oneFile(
      'a.nhdr',
      latin1('NRRD0004\ntype: uchar\ndimension: 3\nsizes: 2 2 2\nencoding: raw\ndata file: a%099999999d.raw 1 8 1\n'),
    ),
  'attribute: numbers with many digits and a wrong end': () => pumped('valueWindow', '1', 'x'),
  'attribute: an angle with many digits and a wrong end': () => pumped('cameraOrbit', '1', 'x 1 1'),
  'attribute: many blanks in a mosaic': () => pumped('mosaic', ' ', 'x'),
  'attribute: a stop with many digits': () => pumped('transferFunction', '1', 'x red 1'),
  'attribute: many stops': () => pumped('transferFunction', '0 red 0,'),
  'attribute: a colour without end': () => pumped('color', 'rgb('),
  'attribute: a colour of many digits': () => ({ attribute: 'color', before: 'rgb(', pump: '1', after: ' 2' }),
};
