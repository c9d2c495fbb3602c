import { expect } from '@esm-bundle/chai';
import type { VolumeScene } from '../../src/x3d/scene.ts';
import { isEdge, listOff } from './edges.ts';
import {
  bothWalks,
  comparePictures,
  drawPicture,
  drawReference,
  height,
  raysOf,
  stagesOfView,
  width,
} from './picture.ts';
import type { View } from './picture.ts';

/**
 * Draw a view with both walks, and compare it with its twin. Where rounding decides what a sample has, as at an edge, both results
 * are right. Returns the picture with substeps.
 */
export function compareWithTwin(scene: VolumeScene, view: View, name: string): Uint8ClampedArray {
  const [, got] = bothWalks(view).map((walked) => compareWalk(scene, walked, name));
  return got;
}

function compareWalk(scene: VolumeScene, view: View, name: string): Uint8ClampedArray {
  const got = drawPicture(scene, view);
  const rays = raysOf(view);
  const stages = stagesOfView(view);
  const expected = drawReference(view);
  const edges = new Set([...listOff(got, expected)].filter((pixel) => isEdge(stages, rays, pixel)));
  const { worst, rmse } = comparePictures(got, expected, (pixel) => edges.has(pixel));
  console.log(`${name}: worst ${worst.toFixed(2)} rmse ${rmse.toFixed(2)}, ${edges.size} pixels left out`);
  expect(worst, name).to.be.at.most(2);
  expect(edges.size, name).to.be.below(0.02 * width * height);
  return got;
}

/** A view and its picture in float64, 0..255. */
export interface Expectation {
  readonly view: View;
  readonly expected: Float64Array;
}

/** A view with each walk, and its picture in float64. */
export function expectWalks(view: View): Expectation[] {
  return bothWalks(view).map((walked) => ({ view: walked, expected: drawReference(walked) }));
}

/**
 * Draw a view, and compare every pixel with the expected one. Rounding to 8 bits alone gives an error of 0.5, and of 0.29 RMS.
 * @param minShown - the minimum of the strongest channel, so that the picture shows something
 */
export function drawAsExpected(
  scene: VolumeScene,
  { view, expected }: Expectation,
  { name, minShown }: { name: string; minShown: number },
): void {
  const { worst, rmse } = comparePictures(drawPicture(scene, view), expected);
  const strongest = Math.max(...expected);
  console.log(`${name}: worst ${worst.toFixed(2)} rmse ${rmse.toFixed(2)} of ${strongest.toFixed(0)}`);
  expect(strongest, 'the picture shows something').to.be.above(minShown);
  expect(worst, 'worst pixel').to.be.at.most(2);
  expect(rmse, 'RMSE').to.be.at.most(0.5);
}
