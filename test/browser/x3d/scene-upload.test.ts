import { expect } from '@esm-bundle/chai';
import { VolumeViewError } from '../../../src/core/errors.ts';
import { orbitCamera } from '../../../src/optics/rays/camera.ts';
import { longestDiagonal } from '../../../src/volume/grid.ts';
import type { Vector3 } from '../../../src/volume/matrix.ts';
import type { Volume } from '../../../src/volume/volume.ts';
import { pieceBytes, quickBytes } from '../../../src/renderer/textures/fill-texture.ts';
import type { Upload } from '../../../src/renderer/textures/fill-texture.ts';
import type { VolumeScene } from '../../../src/x3d/scene.ts';
import { maxBytesAFrame, uploadGradually } from '../../../src/renderer/textures/upload-gradually.ts';
import { countGpuBytes } from '../../bench/count-gpu-bytes.mjs';
import { changePlan, drawAt } from '../../helpers/change-plan.ts';
import { comparePictures, plainOptics, withScene } from '../../helpers/picture.ts';
import { remember } from '../../helpers/remember.ts';
import { syntheticVolume } from '../../helpers/synthetic.ts';
import type { SampleKind } from '../../helpers/synthetic.ts';
import { readPixels } from '../../helpers/read-pixels.ts';

countGpuBytes();
const { gpuBytes } = window as unknown as { gpuBytes: () => { samples: number; textures: number } };

/** Cheap to compute for millions of voxels, symmetric in nothing. */
const slope = (x: number, y: number, z: number): number => Math.min(1, x * y + 0.5 * z * z);
const hole = (x: number, y: number, z: number): number =>
  (x - 0.4) ** 2 + (y - 0.6) ** 2 + z * z < 0.1 ? NaN : slope(x, y, z);

const small = syntheticVolume({ dimensions: [16, 12, 10], spacing: [12, 16, 20] });

function build(kind: SampleKind, dimensions: Vector3, field = slope): Volume {
  const volume = syntheticVolume({ dimensions, kind, field });
  expect(volume.samples.byteLength).to.be.above(quickBytes);
  return volume;
}

/** A little more than what takes one step, each made once. */
const makeOf = {
  bytes: () => build('uint8', [203, 211, 223]),
  words: () => build('uint16', [151, 149, 199]),
  floats: () => build('float32', [131, 137, 139], hole),
  wide: () => build('uint8', [1201, 1103, 7]),
};
const large = remember((kind: keyof typeof makeOf) => makeOf[kind]());

function draw(scene: VolumeScene, volume: Volume): Uint8ClampedArray {
  const diagonal = longestDiagonal(volume.grid);
  void scene.setAppearance({ optics: { ...plainOptics, referenceLength: diagonal / 50 } });
  changePlan(scene, { camera: orbitCamera({ theta: 0.6, phi: 1.2, radius: 1.6 * diagonal }, [0, 0, 0], 0.6) });
  drawAt(scene, diagonal / 60);
  return readPixels(scene);
}

function contextOf({ canvas }: VolumeScene): WebGL2RenderingContext {
  return (canvas.getContext('webgl2') ?? canvas.getContext('webgl')) as WebGL2RenderingContext;
}

interface Piece {
  readonly frame: number;
  readonly bytes: number;
}

/** Note what a context is given by texSubImage, and in which of the page's frames. */
function watchPieces(gl: WebGL2RenderingContext): { pieces: Piece[]; stop: () => void } {
  const pieces: Piece[] = [];
  let frame = 0;
  let handle = requestAnimationFrame(function count() {
    frame++;
    handle = requestAnimationFrame(count);
  });
  for (const name of ['texSubImage2D', 'texSubImage3D'] as const) {
    const original = gl[name] as ((...args: unknown[]) => void) | undefined;
    if (!original) continue;
    Object.defineProperty(gl, name, {
      value: (...args: unknown[]) => {
        pieces.push({ frame, bytes: (args.at(-1) as ArrayBufferView).byteLength });
        original.apply(gl, args);
      },
    });
  }
  return { pieces, stop: () => cancelAnimationFrame(handle) };
}

