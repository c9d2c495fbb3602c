// What of a volume an author cuts away, as read from a page, and where a person drags it.
import { expect } from '@esm-bundle/chai';
import { clipInterval, cutoutInterval } from '../../../../src/optics/rays/clip-intervals.ts';
import type { Cutout, HalfSpace } from '../../../../src/optics/rays/clip-intervals.ts';
import { readClipAttributes } from '../../../../src/viewer/cuts/clip-attributes.ts';
import { ClipModel } from '../../../../src/viewer/cuts/clip-model.ts';
import type { ClipRoom } from '../../../../src/viewer/cuts/clip-model.ts';
import { socketOf } from '../../../../src/viewer/model/view-socket.ts';
import { readClips } from '../../../../src/viewer/cuts/read-clips.ts';
import { unitToWorld } from '../../../../src/volume/grid.ts';
import { dot, invertAffine, subtract, transformDirection, transformPoint } from '../../../../src/volume/matrix.ts';
import type { Vector3 } from '../../../../src/volume/matrix.ts';
import type { Volume } from '../../../../src/volume/volume.ts';
import { isKept } from '../../../../src/volume/world-cut.ts';
import { polarScenes, radarVolume } from '../../../helpers/synthetic-radar.ts';
import { syntheticVolume } from '../../../helpers/synthetic.ts';

const volume: Volume = syntheticVolume({ dimensions: [20, 18, 16] }); // From -10 -9 -8 to 10 9 8.

interface Left {
  /** What is left of a line from one place of the world to another: from where to where, in shares of it. */
  readonly from: number;
  readonly to: number;
  readonly gap: readonly number[] | null;
  readonly message: string;
}

function cutLine(
  html: string,
  [from, to]: readonly [Vector3, Vector3],
  { of = volume, attributes = {}, clips = [] as Record<string, string>[] } = {},
): Left {
  const host = document.createElement('div');
  host.innerHTML = html;
  for (const [name, value] of Object.entries(attributes)) host.setAttribute(name, String(value));
  for (const texts of clips)
    void socketOf(host).join({
      key: 'volume-clip',
      clip: () => modelOf(texts).shape(null) ?? modelOf(texts).shape(room),
    });
  const { cuts, error } = readClips(host, of);
  const items = cuts.flatMap((cut) => cut.items) as (HalfSpace | Cutout)[];
  const toUnit = invertAffine(unitToWorld(of.grid))!;
  const ray = {
    point: transformPoint(toUnit, from),
    direction: transformDirection(toUnit, subtract(to, from)),
    lengthPerT: 1,
  };
  const stages = [
    clipInterval(items.filter((item) => item.kind === 'half-space')),
    ...items.filter((item) => item.kind === 'cutout').map(cutoutInterval),
  ];
  const left = stages.reduce((interval, stage) => stage(ray, interval), {
    entry: 0,
    exit: 1,
    behind: null,
  } as Parameters<(typeof stages)[0]>[1]);
  const round = (x: number): number => Math.round(x * 1e9) / 1e9 + 0;
  return {
    from: round(left.entry),
    to: round(left.exit),
    gap: left.gap?.map(round) ?? null,
    message: error?.message ?? '',
  };
}

const room: ClipRoom = { low: [-10, -9, -8], high: [10, 9, 8], stretch: 1 };

function modelOf(texts: Record<string, string>): ClipModel {
  const model = new ClipModel();
  model.said = readClipAttributes((name) => texts[name] ?? null);
  return model;
}

const alongX: readonly [Vector3, Vector3] = [
  [-10, 0.5, 0.5],
  [10, 0.5, 0.5],
];
const plane = (numbers: string, more = ''): string => `<clipplane plane="${numbers}" ${more}></clipplane>`;
const whole = { from: 0, to: 1, gap: null, message: '' };

