// Properties and attributes of the elements: each says what the other says, at once.
import { expect } from '@esm-bundle/chai';
import { VolumeViewAttributes } from '../../../components/volume-view/volume-view-attributes.ts';
import { elements } from '../../../components/internal/elements.ts';
import type { ReflectingElement } from '../../../components/internal/reflecting-element.ts';

/** The attributes of <volume-view>, with nothing that acts on them. */
class TestView extends VolumeViewAttributes {
  changes: PropertyKey[] = [];

  override get given(): VolumeViewAttributes['given'] {
    return super.given;
  }

  protected override updated(changed: ReadonlyMap<PropertyKey, unknown>): void {
    this.changes.push(...changed.keys());
  }
}

customElements.define('test-view', TestView);
await Promise.all(Object.values(elements).map((load) => load()));

type Row = [property: string, attribute: string, value: unknown, text: string];

const viewRows: Row[] = [
  ['src', 'src', 'a.nii b.nii', 'a.nii b.nii'],
  ['mosaic', 'mosaic', [10, 12], '10x12'],
  ['slices', 'slices', 96, '96'],
  ['spacing', 'spacing', [0.8, -0.8, 1.2], '0.8 -0.8 1.2'],
  ['coordinates', 'coordinates', 'spherical', 'spherical'],
  ['elevations', 'elevations', [0.5, 1.2], '0.5 1.2'],
  ['range', 'range', [250, 500], '250 500'],
  ['azimuth', 'azimuth', [0.5, -1], '0.5 -1'],
  ['moment', 'moment', 'DBZH', 'DBZH'],
  ['colorMoment', 'color-moment', 'VRADH', 'VRADH'],
  ['beamModel', 'beam-model', 'straight', 'straight'],
  ['verticalExaggeration', 'vertical-exaggeration', 3, '3'],
  ['series', 'series', 2, '2'],
  ['maxBytes', 'max-bytes', 5e7, '50000000'],
  ['maxGpuBytes', 'max-gpu-bytes', 1e8, '100000000'],
  ['crossOrigin', 'crossorigin', 'use-credentials', 'use-credentials'],
  ['clean', 'clean', true, ''],
  ['clean', 'clean', -400, '-400'],
  ['time', 'time', 2, '2'],
  ['time', 'time', '2018-12-20T06:06:28Z', '2018-12-20T06:06:28Z'],
  ['playSpeed', 'play-speed', 0.5, '0.5'],
  ['autoplay', 'autoplay', true, ''],
  ['stack', 'stack', true, ''],
  ['transferFunction', 'transfer-function', 'ct-bone', 'ct-bone'],
  ['projection', 'projection', 'max', 'max'],
  ['shading', 'shading', 'lit', 'lit'],
  ['look', 'look', 'textbook', 'textbook'],
  ['surfaceValues', 'surface-values', '40 red 50%', '40 red 50%'],
  ['transferFunction2d', 'transfer-function-2d', 'box 0 1 2 3 red 1', 'box 0 1 2 3 red 1'],
  ['gradientOpacity', 'gradient-opacity', '0 0, 10% 1', '0 0, 10% 1'],
  ['valueWindow', 'value-window', [-150, 250], '-150 250'],
  ['referenceLength', 'reference-length', 1e-7, '1e-7'],
  ['opacityFactor', 'opacity-factor', 0, '0'],
  ['lightFactor', 'light-factor', 2, '2'],
  ['steps', 'steps', 200, '200'],
  ['steps', 'steps', 'auto', 'auto'],
  ['maxError', 'max-error', 0.5, '0.5'],
  ['detail', 'detail', 'free', 'free'],
  ['targetFps', 'target-fps', 60, '60'],
  ['region', 'region', [0, 0, 0, 1, 1, 1], '0 0 0 1 1 1'],
  ['cutout', 'cutout', [0, 0, 0, 1, 1, 1], '0 0 0 1 1 1'],
  ['rings', 'rings', true, ''],
  ['rings', 'rings', 25, '25'],
  ['cameraOrbit', 'camera-orbit', '30deg 70deg 110%', '30deg 70deg 110%'],
  ['cameraTarget', 'camera-target', [1, 2, 3], '1 2 3'],
  ['fieldOfView', 'field-of-view', '20deg', '20deg'],
  ['minCameraOrbit', 'min-camera-orbit', 'auto 0deg 50%', 'auto 0deg 50%'],
  ['maxCameraOrbit', 'max-camera-orbit', 'Infinity 90deg 400%', 'Infinity 90deg 400%'],
  ['interpolationDecay', 'interpolation-decay', 0, '0'],
  ['autoRotate', 'auto-rotate', true, ''],
  ['autoRotateDelay', 'auto-rotate-delay', 3000, '3000'],
  ['rotationPerSecond', 'rotation-per-second', '12deg', '12deg'],
  ['orientationMarker', 'orientation-marker', true, ''],
  ['interaction', 'interaction', 'none', 'none'],
  ['controls', 'controls', true, ''],
  ['controlslist', 'controlslist', 'nosave', 'nosave'],
  ['linkState', 'link-state', true, ''],
  ['pickable', 'pickable', true, ''],
  ['authoring', 'authoring', true, ''],
  ['selfCheck', 'self-check', true, ''],
  ['cursor', 'cursor', [1, 2, 3], '1 2 3'],
  ['crosshair', 'crosshair', 'none', 'none'],
  ['width', 'width', 400, '400'],
  ['width', 'width', '50%', '50%'],
  ['height', 'height', 300, '300'],
  ['alt', 'alt', '', ''],
  ['poster', 'poster', 'a.png', 'a.png'],
  ['loading', 'loading', 'eager', 'eager'],
];

