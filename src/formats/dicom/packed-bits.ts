import { corruptFile } from '../base/file-problem.ts';

/**
 * Reads the bits of a packed stream. In the byte after one of 255, the upper bits are not of the stream: all eight in JPEG, one in
 * JPEG-LS. They are 0; others are a mark, which ends the bits. Behind their end are zeros. Sources: ITU-T T.81, F.1.2.3, and T.87, C.2.1
 */
export class PackedBits {
  protected bits = 0;
  protected count = 0;
  /** Zeros that are not in the stream. */
  protected added = 0;
  #isAfterFull = false;

  /**
   * @param stuffed - upper bits of the byte after one of 255 that are not of the stream
   * @param what - for messages: 'file 12 of 300'
   */
  constructor(
    protected readonly bytes: Uint8Array,
    protected at: number,
    private readonly stuffed: 1 | 8,
    protected readonly what: string,
  ) {}

  /** 0 to 16 bits. */
  read(count: number): number {
    if (this.count < count) this.fill();
    this.count -= count;
    return (this.bits >>> this.count) & (2 ** count - 1);
  }

  /** @throws {VolumeViewError} `format/corrupt` if bits were read that are not in the stream */
  check(): void {
    if (this.added > this.count) throw this.endsEarly();
  }

  protected endsEarly(): Error {
    const name = this.stuffed === 8 ? 'JPEG' : 'JPEG-LS';
    return corruptFile(this.what, `has packed pixels (${name}) that end early; copy the file again`);
  }

  protected fill(): void {
    while (this.count <= 16) {
      const byte = this.bytes[this.at];
      const isEnd = byte === undefined || (byte === 0xff && this.bytes[this.at + 1] >> (8 - this.stuffed) !== 0);
      const size = this.#isAfterFull && !isEnd ? 8 - this.stuffed : 8;
      if (isEnd) this.added += size;
      else {
        this.at++;
        this.#isAfterFull = byte === 0xff;
      }
      this.bits = (this.bits << size) | (isEnd ? 0 : byte);
      this.count += size;
    }
  }

  /** Forgets the bits that were read ahead, and goes on at another byte. */
  protected goTo(at: number): void {
    this.bits = this.count = this.added = 0;
    this.#isAfterFull = false;
    this.at = at;
  }
}
