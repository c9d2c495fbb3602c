import { expect } from '@esm-bundle/chai';
import { VolumeViewError } from '../../../../src/core/errors.ts';
import { ErrorState } from '../../../../src/viewer/model/error-state.ts';
import type { Aspect } from '../../../../src/viewer/model/error-state.ts';
import { isSameReading, readSettings } from '../../../../src/viewer/model/settings.ts';
import { readSource } from '../../../../src/viewer/loading/read-source.ts';
import { noAttributes } from '../../../helpers/view-settings.ts';
import type { GivenAttributes, Reading, Settings } from '../../../../src/viewer/model/settings.ts';

const read = (given: Partial<GivenAttributes>): Settings => readSettings({ ...noAttributes, ...given });

type Part = { [K in keyof Settings]: Settings[K] extends Reading<unknown> ? K : never }[keyof Settings];

/** A part of the settings; what is read of a source only when it is loaded, too. */
function readPart(part: Part | 'source', given: Partial<GivenAttributes>): Reading<unknown> {
  const settings = read(given);
  if (part !== 'source') return settings[part];
  try {
    return { value: readSource(settings.source!) };
  } catch (error) {
    return { error: error as Error };
  }
}

const degrees = Math.PI / 180;

/** An attribute, where it is read, what it says, and texts that it can't say. */
const cases: [
  name: keyof GivenAttributes,
  part: Part | 'source',
  good: [text: string, value: object | number | string | null][],
  bad: string[],
][] = [
  ['mosaic', 'source', [['10x8', { mosaic: { columns: 10, rows: 8 } }]], ['10', '0x4', 'tall']],
  ['slices', 'source', [['96', { slices: 96 }]], ['0', '1.5', '-3']],
  [
    'spacing',
    'source',
    [
      ['1 1 -2.5', { spacing: [1, 1, -2.5] }],
      ['0.8,0.8,3', { spacing: [0.8, 0.8, 3] }],
    ],
    ['1 1', '1 0 1', 'wide'],
  ],
  [
    'coordinates',
    'source',
    [
      ['Spherical', { spherical: true }],
      ['cartesian', { spherical: false }],
    ],
    ['polar'],
  ],
  [
    'elevations',
    'source',
    [
      ['0.5 1.2', { elevations: [0.5, 1.2] }],
      ['-1,90', { elevations: [-1, 90] }],
    ],
    ['', '91', 'low'],
  ],
  ['range', 'source', [['250 500', { range: [250, 500] }]], ['250', '250 0']],
  ['azimuth', 'source', [['0.5 1', { azimuth: [0.5, 1] }]], ['1 2 3', '0 0']],
  [
    'moment',
    'source',
    [
      [' VRADH ', { moment: 'VRADH' }],
      ['', {}],
    ],
    [],
  ],
  ['beamModel', 'source', [['straight', { beamModel: 'straight' }]], ['bent']],
  ['verticalExaggeration', 'source', [['5', { verticalExaggeration: 5 }]], ['0', '-1', 'much']],
  [
    'clean',
    'source',
    [
      ['', { clean: 'auto' }],
      ['150', { clean: 150 }],
      ['-4e2', { clean: -400 }],
      [' None', {}],
    ],
    ['yes', '1 2', '1e400'],
  ],
  [
    'time',
    'time',
    [
      ['3', { index: 3 }],
      ['', { index: 0 }],
      ['2018-12-20T06:06:28Z', { time: Date.UTC(2018, 11, 20, 6, 6, 28) }],
    ],
    ['noon', '-1', '2018-12-20', '1.5'],
  ],
  [
    'playSpeed',
    'playSpeed',
    [
      ['4', 4],
      ['0.5', 0.5],
    ],
    ['0', 'fast', '-2'],
  ],
  [
    'valueWindow',
    'look',
    [
      ['-150 250', { window: [-150, 250] }],
      ['lung', { window: 'lung' }],
      ['2', { window: '2' }],
    ],
    ['250 -150', '-1', '5 5', '1 2 3', '1 lung', ''],
  ],
  ['referenceLength', 'look', [['2.5', { referenceLength: 2.5 }]], ['0', 'long']],
  ['opacityFactor', 'look', [['0', { opacityFactor: 0 }]], ['-1', 'dense']],
  [
    'projection',
    'look',
    [
      ['max', { projection: 'max' }],
      [' Average', { projection: 'average' }],
      ['', { projection: null }],
    ],
    ['mip', '1'],
  ],
  [
    'look',
    'look',
    [
      ['textbook', { named: 'textbook' }],
      ['wax', { named: 'wax' }],
      [' ', { named: null }],
    ],
    [],
  ],
  [
    'shading',
    'look',
    [
      ['lit', { shading: 'lit' }],
      ['Ambient-Occlusion', { shading: 'ambient-occlusion' }],
      [' Unlit ', { shading: 'unlit' }],
      ['', { shading: null }],
    ],
    ['yes', '1'],
  ],
  ['lightFactor', 'look', [['2', { lightFactor: 2 }]], ['-0.1', '1e400']],
  [
    'steps',
    'quality',
    [
      ['200', { steps: 200 }],
      ['Auto', { steps: 'auto' }],
      ['', { steps: 'auto' }],
    ],
    ['0', 'many', '1e9', 'NaN'],
  ],
  ['maxError', 'quality', [['0.5', { maxError: 0.5 }]], ['0', 'none']],
  [
    'detail',
    'quality',
    [
      ['free', { isFree: true }],
      ['Keep', { isFree: false }],
      ['', { isFree: false }],
    ],
    ['some', '1'],
  ],
  ['targetFps', 'quality', [['60', { targetFps: 60 }]], ['0', 'smooth']],
  [
    'region',
    'region',
    [
      ['-1 -2 -3 4 5 6', [-1, -2, -3, 4, 5, 6]],
      [' ', null],
    ],
    ['1 2 3', 'left'],
  ],
  [
    'rings',
    'rings',
    [
      ['', 'auto'],
      ['50', 50],
    ],
    ['0', 'far'],
  ],
  [
    'cameraOrbit',
    'camera',
    [
      ['30deg 1rad 110%', { theta: 30 * degrees, phi: 1, radius: { fraction: 1.1 } }],
      ['auto 90deg 80', { phi: 90 * degrees, radius: { world: 80 } }],
      ['', {}],
    ],
    ['30deg', '30grad 1rad 3', '0deg 0deg -1'],
  ],
  [
    'cameraTarget',
    'camera',
    [
      ['1 2 3', { target: [1, 2, 3] }],
      ['auto auto auto', {}],
    ],
    ['1 2', 'here'],
  ],
  [
    'minCameraOrbit',
    'limits',
    [
      ['-90deg 30deg 50%', { min: { theta: -90 * degrees, phi: 30 * degrees, radius: { fraction: 0.5 } } }],
      ['-Infinity auto 80', { min: { radius: { world: 80 } } }],
      ['', { min: {} }],
    ],
    ['auto', '1 2 -3', 'Infinity 1 near'],
  ],
  [
    'maxCameraOrbit',
    'limits',
    [
      ['Infinity 120deg Infinity', { max: { phi: 120 * degrees, radius: { world: 1e12 } } }],
      ['auto auto auto', { max: {} }],
    ],
    ['90deg 90deg', 'auto auto -Infinity'],
  ],
  [
    'interpolationDecay',
    'limits',
    [
      ['0', { decay: 0 }],
      ['250', { decay: 250 }],
    ],
    ['-1', 'slow'],
  ],
  [
    'fieldOfView',
    'camera',
    [
      ['45deg', { fieldOfView: 45 * degrees }],
      ['auto', {}],
    ],
    ['0deg', '180deg', 'wide'],
  ],
];