const wanted = (): boolean => false;

describe('the pace of an upload', () => {
  it('stays below its cap on a GPU that takes no time', () =>
    withScene({}, async (scene) => {
      const pieces: Piece[] = [];
      let frame = 0;
      function* freeUpload(): Upload<string> {
        const bytes = pieceBytes - 1000;
        for (let i = 0; i < 120; i++) {
          pieces.push({ frame, bytes });
          yield bytes;
        }
        return 'done';
      }
      expect(await uploadGradually(contextOf(scene), freeUpload(), () => ++frame < 0)).to.equal('done');
      const perFrame = Array.from({ length: frame }, (_, i) =>
        pieces.filter((piece) => piece.frame === i + 1).reduce((sum, { bytes }) => sum + bytes, 0),
      );
      expect(Math.max(...perFrame)).to.be.at.most(maxBytesAFrame);
      expect(perFrame[0], 'the first, of which nothing is known').to.be.at.most(maxBytesAFrame / 4);
    }));
});

describe('an upload that waits for the GPU', () => {
  it('goes on in another frame, when the GPU has done all that was sent to it', () =>
    withScene({}, async (scene) => {
      const gl = contextOf(scene);
      const order: string[] = [];
      function* waitingUpload(): Upload<string> {
        order.push('makes room');
        yield Infinity;
        order.push('asks for errors');
        return 'done';
      }
      const { clientWaitSync } = gl;
      gl.clientWaitSync = (...args) => {
        const status = clientWaitSync.apply(gl, args);
        if (status !== gl.TIMEOUT_EXPIRED) order.push('finished');
        return status;
      };
      expect(await uploadGradually(gl, waitingUpload(), wanted)).to.equal('done');
      expect(order).to.deep.equal(['finished', 'makes room', 'finished', 'asks for errors']);
    }));
});

