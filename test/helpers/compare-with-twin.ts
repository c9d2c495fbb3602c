import { expect } from '@esm-bundle/chai';
import type { VolumeScene } from '../../src/x3d/scene.ts';
import { isEdge, listOff } from './edges.ts';
import { bothWalks, comparePictures, drawPicture, drawReference, height, raysOf, stagesOfView, width } from './picture.ts';
import type { View } from './picture.ts';

/**
 * Draw a view with both walks, and compare it with its twin. Where it hangs by a thread what a sample has, as at an edge, both
 * are right. The picture with substeps comes back.
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
