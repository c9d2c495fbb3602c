import { planesOf } from '../../volume/channels.ts';
import type { ChannelColors } from '../../volume/channels.ts';
import type { Vector3 } from '../../volume/matrix.ts';
import { interpolate } from '../rays/interpolate.ts';
import type { SecondFieldStage, ShadeStage } from '../rays/ray-stages.ts';
import type { Premultiplied } from '../transfer/transfer-function.ts';

/**
 * Adds the light of a volume's channels to each sample: red, green, blue and brightness, 0..255.
 * Twin: shaders/chunks/field/channels.glsl
 */
export function channelField(channels: ChannelColors, dimensions: Vector3): SecondFieldStage {
  const planes = planesOf(channels);
  return (place, known) => {
    known.channels = planes.map((plane) => interpolate(plane, dimensions, place));
    return known;
  };
}

/**
 * Gives a segment the colour of its channels. Light adds: a place emits the sum of their lights for its brightness, so the
 * colour of a segment is the sum of the lights of both ends over the sum of their brightnesses. It multiplies that of the transfer function, which is white by default; the
 * opacity stays. Where there is no light, nothing is changed.
 * Twin: shaders/chunks/shade/channel-colors.glsl
 */
export const channelShade: ShadeStage = ({ front, back }, seen) => {
  const [first, last] = [front, back].map(({ channels }) => channels as Premultiplied);
  const brightness = first[3] + last[3];
  if (!(brightness > 0)) return seen;
  const of = (c: number): number => seen[c] * Math.min(1, (first[c] + last[c]) / brightness);
  return [of(0), of(1), of(2), seen[3]];
};
