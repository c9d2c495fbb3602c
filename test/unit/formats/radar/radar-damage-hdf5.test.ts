import { expect } from '@esm-bundle/chai';
import { VolumeViewError } from '../../../../src/core/errors.ts';
import { readCfradial1 } from '../../../../src/formats/radar/cfradial1.ts';
import { readHdf5Radar } from '../../../../src/formats/radar/hdf5-radar.ts';
import type { RadarFile } from '../../../../src/formats/radar/radar-file.ts';
import { fetchFixture } from '../../../helpers/decode.ts';
import { randomNumbers } from '../../../helpers/synthetic.ts';

const tooLong = 5000;

type Reader = (bytes: Uint8Array<ArrayBuffer>) => Promise<RadarFile>;

/** Old and new forms of HDF5 for ODIM_H5; both containers of CfRadial 1; CfRadial 2. */
const files: readonly (readonly [string, Reader])[] = [
  ['odim-2.0.h5', readHdf5Radar],
  ['odim-2.2.h5', readHdf5Radar],
  ['odim-2.3.h5', readHdf5Radar],
  ['cfradial1-classic.nc', readCfradial1],
  ['cfradial1-records.nc', readCfradial1],
  ['cfradial1-nc4.nc', readHdf5Radar],
  ['cfradial2.nc', readHdf5Radar],
];

/** Signatures of structures in an HDF5 file. */
const signatures = [
  'TREE',
  'SNOD',
  'HEAP',
  'OHDR',
  'OCHK',
  'FRHP',
  'FHDB',
  'FHIB',
  'BTHD',
  'BTLF',
  'FAHD',
  'FADB',
  'GCOL',
];

/** Read all that a file holds. A radar file or one of our errors is well; anything else, or a long wait, is not. */
async function survive(read: Reader, bytes: Uint8Array<ArrayBuffer>, what: string): Promise<string> {
  const start = performance.now();
  let answer = 'radar file';
  try {
    const radar = await read(bytes);
    for (const sweep of radar.sweeps) {
      expect(
        sweep.azimuths.every((azimuth) => azimuth >= 0 && azimuth < 360),
        what,
      ).to.equal(true);
      for (const moment of sweep.moments) checkData(sweep.read(moment), sweep.azimuths.length, what);
    }
  } catch (error) {
    if (!(error instanceof VolumeViewError)) throw new Error(`${what}: ${String(error)}`, { cause: error });
    expect(error.message.length, what).to.be.greaterThan(20);
    answer = error.code;
  }
  // No timer could end a loop, so that what took long is found only here.
  expect(performance.now() - start, what).to.be.lessThan(tooLong);
  return answer;
}

function checkData(data: ReturnType<RadarFile['sweeps'][number]['read']>, rays: number, what: string): void {
  expect(data, what).to.not.equal(null);
  const { samples, gates, firstGate, gateLength, slope, intercept } = data!;
  expect(samples.length, what).to.equal(rays * gates);
  expect(gateLength, what).to.be.greaterThan(0);
  expect([firstGate, gateLength, slope, intercept].every(Number.isFinite), what).to.equal(true);
}

/** Places that hold the structure of the file: its first bytes, and those after each signature. */
function listStructure(bytes: Uint8Array): number[] {
  const text = new TextDecoder('latin1').decode(bytes);
  const starts = [0];
  for (const signature of signatures) {
    for (let at = text.indexOf(signature); at >= 0; at = text.indexOf(signature, at + 1)) starts.push(at);
  }
  return starts.flatMap((start) => Array.from({ length: 96 }, (_, i) => start + i)).filter((at) => at < bytes.length);
}

describe('damaged HDF5 and NetCDF radar files', () => {
  for (const [name, read] of files) {
    it(`${name}: cut at 100 positions, an error with a code`, async () => {
      const bytes = await fetchFixture(`radar/${name}`);
      for (let i = 0; i < 100; i++) {
        const length = Math.floor((i * bytes.length) / 100);
        const answer = await survive(read, bytes.slice(0, length), `${length} bytes`);
        expect(answer, `${length} of ${bytes.length} bytes`).to.be.oneOf(['format/corrupt', 'format/unknown']);
      }
    });

    it(`${name}: bytes changed at random 1,000 times, a radar file or an error with a code`, async () => {
      const bytes = await fetchFixture(`radar/${name}`);
      const structure = listStructure(bytes);
      const random = randomNumbers(bytes.length);
      const answers = new Map<string, number>();
      for (let run = 0; run < 1000; run++) {
        const damaged = bytes.slice();
        for (let n = 0; n <= run % 8; n++) {
          // Every other run damages the structure, which is only a few of the file's bytes.
          const at = run % 2 ? structure[Math.floor(random() * structure.length)] : Math.floor(random() * bytes.length);
          damaged[at] = Math.floor(random() * 256);
        }
        const answer = await survive(read, damaged, `${name}, run ${run}`);
        answers.set(answer, (answers.get(answer) ?? 0) + 1);
      }
      // Both must come up, or the changes hit nothing, or everything.
      expect(answers.get('radar file'), JSON.stringify([...answers])).to.be.greaterThan(20);
      expect(answers.get('format/corrupt'), JSON.stringify([...answers])).to.be.greaterThan(20);
    });
  }
});
