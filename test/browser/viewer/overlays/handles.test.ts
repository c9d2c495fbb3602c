// Handles over a picture: where they stand, and what they tell of a drag and of keys. End to end: test/e2e/measure.spec.ts.
import { expect } from '@esm-bundle/chai';
import { orbitCamera } from '../../../../src/optics/rays/camera.ts';
import type { Camera } from '../../../../src/optics/rays/camera.ts';
import { Handles } from '../../../../src/viewer/overlays/handles.ts';
import type { HandledView } from '../../../../src/viewer/overlays/handles.ts';
import type { View } from '../../../../src/viewer/model/scene.ts';
import { socketOf } from '../../../../src/viewer/model/view-socket.ts';
import type { Vector3 } from '../../../../src/volume/matrix.ts';

/** From the front at a distance of 10, 200 pixels high: a pixel at the middle is this long, and x runs to the left. */
const camera = orbitCamera({ theta: 0, phi: Math.PI / 2, radius: 10 }, [0, 0, 0], Math.PI / 3);
const pixel = (20 * Math.tan(Math.PI / 6)) / 200;

interface Stage {
  readonly view: HandledView & { camera: Camera };
  readonly handles: Handles;
  readonly buttons: () => HTMLButtonElement[];
  readonly moves: [index: number, to: Vector3, end: boolean][];
}

function setStage(places: readonly Vector3[], along?: Vector3): Stage {
  const view = Object.assign(document.createElement('div'), { camera });
  view.style.cssText = 'position: absolute; left: 10px; top: 20px; width: 300px; height: 200px; border: 5px solid';
  const root = view.attachShadow({ mode: 'open' });
  const picture = root.appendChild(document.createElement('div'));
  document.body.append(view);
  const moves: Stage['moves'] = [];
  const list = [...places];
  const show = (): void =>
    handles.set(
      list.map((at, i) => ({
        at,
        along,
        name: `Point ${i + 1}`,
        place: at.map((x) => x.toFixed(2)).join(' '),
        keys: 'Keys',
      })),
    );
  const handles: Handles = new Handles(view, picture, {
    moved: (index, to, end) => {
      moves.push([index, to, end]);
      list[index] = to;
      show();
    },
  });
  show();
  return { view, handles, moves, buttons: () => [...root.querySelectorAll<HTMLButtonElement>('.handle')] };
}

/** Press, move and let go, by pixels from the middle of a button; synthetic pointers can't be captured. */
function drag(button: HTMLButtonElement, by: readonly [x: number, y: number], last = 'pointerup'): void {
  button.setPointerCapture = () => {};
  const { left, top, width, height } = button.getBoundingClientRect();
  const at = [left + width / 2 + 3, top + height / 2 - 2]; // Nobody hits the middle.
  const fire = (type: string, clientX: number, clientY: number): boolean =>
    button.dispatchEvent(new PointerEvent(type, { pointerId: 7, clientX, clientY, bubbles: true, cancelable: true }));
  fire('pointerdown', at[0], at[1]);
  fire('pointermove', at[0] + by[0], at[1] + by[1]);
  fire(last, at[0] + by[0], at[1] + by[1]);
}

const middleOf = (button: Element): number[] => {
  const { left, top, width, height } = button.getBoundingClientRect();
  return [left + width / 2 - 15, top + height / 2 - 25]; // From the edge of the picture, inside the border.
};

describe('handles over a picture', () => {
  it('stand where the camera shows their places, follow it, and hide behind the eye and outside the picture', () => {
    const { view, buttons, handles } = setStage([
      [0, 0, 0],
      [-50 * pixel, 0, 30 * pixel],
      [0, 11, 0],
      [-200 * pixel, 0, 0],
    ]);
    expect(middleOf(buttons()[0]).map(Math.round)).to.deep.equal([150, 100]);
    expect(middleOf(buttons()[1]).map(Math.round)).to.deep.equal([200, 70]);
    expect(buttons().map((button) => getComputedStyle(button).visibility)).to.deep.equal([
      'visible',
      'visible',
      'hidden',
      'hidden',
    ]);
    view.camera = orbitCamera({ theta: Math.PI, phi: Math.PI / 2, radius: 10 }, [0, 0, 0], Math.PI / 3);
    socketOf(view).place({} as View);
    expect(middleOf(buttons()[1]).map(Math.round)).to.deep.equal([100, 70]);
    expect(getComputedStyle(buttons()[2]).visibility).to.equal('visible');
    expect(buttons()[0].getBoundingClientRect().width).to.be.at.least(24);
    handles.dispose();
    expect(buttons()).to.have.length(0);
    view.remove();
  });

  it('go where they are dragged, by as much as the pointer goes; what is cancelled goes back', () => {
    const { view, buttons, moves } = setStage([
      [0, 0, 0],
      [0, 0, 1],
    ]);
    drag(buttons()[0], [30, -20]);
    expect(moves.map(([index, , end]) => [index, end])).to.deep.equal([
      [0, false],
      [0, true],
    ]);
    moves[1][1].forEach((x, axis) => expect(x).to.be.closeTo([-30 * pixel, 0, 20 * pixel][axis], 1e-9));
    expect(middleOf(buttons()[0]).map(Math.round)).to.deep.equal([180, 80]);
    drag(buttons()[1], [30, -20], 'pointercancel');
    expect(moves[3]).to.deep.equal([1, [0, 0, 1], true]);
    view.remove();
  });

  it('go along their line alone where they have one, and by keys, but not out of the picture', () => {
    const { view, buttons, moves } = setStage([[0, 0, 0]], [0, 0, 2]);
    drag(buttons()[0], [30, -20]);
    moves[1][1].forEach((x, axis) => expect(x).to.be.closeTo([0, 0, 20 * pixel][axis], 1e-9));
    const press = (key: string): boolean =>
      buttons()[0].dispatchEvent(
        new KeyboardEvent('keydown', { key, shiftKey: true, bubbles: true, cancelable: true }),
      );
    expect(press('ArrowUp'), 'the page does not scroll').to.equal(false);
    moves[2][1].forEach((x, axis) => expect(x).to.be.closeTo([0, 0, 60 * pixel][axis], 1e-9));
    press('ArrowUp');
    expect(moves, 'it is 100 pixels to the edge').to.have.length(4);
    press('ArrowUp');
    expect(moves).to.have.length(4);
    expect(press('Tab')).to.equal(true);
    view.remove();
  });

  it('say to a screen reader what they are, and where they are once they are still', async () => {
    const { view, buttons } = setStage([[0, 0, 0]]);
    expect(buttons()[0].getAttribute('aria-label')).to.equal('Point 1, 0.00 0.00 0.00');
    buttons()[0].focus();
    buttons()[0].dispatchEvent(new KeyboardEvent('keydown', { key: 'PageUp', bubbles: true, cancelable: true }));
    const reported = view.shadowRoot!.querySelector('[role=status]')!;
    expect(reported.textContent).to.equal('');
    await new Promise((resolve) => setTimeout(resolve, 700));
    expect(reported.textContent?.split(' ')[1]).to.equal((-4 * pixel).toFixed(2));
    view.remove();
  });
});
