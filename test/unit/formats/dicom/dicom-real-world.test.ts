import { expect } from '@esm-bundle/chai';
import { ctSlice } from '../../../helpers/dicom-bytes.ts';
import type { DicomFields } from '../../../helpers/dicom-bytes.ts';
import { decodeFields } from '../../../helpers/dicom-series.ts';
import { valuesOf } from '../../../helpers/decode.ts';

const plain = { Modality: 'MR', RescaleSlope: undefined, RescaleIntercept: undefined };
const mapping: DicomFields = {
  RealWorldValueSlope: [0.5],
  RealWorldValueIntercept: [-3],
  MeasurementUnitsCodeSequence: [{ CodeValue: 'Bq/ml' }],
};
const stored = Array.from({ length: 12 }, (_, i) => 100 + i);
/** Slope * number + intercept. Source: PS3.3, C.7.6.16.2.11 */
const real = stored.map((number) => 0.5 * number - 3);

describe('real world values of DICOM files', () => {
  for (const [what, fields] of [
    ['of a file', { RealWorldValueMappingSequence: [mapping] }],
    ['that all frames share', { SharedFunctionalGroupsSequence: [{ RealWorldValueMappingSequence: [mapping] }] }],
    ['of a frame', { PerFrameFunctionalGroupsSequence: [{ RealWorldValueMappingSequence: [mapping] }] }],
  ] as const satisfies readonly (readonly [string, DicomFields])[])
    it(`${what} are its values, with their unit`, async () => {
      const volume = await decodeFields([ctSlice(0, { ...plain, ...fields })]);
      expect(valuesOf(volume)).to.deep.equal(real);
      expect(volume.unit).to.equal('Bq/ml');
    });

  it('do not replace a rescale, and are left out where there are several', async () => {
    const rescaled = { RescaleSlope: [2], RescaleIntercept: [1], RealWorldValueMappingSequence: [mapping] };
    expect(valuesOf(await decodeFields([ctSlice(0, { ...plain, ...rescaled })]))).to.deep.equal(
      stored.map((number) => 2 * number + 1),
    );
    const several = { RealWorldValueMappingSequence: [mapping, mapping] };
    expect(valuesOf(await decodeFields([ctSlice(0, { ...plain, ...several })]))).to.deep.equal(stored);
  });

  it('have the window of the stored numbers at the same pixels', async () => {
    const fields = { RealWorldValueMappingSequence: [mapping], WindowCenter: [106], WindowWidth: [10] };
    const window = { VOILUTFunction: 'LINEAR_EXACT' };
    const { windows } = await decodeFields([ctSlice(0, { ...plain, ...fields, ...window })]);
    const { from, to, width } = windows![0];
    expect([from, to, width]).to.deep.equal([47.5, 52.5, 5]);
  });

  it('have no unit of a code that is not known, which may be any text', async () => {
    const unknown = { ...mapping, MeasurementUnitsCodeSequence: [{ CodeValue: 'Geheim' }] };
    const { unit } = await decodeFields([ctSlice(0, { ...plain, RealWorldValueMappingSequence: [unknown] })]);
    expect(unit).not.to.contain('Geheim');
  });
});
