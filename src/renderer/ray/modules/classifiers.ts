import { domainOf } from '../../../optics/emission.ts';
import { findColumns } from '../../../optics/table-columns.ts';
import type { TransferFunction } from '../../../optics/transfer-function.ts';
import type { Volume } from '../../../volume/volume.ts';
import type { Device, Gl } from '../../device.ts';
import { Kept } from '../../kept.ts';
import type { FieldModule, Optics, RayModule } from '../ray-module.ts';
import { createColumns } from './columns.ts';
import { createTransferFunction } from './transfer-function.ts';

/** Modules for transfer functions that the usual table does not hold: a table of other columns, or no table. Without the device's filter for floats no table is read. */
export class Classifiers {
  readonly #gl: Gl;
  readonly #columns: ReturnType<typeof createColumns>;
  readonly #tables = new Kept<RayModule | null>();
  #shown: readonly [TransferFunction, number | null] | null = null;

  constructor(gl: Gl, readonly device: Device) {
    this.#gl = gl;
    this.#columns = createColumns(gl);
  }

  /** They stand in for those of the same stages. */
  modulesFor(volume: Volume, field: FieldModule, optics: Optics): readonly RayModule[] {
    const { transferFunction } = optics;
    if (this.#shown?.[0] !== transferFunction) this.#shown = [transferFunction, this.device.floatLinear ? findColumns(transferFunction) : null];
    const [, columns] = this.#shown;
    const table = this.#tables.get([columns], (last) => {
      last?.dispose?.();
      return columns === null ? null : createTransferFunction(this.#gl, columns);
    });
    return table ? [table] : this.#columns.modulesFor({ volume, field, optics, domain: domainOf(transferFunction) });
  }

  dispose(): void {
    this.#columns.dispose();
    this.#tables.last?.dispose?.();
  }
}
