// What a readout keeps while answers are on their way. End to end: test/e2e/readout.spec.ts.
import { assert } from '@esm-bundle/chai';
import { ReadoutPointer } from '../../../../components/volume-readout/volume-readout-pointer.ts';
import type { VolumeView } from '../../../../components/volume-view/volume-view.ts';
import { orbitCamera } from '../../../../src/optics/rays/camera.ts';
import type { VolumePick } from '../../../../src/viewer/model/volume-pick.ts';
import { fakeOf } from '../../../helpers/fake.ts';

const camera = orbitCamera({ theta: 0, phi: Math.PI / 2, radius: 10 }, [0, 0, 0], 1);

/** What is at the place that all of these tests look at. */
const found = (value: number): VolumePick =>
  fakeOf<VolumePick>('VolumePick', { world: [0, 0, 0], value, labelName: undefined });

const nextFrame = (): Promise<number> => new Promise((resolve) => requestAnimationFrame(resolve));

/** A view whose picks are answered when a test says so. */
function openView() {
  const answers: ((pick: VolumePick | null) => void)[] = [];
  const view = Object.assign(document.body.appendChild(document.createElement('div')), {
    camera,
    pick: () => new Promise<VolumePick | null>((resolve) => answers.push(resolve)),
  });
  view.style.cssText = 'width: 100px; height: 100px';
  const reported: (number | null)[] = [];
  const pointer = new ReadoutPointer(view as unknown as VolumeView, view, (pick) => reported.push(pick?.value ?? null));
  const keep = async (value: number): Promise<void> => {
    view.dispatchEvent(new CustomEvent('volume-pick', { detail: found(value) }));
    await nextFrame();
  };
  const close = (): void => {
    pointer.dispose();
    view.remove();
  };
  return { view, answers, reported, keep, close };
}

describe('what a readout keeps', () => {
  it('is read again from another scan, also where the answer takes longer than a frame', async () => {
    const { view, answers, reported, keep, close } = openView();
    await keep(1);
    assert.equal(reported.at(-1), 1);
    view.dispatchEvent(new Event('time-change'));
    for (let i = 0; i < 3; i++) await nextFrame();
    assert.equal(reported.at(-1), 1, 'nothing new is known');
    assert.lengthOf(answers, 1);
    answers[0](found(2));
    for (let i = 0; i < 2; i++) await nextFrame();
    assert.equal(reported.at(-1), 2);
    close();
  });

  it('is what was asked for last, in whichever order answers come', async () => {
    const { view, answers, reported, keep, close } = openView();
    await keep(1);
    view.dispatchEvent(new Event('time-change'));
    view.dispatchEvent(new Event('optics-change'));
    answers[1](found(3));
    await nextFrame();
    answers[0](found(2));
    for (let i = 0; i < 2; i++) await nextFrame();
    assert.equal(reported.at(-1), 3);
    view.dispatchEvent(new Event('time-change'));
    await keep(4);
    answers[2](found(5));
    for (let i = 0; i < 2; i++) await nextFrame();
    assert.equal(reported.at(-1), 4, 'somebody has clicked elsewhere since');
    close();
  });

  it('is a place without a value where nothing is there any more', async () => {
    const { view, answers, reported, keep, close } = openView();
    await keep(1);
    view.dispatchEvent(new Event('load'));
    answers[0](null);
    for (let i = 0; i < 2; i++) await nextFrame();
    assert.isNull(reported.at(-1));
    view.dispatchEvent(new Event('time-change'));
    assert.lengthOf(answers, 2, 'it is asked again');
    answers[1](found(2));
    for (let i = 0; i < 2; i++) await nextFrame();
    assert.equal(reported.at(-1), 2);
    close();
  });
});