describe('what cuts a volume', () => {
  it('are ClipPlanes that are on, of the length that they have: what is where a x + b y + c z + d is 0 or more is kept', () => {
    expect(cutLine(plane('1 0 0 5'), alongX)).to.deep.equal({ ...whole, from: 0.25 });
    expect(cutLine(plane('-4, 0, 0, 20'), alongX)).to.deep.equal({ ...whole, to: 0.75 });
    expect(cutLine(plane('1 0 0 5') + plane('-1 0 0 5'), alongX)).to.deep.equal({ ...whole, from: 0.25, to: 0.75 });
    for (const off of ['on="false"', 'enabled="FALSE"'])
      expect(cutLine(plane('1 0 0 5', off), alongX)).to.deep.equal(whole);
    expect(cutLine('<clipplane></clipplane>', alongX)).to.deep.equal(whole); // 0 1 0 0, and y is 0.5.
    expect(
      cutLine('<ClipPlane DEF="a" plane="1 0 0 5"></ClipPlane><clipplane USE="a"></clipplane>', alongX),
    ).to.deep.equal({ ...whole, from: 0.25 });
    expect(
      cutLine(`<group>${plane('1 0 0 5')}</group>`, alongX),
      'what is in a group cuts what is there',
    ).to.deep.equal(whole);
  });

  it('is a box that is cut out, whichever corners are given; one outside the volume, or flat, removes nothing', () => {
    for (const cutout of ['-5 -2 -2 2 3 3', '2,3,3,-5,-2,-2'])
      expect(cutLine('', alongX, { attributes: { cutout } })).to.deep.equal({ ...whole, gap: [0.25, 0.6] });
    expect(cutLine('', alongX, { attributes: { cutout: '-1e300 -1e300 -1e300 2 1e300 1e300' } })).to.deep.equal({
      ...whole,
      from: 0.6,
    });
    for (const cutout of ['50 50 50 60 60 60', '-5 1 -2 2 3 3', '-5 -2 0.5 2 3 0.5', ''])
      expect(cutLine('', alongX, { attributes: { cutout } })).to.deep.equal(whole);
    expect(
      cutLine('', alongX, { attributes: { cutout: '-50 -50 -50 50 50 50' } }).from,
      'all is cut away, and that is no error',
    ).to.be.above(1);
  });

  it('are planes and boxes that stand elsewhere in the page', () => {
    expect(cutLine('', alongX, { clips: [{ normal: '2 0 0', at: '5' }] })).to.deep.equal({ ...whole, from: 0.75 });
    expect(cutLine('', alongX, { clips: [{ normal: '1 0 0' }] }), 'the middle').to.deep.equal({ ...whole, from: 0.5 });
    expect(
      cutLine('', alongX, {
        clips: [
          { type: 'box', box: '-5 -5 -5 5 5 5' },
          { type: 'box', box: '-8 -5 -5 2 5 5' },
        ],
      }),
      'what both keep',
    ).to.deep.equal({ ...whole, from: 0.25, to: 0.6 });
    expect(cutLine('', alongX, { clips: [{ type: 'box', keep: 'outside', box: '-5 -5 -5 5 5 5' }] })).to.deep.equal({
      ...whole,
      gap: [0.25, 0.75],
    });
  });

  it('of a radar is in metres before heights are stretched, except ClipPlanes, which are in the scene as shapes are', () => {
    const radar = radarVolume(polarScenes['five sweeps'], { verticalExaggeration: 4 });
    const up: readonly [Vector3, Vector3] = [
      [100, 100, 0],
      [100, 100, 16_000],
    ];
    expect(cutLine('', up, { of: radar, attributes: { cutout: '-1e5 -1e5 1000 1e5 1e5 2000' } }).gap).to.deep.equal([
      0.25, 0.5,
    ]);
    expect(cutLine(plane('0 0 1 -4000'), up, { of: radar }).from).to.equal(0.25);
    expect(cutLine('', up, { of: radar, clips: [{ normal: '0 0 1', at: '1000' }] }).from).to.equal(0.25);
  });

  it('is the same in the world, where sides of boxes stay as far away as they are said to be', () => {
    const radar = radarVolume(polarScenes['five sweeps'], { verticalExaggeration: 4 });
    const host = document.createElement('div');
    host.innerHTML = plane('0 0 1 -4000');
    host.setAttribute('cutout', '-1e7 -1e7 1500 1e7 0 2000');
    const clips: Record<string, string>[] = [
      { normal: '1 2 0', at: '50' },
      { type: 'box', box: '-1e7 -1e7 -1e7 4e4 1e7 3000' },
    ];
    for (const texts of clips) void socketOf(host).join({ key: 'volume-clip', clip: () => modelOf(texts).shape(null) });
    const { cuts, away, error } = readClips(host, radar);
    expect([error, away.kept.length, away.removed]).to.deep.equal([
      null,
      8,
      [
        [-1e7, 1e7],
        [-1e7, 0],
        [6000, 8000],
      ],
    ]);
    const items = cuts.flatMap((cut) => cut.items) as (HalfSpace | Cutout)[];
    const toUnit = invertAffine(unitToWorld(radar.grid))!;
    let kept = 0;
    for (let i = 0; i < 400; i++) {
      const place: Vector3 = [5e4 * Math.sin(i), 5e4 * Math.sin(1.7 * i), 7000 + 6999 * Math.sin(2.3 * i)];
      const point = transformPoint(toUnit, place);
      const isShown = items.every((item) =>
        item.kind === 'half-space'
          ? dot(item.normal, point) >= item.offset
          : !transformPoint(item.unitToBox, point).every((x) => x > 0 && x < 1),
      );
      expect(isKept(away, place), String(place)).to.equal(isShown);
      kept += Number(isShown);
    }
    expect(kept).to.be.within(40, 360);
    for (const [place, isThere] of [
      [[-9e6, 9e6, 7000], true],
      [[-9e6, 9e7, 7000], false],
      [[-9e6, -9e6, 7000], false],
      [[-9e6, 9e6, 3999], false],
    ] as const)
      expect(isKept(away, place), String(place)).to.equal(isThere);
  });

  it('can be six planes and one box; more are refused, and those stay', () => {
    const six = plane('1 0 0 5') + plane('0 1 0 50').repeat(5);
    expect(cutLine(six, alongX)).to.deep.equal({ ...whole, from: 0.25 });
    const seven = cutLine(`${six}${plane('1 0 0 0')}`, alongX);
    expect(seven.message).to.contain('got 7 planes').and.to.contain('at most 6');
    expect(seven.from).to.equal(0.25);
    expect(cutLine(six, alongX, { clips: [{ normal: '1 0 0' }] }).message).to.contain('got 7 planes');
    const boxes = cutLine('', alongX, {
      attributes: { cutout: '-5 -2 -2 2 3 3' },
      clips: [{ type: 'box', keep: 'outside', box: '3 -5 -5 5 5 5' }],
    });
    expect(boxes.message).to.contain('got 2 boxes');
    expect(boxes.gap).to.deep.equal([0.25, 0.6]);
  });

  it('is left out where it can not be read, and the first error is reported', () => {
    for (const text of ['0 0 0 1', 'a b c d', '1 0 0', '1 0 0 NaN', '1e400 0 0 1', '1e-300 0 0 1', '']) {
      const { message, ...left } = cutLine(plane(text) + plane('1 0 0 5'), alongX);
      expect(message, text).to.contain('plane of a ClipPlane');
      expect(left.from, text).to.equal(0.25);
    }
    for (const cutout of ['1 2 3', 'NaN 0 0 1 1 1', '0 0 0 1 1 x'])
      expect(cutLine('', alongX, { attributes: { cutout } }).message, cutout).to.contain('cutout got');
    for (const [texts, said] of [
      [{ type: 'ball' }, 'plane or box'],
      [{ normal: '0 0 0' }, 'may not be 0 0 0'],
      [{ at: 'x' }, 'along the normal'],
      [{ at: '1e300' }, 'along the normal'],
      [{ type: 'box', box: '1 2' }, '6 numbers'],
      [{ type: 'box', keep: 'both' }, 'inside or outside'],
    ] as const)
      expect(() => modelOf(texts), JSON.stringify(texts)).to.throw(said);
  });
});