describe('settings', () => {
  it('of nothing are the defaults, and no error', () => {
    expect(JSON.parse(JSON.stringify(read({})))).to.deep.equal({
      src: null,
      stack: false,
      source: null,
      time: { value: { index: 0 } },
      autoplay: false,
      playSpeed: { value: 2 },
      look: {
        value: {
          named: null,
          transferFunction: null,
          window: null,
          referenceLength: null,
          opacityFactor: null,
          lightFactor: 1,
          projection: null,
          shading: null,
          surfaces: null,
          gradientOpacity: null,
          transferFunction2d: null,
        },
      },
      camera: { value: {} },
      limits: { value: { min: {}, max: {}, decay: 120 } },
      quality: { value: { steps: 'auto', maxError: 1, isFree: false, targetFps: 30 } },
      region: { value: null },
      rings: { value: null },
      controls: true,
      eager: false,
    });
  });

  for (const [name, part, good, bad] of cases) {
    it(`read ${name} and say what is wrong with it`, () => {
      for (const [given, expected] of good) {
        const { value } = readPart(part, { [name]: given });
        const known = JSON.parse(JSON.stringify(value)) as object;
        if (expected !== null && typeof expected === 'object' && !Array.isArray(expected))
          expect(known, given).to.deep.include(JSON.parse(JSON.stringify(expected)));
        else expect(known, given).to.deep.equal(expected);
      }
      for (const given of bad) {
        const { error } = readPart(part, { [name]: given });
        expect(error, given).to.be.instanceOf(VolumeViewError);
        expect((error as VolumeViewError).code).to.equal('attribute/invalid');
        const attribute = name.replace(/[A-Z]/g, (letter) => `-${letter.toLowerCase()}`);
        expect((error as VolumeViewError).message).to.match(new RegExp(`^${attribute} got "`));
      }
    });
  }

  it('know the words that switch something, whatever their case', () => {
    expect([null, 'auto', 'NONE '].map((interaction) => read({ interaction }).controls)).to.deep.equal([
      true,
      true,
      false,
    ]);
    expect([null, ''].map((text) => [read({ autoplay: text }).autoplay, read({ stack: text }).stack])).to.deep.equal([
      [false, false],
      [true, true],
    ]);
    expect([null, 'lazy', ' Eager'].map((loading) => read({ loading }).eager)).to.deep.equal([false, false, true]);
  });

  it('say that a limit from above is below one from below', () => {
    const pairs: readonly (readonly [min: string, max: string, isWrong: boolean])[] = [
      ['auto auto 50%', 'auto auto 200%', false],
      ['auto auto 300', 'auto auto 200%', false],
      ['-1rad 1rad 2', '-1rad 1rad 2', false],
      ['10deg auto auto', '5deg auto auto', true],
      ['auto 90deg auto', 'auto 80deg auto', true],
      ['auto auto 50%', 'auto auto 40%', true],
      ['auto auto 9', 'auto auto 8', true],
    ];
    for (const [minCameraOrbit, maxCameraOrbit, isWrong] of pairs) {
      expect(
        read({ minCameraOrbit, maxCameraOrbit }).limits.error?.message ?? '',
        `${minCameraOrbit}, ${maxCameraOrbit}`,
      ).to.match(isWrong ? /^max-camera-orbit got .* expected no part below that of min-camera-orbit/ : /^$/);
    }
  });

  it('are read apart: what is wrong with one attribute leaves the others alone', () => {
    const settings = read({ steps: 'many', spacing: 'wide', cameraTarget: '1 2 3', playSpeed: '5' });
    expect([settings.quality.error, settings.camera.error].map(Boolean)).to.deep.equal([true, false]);
    expect(settings.source).to.include({ spacing: 'wide', mosaic: null });
    expect([settings.camera.value!.target, settings.playSpeed.value, settings.region.value]).to.deep.equal([
      [1, 2, 3],
      5,
      null,
    ]);
  });

  it('are the same where they say the same, in whatever spelling, and not where another text is wrong', () => {
    const [a, b, c] = [read({ steps: '60' }), read({ steps: ' 60.0' }), read({ steps: '61' })].map(
      ({ quality }) => quality,
    );
    expect([isSameReading(a, b), isSameReading(a, c)]).to.deep.equal([true, false]);
    const [many, few, again] = ['many', 'few', 'many'].map((steps) => read({ steps }).quality);
    expect([isSameReading(many, few), isSameReading(many, again), isSameReading(many, a)]).to.deep.equal([
      false,
      true,
      false,
    ]);
  });
});