for (const webgl1 of [false, true]) {
  describe(`a large volume's way to the GPU, WebGL ${webgl1 ? 1 : 2}`, () => {
    const volumes: readonly (readonly [string, keyof typeof makeOf])[] = [
      ['8 bits', 'bytes'],
      ['16 bits', 'words'],
      ['floats and no data', 'floats'],
      ['slices larger than a piece', 'wide'],
    ];
    for (const [what, kind] of volumes) {
      it(`gives the picture that it gives at once: ${what}`, () =>
        withScene({ webgl1 }, async (scene) => {
          const volume = large(kind);
          const { pieces, stop } = watchPieces(contextOf(scene));
          const held = gpuBytes().textures;
          expect(await scene.bringVolume(volume, wanted)).to.equal(true);
          stop();
          const taken = gpuBytes().textures - held;
          const gradual = draw(scene, volume);
          expect(Math.max(...pieces.map(({ bytes }) => bytes)), 'largest piece').to.be.at.most(pieceBytes);
          const frames = new Map<number, number>();
          for (const { frame, bytes } of pieces) frames.set(frame, (frames.get(frame) ?? 0) + bytes);
          expect(Math.max(...frames.values()), 'most in a frame').to.be.at.most(maxBytesAFrame);
          expect(frames.size, 'frames').to.be.above(1);
          expect(
            pieces.reduce((sum, { bytes }) => sum + bytes, 0),
            'bytes given',
          ).to.equal(taken);
          // Floats of which some have no data come with their weights.
          const most = kind === 'floats' ? 2 : 1;
          expect(taken / volume.samples.byteLength, 'bytes taken for each of the samples').to.be.within(
            most,
            1.3 * most,
          );

          scene.setVolume(small);
          expect(comparePictures(draw(scene, small), gradual).rmse, 'another volume looks otherwise').to.be.above(5);
          scene.setVolume(volume);
          expect(comparePictures(draw(scene, volume), gradual).worst).to.equal(0);
        }));
    }

    it('takes one step where the volume is small', () =>
      withScene({ webgl1 }, async (scene) => {
        const { pieces, stop } = watchPieces(contextOf(scene));
        const coming = scene.bringVolume(small, wanted);
        expect(scene.getRays() !== null, 'before anything was awaited').to.equal(true);
        stop();
        expect(await coming).to.equal(true);
        expect(pieces.length).to.equal(1);
      }));

    it('leaves the old picture until it is there', () =>
      withScene({ webgl1 }, async (scene) => {
        scene.setVolume(small);
        const before = draw(scene, small);
        const { pieces, stop } = watchPieces(contextOf(scene));
        let [looks, worst] = [0, 0];
        const volume = large('words');
        await scene.bringVolume(volume, () => {
          looks++;
          worst = Math.max(worst, comparePictures(draw(scene, small), before).worst);
          return false;
        });
        stop();
        expect(looks, 'pictures on the way').to.be.above(1);
        expect(worst, 'change of the old picture').to.equal(0);
        expect(pieces.length).to.be.above(looks);
        expect(comparePictures(draw(scene, volume), before).rmse, 'then the new one').to.be.above(5);
      }));

    it('needs no frames in a page that nobody sees', () =>
      withScene({ webgl1 }, async (scene) => {
        const native = globalThis.requestAnimationFrame;
        Object.defineProperty(document, 'hidden', { value: true, configurable: true });
        globalThis.requestAnimationFrame = () => 0;
        try {
          expect(await scene.bringVolume(large('bytes'), wanted)).to.equal(true);
        } finally {
          globalThis.requestAnimationFrame = native;
          Reflect.deleteProperty(document, 'hidden');
        }
      }));

    it('ends where it is given up, and its texture goes', () =>
      withScene({ webgl1 }, async (scene) => {
        scene.setVolume(small);
        const before = draw(scene, small);
        const held = gpuBytes().textures;
        const { pieces, stop } = watchPieces(contextOf(scene));
        expect(await scene.bringVolume(large('bytes'), () => pieces.length > 2)).to.equal(false);
        const given = pieces.length;
        await new Promise((resolve) => setTimeout(resolve, 100));
        stop();
        expect(given).to.be.above(2);
        expect(pieces.length, 'pieces after that').to.equal(given);
        expect(gpuBytes().textures).to.equal(held);
        expect(comparePictures(draw(scene, small), before).worst).to.equal(0);
      }));

    it('ends where the context is lost', () =>
      withScene({ webgl1 }, async (scene) => {
        const gl = contextOf(scene);
        const { pieces, stop } = watchPieces(gl);
        const lose = gl.getExtension('WEBGL_lose_context')!;
        const isThere = await scene.bringVolume(large('bytes'), () => {
          if (pieces.length > 2) lose.loseContext();
          return false;
        });
        stop();
        expect(isThere).to.equal(false);
        expect(scene.getRays() !== null).to.equal(false);
      }));

    it('does not take place where the context was lost before, be the volume small', () =>
      withScene({ webgl1 }, async (scene) => {
        contextOf(scene).getExtension('WEBGL_lose_context')!.loseContext();
        expect(await scene.bringVolume(small, wanted)).to.equal(false);
      }));

    it('says so where the GPU has no memory, and leaves none of it in use', () =>
      withScene({ webgl1 }, async (scene) => {
        scene.setVolume(small);
        const before = draw(scene, small);
        const held = gpuBytes().textures;
        const gl = contextOf(scene);
        Object.defineProperty(gl, 'getError', { value: () => gl.OUT_OF_MEMORY, configurable: true });
        const failure = await scene.bringVolume(large('bytes'), wanted).then(
          () => null,
          (error: unknown) => error,
        );
        Reflect.deleteProperty(gl, 'getError');
        expect(failure).to.be.instanceOf(VolumeViewError).with.property('code', 'format/too-large');
        expect(gpuBytes().textures).to.equal(held);
        expect(comparePictures(draw(scene, small), before).worst).to.equal(0);
      }));
  });
}