const companionRows: Record<string, Row[]> = {
  'volume-label': [
    ['value', 'value', 17, '17'],
    ['name', 'name', 'Spine', 'Spine'],
    ['color', 'color', 'red', 'red'],
    ['opacity', 'opacity', 0.5, '0.5'],
    ['transferFunction', 'transfer-function', 'ct-bone', 'ct-bone'],
  ],
  'volume-label-list': [['htmlFor', 'for', 'a', 'a']],
  'volume-labels': [
    ['src', 'src', 'a.nii', 'a.nii'],
    ['table', 'table', 'a.tsv', 'a.tsv'],
    ['transferFunction', 'transfer-function', 'gray', 'gray'],
    ['only', 'only', '17 18 ghost', '17 18 ghost'],
  ],
  'volume-question': [
    ['htmlFor', 'for', 'a', 'a'],
    ['type', 'type', 'find', 'find'],
    ['position', 'position', [1, 2, 3], '1 2 3'],
    ['of', 'of', '10 49', '10 49'],
    ['latitude', 'latitude', 50.5, '50.5'],
    ['longitude', 'longitude', 4.5, '4.5'],
    ['height', 'height', 2000, '2000'],
    ['radius', 'radius', 10, '10'],
    ['answer', 'answer', 'Pons', 'Pons'],
    ['tolerance', 'tolerance', 5, '5'],
    ['unit', 'unit', 'dBZ', 'dBZ'],
    ['tries', 'tries', 2, '2'],
    ['remember', 'remember', true, ''],
  ],
  'volume-readout': [
    ['htmlFor', 'for', 'a', 'a'],
    ['coordinates', 'coordinates', 'xyz', 'xyz'],
    ['curve', 'curve', true, ''],
  ],
  'volume-workspace': [
    ['panes', 'panes', 'axial', 'axial'],
    ['companions', 'companions', 'legend', 'legend'],
  ],
  'volume-legend': [
    ['htmlFor', 'for', 'a', 'a'],
    ['label', 'label', '', ''],
    ['orientation', 'orientation', 'vertical', 'vertical'],
    ['layer', 'layer', true, ''],
  ],
  'volume-layer': [
    ['src', 'src', 'a.nii', 'a.nii'],
    ['transferFunction', 'transfer-function', 'viridis', 'viridis'],
    ['valueWindow', 'value-window', [-3, 3], '-3 3'],
    ['blend', 'blend', 'color', 'color'],
    ['opacityFactor', 'opacity-factor', 0.5, '0.5'],
    ['label', 'label', 'z', 'z'],
  ],
  'volume-surface': [
    ['src', 'src', 'a.stl', 'a.stl'],
    ['color', 'color', 'red', 'red'],
    ['opacity', 'opacity', 1, '1'],
    ['space', 'space', 'lps', 'lps'],
    ['cutWithVolume', 'cut-with-volume', true, ''],
  ],
  'volume-terrain': [
    ['src', 'src', 'a.hgt', 'a.hgt'],
    ['corner', 'corner', [46, 7], '46 7'],
    ['color', 'color', 'red', 'red'],
    ['opacity', 'opacity', 1, '1'],
    ['cutWithVolume', 'cut-with-volume', true, ''],
  ],
  'volume-measure': [
    ['htmlFor', 'for', 'a', 'a'],
    ['type', 'type', 'angle', 'angle'],
    ['label', 'label', '', ''],
    ['color', 'color', 'red', 'red'],
    [
      'points',
      'points',
      [
        [1, 2, 3],
        [4, 5, 6],
      ],
      '1 2 3, 4 5 6',
    ],
  ],
  'volume-note': [
    ['htmlFor', 'for', 'a', 'a'],
    ['position', 'position', [1, -2, 3.5], '1 -2 3.5'],
    ['of', 'of', 23, '23'],
    ['latitude', 'latitude', 48.25, '48.25'],
    ['longitude', 'longitude', -11.5, '-11.5'],
    ['height', 'height', 2000, '2000'],
    ['label', 'label', 'LAD', 'LAD'],
    ['hide', 'hide', 'never', 'never'],
    ['open', 'open', true, ''],
  ],
  'volume-step': [
    ['label', 'label', 'Heart', 'Heart'],
    ['dwell', 'dwell', 12, '12'],
    ['labels', 'labels', '17 18', '17 18'],
    ['notes', 'notes', 'lad rca', 'lad rca'],
    ['slice', 'slice', 'axial 20', 'axial 20'],
  ],
  'volume-timeline': [
    ['htmlFor', 'for', 'a', 'a'],
    ['timeZone', 'time-zone', 'Europe/Brussels', 'Europe/Brussels'],
  ],
  'volume-compare': [
    ['layout', 'layout', 'slider', 'slider'],
    ['position', 'position', 30, '30'],
  ],
  'volume-drop': [['htmlFor', 'for', 'a', 'a']],
  'volume-series': [['htmlFor', 'for', 'a', 'a']],
  'volume-tour': [
    ['htmlFor', 'for', 'a', 'a'],
    ['step', 'step', 2, '2'],
    ['duration', 'duration', 900, '900'],
    ['autoplay', 'autoplay', true, ''],
    ['dwell', 'dwell', 12, '12'],
    ['by', 'by', 'scroll', 'scroll'],
  ],
  'volume-transfer-function': [
    ['htmlFor', 'for', 'a', 'a'],
    ['mode', 'mode', 'bands', 'bands'],
    ['bands', 'bands', 12, '12'],
    ['bandEdges', 'band-edges', [0, 5, 9], '0 5 9'],
  ],
  'volume-clip': [
    ['htmlFor', 'for', 'head', 'head'],
    ['type', 'type', 'box', 'box'],
    ['normal', 'normal', [1, 0, -1], '1 0 -1'],
    ['at', 'at', -12.5, '-12.5'],
    ['box', 'box', [0, 0, 0, 1, 1, 1], '0 0 0 1 1 1'],
    ['keep', 'keep', 'outside', 'outside'],
  ],
  'volume-slice-view': [
    ['htmlFor', 'for', 'a', 'a'],
    ['src', 'src', 'a.nii', 'a.nii'],
    ['type', 'type', 'coronal', 'coronal'],
    ['normal', 'normal', [0, 1, 1], '0 1 1'],
    ['at', 'at', -12.5, '-12.5'],
    ['thickness', 'thickness', 20, '20'],
    ['projection', 'projection', 'max', 'max'],
    ['valueWindow', 'value-window', [-160, 240], '-160 240'],
    ['windowFunction', 'window-function', 'linear', 'linear'],
    ['interpolation', 'interpolation', 'nearest', 'nearest'],
    ['colors', 'colors', 'volume', 'volume'],
    ['drag', 'drag', 'window', 'window'],
    ['group', 'group', 'a', 'a'],
    ['cursor', 'cursor', [1, 2, 3], '1 2 3'],
    ['alt', 'alt', '', ''],
    ['labelOpacity', 'label-opacity', 0.4, '0.4'],
  ],
  'volume-slice': [
    ['type', 'type', 'rhi', 'rhi'],
    ['elevation', 'elevation', 0.5, '0.5'],
    ['sweep', 'sweep', 0, '0'],
    ['height', 'height', 3000, '3000'],
    ['azimuth', 'azimuth', 45, '45'],
    ['from', 'from', [0, -5], '0 -5'],
    ['to', 'to', [9, 9], '9 9'],
    ['at', 'at', 12.5, '12.5'],
    ['normal', 'normal', [0, 1, 1], '0 1 1'],
    ['valueWindow', 'value-window', [0, 80], '0 80'],
    ['windowFunction', 'window-function', 'linear', 'linear'],
    ['colors', 'colors', 'volume', 'volume'],
    ['thickness', 'thickness', 20, '20'],
    ['projection', 'projection', 'max', 'max'],
  ],
};

