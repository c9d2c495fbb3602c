import { expect } from '@esm-bundle/chai';
import { openSource } from '../../../../src/viewer/loading/open-source.ts';
import type { SourceHost, SourceRequest } from '../../../../src/viewer/loading/open-source.ts';
import type { Volume } from '../../../../src/volume/volume.ts';
import { syntheticVolume } from '../../../helpers/synthetic.ts';

/** Open a source with nothing behind it; returns what was asked for, and whether it was opened as scans in time. */
async function ask(
  src: string,
  stack: boolean,
): Promise<{ requests: SourceRequest[]; opened: boolean; volume: Volume }> {
  const requests: SourceRequest[] = [];
  let opened = false;
  const host: SourceHost = {
    load: async (request) => {
      requests.push(request);
      return syntheticVolume({ dimensions: [2, 2, 2] });
    },
    opened: () => (opened = true),
    go: () => {},
    shown: () => {},
    changed: () => {},
    giveUp: () => {},
  };
  const { signal } = new AbortController();
  const volume = await openSource({ src, stack }, host, {
    wanted: { index: 0 },
    signal,
    onProgress: () => {},
    onCoarse: () => {},
  });
  return { requests, opened, volume };
}

describe('a source', () => {
  it('of several files is scans in time', async () => {
    const { requests, opened } = await ask(' a.nii\n b.nii ', false);
    expect(opened).to.equal(true);
    expect(requests[0]).to.include({ url: 'a.nii' });
    expect(requests[0].files).to.equal(undefined);
  });

  it('of several files is one volume where they are a stack', async () => {
    const { requests, opened, volume } = await ask(' a.png\n b.png  c.png', true);
    expect(opened).to.equal(false);
    expect(requests).to.deep.equal([{ url: 'a.png', files: ['a.png', 'b.png', 'c.png'], scan: { index: 0 } }]);
    expect(volume.grid.dimensions).to.deep.equal([2, 2, 2]);
  });

  it('of one file is a stack of one where that is said, as an image is one slice', async () => {
    expect((await ask('a.png', true)).requests[0].files).to.deep.equal(['a.png']);
    expect((await ask('a.png', false)).requests[0].files).to.equal(undefined);
  });
});
