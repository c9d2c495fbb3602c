import { expect } from '@esm-bundle/chai';
import { divideFiles } from '../../../src/sources/divide-files.ts';
import type { Division, FileKind } from '../../../src/sources/divide-files.ts';

const base = 'https://archive.invalid/';
type Named = readonly [name: string, kind: FileKind];
const divide = (files: readonly Named[], isStack = false): Division =>
  divideFiles(
    files.map(([name, kind]) => ({ url: base + name, kind })),
    isStack,
  );
const urls = (...names: string[]): string[] => names.map((name) => base + name);

const images: readonly Named[] = [
  ['slice 10.png', 'image'],
  ['slice 9.png', 'image'],
  ['notes.txt', 'other'],
];

describe('several files are', () => {
  for (const [what, files, isStack, expected] of [
    ['nothing without one of a known type', [['a.txt', 'other']], false, { is: 'nothing' }],
    [
      'the volume of the only file that holds one',
      [
        ['a.txt', 'other'],
        ['b.nii', 'volume'],
        ['c.png', 'image'],
      ],
      false,
      { is: 'volume', first: `${base}b.nii` },
    ],
    [
      'that of the manifest, whatever else is there',
      [
        ['a.nii', 'volume'],
        ['b.json', 'manifest'],
        ['c.nii', 'volume'],
      ],
      true,
      { is: 'volume', first: `${base}b.json` },
    ],
    [
      'that of a header, and not of its packed data',
      [
        ['a.raw.gz', 'packed'],
        ['a.mhd', 'volume'],
      ],
      false,
      { is: 'volume', first: `${base}a.mhd` },
    ],
    [
      'that of a packed file where no other holds one',
      [
        ['a.gz', 'packed'],
        ['b.png', 'image'],
      ],
      false,
      { is: 'volume', first: `${base}a.gz` },
    ],
    [
      'those of series, in the order of their numbers, and not their preview',
      [
        ['a.png', 'image'],
        ['10.dcm', 'slice'],
        ['9.dcm', 'slice'],
        ['a.gz', 'packed'],
      ],
      false,
      { is: 'stack', of: 'slices', files: urls('9.dcm', '10.dcm') },
    ],
    [
      'one volume of one file of a series',
      [
        ['a.txt', 'other'],
        ['1.dcm', 'slice'],
      ],
      false,
      { is: 'volume', first: `${base}1.dcm` },
    ],
    ['a mosaic where there is one image', [['a.png', 'image']], true, { is: 'volume', first: `${base}a.png` }],
    [
      'several volumes',
      [
        ['a.nii', 'volume'],
        ['b.nii', 'volume'],
        ['c.png', 'image'],
      ],
      true,
      { is: 'several', of: 'volumes', urls: urls('a.nii', 'b.nii') },
    ],
    [
      'several images where the page does not say that they are slices',
      images,
      false,
      { is: 'several', of: 'images', urls: urls('slice 10.png', 'slice 9.png') },
    ],
    [
      'the slices of one volume where it does, in the order of their numbers',
      images,
      true,
      { is: 'stack', of: 'images', files: urls('slice 9.png', 'slice 10.png') },
    ],
  ] as const satisfies readonly (readonly [string, readonly Named[], boolean, Division])[]) {
    it(what, () => expect(divide(files, isStack)).to.deep.equal(expected));
  }
});