for (const [tag, rows] of Object.entries({ 'test-view': viewRows, ...companionRows })) {
  describe(`the properties of ${tag.replace('test', 'volume')}`, () => {
    const create = (): ReflectingElement & Record<string, unknown> => document.createElement(tag) as never;

    for (const [property, attribute, value, text] of rows) {
      it(`${property} = ${JSON.stringify(value)} is ${attribute}="${text}", and the other way round`, () => {
        const element = create();
        const absent = element[property];
        expect(absent, 'without the attribute').to.equal(
          (text === '' && value === true) || ['rings', 'clean'].includes(property) ? false : null,
        );
        element[property] = value;
        expect(element.getAttribute(attribute)).to.equal(text);
        expect(element[property]).to.deep.equal(value);
        element[property] = absent;
        expect(element.hasAttribute(attribute)).to.equal(false);
        element.setAttribute(attribute, text);
        expect(element[property]).to.deep.equal(value);
        element[property] = undefined;
        expect(element.hasAttribute(attribute)).to.equal(false);
      });
    }

    it('are all in this test, and shadow no global of inline handlers', () => {
      const { elementProperties } = create().constructor as typeof ReflectingElement;
      const ours = [...elementProperties].filter(([, { attribute }]) => typeof attribute === 'string');
      const tested = new Set(rows.map(([property]) => property));
      expect(ours.map(([name]) => name).filter((name) => !tested.has(String(name)))).to.deep.equal([]);
      // Elements of HTML have a `name` too, and <details> and <dialog> are `open`.
      const inHtml = ['name', 'open'];
      expect(
        ours.map(([name]) => String(name)).filter((name) => !inHtml.includes(name) && name in window),
      ).to.deep.equal([]);
    });
  });
}

