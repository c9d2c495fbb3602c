import { invalidAttribute, VolumeViewError } from '../../core/errors.ts';
import { resolveTransferFunction } from '../../optics/transfer/resolve-transfer-function.ts';
import type { TransferFunction } from '../../optics/transfer/transfer-function.ts';
import { maxGroups } from '../../volume/labels.ts';
import type { LabelEntry } from '../model/view-labels.ts';

/** Labels with the same text are a group. */
export interface LabelGroups {
  /** Numbers of the groups, by text, from 1; labels without a text have 0. */
  readonly numbers: ReadonlyMap<string, number>;
  /** Functions of the groups, from group 1 on. */
  readonly functions: readonly TransferFunction[];
  /** The error of the first text that can't be read; its labels use the volume's own function. */
  readonly error: unknown;
}

const none: LabelGroups = { numbers: new Map(), functions: [], error: null };

/** Reads the transfer functions of labels, and keeps them while they are unchanged. */
export class LabelFunctions {
  #key = '';
  #kept: Promise<LabelGroups> = Promise.resolve(none);

  /** @param window - data values that presets and percentages span @returns null where no label has one */
  read(entries: readonly LabelEntry[], window: readonly [number, number]): Promise<LabelGroups> | null {
    const firsts = new Map<string, number>();
    for (const { id, transferFunction } of entries)
      if (transferFunction && !firsts.has(transferFunction)) firsts.set(transferFunction, id);
    if (firsts.size === 0) return null;
    const key = JSON.stringify([window, ...firsts]);
    if (key !== this.#key) this.#kept = readAll(firsts, window);
    this.#key = key;
    return this.#kept;
  }
}

/** @param firsts - the first label with each text */
async function readAll(firsts: ReadonlyMap<string, number>, window: readonly [number, number]): Promise<LabelGroups> {
  const numbers = new Map<string, number>();
  const functions: TransferFunction[] = [];
  let error: unknown = null;
  for (const [text, id] of firsts) {
    const name = `transfer-function of the label ${id}`;
    try {
      if (functions.length === maxGroups)
        throw invalidAttribute(
          name,
          text,
          `one of the ${maxGroups} that labels before it have. Labels have at most ${maxGroups} different ones in addition to the volume's own`,
        );
      functions.push(await resolveTransferFunction(text, window));
      numbers.set(text, functions.length);
    } catch (thrown) {
      error ??=
        thrown instanceof VolumeViewError && thrown.code === 'transfer-function/syntax'
          ? new VolumeViewError(thrown.code, `${name}: ${thrown.message}`, { cause: thrown })
          : thrown;
    }
  }
  return { numbers, functions, error };
}
