import { expect } from '@esm-bundle/chai';
import { VolumeViewError } from '../../../../src/core/errors.ts';
import { bunzip2 } from '../../../../src/formats/codecs/bunzip2.ts';
import { readNexrad } from '../../../../src/formats/radar/nexrad.ts';
import { fetchFixture } from '../../../helpers/decode.ts';
import { randomNumbers } from '../../../helpers/synthetic.ts';

const longest = 5000;

/** Read all of a file; a radar file or one of our errors is well, anything else, or an answer that takes long, is not. */
async function survive(bytes: Uint8Array<ArrayBuffer>, what: string): Promise<string> {
  const start = performance.now();
  try {
    const radar = await readNexrad(bytes);
    for (const sweep of radar.sweeps)
      for (const moment of sweep.moments) expect(sweep.read(moment)!.samples.length).to.be.greaterThan(-1);
    return radar.partial ? 'partial' : 'whole';
  } catch (error) {
    if (!(error instanceof VolumeViewError)) throw new Error(`${what}: ${String(error)}`, { cause: error });
    expect(error.message.length, what).to.be.greaterThan(20);
    return error.code;
  } finally {
    expect(performance.now() - start, what).to.be.lessThan(longest);
  }
}

async function unpack(bytes: Uint8Array<ArrayBuffer>): Promise<Uint8Array<ArrayBuffer>> {
  const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream('gzip'));
  return new Uint8Array(await new Response(stream).arrayBuffer());
}

const packed1 = await fetchFixture('nexrad/message-1.gz');
const files: Record<string, Uint8Array<ArrayBuffer>> = {
  'message 31, bzip2': await fetchFixture('nexrad/message-31.ar2v'),
  'message 31, plain': await fetchFixture('nexrad/message-31-plain.ar2v'),
  'message 1, bzip2': await fetchFixture('nexrad/message-1-packed.ar2v'),
  'message 1, plain': await unpack(packed1),
  'message 1, gzip': packed1,
};

describe('damaged NEXRAD Level II files', () => {
  for (const [name, bytes] of Object.entries(files)) {
    it(`${name}: cut at 100 positions, an error or a partial volume`, async () => {
      for (let i = 0; i < 100; i++) {
        // The last frame of a message 1 is filled up with zeros, which nobody misses.
        const length = Math.floor((i * (bytes.length - 2432 * Number(name === 'message 1, plain'))) / 100);
        const answer = await survive(bytes.slice(0, length), `${length} bytes`);
        expect(answer, `${length} bytes`).to.not.equal('whole');
      }
    });

    it(`${name}: 1,000 times some bytes changed, an answer`, async () => {
      const random = randomNumbers(bytes.length);
      const answers = new Set<string>();
      for (let run = 0; run < 1000; run++) {
        const damaged = bytes.slice();
        // Now and then only in the first bytes, where the lengths and headers are.
        const reach = run % 4 === 0 ? Math.min(400, bytes.length) : bytes.length;
        for (let n = 0; n <= run % 8; n++) damaged[Math.floor(random() * reach)] = Math.floor(random() * 256);
        answers.add(await survive(damaged, `run ${run}`));
      }
      expect([...answers]).to.include('format/corrupt');
    });
  }
});

describe('bunzip2', () => {
  it('stops at the size that it is given', () => {
    const bytes = files['message 31, bzip2'].subarray(28);
    expect(bunzip2(bytes, 1e6).length).to.equal(3 * 2432);
    expect(() => bunzip2(bytes, 1000)).to.throw(VolumeViewError, 'more than 1,000 bytes');
  });

  it('says what is not bzip2, and what ends early', () => {
    expect(() => bunzip2(new Uint8Array(10), 1000)).to.throw(VolumeViewError, 'no bzip2 header');
    expect(() => bunzip2(files['message 31, bzip2'].slice(28, 60), 1e6)).to.throw(VolumeViewError, 'ends early');
  });
});