it('the properties of all elements of the table are in this test', () => {
  expect(companionRows).to.have.all.keys(Object.keys(elements));
});

describe('a property', () => {
  it('takes the text of its attribute too, and stops where they are wanted', () => {
    const view = new TestView();
    Object.assign(view, { steps: '31', spacing: '1, 2 3', mosaic: '4x5' });
    expect([view.steps, view.spacing, view.mosaic]).to.deep.equal([31, [1, 2, 3], [4, 5]]);
    view.transferFunction = [
      { value: 0, color: [0, 0, 0], opacity: 0 },
      { value: 9, color: [1, 1, 1], opacity: 0.5 },
    ];
    expect(view.getAttribute('transfer-function'))
      .to.equal('0 #000000 0%, 9 #ffffff 50%')
      .and.to.equal(view.transferFunction);
  });

  it('is null where its attribute cannot be read, which is given as it stands', () => {
    const view = new TestView();
    Object.assign(view, { steps: 'lots', spacing: [1, 2], opacityFactor: NaN });
    expect([view.steps, view.spacing, view.opacityFactor]).to.deep.equal([null, null, null]);
    const { steps, spacing, opacityFactor, lightFactor } = view.given;
    expect([steps, spacing, opacityFactor, lightFactor]).to.deep.equal(['lots', '1 2', 'NaN', null]);
  });

  it('of a window is two numbers, or the name or number of one, as its text', () => {
    const view = new TestView();
    for (const [set, got] of [
      [
        [-150, 250],
        [-150, 250],
      ],
      ['lung', 'lung'],
      [2, '2'],
      [null, null],
    ] as const) {
      Object.assign(view, { valueWindow: set });
      expect(view.valueWindow).to.deep.equal(got);
    }
  });

  it('is an update each time that it is set, also to what cannot be read', async () => {
    const view = new TestView();
    document.body.append(view);
    await view.updateComplete;
    view.changes = [];
    for (const steps of ['lots', 'many', 'many']) {
      view.setAttribute('steps', steps);
      await view.updateComplete;
    }
    expect(view.changes, 'the same again is one too, as in HTML').to.deep.equal(['steps', 'steps', 'steps']);
    view.remove();
  });

  it('that was set before its element was defined holds', async () => {
    const early = document.createElement('test-early') as TestView;
    Object.assign(early, { steps: 12, cameraTarget: [1, 2, 3] });
    document.body.append(early);
    customElements.define('test-early', class extends TestView {});
    await early.updateComplete;
    expect([early.getAttribute('steps'), early.getAttribute('camera-target')]).to.deep.equal(['12', '1 2 3']);
    expect(Object.keys(early)).to.not.include('steps');
    early.remove();
  });
});

