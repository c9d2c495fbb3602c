// Manifests of strangers, and the timeline of what they list.
import { expect } from '@esm-bundle/chai';
import { Validator } from '@cfworker/json-schema';
import type { Schema } from '@cfworker/json-schema';
import { VolumeViewError } from '../../../../src/core/errors.ts';
import { readManifest } from '../../../../src/formats/manifest/manifest.ts';
import { ScanSequence } from '../../../../src/viewer/loading/scan-sequence.ts';
import { resolveAppearance } from '../../../../src/viewer/appearance/resolve-appearance.ts';
import { plainAppearance } from '../../../../src/viewer/model/plain-appearance.ts';
import { VolumeTimeline } from '../../../../components/volume-timeline/volume-timeline.ts';
import { decodeBytes, expectError, fetchFile } from '../../../helpers/decode.ts';
import { errorOf } from '../../../helpers/error-of.ts';
import { syntheticVolume } from '../../../helpers/synthetic.ts';

const encode = (text: string): Uint8Array<ArrayBuffer> => new TextEncoder().encode(text);

const refusal = (text: string): VolumeViewError => errorOf(() => readManifest(encode(text)));

describe('a manifest of a stranger', () => {
  it('has its sweeps checked once, not once for each scan', () => {
    const sweeps = `[${Array.from({ length: 4000 }, () => '{"rays":1,"azimuths":[0,1,2,3]}').join(',')}]`;
    const scans = `[${Array.from({ length: 10_000 }, () => '{"image":"a"}').join(',')}]`;
    const began = performance.now();
    const manifest = readManifest(encode(`{"sweeps":${sweeps},"scans":${scans}}`));
    // 40 million sweeps took a minute.
    expect(performance.now() - began).to.be.lessThan(20_000);
    expect(manifest.scans).to.have.length(10_000);
    expect(manifest.scans![9999].sweeps).to.equal(manifest.scans![0].sweeps);
  });

  const list = (length: number, one: string): string => `[${Array.from({ length }, () => one).join(',')}]`;
  const bad: [field: string, text: string][] = [
    ['scans', `{"scans":${list(10_001, '{"image":"a"}')}}`],
    ['sweeps', `{"image":"a","sweeps":${list(4097, '{}')}}`],
    ['elevations', `{"image":"a","elevations":${list(4097, '1')}}`],
    ['sweeps', `{"image":"a","sweeps":[{"azimuths":${list(100_001, '1')}}]}`],
    ['title', `{"image":"a","title":"${'t'.repeat(10_001)}"}`],
    ['credit', `{"image":"a","credit":"${'t'.repeat(10_001)}"}`],
    ['unit', `{"image":"a","unit":"${'u'.repeat(201)}"}`],
    ['moment', `{"image":"a","moment":"${'m'.repeat(201)}"}`],
    ['site', `{"image":"a","site":{"name":"${'n'.repeat(201)}"}}`],
    ['range', '{"image":"a","range":[0,1e308]}'],
    ['range', '{"image":"a","range":[-1e300,1]}'],
    ['azimuth', '{"image":"a","azimuth":[1e300,1]}'],
  ];

  it('is refused where it lists too much, and the message is short', async () => {
    const schema = new Validator(
      JSON.parse(new TextDecoder().decode(await fetchFile('/schema/manifest.json'))) as Schema,
      '2020-12',
    );
    for (const [field, text] of bad) {
      const error = refusal(text);
      expect(error.code, field).to.equal('manifest/invalid');
      expect(error.message).to.contain(`"${field}"`);
      expect(error.message.length).to.be.lessThan(400);
      expect(schema.validate(JSON.parse(text)).valid, `the schema says the same of ${field}`).to.equal(false);
    }
    expect(refusal('{"image":"a","window":[-1.7e308,1.7e308]}').message).to.contain('"window"');
  });

  it('is refused before it is read where it is too long', () => {
    const long = new Uint8Array(2 ** 26 + 1);
    let thrown: unknown = null;
    try {
      readManifest(long);
    } catch (error) {
      thrown = error;
    }
    expect((thrown as VolumeViewError).code).to.equal('format/too-large');
  });

  it('may nest lists as it likes', () => {
    const deep = (depth: number): string => `${'['.repeat(depth)}${']'.repeat(depth)}`;
    expect(refusal(`{"image":${deep(50_000)}}`)).to.include({ code: 'manifest/invalid' });
    expect(refusal(`{"scans":[${deep(50_000)}]}`)).to.include({ code: 'manifest/invalid' });
    expect(refusal(`{"image":"a","sweeps":[{"azimuths":${deep(50_000)}}]}`)).to.include({ code: 'manifest/invalid' });
    expect(readManifest(encode(`{"image":"a","note":${deep(50_000)}}`)).image).to.equal('a');
  });

  it('can not bring its own prototype', () => {
    const manifest = readManifest(encode('{"image":"a","__proto__":{"unit":"HU"},"constructor":{"slope":2}}'));
    expect([manifest.unit, manifest.slope]).to.deep.equal([undefined, undefined]);
  });

  it('scales values no farther than numbers go', async () => {
    const fixture = { image: 'nifti/v1-le-f4.nii' };
    const error = await expectError(decodeBytes(encode(JSON.stringify({ ...fixture, slope: 1e308 })), 'a.json'));
    expect(error.message).to.contain('expected finite numbers');
    for (const place of [
      { spacing: [1e200, 1, 1] },
      { spacing: [1, 1e-200, 1] },
      { indexToWorld: [1, 0, 0, 1e300, 0, 1, 0, 0, 0, 0, 1, 0] },
    ]) {
      const far = await expectError(decodeBytes(encode(JSON.stringify({ ...fixture, ...place })), 'a.json'));
      expect(far.code, JSON.stringify(place)).to.equal('format/corrupt');
      expect(far.message).to.contain('from 1e-12 to 1e12');
    }
  });
});

