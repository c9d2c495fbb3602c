const [newline, backslash, minus, plus, point, zero, nine] = new TextEncoder().encode('\n\\-+.09');

/** Powers of ten that are exact. */
const exact = Array.from({ length: 23 }, (_, i) => Number(`1e${i}`));

/** Number of digits that a double can hold exactly. */
const maxDigits = 15;

/** Reads words and numbers of a text directly from its bytes: texts of meshes have many millions of numbers. */
export class TextScanner {
  /** Counted from 1. */
  line = 1;

  constructor(
    readonly bytes: Uint8Array,
    public at = 0,
  ) {}

  get isAtEnd(): boolean {
    return this.at >= this.bytes.length;
  }

  /** The next word of this line; empty if there is none. A backslash at the end of a line joins the next line to it. */
  word(): string {
    this.#skipBlanks();
    const from = this.at;
    while (this.at < this.bytes.length && this.bytes[this.at] > 32) this.at++;
    let word = '';
    for (let i = from; i < this.at && i < from + 256; i++) word += String.fromCharCode(this.bytes[i]);
    return word;
  }

  /** The rest of this line. */
  rest(): string {
    this.#skipBlanks();
    const from = this.at;
    this.#seekLineEnd();
    return new TextDecoder('latin1').decode(this.bytes.subarray(from, Math.min(this.at, from + 1000))).trim();
  }

  /** Goes to the next line. */
  nextLine(): void {
    this.#seekLineEnd();
    this.at++;
    this.line++;
  }

  /** The next number, also from a later line. @returns NaN if the next word is not a number */
  anyNumber(): number {
    for (; this.at < this.bytes.length && this.bytes[this.at] <= 32; this.at++)
      if (this.bytes[this.at] === newline) this.line++;
    return this.number();
  }

  /** The next number of this line. @returns NaN if the next word is not a number */
  number(): number {
    this.#skipBlanks();
    const { bytes } = this;
    const from = this.at;
    const isNegative = bytes[from] === minus;
    if (isNegative || bytes[from] === plus) this.at++;
    let [mantissa, digits, exponent, hasPoint, any] = [0, 0, 0, false, false];
    for (; this.at < bytes.length; this.at++) {
      const byte = bytes[this.at];
      if (byte >= zero && byte <= nine) {
        any = true;
        if (digits < maxDigits) {
          mantissa = 10 * mantissa + (byte - zero);
          if (mantissa > 0) digits++;
          if (hasPoint) exponent--;
        } else if (!hasPoint) exponent++;
      } else if (byte === point && !hasPoint) hasPoint = true;
      else break;
    }
    if (any && (bytes[this.at] | 32) === 101) exponent += this.#exponent();
    if (!any || (this.at < bytes.length && bytes[this.at] > 32)) {
      this.at = from;
      return Number.NaN;
    }
    const value =
      exponent < 0
        ? exponent < -22
          ? mantissa * 10 ** exponent
          : mantissa / exact[-exponent]
        : mantissa * (exact[exponent] ?? 10 ** exponent);
    return isNegative ? -value : value;
  }

  /** @returns NaN if there is none */
  #exponent(): number {
    this.at++;
    const sign = this.bytes[this.at] === minus ? -1 : 1;
    if (sign < 0 || this.bytes[this.at] === plus) this.at++;
    let [value, any] = [0, false];
    for (; this.bytes[this.at] >= zero && this.bytes[this.at] <= nine; this.at++, any = true)
      value = Math.min(1000, 10 * value + (this.bytes[this.at] - zero));
    return any ? sign * value : Number.NaN;
  }

  #skipBlanks(): void {
    const { bytes } = this;
    for (; this.at < bytes.length; this.at++) {
      const byte = bytes[this.at];
      if (byte === backslash && this.#joinsLines()) continue;
      if (byte > 32 || byte === newline) return;
    }
  }

  #joinsLines(): boolean {
    const next = this.bytes[this.at + 1] === 13 ? this.at + 2 : this.at + 1;
    if (this.bytes[next] !== newline) return false;
    this.at = next;
    this.line++;
    return true;
  }

  #seekLineEnd(): void {
    const end = this.bytes.indexOf(newline, this.at);
    this.at = end < 0 ? this.bytes.length : end;
  }
}
