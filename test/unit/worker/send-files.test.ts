import { expect } from '@esm-bundle/chai';
import type { LoadRequest } from '../../../src/formats/base/load-request.ts';
import { openLocal } from '../../../src/sources/open-local.ts';
import { sendFiles } from '../../../src/worker/send-files.ts';

const base = 'https://local-7.invalid/';
const files = Array.from({ length: 100 }, (_, i) => new File([`${i}`], `${i}.dcm`));
const { signal } = new AbortController();

/** What a worker gets of an order for chosen files. @param data - of the time that is shown */
const send = (data?: object): LoadRequest =>
  sendFiles({ url: base, local: { base, files }, data: data as LoadRequest['data'] }, signal) as LoadRequest;

describe('chosen files on their way to a worker', () => {
  it('come in groups, as many as were chosen', async () => {
    const { local } = send();
    expect(local!.files).to.have.length(0);
    const store = await openLocal(local!, signal);
    const urls = await store.list();
    expect(urls).to.have.length(100);
    expect(new TextDecoder().decode((await store.read(urls[99])).bytes)).to.equal('99');
  });

  for (const [what, data] of [
    ['has its own files', { from: { files: files.slice(40, 60), slices: [[0, 0]] } }],
    ['has numbers that the browser keeps', { from: new Blob(['numbers']).slice(2, 5) }],
    ['has numbers of a place', { from: [new Blob(['1']), new Blob(['2'])] }],
    ['has sweeps', { sweeps: [[files[3], 94]] }],
    ['is on a server', { from: { url: 'https://example.test/a.nii', start: 0, end: 9 } }],
  ] as const) {
    it(`none is sent again for one of several times that ${what}`, () => {
      const { local, data: sent } = send(data);
      expect(local).to.deep.equal({ base, files: [] });
      expect(sent).to.equal(data);
    });
  }
});
