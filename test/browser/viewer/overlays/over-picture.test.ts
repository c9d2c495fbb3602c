// What stands over a picture: numbers of measures, labels of rings, handles.
import { expect } from '@esm-bundle/chai';
import { Handles } from '../../../../src/viewer/overlays/handles.ts';
import type { HandledView } from '../../../../src/viewer/overlays/handles.ts';
import { LineOverlay } from '../../../../src/viewer/overlays/line-overlay.ts';
import type { Vector3 } from '../../../../src/volume/matrix.ts';

const camera = { eye: [0, -10, 0], target: [0, 0, 0], up: [0, 0, 1], fieldOfView: 1 } as const;
let view: HTMLElement;
let picture: HTMLElement;

beforeEach(() => {
  view = document.createElement('div');
  view.style.cssText = 'position: relative; width: 200px; height: 100px';
  picture = document.createElement('div');
  view.attachShadow({ mode: 'open' }).append(picture);
  document.body.append(view);
});
afterEach(() => view.remove());

it('of ring labels those are left out that a number would cover, and no other', () => {
  const labels = document.createElement('div');
  labels.className = 'labels';
  labels.innerHTML =
    '<span style="position: absolute; left: 90px; top: 30px">50 km</span><span style="position: absolute; left: 5px; top: 80px">100 km</span>';
  picture.after(labels);
  const overlay = new LineOverlay(picture, { part: 'measure', opacity: 1, isDashed: true });
  overlay.show({ camera, width: 200, height: 100 }, [], '#fff', { at: [0, 0, 0], text: '96.5 km', isAbove: false });
  expect([...labels.children].map((label) => (label as HTMLElement).hidden)).to.deep.equal([true, false]);
});

it('handles of several owners are in the order in which they came', () => {
  const handled = Object.assign(view, { camera }) as HandledView;
  const owners = ['first', 'second', 'third'].map((name) => {
    const handles = new Handles(handled, picture, { moved: () => {} });
    handles.set([{ at: [0, 0, 0] as Vector3, name, place: '', keys: '' }]);
    return handles;
  });
  expect([...view.shadowRoot!.querySelectorAll('button')].map(({ ariaLabel }) => ariaLabel)).to.deep.equal([
    'first',
    'second',
    'third',
  ]);
  owners.forEach((handles) => handles.dispose());
  expect(view.shadowRoot!.children.length).to.equal(1);
});
