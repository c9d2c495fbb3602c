import { overlayColors } from '../../optics/attachments/overlay.ts';
import type { ShownOverlay } from '../../optics/attachments/overlay.ts';
import { buildPreintegrationTable, preintegrationTableSize } from '../../optics/transfer/preintegration-table.ts';
import { findColumns } from '../../optics/transfer/table-columns.ts';
import { usualColumns } from '../../optics/transfer/usual-columns.ts';
import type { Gl } from '../device/device.ts';
import type { ProgramInputs } from '../device/inputs.ts';
import { uploadTable } from '../textures/table-textures.ts';

/** How a table is uploaded. */
interface TableOptions {
  /** Of the picture. */
  readonly lightFactor: number;
  /** Whether the device filters floats. */
  readonly isFiltered: boolean;
  /** The table before, whose texture is used again. */
  readonly last: ProgramInputs | null | undefined;
}

/** Upload what a second field's transfer function shows of the spans between two values. */
export function uploadOverlayTable(
  gl: Gl,
  overlay: ShownOverlay,
  { lightFactor, isFiltered, last }: TableOptions,
): ProgramInputs {
  const table = buildPreintegrationTable(overlayColors(overlay, lightFactor), {
    columns: findColumns(overlay.transferFunction) ?? usualColumns,
    rows: preintegrationTableSize.rows,
  });
  const unit = uploadTable(gl, table, last?.units[0].texture ?? null);
  const filter = isFiltered ? gl.LINEAR : gl.NEAREST;
  return {
    uniforms: { uOverlayTableSize: [table.columns, table.rows], uOverlayFirst: table.first, uOverlayLast: table.last },
    units: [{ ...unit, minFilter: filter, magFilter: filter, samplerName: 'uOverlayTable' }],
  };
}
