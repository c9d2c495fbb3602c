import { expect } from '@esm-bundle/chai';
import { mixChannels } from '../../../src/volume/channels.ts';
import type { Channel } from '../../../src/volume/channels.ts';
import type { Vector3 } from '../../../src/volume/matrix.ts';

const channelOf = (samples: Channel['samples'], color: Vector3, window: readonly [number, number]): Channel => ({
  number: 1,
  name: '',
  color,
  window,
  samples,
  slope: 1,
  intercept: 0,
});

describe('channels that are mixed', () => {
  const red = channelOf(Uint16Array.of(0, 100, 300, 500, 900), [1, 0, 0], [100, 500]);
  const cyan = channelOf(Float32Array.of(0, NaN, 1, 2, 2), [0, 1, 0.5], [0, 2]);
  const shares = [
    [0, 0, 0.5, 1, 1],
    [0, 0, 0.5, 1, 1],
  ];

  it('add their light and their brightness, each in its window', () => {
    const { samples, slope, colors } = mixChannels([red, cyan]);
    for (let i = 0; i < 5; i++) {
      const [a, b] = [shares[0][i], shares[1][i]];
      expect(slope * samples[i], `brightness ${i}`).to.be.closeTo(a + b, slope / 2 + 1e-12);
      const light = Array.from(colors.subarray(4 * i, 4 * i + 4), (one) => slope * one);
      for (const [c, expected] of [a, b, 0.5 * b, a + b].entries())
        expect(light[c], `${i} ${c}`).to.be.closeTo(expected, slope / 2 + 1e-12);
    }
    expect(slope).to.be.closeTo(2 / 255, 1e-15);
  });

  it('are a picture of one slice: black where there is no light, and each colour ends at full light', () => {
    const green = channelOf(Uint8Array.of(0, 50, 0, 50, 100), [0.5, 1, 0], [0, 100]);
    const { samples, slope, colors, full } = mixChannels([red, cyan, green], true);
    expect(full).to.equal(255);
    expect([...colors]).to.deep.equal([
      ...[0, 0, 0, 255],
      ...[64, 128, 0, 255],
      ...[128, 128, 64, 255],
      ...[255, 255, 128, 255],
      ...[255, 255, 128, 255],
    ]);
    expect(slope * samples[4]).to.be.closeTo(3, 1e-9);
  });

  it('give the same, whichever comes first', () => {
    const [one, other] = [mixChannels([red, cyan]), mixChannels([cyan, red])];
    expect([one.samples, one.colors]).to.deep.equal([other.samples, other.colors]);
  });

  it('use all steps where they are never bright together', () => {
    const { samples, slope } = mixChannels([red, channelOf(Uint8Array.of(0, 9, 0, 0, 0), [0, 1, 0], [0, 10])]);
    expect(slope * 255).to.equal(1);
    expect(Math.max(...samples)).to.equal(255);
  });

  it('that show nothing are dark, and no error', () => {
    const { samples, colors } = mixChannels([channelOf(new Float32Array(4).fill(NaN), [1, 1, 1], [0, 1])]);
    expect([Math.max(...samples), Math.max(...colors)]).to.deep.equal([0, 0]);
  });
});