describe('what an editor changes', () => {
  it('is one property, which leaves what is the same as the page wrote it', () => {
    const view = new TestView();
    view.setAttribute('opacity-factor', '1.50');
    view.appearance = { ...view.appearance, transferFunction: 'hot' };
    expect([
      view.getAttribute('opacity-factor'),
      view.transferFunction,
      view.hasAttribute('light-factor'),
    ]).to.deep.equal(['1.50', 'hot', false]);
    view.appearance = { transferFunction: null, opacityFactor: 2, lightFactor: 3 };
    expect([view.hasAttribute('transfer-function'), view.opacityFactor, view.lightFactor]).to.deep.equal([false, 2, 3]);
  });
});

describe('a property of any element', () => {
  const fail = (): never => {
    throw new Error('a trap');
  };
  const traps: readonly [string, unknown][] = [
    ['null', null],
    ['undefined', undefined],
    ['NaN', NaN],
    ['a bigint', 10n],
    ['a symbol', Symbol('s')],
    ['a function', fail],
    ['no prototype', Object.create(null)],
    ['a toString that throws', { toString: fail }],
    ['a toString of an object', { toString: () => ({}) }],
    ['a proxy', new Proxy({}, { get: fail, has: fail, ownKeys: fail, getPrototypeOf: fail })],
    ['an array of a symbol', [Symbol('s')]],
    ['an array of traps', [{ toString: fail }]],
    ['a huge array', Array(2 ** 32 - 1)],
    ['stops that are none', [{ value: 1 }]],
    ['a long text', 'x'.repeat(1e5)],
    ['a document', document],
  ];
  for (const name of [
    'test-view',
    'volume-clip',
    'volume-legend',
    'volume-slice',
    'volume-slice-view',
    'volume-timeline',
    'volume-transfer-function',
  ]) {
    it(`takes whatever it is given: <${name}>`, () => {
      const element = document.createElement(name) as ReflectingElement;
      const { elementProperties } = element.constructor as typeof ReflectingElement;
      const names = [...elementProperties.keys()].filter(
        (key): key is string => typeof key === 'string' && !key.startsWith('_'),
      );
      expect(names.length).to.be.above(0);
      for (const property of [...names, ...(name === 'test-view' ? ['appearance'] : [])]) {
        for (const [what, trap] of traps) {
          expect(() => Reflect.set(element, property, trap), `${property}, ${what}`).not.to.throw();
          expect(() => Reflect.get(element, property) as unknown, `${property} after ${what}`).not.to.throw();
        }
      }
    });
  }
});
