import { expect } from '@esm-bundle/chai';
import { openSource } from '../../../../src/viewer/loading/open-source.ts';
import type { SourceHost, SourceRequest } from '../../../../src/viewer/loading/opening.ts';
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

  describe('of several tilts of NEXRAD Level III', () => {
    /** A file's name has its elevation and its time. */
    const tiltOf = (url: string): Volume => {
      const [elevation, time] = url.split('-').map(Number);
      const radar = { sweeps: [{ elevation }], time: `2015-01-02T0${time}:00:00Z` };
      return { ...syntheticVolume({ dimensions: [2, 2, 2] }), format: 'NEXRAD Level III, product 94', radar } as never;
    };
    /** Opens a list whose files together are scans of these times; returns how many scans each player has, the last one first. */
    const openTilts = async (
      src: string,
      times: readonly string[],
      fails = '',
    ): Promise<{ counts: number[]; together: boolean; volume: Volume }> => {
      const players: { times: readonly unknown[] }[] = [];
      let together = false;
      const host: SourceHost = {
        load: async ({ url, files, data }, { onScans }) => {
          if (url === fails) throw new TypeError('not there');
          if (files) together = true;
          if (files && times.length > 1)
            onScans?.(
              times,
              times.map((time) => ({ sweeps: [[time, 94] as const] })),
            );
          return data ? tiltOf('9-9') : tiltOf(url);
        },
        opened: (player) => players.unshift(player),
        go: () => {},
        shown: () => {},
        changed: () => {},
        giveUp: () => {},
      };
      const { signal } = new AbortController();
      const volume = await openSource({ src, stack: false }, host, {
        wanted: { index: 0 },
        signal,
        onProgress: () => {},
        onCoarse: () => {},
      });
      return { counts: players.map((player) => player.times.length), together, volume };
    };

    it('is one scan where they have one time', async () => {
      expect(await openTilts('0.5-1 1.5-1 2.4-1', ['1'])).to.deep.include({ counts: [1, 3], together: true });
    });

    it('is scans in time where they have several, however they are sorted', async () => {
      for (const src of ['0.5-1 1.5-1 0.5-2 1.5-2', '0.5-1 0.5-2 1.5-1 1.5-2'])
        expect(await openTilts(src, ['1', '2']), src).to.deep.include({ counts: [2, 4], together: true });
    });

    it('is scans in time as any other files where all have one elevation, or the others can not be read', async () => {
      expect(await openTilts('0.5-1 0.5-2 0.5-3', [])).to.deep.include({ counts: [3], together: false });
      expect(await openTilts('0.5-1 1.5-1', [], '1.5-1')).to.deep.include({ counts: [2], together: false });
    });
  });

  it('of one file is a stack of one where that is said, as an image is one slice', async () => {
    expect((await ask('a.png', true)).requests[0].files).to.deep.equal(['a.png']);
    expect((await ask('a.png', false)).requests[0].files).to.equal(undefined);
  });
});
