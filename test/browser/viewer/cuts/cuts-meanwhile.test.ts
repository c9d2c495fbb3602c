// Cuts that an author asks for while the volume is on its way.
import { expect } from '@esm-bundle/chai';
import { ErrorState } from '../../../../src/viewer/model/error-state.ts';
import { readSettings } from '../../../../src/viewer/model/settings.ts';
import type { GivenAttributes } from '../../../../src/viewer/model/settings.ts';
import { noCuts } from '../../../../src/viewer/cuts/shown-cuts.ts';
import type { Cuts } from '../../../../src/viewer/cuts/shown-cuts.ts';
import type { Viewer } from '../../../../src/viewer/view/viewer.ts';
import { VolumePresenter } from '../../../../src/viewer/view/volume-presenter.ts';
import type { Volume } from '../../../../src/volume/volume.ts';
import { syntheticVolume } from '../../../helpers/synthetic.ts';

it('a cutout that is set while the first volume is uploaded is cut out', async () => {
  const host = document.createElement('div');
  const work: Promise<unknown>[] = [];
  const errors = new ErrorState({ file: '', changed: () => {}, failed: () => {} });
  const settings = readSettings(new Proxy({} as GivenAttributes, { get: () => null }));
  const presenter = new VolumePresenter(
    { host, settings, awake: true, emit: () => {}, changed: () => {}, track: (one) => work.push(one) },
    errors,
  );
  const shown: { volume: Volume | null; cuts: Cuts } = { volume: null, cuts: noCuts };
  presenter.viewer = {
    get volume() {
      return shown.volume;
    },
    show(volume: Volume, _optics: unknown, readCuts: () => Cuts) {
      host.setAttribute('cutout', '-2 -2 -2 0 0 0');
      presenter.cutAgain(); // As who watches the element does.
      shown.volume = volume;
      shown.cuts = readCuts();
      return Promise.resolve();
    },
    setCuts(cuts: Cuts) {
      shown.cuts = cuts;
    },
  } as unknown as Viewer;
  await presenter.show(syntheticVolume({ dimensions: [8, 8, 8] }), new AbortController().signal);
  await Promise.all(work);
  expect(shown.cuts.cuts.flatMap(({ items }) => items)).to.have.length(1);
});

it('a region that is not there is reported for the volume, and not for its stand-in as well', async () => {
  const reported: string[] = [];
  const errors = new ErrorState({ file: '', changed: () => {}, failed: (aspect) => reported.push(aspect) });
  const settings = readSettings(
    new Proxy({ region: '100 100 100 101 101 101' } as GivenAttributes, {
      get: (given, name) => Reflect.get(given, name) ?? null,
    }),
  );
  const presenter = new VolumePresenter(
    { host: document.createElement('div'), settings, awake: true, emit: () => {}, changed: () => {}, track: () => {} },
    errors,
  );
  const shown: unknown[] = [];
  presenter.viewer = {
    show: async (volume: Volume, _optics: unknown, readCuts: () => Cuts) =>
      void shown.push(volume.coarse, readCuts().region),
  } as unknown as Viewer;
  const volume = syntheticVolume({ dimensions: [8, 8, 8] });
  const { signal } = new AbortController();
  await presenter.showCoarse({ volume: { ...volume, coarse: true }, of: volume }, signal);
  await presenter.show(volume, signal);
  expect([shown, reported]).to.deep.equal([[true, null, undefined, null], ['region']]);
});
