import { domainOf } from '../../../optics/transfer/emission.ts';
import { findColumns } from '../../../optics/transfer/table-columns.ts';
import type { TransferFunction } from '../../../optics/transfer/transfer-function.ts';
import type { VolumeData } from '../../../volume/volume.ts';
import type { Device, Gl } from '../../device/device.ts';
import { Kept } from '../../device/kept.ts';
import type { FieldModule, Optics, RayModule } from '../ray-module.ts';
import { createColumns } from './columns.ts';
import { createJumps } from './jumps.ts';
import type { Jumps } from './jumps.ts';
import { createTransferFunction } from './transfer-function.ts';

/**
 * Modules for transfer functions that the usual table can't hold: a table with other columns, or no table. It also makes the module that
 * searches for places where a volume becomes opaque at once. If the device can't filter floats, no table is used.
 */
export class Classifiers {
  readonly #gl: Gl;
  readonly #columns: ReturnType<typeof createColumns>;
  readonly #tables = new Kept<RayModule | null>();
  #jumps: Jumps | null = null;
  #shown: readonly [TransferFunction, number | null] | null = null;

  constructor(
    gl: Gl,
    readonly device: Device,
  ) {
    this.#gl = gl;
    this.#columns = createColumns(gl);
  }

  /** These modules replace those of the same stages. @param looks - whether rays search for places where the volume becomes opaque at once */
  modulesFor(volume: VolumeData, field: FieldModule, optics: Optics, looks: boolean): readonly RayModule[] {
    const { transferFunction } = optics;
    if (this.#shown?.[0] !== transferFunction)
      this.#shown = [transferFunction, this.device.floatLinear ? findColumns(transferFunction) : null];
    const [, columns] = this.#shown;
    const table = this.#tables.get([columns], (last) => {
      last?.dispose?.();
      return columns === null ? null : createTransferFunction(this.#gl, columns);
    });
    return table
      ? [table]
      : [
          ...this.#columns.modulesFor({ volume, field, optics, domain: domainOf(transferFunction) }),
          ...(looks ? (this.#jumps ??= createJumps(this.#gl, this.device)).modulesFor(volume, optics) : []),
        ];
  }

  dispose(): void {
    this.#jumps?.dispose();
    this.#columns.dispose();
    this.#tables.last?.dispose?.();
  }
}