describe('a plane or a box that is dragged', () => {
  it('is where it is dragged to, within the volume, until its attributes are others', () => {
    const model = modelOf({ normal: '0 0 2', at: '3' });
    expect(model.grips(room)).to.deep.equal([{ at: [0, 0, 3], along: [0, 0, 1], side: null }]);
    model.move(0, [7, 1, -2], room);
    expect(model.shape(room)).to.deep.include({ at: -2 });
    model.move(0, [7, 1, 200], room);
    expect(model.shape(room)).to.deep.include({ at: 8 });
    model.said = readClipAttributes((name) => ({ normal: '0 0 2', at: '3' })[name] ?? null);
    expect(model.shape(room)).to.deep.include({ at: 3 });
  });

  it('of a box has six sides, none of which goes past the one across, and a middle that moves all of it', () => {
    const model = modelOf({ type: 'box', box: '-4 -4 -4 4 2 4' });
    const grips = model.grips(room);
    expect(grips.map(({ at }) => at)).to.deep.equal([
      [0, -1, 0],
      [-4, -1, 0],
      [4, -1, 0],
      [0, -4, 0],
      [0, 2, 0],
      [0, -1, -4],
      [0, -1, 4],
    ]);
    model.move(2, [9, 5, 5], room);
    expect(model.shape(room)).to.deep.include({ box: [-4, -4, -4, 9, 2, 4] });
    model.move(3, [0, 7, 0], room);
    expect(model.shape(room)).to.deep.include({ box: [-4, 2, -4, 9, 2, 4] });
    model.move(0, [2.5, 5, -9], room);
    expect(model.shape(room)).to.deep.include({ box: [-4, 5, -12, 9, 5, -4] });
    expect(modelOf({ type: 'box' }).shape(room)).to.deep.include({ box: [-10, -9, -8, 10, 9, 8] });
    expect(modelOf({ type: 'box', keep: 'outside' }).shape(room)).to.deep.include({ box: [0, 0, 0, 10, 9, 8] });
  });

  it('that lies outside the volume is taken hold of at the end that is next to it, and brought back from there', () => {
    const model = modelOf({ at: '1e6', normal: '0 3 4' });
    expect(model.shape(room), 'it stays where it is').to.deep.include({ at: 1e6 });
    const [{ at, along }] = model.grips(room);
    // The farthest corner is at 0.6 * 9 + 0.8 * 8 = 11.8 along the normal.
    [0, 0.6 * 11.8, 0.8 * 11.8].forEach((x, axis) => expect(at[axis]).to.be.closeTo(x, 1e-12));
    model.move(0, at.map((x, axis) => x - 2 * along![axis]) as unknown as Vector3, room);
    expect((model.shape(room) as { at: number }).at).to.be.closeTo(9.8, 1e-12);
    const box = modelOf({ type: 'box', box: '40 40 40 50 60 50' });
    expect(box.grips(room)[0].at).to.deep.equal([10, 9, 8]);
    box.move(0, [9, 9, 8], room);
    expect(box.shape(room)).to.deep.include({ box: [4, -1, 3, 14, 19, 13] });
  });

  it('moves as it is seen where heights are exaggerated', () => {
    const model = modelOf({ normal: '0 1 1', at: '0' });
    const high: ClipRoom = { ...room, stretch: 5 };
    const [{ at, along }] = model.grips(high);
    model.move(0, [at[0] + 2 * along![0], at[1] + 2 * along![1], at[2] + 2 * along![2]], high);
    expect((model.shape(high) as { at: number }).at).to.be.closeTo(2, 1e-12);
  });
});