describe('the board of errors', () => {
  function openErrorState(): { errorState: ErrorState; reported: [Aspect, string][]; shown: (string | null)[] } {
    const reported: [Aspect, string][] = [];
    const shown: (string | null)[] = [];
    const errorState: ErrorState = new ErrorState({
      file: 'head.nii.gz',
      changed: () => shown.push(errorState.first?.code ?? null),
      failed: (aspect, { code }) => reported.push([aspect, code]),
    });
    return { errorState, reported, shown };
  }
  const wrong = (): never => {
    throw new VolumeViewError('attribute/invalid', 'steps got "x"');
  };

  it('shows the first of several, reports each, and is clear when all are mended', () => {
    const { errorState, reported, shown } = openErrorState();
    errorState.attempt('steps', wrong);
    errorState.report('source', new VolumeViewError('source/not-found', 'no'));
    errorState.clear('source');
    errorState.attempt('steps', () => {});
    expect(reported).to.deep.equal([
      ['steps', 'attribute/invalid'],
      ['source', 'source/not-found'],
    ]);
    expect(shown).to.deep.equal(['attribute/invalid', 'source/not-found', 'attribute/invalid', null]);
  });

  it('calls an exception that nobody expects internal, with the attributes and the file', () => {
    const { errorState, reported } = openErrorState();
    const mistake = new TypeError('x is undefined');
    errorState.attempt('optics', () => {
      throw mistake;
    });
    expect(reported).to.deep.equal([['optics', 'internal']]);
    expect(errorState.first!.message).to.match(/transfer-function.*window.*head\.nii\.gz.*x is undefined/);
    expect(errorState.first!.cause).to.equal(mistake);
    errorState.report('scene', mistake);
    errorState.clear('optics');
    expect(errorState.first!.message).to.match(/picture.*head\.nii\.gz/);
  });

  it('uses what could be read, and reports what could not', () => {
    const { errorState, reported } = openErrorState();
    const used: unknown[] = [];
    errorState.take('steps', read({ steps: 'many' }).quality, (quality) => used.push(quality));
    errorState.take('play', read({ playSpeed: '3' }).playSpeed, (speed) => used.push(speed));
    expect(used).to.deep.equal([3]);
    expect(reported).to.deep.equal([['steps', 'attribute/invalid']]);
  });

  it('says nothing of work that was given up', async () => {
    const { errorState, reported } = openErrorState();
    const controller = new AbortController();
    const given = errorState.run('source', controller.signal, async () => {
      await Promise.resolve();
      wrong();
    });
    controller.abort();
    expect(await given).to.equal(false);
    expect(await errorState.run('source', null, async () => wrong())).to.equal(false);
    expect(await errorState.run('source', null, async () => {})).to.equal(true);
    expect([reported.length, errorState.first]).to.deep.equal([1, null]);
  });
});
