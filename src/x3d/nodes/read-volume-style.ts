import { VolumeViewError } from '../../core/errors.ts';
import type { StyleMaterial, VolumeStyle } from '../../optics/transfer/volume-styles.ts';
import { meantChildren } from '../../page/unclosed.ts';
import { X3dFields } from './x3d-fields.ts';

/** X3D's styles that change the appearance of a point, with the standard's defaults. Source: ISO/IEC 19775-1, 41.4 */
const readers: Readonly<Record<string, readonly [node: string, read: (fields: X3dFields) => VolumeStyle | null]>> = {
  boundaryenhancementvolumestyle: [
    'BoundaryEnhancementVolumeStyle',
    (fields) => ({
      kind: 'boundary',
      retained: fields.number('retainedOpacity', 0.2),
      boundary: fields.number('boundaryOpacity', 0.9),
      power: fields.number('opacityFactor', 2, [0, 100]),
    }),
  ],
  silhouetteenhancementvolumestyle: [
    'SilhouetteEnhancementVolumeStyle',
    (fields) => ({
      kind: 'silhouette',
      retained: fields.number('silhouetteRetainedOpacity', 1),
      boundary: fields.number('silhouetteBoundaryOpacity', 0),
      sharpness: fields.number('silhouetteSharpness', 0.5, [0, 100]),
    }),
  ],
  edgeenhancementvolumestyle: [
    'EdgeEnhancementVolumeStyle',
    (fields) => ({
      kind: 'edge',
      color: fields.color('edgeColor', [0, 0, 0]),
      threshold: fields.number('gradientThreshold', 0.4, [0, Math.PI]),
    }),
  ],
  cartoonvolumestyle: [
    'CartoonVolumeStyle',
    (fields) => ({
      kind: 'cartoon',
      parallel: fields.color('parallelColor', [0, 0, 0]),
      orthogonal: fields.color('orthogonalColor', [1, 1, 1]),
      steps: fields.whole('colorSteps', 4, [1, 64]),
    }),
  ],
  tonemappedvolumestyle: [
    'ToneMappedVolumeStyle',
    (fields) => ({
      kind: 'tone',
      cool: fields.color('coolColor', [0, 0, 1]),
      warm: fields.color('warmColor', [1, 1, 0]),
    }),
  ],
  shadedvolumestyle: ['ShadedVolumeStyle', readShaded],
};

/**
 * @returns null for a style that changes nothing; undefined for an element that is not one of these styles
 * @throws {VolumeViewError} `attribute/invalid`
 */
export function readVolumeStyle(element: Element): VolumeStyle | null | undefined {
  const found = readers[element.localName.toLowerCase()];
  if (!found) return undefined;
  const [node, read] = found;
  if (
    meantChildren(element).some(({ attributes }) =>
      /^surfacenormals$/i.test(attributes.getNamedItem('containerfield')?.value ?? ''),
    )
  ) {
    throw new VolumeViewError(
      'attribute/invalid',
      `<${node}> got surfaceNormals; expected none. Normals are taken from the volume itself: leave them out.`,
    );
  }
  return read(new X3dFields(element, node));
}

let warned = false;

/** The standard requires shadows only from browsers of its highest level. */
function warnOfShadows(): void {
  if (!warned)
    console.warn(
      '<volume-view>: shadows="true" of a ShadedVolumeStyle is left out of the picture: a volume casts no shadows here.',
    );
  warned = true;
}

function readShaded(fields: X3dFields): VolumeStyle | null {
  fields.word('phaseFunction', 'Henyey-Greenstein', ['Henyey-Greenstein', 'NONE']);
  if (fields.flag('shadows', false)) warnOfShadows();
  if (!fields.flag('lighting', false)) return null;
  const material = meantChildren(fields.element).find(({ localName }) => /^material$/i.test(localName));
  return { kind: 'shaded', material: material ? readMaterial(new X3dFields(material, 'Material')) : null };
}

function readMaterial(fields: X3dFields): StyleMaterial {
  return {
    ambient: fields.number('ambientIntensity', 0.2, [0, 1]),
    diffuse: fields.color('diffuseColor', [0.8, 0.8, 0.8]),
    specular: fields.color('specularColor', [0, 0, 0]),
    emissive: fields.color('emissiveColor', [0, 0, 0]),
    shininess: Math.max(1, 128 * fields.number('shininess', 0.2, [0, 1])),
  };
}
