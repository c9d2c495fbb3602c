import { expect } from '@esm-bundle/chai';
import { ctSlice, packRle } from '../../../helpers/dicom-bytes.ts';
import type { DicomFields, DicomForm } from '../../../helpers/dicom-bytes.ts';
import { overlapping, scatter, segment, segmentationFields } from '../../../helpers/dicom-segmentation.ts';
import type { Segmentation } from '../../../helpers/dicom-segmentation.ts';
import { decodeFields } from '../../../helpers/dicom-series.ts';
import type { Scan } from '../../../helpers/dicom-series.ts';
import { expectError } from '../../../helpers/decode.ts';

const read = (made: Segmentation, fields: DicomFields = {}, form?: DicomForm): Promise<Scan> =>
  decodeFields([{ ...segmentationFields(made), ...fields }], form);

/** Expects that elements are refused. */
async function refuse(fields: DicomFields, code: string, words: RegExp): Promise<void> {
  const error = await expectError(decodeFields([fields]));
  expect(error.code, error.message).to.equal(code);
  expect(error.message).to.match(words);
}

/** The labels of each slice, row by row, as digits. */
function labelsOf({ grid: { dimensions }, ids, samples }: Scan): string[] {
  const [nx, ny, nz] = dimensions;
  const values = Array.from(samples, (stored) => ids?.[stored] ?? stored);
  return Array.from({ length: nz }, (_, k) => values.slice(k * nx * ny, (k + 1) * nx * ny).join(''));
}

// Labels, places and colours below: highdicom 0.28.2, Segmentation.from_dataset, get_volume and CIELabColor.to_rgb(clip=True), of the same
// files with the elements that it demands added.
const overlaid = ['031303310330133', '000000000000000', '303130011011300', '000000000000000', '200002020002022'];
const place = [-0.4, 0.27, -1.2, -10, -0.3, -0.36, 1.6, 20, 0, 0.6, 1.5, 30];

const fractional: Segmentation = {
  ...overlapping,
  type: 'FRACTIONAL',
  frames: overlapping.frames.map((frame, i) => ({ ...frame, pixels: scatter(15, 201, i + 1) })),
};
const labelMap: Segmentation = {
  ...overlapping,
  type: 'LABELMAP',
  bits: 16,
  frames: [0, 1, 3].map((slice) => ({ slice, pixels: scatter(15, 4, slice + 1) })),
};

