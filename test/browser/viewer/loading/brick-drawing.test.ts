// When views in bricks draw, and how long one of them keeps its context where a page has more views than contexts.
import { expect } from '@esm-bundle/chai';
import type { Scene } from '../../../../src/viewer/model/scene.ts';
import type { SocketView, SocketViewer } from '../../../../src/viewer/model/view-socket.ts';
import { BrickDrawing, takeTurn } from '../../../../src/viewer/loading/brick-drawing.ts';

const turn = (): Promise<void> => new Promise((resolve) => setTimeout(resolve));

/** A viewer of which the test says when it has drawn. */
function createViewer() {
  const waiting: (() => void)[] = [];
  const state = { held: 0, asked: 0 };
  const loop = {
    dirty: false,
    drawing: null as Promise<void> | null,
    request: () => void (state.asked++, (loop.dirty = true)),
    change: () => new Promise<void>((resolve) => waiting.push(resolve)),
  };
  const controller = {
    async withScene<T>(work: (scene: Scene) => Promise<T>): Promise<T> {
      state.held++;
      try {
        return await work({} as Scene);
      } finally {
        state.held--;
      }
    },
  };
  const draw = async (): Promise<void> => {
    loop.dirty = false;
    for (const resolve of waiting.splice(0)) resolve();
    await turn();
    await turn();
  };
  return { viewer: { loop, controller } as Partial<SocketViewer> as SocketViewer, loop, state, draw };
}

describe('the turn of a view in bricks', () => {
  let host: HTMLElement;
  let other: HTMLElement;
  beforeEach(() => {
    [host, other] = [document.createElement('div'), document.createElement('div')];
    document.body.append(host, other);
  });
  afterEach(() => {
    host.remove();
    other.remove();
  });

  function begin() {
    const { viewer, loop, state, draw } = createViewer();
    const life = new AbortController();
    let settle!: () => void;
    const settled = new Promise<void>((resolve) => (settle = resolve));
    takeTurn({ host, viewer } as Partial<SocketView> as SocketView, life.signal, settled);
    return { loop, state, draw, life, settle };
  }

  it('lasts until the bricks are there and drawn', async () => {
    const { loop, state, draw, settle } = begin();
    await turn();
    expect(state.held).to.equal(1);
    loop.dirty = true;
    settle();
    await turn();
    expect(state.held).to.equal(1);
    await draw();
    expect(state.held).to.equal(0);
  });

  for (const [name, act] of [
    ['presses', (at: Element) => at.dispatchEvent(new PointerEvent('pointerdown', { bubbles: true, composed: true }))],
    ['turns the wheel', (at: Element) => at.dispatchEvent(new WheelEvent('wheel', { bubbles: true, composed: true }))],
    ['uses a key', (at: Element) => at.dispatchEvent(new KeyboardEvent('keydown', { bubbles: true, composed: true }))],
  ] as const)
    it(`ends when a reader ${name} in another view, not in this one`, async () => {
      const { state } = begin();
      act(host);
      await turn();
      expect(state.held).to.equal(1);
      act(other);
      await turn();
      expect(state.held).to.equal(0);
    });

  it('ends with the life of the textures', async () => {
    const { state, life } = begin();
    await turn();
    life.abort();
    await turn();
    expect(state.held).to.equal(0);
  });
});

describe('pictures while bricks come', () => {
  it('are one at a time, also where many bricks come, and none where the view no longer wants it', async () => {
    const { viewer, loop, state, draw } = createViewer();
    const pictures = new BrickDrawing();
    let isWanted = true;
    loop.dirty = true;
    for (let n = 0; n < 5; n++) void pictures.drawSoon(viewer, () => isWanted);
    await draw();
    expect(state.asked).to.equal(1);
    await draw();
    isWanted = false;
    void pictures.drawSoon(viewer, () => isWanted);
    await new Promise((resolve) => setTimeout(resolve, 200));
    expect(state.asked).to.equal(1);
  });

  it('come again in another scene, though the one that was due in the last scene was never drawn', async () => {
    const [before, after] = [createViewer(), createViewer()];
    const pictures = new BrickDrawing();
    before.loop.dirty = true;
    void pictures.drawSoon(before.viewer, () => true);
    pictures.restart();
    void pictures.drawSoon(after.viewer, () => true);
    await turn();
    await turn();
    expect([before.state.asked, after.state.asked]).to.deep.equal([0, 1]);
  });
});
