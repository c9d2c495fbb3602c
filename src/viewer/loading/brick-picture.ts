import type { Matrix4 } from '../../volume/matrix.ts';
import type { WorldCut } from '../../volume/world-cut.ts';
import type { PlaneSlice } from '../../optics/attachments/plane-slices.ts';
import { pictureSize } from '../model/picture-size.ts';
import type { View } from '../model/scene.ts';
import type { SocketView, SocketViewer } from '../model/view-socket.ts';
import type { VolumeOptics } from '../model/volume-info.ts';

/** A picture, as far as bricks depend on it. */
export interface BrickPicture {
  readonly view: View;
  readonly optics: VolumeOptics;
  /** Of the picture at rest, across and down; undefined: what is finer than a pixel counts, too. */
  readonly pixels?: readonly [number, number];
  /** What is cut away; undefined for nothing. */
  readonly away?: WorldCut;
  /** Planes on which the values are painted. */
  readonly planes?: readonly PlaneSlice[];
}

/** A picture that can be compared with others. */
export interface KeyedPicture extends BrickPicture {
  /** Another one is another picture. */
  readonly key: string;
}

/** The picture that a view shows of its volume. */
export function describePicture(
  { host, settings }: Pick<SocketView, 'host' | 'settings'>,
  { view, projection }: View,
  { optics, cuts }: { readonly optics: VolumeOptics; readonly cuts: SocketViewer['shown']['cuts'] },
): KeyedPicture {
  const { width, height } = pictureSize(host, Infinity);
  const { away } = cuts;
  const planes = cuts.cuts.flatMap(({ items }) => items).filter(isPlane);
  const key = JSON.stringify([view, optics, away, planes, width, height, settings.quality.value?.maxError]);
  return { key, view: { view, projection }, optics, away, planes, pixels: [width, height] };
}

const isPlane = (item: unknown): item is PlaneSlice => (item as Partial<PlaneSlice>).kind === 'plane';

/** How far numbers of a projection may be apart, as a share of them, so that no other bricks are asked for. */
const nearly = 0.03;

/** Whether both need the same bricks. A moving picture has fewer pixels than one at rest, and so not quite the same shape. */
export function isSamePicture(one: KeyedPicture, other: KeyedPicture): boolean {
  return one.key === other.key && isSameShape(one.view.projection, other.view.projection);
}

function isSameShape(one: Matrix4, other: Matrix4): boolean {
  return one.every((x, i) => Math.abs(x - other[i]) <= nearly * Math.abs(other[i]));
}