describe('a unit of a stranger', () => {
  it('is a name, whatever objects have under it', async () => {
    for (const unit of ['constructor', '__proto__', 'toString', 'hasOwnProperty']) {
      const appearance = await resolveAppearance(plainAppearance, {
        ...syntheticVolume({ dimensions: [4, 4, 4] }),
        unit,
      });
      expect(appearance.transferFunction.length, unit).to.be.greaterThan(1);
    }
  });
});

describe('thousands of scans', () => {
  it('are not more than a manifest may list', () => {
    const sources = Array.from({ length: 10_001 }, (_, i) => ({ url: `${i}` }));
    expect(() => new ScanSequence(sources, () => Promise.reject(new Error('no')))).to.throw(
      VolumeViewError,
      'at most 10,000',
    );
  });

  it('have a timeline of a hundred marks, whose slider reaches all of them', async () => {
    if (!customElements.get('volume-timeline')) customElements.define('volume-timeline', VolumeTimeline);
    const view = document.createElement('volume-view');
    const times = Array.from({ length: 10_000 }, (_, i) => new Date(Date.UTC(2020, 1, 1) + 60_000 * i).toISOString());
    Object.assign(view, {
      times,
      scan: { index: 4000, time: times[4000], count: times.length },
      waiting: false,
      paused: true,
    });
    const timeline = document.createElement('volume-timeline');
    const box = document.createElement('div');
    box.append(view, timeline);
    document.body.append(box);
    try {
      await timeline.updateComplete;
      const root = timeline.shadowRoot!;
      expect(root.querySelectorAll('*').length).to.be.lessThan(250);
      expect(root.querySelectorAll('.tick').length).to.be.within(100, 125);
      expect(Array.from(root.querySelectorAll('.name'), ({ textContent }) => textContent)).to.deep.equal([
        '00:00',
        '17:40',
        '11:20',
        '22:39',
      ]);
      expect(root.querySelector('input')).to.include({ max: '9999', value: '4000' });
      expect(root.querySelector('.count')!.textContent).to.equal('4001 / 10000');
    } finally {
      box.remove();
    }
  });
});
