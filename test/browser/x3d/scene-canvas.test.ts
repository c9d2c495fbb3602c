import { expect } from '@esm-bundle/chai';
import { orbitCamera } from '../../../src/optics/rays/camera.ts';
import { VolumeScene } from '../../../src/x3d/scene.ts';
import { changePlan, drawAt } from '../../helpers/change-plan.ts';
import { comparePictures, drawPicture, height, plainOptics, shells, width, withScene } from '../../helpers/picture.ts';
import type { View } from '../../helpers/picture.ts';
import { syntheticVolume } from '../../helpers/synthetic.ts';
import { readPixels } from '../../helpers/read-pixels.ts';

const view: View = {
  volume: syntheticVolume({ dimensions: [16, 16, 16] }),
  camera: orbitCamera({ theta: 0.6, phi: 1.2, radius: 40 }, [0, 0, 0], 0.6),
  stepLength: 0.5,
};

function contextOf(scene: VolumeScene): WebGLRenderingContext {
  return (scene.canvas.getContext('webgl2') ?? scene.canvas.getContext('webgl')) as WebGLRenderingContext;
}

/** What the page's compositor makes of the canvas over a colour. */
function drawOver(canvas: HTMLCanvasElement, background: string): Uint8ClampedArray {
  const page = document.createElement('canvas');
  page.width = width;
  page.height = height;
  const context = page.getContext('2d', { willReadFrequently: true })!;
  context.fillStyle = background;
  context.fillRect(0, 0, width, height);
  context.drawImage(canvas, 0, 0);
  return context.getImageData(0, 0, width, height).data;
}

describe('the canvas', () => {
  for (const webgl1 of [false, true]) {
    it(`lets the CSS background show through without a dark fringe, WebGL ${webgl1 ? 1 : 2}`, () =>
      withScene({ webgl1 }, (scene) => {
        const pixels = drawPicture(scene, view);
        expect(contextOf(scene).getContextAttributes()).to.include({ alpha: true, premultipliedAlpha: true });
        for (const [color, rgb] of [
          ['#fff', [255, 255, 255]],
          ['rgb(20 140 220)', [20, 140, 220]],
        ] as const) {
          const page = drawOver(scene.canvas, color);
          let partial = 0;
          for (let i = 0; i < pixels.length; i += 4) {
            const alpha = pixels[i + 3] / 255;
            if (alpha > 0.1 && alpha < 0.9) partial++;
            for (let c = 0; c < 3; c++) {
              // Premultiplied colour over the page; the canvas and the compositor each round once.
              expect(page[i + c], `pixel ${i / 4} over ${color}`).to.be.closeTo(
                pixels[i + c] + (1 - alpha) * rgb[c],
                1.5,
              );
            }
          }
          expect(partial, 'half transparent pixels to speak of').to.be.above(50);
        }
      }));
  }

  it('is empty where the volume is not, and never brighter than its opacity', () =>
    withScene({}, (scene) => {
      const pixels = drawPicture(scene, view);
      expect([...pixels.subarray(0, 4)]).to.deep.equal([0, 0, 0, 0]);
      for (let i = 0; i < pixels.length; i += 4) {
        expect(Math.max(pixels[i], pixels[i + 1], pixels[i + 2])).to.be.at.most(pixels[i + 3]);
      }
    }));

  it('takes a new size, with the aspect of the picture right in the first frame', () =>
    withScene({}, (scene) => {
      drawPicture(scene, view);
      changePlan(scene, { picture: { width: 60, height: 60 } });
      drawAt(scene, view.stepLength);
      const projection = scene.getView().projection;
      expect(projection[0]).to.be.closeTo(projection[5], 1e-12);
      const pixels = readPixels(scene);
      expect(pixels.length).to.equal(60 * 60 * 4);
      expect(pixels[(30 * 60 + 30) * 4 + 3], 'the middle').to.be.above(100);
      expect(pixels[3], 'a corner').to.equal(0);
    }));

  it('draws the same picture again, and another one when what it shows changes', () =>
    withScene({}, (scene) => {
      const first = drawPicture(scene, view);
      drawAt(scene, view.stepLength);
      expect(comparePictures(readPixels(scene), first).worst).to.equal(0);
      void scene.setAppearance({
        optics: {
          ...plainOptics,
          transferFunction: shells.map((stop) => ({ ...stop, color: [0, 1, 0] as const })),
        },
      });
      drawAt(scene, view.stepLength);
      const green = readPixels(scene);
      expect(comparePictures(green, first).worst).to.be.above(20);
      expect(Math.max(...green.filter((_, i) => i % 4 === 0)), 'red').to.equal(0);
      // Another volume, of another type and size, in the same scene.
      scene.setVolume(syntheticVolume({ dimensions: [9, 12, 7], kind: 'uint16', field: () => 0.5 }));
      drawAt(scene, view.stepLength);
      const other = readPixels(scene);
      expect(comparePictures(other, green).worst).to.be.above(20);
      expect(comparePictures(drawPicture(scene, view), first).worst, 'and back').to.equal(0);
    }));

  it('loses its context and leaves the page when the scene is taken down', async () => {
    const container = document.createElement('div');
    document.body.append(container);
    const scene = await VolumeScene.create(container, container, () => {});
    await scene.setAppearance({ optics: plainOptics });
    changePlan(scene, { picture: { width, height } });
    drawPicture(scene, view);
    const gl = contextOf(scene);
    expect(gl.isContextLost()).to.equal(false);
    scene.dispose();
    expect(gl.isContextLost()).to.equal(true);
    expect(container.childElementCount).to.equal(0);
    container.remove();
  });

  it('eight scenes stand side by side and show what one alone shows', async () => {
    const expected = await withScene({}, (scene) => drawPicture(scene, view));
    const hosts = Array.from({ length: 8 }, () => document.body.appendChild(document.createElement('div')));
    const scenes = await Promise.all(hosts.map((host) => VolumeScene.create(host, host, () => {})));
    try {
      await Promise.all(scenes.map((scene) => scene.setAppearance({ optics: plainOptics })));
      for (const scene of scenes) changePlan(scene, { picture: { width, height } });
      for (const scene of scenes) drawPicture(scene, view);
      for (const scene of scenes) {
        drawAt(scene, view.stepLength);
        expect(comparePictures(readPixels(scene), expected).worst).to.equal(0);
      }
    } finally {
      for (const scene of scenes) scene.dispose();
      for (const host of hosts) host.remove();
    }
  });

  it('twenty scenes one after the other leave no context behind', async () => {
    const expected = await withScene({}, (scene) => drawPicture(scene, view));
    for (let i = 0; i < 20; i++) {
      const pixels = await withScene({}, (scene) => drawPicture(scene, view));
      expect(comparePictures(pixels, expected).worst, `scene ${i}`).to.equal(0);
    }
  });
});
