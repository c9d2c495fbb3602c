import { expect } from '@esm-bundle/chai';
import { ctSlice, dicomBytes, pixelFields } from '../../../helpers/dicom-bytes.ts';
import type { DicomFields } from '../../../helpers/dicom-bytes.ts';
import { decodeFields, decodeSeries } from '../../../helpers/dicom-series.ts';
import { valuesOf } from '../../../helpers/decode.ts';

const stored = Uint16Array.from({ length: 12 }, (_, i) => 1000 * i);

const dose: DicomFields = {
  RadiopharmaceuticalStartTime: '130000',
  RadionuclideTotalDose: '370000000',
  RadionuclideHalfLife: '6586.2',
};

/** A slice of PET in Bq/ml, 20 for each stored number, corrected to the time of its scan: one hour after the tracer was given to 75 kg. */
const petSlice = (z: number, fields: DicomFields = {}): DicomFields =>
  ctSlice(z, {
    ...pixelFields(stored),
    Modality: 'PT',
    ImageType: 'ORIGINAL\\PRIMARY',
    RescaleSlope: '20',
    RescaleIntercept: '0',
    Units: 'BQML',
    CorrectedImage: 'NORM\\DTIM\\ATTN\\SCAT\\DECY',
    DecayCorrection: 'START',
    PatientWeight: '75',
    SeriesDate: '20240131',
    SeriesTime: '140000.00',
    AcquisitionDate: '20240131',
    AcquisitionTime: '140210',
    RadiopharmaceuticalInformationSequence: [dose],
    ...fields,
  });

/** The value of the number 1000, and its unit. */
async function read(fields: DicomFields): Promise<[value: number, unit: string]> {
  const volume = await decodeFields([petSlice(0, fields), petSlice(5, fields)]);
  return [valuesOf(volume)[1], volume.unit];
}

describe('SUV by body weight', () => {
  // Body weight in g, through the dose in Bq that is left after so many half-lives: QIBA Profile FDG-PET/CT, appendix G, computed in Python.
  const [afterAnHour, withoutDecay, afterTwoHours] = [
    20000 * 0.0002960750161260463,
    20000 * 0.0002027027027027027,
    20000 * 0.0004324580481919237,
  ];

  const cases: Readonly<Record<string, readonly [fields: DicomFields, value: number]>> = {
    'corrected to the start of the scan': [{}, afterAnHour],
    'corrected to the time of the injection': [{ DecayCorrection: 'ADMIN' }, withoutDecay],
    'with date and time of the injection': [
      {
        RadiopharmaceuticalInformationSequence: [
          { ...dose, RadiopharmaceuticalStartTime: '010000', RadiopharmaceuticalStartDateTime: '20240131120000.0' },
        ],
      },
      afterTwoHours,
    ],
    'over midnight': [
      {
        SeriesTime: '003000',
        AcquisitionTime: '003100',
        RadiopharmaceuticalInformationSequence: [{ ...dose, RadiopharmaceuticalStartTime: '233000' }],
      },
      afterAnHour,
    ],
  };
  for (const [name, [fields, value]] of Object.entries(cases)) {
    it(name, async () => {
      const [got, unit] = await read(fields);
      expect(unit).to.equal('SUV');
      expect(got / value).to.be.closeTo(1, 1e-7);
    });
  }

  const without: Readonly<Record<string, DicomFields>> = {
    'no weight': { PatientWeight: undefined },
    'a weight of 0': { PatientWeight: '0' },
    'no dose': { RadiopharmaceuticalInformationSequence: undefined },
    'no half-life': { RadiopharmaceuticalInformationSequence: [{ ...dose, RadionuclideHalfLife: undefined }] },
    'no time of the injection': {
      RadiopharmaceuticalInformationSequence: [{ ...dose, RadiopharmaceuticalStartTime: undefined }],
    },
    'no correction of decay': { DecayCorrection: 'NONE' },
    'no correction of attenuation': { CorrectedImage: 'NORM\\DECY' },
    'a series that was made after its acquisition': { SeriesTime: '150000' },
    'an injection after the scan': {
      RadiopharmaceuticalInformationSequence: [{ ...dose, RadiopharmaceuticalStartDateTime: '20240131150000' }],
    },
  };
  for (const [name, fields] of Object.entries(without))
    it(`stays in Bq/ml with ${name}`, async () => expect(await read(fields)).to.deep.equal([20000, 'Bq/ml']));

  it('takes numbers that are SUV as they are, and those by another measure of the body as g/ml', async () => {
    expect(await read({ Units: 'GML' })).to.deep.equal([20000, 'SUV']);
    expect(await read({ Units: 'GML', SUVType: 'BW' })).to.deep.equal([20000, 'SUV']);
    expect(await read({ Units: 'GML', SUVType: 'LBM' })).to.deep.equal([20000, 'g/ml']);
  });

  it('scales the window of the file too', async () => {
    const { window } = await decodeFields([petSlice(0, { WindowCenter: '5000', WindowWidth: '10000' })]);
    expect(window![0]).to.equal(0);
    // White is one count lower, as LINEAR has it: 9,999.
    expect(window![1] / (afterAnHour / 2)).to.be.closeTo(0.9999, 1e-7);
  });
});

describe('the look of PET', () => {
  /** A body of 32 x 32 pixels with noise around it, in which a few pixels have 100 times as much as the others. */
  function makeSlice(z: number, fields: DicomFields): Uint8Array<ArrayBuffer> {
    const numbers = Uint16Array.from({ length: 1024 }, (_, i) => {
      const isInside = Math.hypot((i % 32) - 15.5, (i >> 5) - 15.5) < 12;
      const noise = (i * 7919 + z * 104_729) % 17;
      if (!isInside) return noise;
      return i % 397 === 0 ? 50_000 + noise : i % 31 === 0 ? 4000 + noise : 400 + 4 * noise;
    });
    return dicomBytes(petSlice(z, { ...pixelFields(numbers), Rows: [32], Columns: [32], ...fields }));
  }

  for (const [unit, fields] of Object.entries({
    SUV: {},
    'Bq/ml': { PatientWeight: undefined },
    counts: { Units: 'CNTS' },
  } satisfies Record<string, DicomFields>)) {
    it(`is hot iron in ${unit}`, async () => {
      const volume = await decodeSeries(Array.from({ length: 32 }, (_, z) => makeSlice(z, fields)));
      expect(volume.unit).to.equal(unit);
      expect(volume.transferFunction).to.match(/^0% #160b39 0, .* 100% #fdf9c8/);
    });
  }

  it('is not that of other kinds with a unit', async () => {
    const volume = await decodeSeries(
      Array.from({ length: 32 }, (_, z) => makeSlice(z, { Modality: 'RTDOSE', DoseUnits: 'GY', DoseGridScaling: '1' })),
    );
    expect(volume.unit).to.equal('Gy');
    expect(volume.transferFunction).to.equal(undefined);
  });
});
