import { VolumeViewError } from '../../core/errors.ts';
import { resolveTransferFunction } from '../../optics/transfer/resolve-transfer-function.ts';
import type { TransferFunction } from '../../optics/transfer/transfer-function.ts';
import { dragKinds } from '../../panes/pane-input.ts';
import type { DragKind } from '../../panes/pane-input.ts';
import type { SliceAppearance } from '../../panes/slice-pane.ts';
import { suitingWindow, suitsColors } from '../../panes/suiting-window.ts';
import type { Vector3 } from '../../volume/matrix.ts';
import { isPolar } from '../../volume/volume.ts';
import type { Volume } from '../../volume/volume.ts';
import { parseFactor } from '../model/parse-attributes.ts';
import type { WindowSetting } from '../model/parse-attributes.ts';
import { findWindow } from '../appearance/find-window.ts';
import { suggestedOf } from '../appearance/resolve-appearance.ts';
import { parsePlace, SliceReader } from '../cuts/slice-attributes.ts';
import type { PlaneAttributes } from '../cuts/slice-attributes.ts';
import type { VolumeOptics } from '../model/volume-info.ts';

/** The grey values stay visible through labels, and people can still distinguish the colours. */
const usualLabelOpacity = 0.5;

/** What the attributes of a pane say, independent of the volume. The volume determines what is null. */
export interface SliceAttributes extends PlaneAttributes, Pick<SliceAppearance, 'isNearest'> {
  readonly drag: DragKind;
  readonly cursor: Vector3 | null;
  /** Opacity of labels over the grey values, 0..1. */
  readonly labelOpacity: number;
}

/** @param text - returns the text of an attribute, null where it is absent @throws {VolumeViewError} `attribute/invalid` */
export function readSliceAttributes(text: (name: string) => string | null): SliceAttributes {
  const reader = new SliceReader(text);
  return {
    ...reader.plane(),
    isNearest: reader.word('interpolation', ['linear', 'nearest']) === 'nearest',
    drag: reader.word('drag', dragKinds) ?? 'cursor',
    cursor: reader.read('cursor', parsePlace),
    labelOpacity: Math.min(1, reader.read('label-opacity', parseFactor) ?? usualLabelOpacity),
  };
}

/** The view whose colours and window a pane may use. */
export interface SharedAppearance {
  readonly optics: VolumeOptics | null;
  /** The window that the page gives the <volume-view>. */
  readonly window: WindowSetting | null;
}

/**
 * The appearance of a volume's slices: from the pane, else from its <volume-view>, else what suits the values.
 * @param own - colours of a volume that is itself labels
 * @throws {VolumeViewError}
 */
export async function resolveSliceAppearance(
  { window, colors, ...attributes }: SliceAttributes,
  volume: Volume,
  shared: SharedAppearance | null,
  own?: TransferFunction | null,
): Promise<SliceAppearance> {
  const isColored = (colors ?? (suitsColors(volume) ? 'volume' : 'gray')) === 'volume';
  return {
    ...attributes,
    window: findWindow(window ?? shared?.window ?? null, volume) ?? suitingWindow(volume),
    colors: isColored
      ? (shared?.optics?.transferFunction ??
        own ??
        (await resolveTransferFunction(await suggestedOf(volume), volume.window ?? volume.range)))
      : null,
  };
}

/** @throws {VolumeViewError} for a volume that has no such slices */
export function refuseNoSlices(volume: Volume): void {
  if (isPolar(volume)) {
    throw new VolumeViewError(
      'format/unsupported',
      'a radar scan has no axial, coronal or sagittal slices; put <volume-slice type="cappi"> or another one into its <volume-view>',
    );
  }
}
