import { expect } from '@esm-bundle/chai';
import { divideFiles } from '../../../src/sources/divide-files.ts';
import type { Division, FileKind, FilePart } from '../../../src/sources/divide-files.ts';

const base = 'https://archive.invalid/';
type Named = readonly [name: string, kind: FileKind];
const divide = (files: readonly Named[], isStack = false): Division =>
  divideFiles(
    files.map(([name, kind]) => ({ url: base + name, kind, format: kind.toUpperCase() })),
    isStack,
  );
const urls = (...names: string[]): string[] => names.map((name) => base + name);

const images: readonly Named[] = [
  ['slice 10.png', 'image'],
  ['slice 9.png', 'image'],
  ['notes.txt', 'other'],
];

const part = (of: FilePart['of'], kind: string, ...names: string[]): FilePart => ({
  of,
  files: urls(...names),
  format: kind.toUpperCase(),
});

describe('several files are', () => {
  for (const [what, files, isStack, parts, others] of [
    ['nothing without one of a known type', [['a.txt', 'other']], false, [], []],
    [
      'the volume of the only file that holds one, beside images',
      [
        ['a.txt', 'other'],
        ['b.nii', 'volume'],
        ['c.png', 'image'],
      ],
      false,
      [part('volume', 'volume', 'b.nii')],
      ['c.png'],
    ],
    [
      'that of the manifest, whatever else is there',
      [
        ['a.nii', 'volume'],
        ['b.json', 'manifest'],
        ['c.nii', 'volume'],
        ['d.dcm', 'slice'],
      ],
      true,
      [part('volume', 'manifest', 'b.json')],
      [],
    ],
    [
      'that of a header, and not of its packed data',
      [
        ['a.raw.gz', 'packed'],
        ['a.mhd', 'volume'],
      ],
      false,
      [part('volume', 'volume', 'a.mhd')],
      [],
    ],
    [
      'that of a packed file where no other holds one',
      [
        ['a.gz', 'packed'],
        ['b.png', 'image'],
      ],
      false,
      [part('volume', 'packed', 'a.gz')],
      ['b.png'],
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
      [part('slices', 'slice', '9.dcm', '10.dcm')],
      ['a.png'],
    ],
    [
      'one volume of one file of a series',
      [
        ['a.txt', 'other'],
        ['1.dcm', 'slice'],
      ],
      false,
      [part('slices', 'slice', '1.dcm')],
      [],
    ],
    ['a mosaic where there is one image', [['a.png', 'image']], true, [part('volume', 'image', 'a.png')], []],
    [
      'several volumes, and series after them',
      [
        ['1.dcm', 'slice'],
        ['2.dcm', 'slice'],
        ['b.nii', 'volume'],
        ['a.nii', 'volume'],
        ['c.png', 'image'],
      ],
      false,
      [part('volume', 'volume', 'a.nii'), part('volume', 'volume', 'b.nii'), part('slices', 'slice', '1.dcm', '2.dcm')],
      ['c.png'],
    ],
    [
      'pages and images as slices beside a volume, where the page says so of images',
      [
        ['2.tif', 'page'],
        ['1.tif', 'page'],
        ['b.nii', 'volume'],
        ['c.png', 'image'],
        ['d.png', 'image'],
      ],
      true,
      [
        part('volume', 'volume', 'b.nii'),
        part('images', 'page', '1.tif', '2.tif'),
        part('images', 'image', 'c.png', 'd.png'),
      ],
      [],
    ],
    [
      'no volume of several images where the page does not say that they are slices',
      images,
      false,
      [],
      ['slice 9.png', 'slice 10.png'],
    ],
    [
      'the slices of one volume where it does, in the order of their numbers',
      images,
      true,
      [part('images', 'image', 'slice 9.png', 'slice 10.png')],
      [],
    ],
  ] as const satisfies readonly (readonly [
    string,
    readonly Named[],
    boolean,
    readonly FilePart[],
    readonly string[],
  ])[]) {
    it(what, () => expect(divide(files, isStack)).to.deep.equal({ parts, images: urls(...others) }));
  }
});