describe('segmentations of DICOM', () => {
  it('have the labels of their frames, whatever their order, with bits that cross bytes, and empty slices that the file leaves out', async () => {
    const volume = await read(overlapping);
    expect(labelsOf(volume)).to.deep.equal(overlaid);
    expect(volume.isDiscrete).to.equal(true);
    expect(volume.anatomical).to.equal(true);
    for (const [i, entry] of place.entries()) expect(volume.grid.indexToWorld[i]).to.be.closeTo(entry, 1e-9);
  });

  it('show the segment of the largest number where segments overlap, and say what that hides', async () => {
    const { left } = await read(overlapping);
    expect(left).to.deep.equal(['9 of the 17 voxels of segment 1 are hidden by segment 3, which overlaps it']);
  });

  it('bring the names of their segments, and their colours as the programs that write them mean them', async () => {
    const { named } = await read(overlapping);
    expect(named!.map(({ id, name }) => [id, name])).to.deep.equal([
      [1, 'Liver'],
      [2, 'Spleen'],
      [3, 'Vessel'],
    ]);
    const colors = named!.map(({ color }) => color?.map((channel) => Math.round(255 * channel)));
    expect(colors).to.deep.equal([[255, 103, 76], [170, 253, 93], undefined]);
  });

  it('have names in the letters of the file', async () => {
    const segments = (name: string): DicomFields => ({ SegmentSequence: [segment(1, name)] });
    const latin = (text: string): string => String.fromCharCode(...new TextEncoder().encode(text));
    const utf8 = await read(overlapping, { ...segments(latin('肝臓 Œ')), SpecificCharacterSet: 'ISO_IR 192' });
    expect(utf8.named![0].name).to.equal('肝臓 Œ');
    const greek = await read(overlapping, {
      ...segments(String.fromCharCode(0xde, 0xf0, 0xe1, 0xf1)),
      SpecificCharacterSet: 'ISO 2022 IR 126',
    });
    expect(greek.named![0].name).to.equal('ήπαρ');
  });

  it('of fractions take half and more, and say so', async () => {
    const volume = await read(fractional);
    expect(labelsOf(volume)).to.deep.equal(overlaid);
    expect(volume.left![0]).to.equal(
      'fractions of segments: a voxel has the label where at least half of it is of the segment (100 of 200)',
    );
    const exact = [0, 99, 100, 200].flatMap((share) => [share, 0, 0, 0]);
    const edge = await read({
      ...fractional,
      columns: 4,
      rows: 4,
      frames: [{ slice: 0, segment: 2, pixels: exact }],
    });
    expect(labelsOf(edge)).to.deep.equal(['0000000020002000']);
  });

  it('of label maps have the numbers of their pixels', async () => {
    const volume = await read(labelMap);
    expect(labelsOf(volume)).to.deep.equal([
      '200013030013123',
      '021312310320133',
      '000000000000000',
      '022212230020202',
    ]);
    expect(volume.left).to.equal(undefined);
    const bytes = await read({ ...labelMap, bits: 8 });
    expect(labelsOf(bytes)).to.deep.equal(labelsOf(volume));
  });

  it('of label maps may be packed, and may have the colours of a palette', async () => {
    const table = (...entries: number[]): Uint8Array => new Uint8Array(Uint16Array.from(entries).buffer);
    const fragments = labelMap.frames.map(({ pixels }) => packRle(Uint16Array.from(pixels)));
    const palette: DicomFields = {
      PhotometricInterpretation: 'PALETTE COLOR',
      SegmentSequence: [segment(1, 'A'), segment(3, 'B')],
      RedPaletteColorLookupTableDescriptor: [4, 0, 16],
      RedPaletteColorLookupTableData: table(0, 65535, 0, 257 * 51),
      GreenPaletteColorLookupTableData: table(0, 0, 65535, 0),
      BluePaletteColorLookupTableData: table(0, 0, 0, 257 * 102),
    };
    const volume = await read(labelMap, palette, { syntax: '1.2.840.10008.1.2.5', fragments });
    expect(labelsOf(volume)[1]).to.equal('021312310320133');
    expect(volume.named).to.deep.equal([
      { id: 1, name: 'A', color: [1, 0, 0] },
      { id: 3, name: 'B', color: [0.2, 0, 0.4] },
    ]);
  });

  it('of label maps have no label where their padding is', async () => {
    const volume = await read(labelMap, { PixelPaddingValue: [3] });
    expect(labelsOf(volume)[0]).to.equal('200010000010120');
  });

  it('are read with implicit representations and with words of the other order', async () => {
    expect(labelsOf(await read(overlapping, {}, { isImplicit: true }))).to.deep.equal(overlaid);
    const fields = segmentationFields(overlapping);
    const turned = Uint8Array.from(
      [...(fields.PixelData as Uint8Array)],
      (_, i) => (fields.PixelData as Uint8Array)[i ^ 1],
    );
    expect(labelsOf(await read(overlapping, { PixelData: turned }, { isBigEndian: true }))).to.deep.equal(overlaid);
  });

  it('of one frame are one slice', async () => {
    const volume = await read({ ...overlapping, frames: overlapping.frames.slice(0, 1) });
    expect(labelsOf(volume)).to.deep.equal([overlaid[4]]);
    expect(volume.grid.spacing.map((length) => Number(length.toFixed(9)))).to.deep.equal([0.5, 0.75, 2.5]);
  });

  it('take the distance of slices from the file before that of their frames: two slices may be far apart', async () => {
    const volume = await read({ ...overlapping, frames: [overlapping.frames[0], overlapping.frames[1]] });
    expect(labelsOf(volume).map((slice) => Number(slice) > 0)).to.deep.equal([true, false, false, false, true]);
  });

  it('whose slices are not even have the labels of the nearest slice, and say so', async () => {
    const heights = [0, 2, 5.1, 7];
    const volume = await read({
      ...overlapping,
      frames: heights.map((_, slice) => ({ slice, segment: slice + 1, pixels: Array<number>(15).fill(1) })),
      positionOf: (slice) => [0.48, -0.64, 0.6].map((x) => heights[slice] * x),
    });
    // 5 slices, 7 / 4 apart: at 0, 1.75, 3.5, 5.25 and 7.
    expect(labelsOf(volume).map(([first]) => first)).to.deep.equal(['1', '2', '2', '3', '4']);
    expect(volume.left).to.deep.equal([
      'the slices are not evenly spaced: each of 5 even ones has the labels of the nearest slice',
    ]);
  });

  it('whose slices lie between two gaps show each of them', async () => {
    const heights = [0, 1, 2, 3, 5.7, 9.4, 10.4, 11.4];
    const volume = await read({
      ...overlapping,
      spacing: [0.75, 0.5, 1],
      frames: heights.map((_, slice) => ({ slice, segment: slice + 1, pixels: Array<number>(15).fill(1) })),
      positionOf: (slice) => [0.48, -0.64, 0.6].map((x) => heights[slice] * x),
    });
    expect(labelsOf(volume).map(([first]) => first)).to.include('5');
  });

  it('whose slices have a gap between them have no labels there', async () => {
    const heights = [0, 2, 4, 35, 37, 39];
    const volume = await read({
      ...overlapping,
      frames: heights.map((_, slice) => ({ slice, segment: slice + 1, pixels: Array<number>(15).fill(1) })),
      positionOf: (slice) => [0.48, -0.64, 0.6].map((x) => heights[slice] * x),
    });
    const firsts = labelsOf(volume).map(([first]) => first);
    const step = 39 / (firsts.length - 1);
    expect(step).to.be.closeTo(2, 0.1);
    firsts.forEach((label, k) => {
      const near = heights.findIndex((height) => Math.abs(height - k * step) <= 1);
      expect(label, `${k * step} mm`).to.equal(String(near + 1));
    });
  });

  it('among the files of a scan are left out, in words', async () => {
    const { left, format } = await decodeFields([ctSlice(0), segmentationFields(overlapping), ctSlice(5)]);
    expect(format).to.equal('DICOM, CT');
    expect(left).to.deep.equal([
      '1 file of 3: file 2 of 3 is a segmentation: its labels are shown over their scan by <volume-labels src="…">, in the <volume-view> of the scan, one file alone, on a DICOMweb server by the address of its instance',
    ]);
  });

  it('that say too little, or too much, are refused in words', async () => {
    const fields = segmentationFields(overlapping);
    await refuse(
      { ...fields, PixelData: (fields.PixelData as Uint8Array).slice(0, 8) },
      'format/corrupt',
      /ends early: got 8 bytes .* need 10\./,
    );
    const frames = fields.PerFrameFunctionalGroupsSequence as readonly DicomFields[];
    await refuse(
      {
        ...fields,
        PerFrameFunctionalGroupsSequence: frames.map(({ PlanePositionSequence }) => ({ PlanePositionSequence })),
      },
      'format/corrupt',
      /does not say of which segment its frame 1 is/,
    );
    await refuse(
      { ...fields, SharedFunctionalGroupsSequence: [] },
      'format/unsupported',
      /does not say where they lie/,
    );
    await refuse(
      segmentationFields({ ...overlapping, positionOf: (slice) => [4 * slice, 3 * slice, 0] }),
      'format/unsupported',
      /do not lie above each other/,
    );
    await refuse(
      segmentationFields({ ...overlapping, positionOf: (slice) => [0, 0, slice * 1e6] }),
      'format/corrupt',
      /has 3 slices over .* expected at most 16,384/,
    );
    await refuse(
      { ...fields, SegmentSequence: [{ SegmentLabel: 'X' }] },
      'format/corrupt',
      /a segment without a number/,
    );
  });

  it('that ask for more memory than their file may are refused before it is taken', async () => {
    const huge = segmentationFields({
      ...overlapping,
      columns: 512,
      rows: 512,
      frames: [0, 1000].map((slice) => ({ slice, segment: 1, pixels: [1] })),
    });
    await refuse(
      { ...huge, PixelData: new Uint8Array(2 ** 16) },
      'format/too-large',
      /the DICOM segmentation asks for/,
    );
  });

  it('show none of their texts but names of segments', async () => {
    const secret = 'Geheim^Erna';
    const volume = await read(overlapping, {
      PatientName: secret,
      SeriesDescription: secret,
      ImageComments: secret,
      StudyInstanceUID: '1.2.77.4711',
    });
    expect(JSON.stringify({ ...volume, samples: null, macrocells: null })).not.to.match(/geheim|erna|4711/i);
    await refuse(
      { ...segmentationFields({ ...overlapping, positionOf: () => [] }), PatientName: secret },
      'format/unsupported',
      /^the DICOM segmentation has frames of several orientations, or does not say where they lie/,
    );
  });
});
