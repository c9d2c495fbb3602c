// What descriptions of ImageJ and of OME-XML say of values and lengths.
import { expect } from '@esm-bundle/chai';
import type { Volume } from '../../../../src/volume/volume.ts';
import { decodeBytes, valuesOf } from '../../../helpers/decode.ts';
import { openScans } from '../../../helpers/scans-of.ts';
import { grayPage, tiffBytes } from '../../../helpers/tiff-bytes.ts';
import type { TiffEntry } from '../../../helpers/tiff-bytes.ts';

type Entries = Readonly<Record<number, TiffEntry>>;

const strip = (from: number, count = 6): Uint8Array => Uint8Array.from({ length: count }, (_, i) => from + i);

/** Two slices of 3 x 2 numbers: 1 to 6, and 7 to 12. */
const twoSlices = (first: Entries): Uint8Array<ArrayBuffer> =>
  tiffBytes([grayPage(3, 2, strip(1), first), grayPage(3, 2, strip(7))]);

const imageJ = (lines: string, more: Entries = {}): Promise<Volume> =>
  decodeBytes(twoSlices({ 270: [2, `ImageJ=1.54f\nimages=2\nslices=2\n${lines}\n`], ...more }), 'x.tif');

/** Two pixels per unit, or as given. */
const resolution = (pixels = 2, unit = 1): Entries => ({ 282: [5, pixels, 1], 283: [5, pixels, 1], 296: [3, unit] });

const spacingOf = ({ grid: { indexToWorld: m } }: Volume): number[] =>
  [0, 1, 2].map((i) => Number(Math.hypot(m[i], m[i + 4], m[i + 8]).toPrecision(9)));

const stored = Array.from({ length: 12 }, (_, i) => i + 1);

describe('the values of an ImageJ TIFF', () => {
  it('have the window that it was shown with', async () => {
    expect((await imageJ('min=3.0\nmax=9.0')).window).to.deep.equal([3, 9]);
  });

  it('are c0 + c1 times the number for a straight line, in their unit', async () => {
    const volume = await imageJ('cf=0\nc0=-1024.0\nc1=0.5\nvunit=HU');
    expect(valuesOf(volume)).to.deep.equal(stored.map((value) => value / 2 - 1024));
    expect(volume.unit).to.equal('HU');
    expect(volume.left).to.equal(undefined);
    expect((await imageJ('cf=0\nc0=1\nc1=2\nvunit=Gray Value')).unit).to.equal('');
  });

  // Source: ImageJ, FileOpener, setCalibration: setMinAndMax of the ImageProcessor, whose numbers are not calibrated.
  it('have a window that is calibrated as they are', async () => {
    expect((await imageJ('cf=0\nc0=10\nc1=2\nmin=3.0\nmax=9.0')).window).to.deep.equal([16, 28]);
    expect((await imageJ('cf=0\nc0=10\nc1=-2\nmin=3.0\nmax=9.0')).window).to.deep.equal([-8, 4]);
  });

  it('of signed numbers are those that ImageJ shifts by 32768', async () => {
    const signed = { 258: [3, 16], 339: [3, 2] } as const;
    const numbers = Uint8Array.from([0xfe, 0xff, 0, 0, 1, 0, 2, 0, 3, 0, 4, 0]);
    const lines = 'ImageJ=1.54f\ncf=0\nc0=-32768\nc1=1\nmin=32768\nmax=32770';
    const file = tiffBytes([grayPage(3, 2, numbers, { ...signed, 270: [2, lines] })]);
    const volume = await decodeBytes(file, 'x.tif');
    expect(valuesOf(volume)).to.deep.equal([-2, 0, 1, 2, 3, 4]);
    expect(volume.window).to.deep.equal([0, 2]);
  });

  it('of several times are calibrated in each', async () => {
    const lines = 'ImageJ=1.54f\nimages=2\nframes=2\ncf=0\nc0=-5\nc1=2\nvunit=HU';
    const { first, read } = await openScans(twoSlices({ 270: [2, lines] }), 'x.tif', { scan: { index: 0 } });
    expect(valuesOf(first)).to.deep.equal([-3, -1, 1, 3, 5, 7]);
    expect(valuesOf(await read(1))).to.deep.equal([9, 11, 13, 15, 17, 19]);
    expect(first.unit).to.equal('HU');
  });

  it('stay as they are where they follow another function, and that is said', async () => {
    for (const lines of ['cf=1\nc0=1\nc1=2\nc2=3', 'cf=21', 'cf=0\nc0=1\nc1=0', 'cf=0\nc0=x\nc1=1', 'cf=0\nc1=1']) {
      const volume = await imageJ(lines);
      expect(valuesOf(volume), lines).to.deep.equal(stored);
      expect(volume.left?.join(''), lines).to.match(/^the calibration of the values \(cf=\d+ of ImageJ\)/);
    }
    // 20 is no function.
    expect((await imageJ('cf=20')).left).to.equal(undefined);
  });
});

