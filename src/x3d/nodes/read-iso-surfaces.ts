import type { IsoSurface, SurfaceStyle } from '../../optics/rays/ray-style.ts';
import { maxSurfaces } from '../../optics/transfer/surface-limits.ts';
import { evaluate } from '../../optics/transfer/transfer-function.ts';
import type { Color, TransferFunction } from '../../optics/transfer/transfer-function.ts';
import { meantChildren } from '../../page/unclosed.ts';
import { X3dFields } from './x3d-fields.ts';

/** No data have larger values. */
const farthest = 1e30;

/** The volume that has the surfaces. */
interface Shown {
  readonly transferFunction: TransferFunction;
  /** Repeated surfaces lie between these values. */
  readonly window: readonly [number, number];
}

/**
 * X3D's IsoSurfaceVolumeData as surfaces. The colour is that of its style's material, else that of the transfer
 * function.
 * @param styles - shaded ones, or opacity maps, inside it, in order; the last one is used for all further surfaces
 * @param unit - data units that are 1 in the fields: X3D's atlases hold shares
 * @throws {VolumeViewError} `attribute/invalid`
 */
export function readIsoSurfaces(
  node: Element,
  styles: readonly Element[],
  { transferFunction, window }: Shown,
  unit: number,
): SurfaceStyle {
  const fields = new X3dFields(node, 'IsoSurfaceVolumeData');
  const values = listValues(fields, window.map((x) => x / unit) as unknown as readonly [number, number]).map(
    (value) => value * unit,
  );
  const looks = styles.map(readAppearance);
  const surfaces = values.map((value, i): IsoSurface => {
    const appearance = looks[Math.min(i, looks.length - 1)] ?? null;
    return { value, color: appearance?.color ?? colorAt(transferFunction, value), opacity: appearance?.opacity ?? 1 };
  });
  surfaces.sort((a, b) => a.value - b.value);
  return { surfaces, clear: true, ...(looks.some((appearance) => appearance?.isPlain) && { plain: true }) };
}

function listValues(fields: X3dFields, [low, high]: readonly [number, number]): number[] {
  const values = fields.numbers('surfaceValues');
  const step = Math.abs(fields.number('contourStepSize', 0, [-farthest, farthest]));
  fields.number('surfaceTolerance', 0);
  if (values.length === 0 || !values.every((value) => Math.abs(value) < farthest))
    throw fields.error('surfaceValues', 'one value or more, like "300"');
  const [first] = values;
  const reach = (to: number): number => (step > 0 && values.length === 1 ? Math.max(0, Math.floor(to / step)) : 0);
  const [below, above] = [reach(first - low), reach(high - first)];
  if (values.length + below + above > maxSurfaces) {
    throw fields.error(
      step > 0 ? 'contourStepSize' : 'surfaceValues',
      `at most ${maxSurfaces} surfaces in the value-window`,
    );
  }
  return [
    ...values,
    ...Array.from({ length: below }, (_, i) => first - (i + 1) * step),
    ...Array.from({ length: above }, (_, i) => first + (i + 1) * step),
  ];
}

/** The appearance that a style gives its surface; null if it changes nothing. */
function readAppearance(
  style: Element,
): { readonly color: Color | null; readonly opacity: number; readonly isPlain: boolean } | null {
  if (!/^shaded/i.test(style.localName)) return null;
  const fields = new X3dFields(style, 'ShadedVolumeStyle');
  const element = meantChildren(style).find(({ localName }) => /^material$/i.test(localName));
  const material = element && new X3dFields(element, 'Material');
  return {
    color: material ? material.color('diffuseColor', [0.8, 0.8, 0.8]) : null,
    opacity: material ? 1 - material.number('transparency', 0, [0, 1]) : 1,
    isPlain: fields.text('lighting') !== '' && !fields.flag('lighting', false),
  };
}

function colorAt(transferFunction: TransferFunction, value: number): Color {
  const [red, green, blue, opacity] = evaluate(transferFunction, value);
  return opacity > 0 ? [red / opacity, green / opacity, blue / opacity] : [1, 1, 1];
}
