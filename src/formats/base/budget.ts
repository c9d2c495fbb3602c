import { VolumeViewError } from '../../core/errors.ts';

// A file's own numbers say how much memory and how many steps it takes, and the file comes from a stranger. So each
// load has one budget, and a reader draws on it before it allocates or loops.

/**
 * Bytes that a load may hold for each byte that it fetched. Deflate, which most files use, expands data by at most
 * 1,032 (zlib's technical notes), and masks come near that; so a smaller number would refuse valid files.
 */
export const bytesPerFileByte = 1100;

/** Bytes that every load may hold, whatever the size of its file: small files may say "all the rest is 0". */
export const freeBytes = 2 ** 26;

/** The maximum number of bytes that a load holds at once, where the device does not say how much memory it has. */
const usualDeviceBytes = 2 ** 32;

/** Steps for each byte that was fetched, and steps that every load may take. A valid file takes a hundredth of them. */
const stepsPerFileByte = 512;
const freeSteps = 2e7;

/** Allocating so many bytes counts as one step: it takes about as long. */
const bytesPerStep = 16;

/**
 * The limits of one load: bytes held at once, and steps in all. Both grow with the bytes that the load fetches. All
 * readers of the load share one budget, also those of the files that a manifest names.
 */
export class Budget {
  #fileBytes = 0;
  #held = 0;
  #steps = 0;

  /**
   * @param deviceBytes - maximum that a load may hold on this device
   * @param effort - share of the usual steps, 0 to 1
   */
  constructor(
    readonly deviceBytes = usualDeviceBytes,
    readonly effort = 1,
  ) {}

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

  /** Bytes that are left to take. */
  get leftBytes(): number {
    return this.allowedBytes - this.#held;
  }

  /** Adds a file that was fetched for this load. @param bytes - its length */
  addFile(bytes: number): void {
    this.#fileBytes += bytes;
  }

  /**
   * Call this before so many bytes are allocated. They also count as steps, so that a file can't make a reader allocate
   * and release forever.
   * @param what - what needs the bytes, as a message can say it: 'the PNG', 'the attribute "how"'
   * @throws {VolumeViewError} `format/too-large`
   */
  take(bytes: number, what: string): void {
    if (!(bytes >= 0 && bytes <= this.leftBytes)) {
      throw new VolumeViewError(
        'format/too-large',
        `${what} asks for ${say(bytes)} of memory in addition to ${say(this.#held)} in use; ` +
          `a file of ${say(this.#fileBytes)} is allowed ${say(this.allowedBytes)} here. Check the file`,
      );
    }
    this.step(bytes / bytesPerStep, what);
    this.#held += bytes;
  }

  /** Returns bytes that were taken and that nothing refers to any longer. */
  giveBack(bytes: number): void {
    this.#held = Math.max(0, this.#held - bytes);
  }

  /**
   * Call this in loops whose length comes from a file's own numbers.
   * @param count - steps that follow: rounds of a loop that each do little
   * @throws {VolumeViewError} `format/too-large`
   */
  step(count: number, what: string): void {
    this.#steps += count;
    const allowed = freeSteps + this.effort * stepsPerFileByte * this.#fileBytes;
    if (this.#steps <= allowed) return;
    throw new VolumeViewError(
      'format/too-large',
      `${what} takes more than ${allowed.toLocaleString('en')} steps, the maximum for a file of ${say(this.#fileBytes)}. Check the file`,
    );
  }
}

function say(bytes: number): string {
  return bytes < 2 ** 20
    ? `${bytes.toLocaleString('en')} bytes`
    : `${(bytes / 2 ** 20).toLocaleString('en', { maximumFractionDigits: 1 })} MiB`;
}
