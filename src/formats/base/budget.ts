import { VolumeViewError } from '../../core/errors.ts';

// A file's own numbers say how much memory and how many steps it takes, and the file comes from a stranger. So each load has
// one budget, and a reader draws on it before it allocates or loops.

/**
 * Bytes that may be held for each byte that was fetched. Deflate, which most files use, swells its data by at most 1,032
 * (zlib's technical notes), and masks come near it; so a smaller number would refuse sound files.
 */
export const bytesPerFileByte = 1100;

/** Bytes that may be held whatever the size of the file: small files may say "all the rest is 0". */
export const freeBytes = 2 ** 26;

/** Bytes that are held at once by no load, where the device does not say how much memory it has. */
const usualDeviceBytes = 2 ** 32;

/** Steps for each byte that was fetched, and those that are free. A sound file takes a hundredth of them. */
const stepsPerFileByte = 512;
const freeSteps = 2e7;

/** Bytes that are made in the time of a step. */
const bytesPerStep = 16;

/**
 * What one load may take: bytes that are held at once, and steps in all. Both grow with the bytes that were fetched for it.
 * The same object goes to all readers of the load, those of a manifest's files among them.
 */
export class Budget {
  #fileBytes = 0;
  #held = 0;
  #steps = 0;

  /**
   * @param deviceBytes - that a load may hold at most on this device
   * @param effort - share of the usual steps, 0 to 1
   */
  constructor(readonly deviceBytes = usualDeviceBytes, readonly effort = 1) {}

  /** The budget of a load of one file. @param fileBytes - its length */
  static ofFile(fileBytes: number): Budget {
    const budget = new Budget();
    budget.addFile(fileBytes);
    return budget;
  }

  /** Bytes that may be held at once. */
  get allowedBytes(): number {
    return Math.min(this.deviceBytes, freeBytes + bytesPerFileByte * this.#fileBytes);
  }

  /** Bytes that may still be taken. */
  get leftBytes(): number {
    return this.allowedBytes - this.#held;
  }

  /** A file that was fetched for this load. @param bytes - its length */
  addFile(bytes: number): void {
    this.#fileBytes += bytes;
  }

  /**
   * To be called before so many bytes are allocated. They also count as steps, so that making and dropping ends, too.
   * @param what - for whom, as a message can say it: 'the PNG', 'the attribute "how"'
   * @throws {VolumeViewError} `format/too-large`
   */
  take(bytes: number, what: string): void {
    if (!(bytes >= 0 && bytes <= this.leftBytes)) {
      throw new VolumeViewError(
        'format/too-large',
        `${what} asks for ${say(bytes)} of memory beside ${say(this.#held)} that are in use; ` +
          `a file of ${say(this.#fileBytes)} is allowed ${say(this.allowedBytes)} here. Check the file, or use a smaller one`,
      );
    }
    this.step(bytes / bytesPerStep, what);
    this.#held += bytes;
  }

  /** Bytes that were taken and are no longer referred to. */
  giveBack(bytes: number): void {
    this.#held = Math.max(0, this.#held - bytes);
  }

  /**
   * To be called in loops that a file's own numbers drive.
   * @param count - steps that follow: rounds of a loop that do little
   * @throws {VolumeViewError} `format/too-large`
   */
  step(count: number, what: string): void {
    this.#steps += count;
    const allowed = freeSteps + this.effort * stepsPerFileByte * this.#fileBytes;
    if (this.#steps <= allowed) return;
    throw new VolumeViewError(
      'format/too-large',
      `${what} takes more than ${allowed.toLocaleString('en')} steps, the most that a file of ${say(this.#fileBytes)} is allowed: ` +
        'it refers to its own parts again and again. Check the file',
    );
  }
}

function say(bytes: number): string {
  return bytes < 2 ** 20 ? `${bytes.toLocaleString('en')} bytes` : `${(bytes / 2 ** 20).toLocaleString('en', { maximumFractionDigits: 1 })} MiB`;
}