// Source of the lengths: ImageJ, TiffDecoder and FileOpener
describe('the lengths of an ImageJ TIFF', () => {
  for (const [what, lines, entries, expected] of [
    ['in micrometres', 'unit=um\nspacing=3', resolution(), [5e-4, 5e-4, 3e-3]],
    ["of Java's properties", 'unit=\\u00B5m\nspacing=3', resolution(), [5e-4, 5e-4, 3e-3]],
    ['with slices 1 apart, which is not written', 'unit=um', resolution(), [5e-4, 5e-4, 1e-3]],
    ['in pixels', 'unit=pixel\nspacing=3', resolution(), [0.5, 0.5, 3]],
    ['without a unit', 'spacing=3', resolution(), [0.5, 0.5, 3]],
    ['in pixels without a width', 'unit=pixel\nspacing=3', {}, [1, 1, 3]],
    ['with the dots of a printer', 'spacing=3', resolution(72, 2), [1, 1, 1]],
    ['in micrometres, of pixels per centimetre', 'unit=um\nspacing=3', resolution(20_000, 3), [5e-4, 5e-4, 3e-3]],
    // Source: ImageJ 1.54, Calibration, setYUnit and setZUnit: numbers stay, and are in these units.
    ['with y and z in units of their own', 'unit=um\nyunit=mm\nzunit=nm\nspacing=3', resolution(), [5e-4, 0.5, 3e-6]],
    ['with z in the same unit', 'unit=mm\nyunit=mm\nzunit=mm\nspacing=3', resolution(), [0.5, 0.5, 3]],
    ['with y in no unit of length', 'unit=um\nyunit=pixel\nspacing=3', resolution(), [1, 1, 1]],
  ] as const)
    it(`are right ${what}`, async () => {
      expect(spacingOf(await imageJ(lines, entries))).to.deep.equal(expected);
    });

  it('are those of the pixels for slices that are apart by something else, and that is said', async () => {
    for (const [units, expected] of [
      ['unit=um\nzunit=sec\nspacing=3', 5e-4],
      ['unit=pixel\nzunit=um\nspacing=3', 0.5],
    ] as const) {
      const volume = await imageJ(units, resolution());
      expect([spacingOf(volume), volume.left?.length], units).to.deep.equal([[expected, expected, expected], 1]);
      expect(volume.left![0]).to.match(/^the distance of the slices/);
    }
  });

  it('are right where the micro sign is a byte of Latin-1', async () => {
    const lines = 'ImageJ=1.54f\nimages=2\nslices=2\nunit=\u00b5m\nspacing=3\n';
    const codes = Array.from(lines, (sign) => sign.charCodeAt(0));
    const volume = await decodeBytes(twoSlices({ 270: [7, ...codes, 0], ...resolution() }), 'x.tif');
    expect(spacingOf(volume)).to.deep.equal([5e-4, 5e-4, 3e-3]);
  });
});

describe('the lengths of an OME-TIFF', () => {
  const ome = (units: string): Promise<Volume> =>
    decodeBytes(
      twoSlices({
        270: [
          2,
          `<OME><Image><Pixels DimensionOrder="XYZCT" SizeC="1" SizeZ="2" SizeT="1" PhysicalSizeX="0.5" PhysicalSizeY="0.5" ${units}/></Image></OME>`,
        ],
      }),
      'x.ome.tif',
    );
  const inUnit = (unit: string): string => ['X', 'Y', 'Z'].map((axis) => `PhysicalSize${axis}Unit="${unit}"`).join(' ');

  for (const [unit, expected] of [
    ['nm', [5e-7, 5e-7, 2e-6]],
    ['pixel', [0.5, 0.5, 2]],
    ['reference frame', [0.5, 0.5, 2]],
  ] as const)
    it(`are right in the unit ${unit}`, async () => {
      expect(spacingOf(await ome(`PhysicalSizeZ="2" ${inUnit(unit)}`))).to.deep.equal(expected);
    });

  it('are guessed, and that is said, where only that of slices is missing or of another kind', async () => {
    for (const units of ['', 'PhysicalSizeZ="2" PhysicalSizeZUnit="pixel"']) {
      const volume = await ome(units);
      expect(spacingOf(volume), units).to.deep.equal([5e-4, 5e-4, 5e-4]);
      expect(volume.left?.join('')).to.contain('the distance of the slices');
    }
    expect(spacingOf(await ome('PhysicalSizeXUnit="pixel" PhysicalSizeYUnit="pixel"'))).to.deep.equal([0.5, 0.5, 0.5]);
  });
});
