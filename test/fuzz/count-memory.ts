import { setFlagsFromString } from 'node:v8';
import { runInNewContext } from 'node:vm';

// How much memory a case holds at its worst. A worker's own figures are exact for its ArrayBuffers and its heap, but count
// garbage, too; so they are looked at whenever arrays or texts of some size have been made, and what would be a new peak
// counts only after the garbage is collected.

/** Looked at after so many new bytes. */
const step = 2 ** 18;

/** Beyond this no array is given, as a browser would refuse it; the peak knows that it was asked for. */
const maxBytes = 1.5 * 2 ** 30;

setFlagsFromString('--expose-gc');
// Else arrays that are garbage are still counted for a while after they were collected.
setFlagsFromString('--no-concurrent-array-buffer-sweeping');
const collect = runInNewContext('gc') as () => void;

/** Garbage of cases before that may be there when one begins: by so much its peak may be too low. */
const maxGarbage = 2 ** 22;

/** A peak below this is not looked for: collecting the garbage takes longer than most cases. */
const worthKnowing = 2 ** 22;

let afterCollection = -Infinity;
let base = 0;
let peak = 0;
let since = 0;
let native = 0;
let pausedMs = 0;

function readHeld(): number {
  const { arrayBuffers, heapUsed } = process.memoryUsage();
  return arrayBuffers + heapUsed + native - base;
}

/** Note that so many bytes are about to be taken. */
function note(bytes: number): void {
  since += bytes;
  if (since < step) return;
  since = 0;
  if (readHeld() + bytes <= 1.25 * peak + step) return;
  const held = collectAndRead() + bytes;
  peak = Math.max(peak, held);
  if (held > maxBytes) throw new RangeError('Array buffer allocation failed');
}

function collectAndRead(): number {
  const start = process.cpuUsage();
  collect();
  const { user, system } = process.cpuUsage(start);
  pausedMs += (user + system) / 1000;
  return readHeld();
}

/** Memory that something outside of JavaScript takes, such as a picture that a browser decodes. */
export function noteNative(bytes: number): void {
  native += bytes;
  note(step + bytes);
}

export function startCounting(): void {
  [native, base, peak, since, pausedMs] = [0, 0, 0, 0, 0];
  if (readHeld() > afterCollection + maxGarbage) {
    collect();
    afterCollection = readHeld();
  }
  base = readHeld();
}

/** @returns the peak in bytes, and milliseconds of the processor that the counting itself took */
export function stopCounting(): { peak: number; pausedMs: number } {
  if (readHeld() > peak + worthKnowing) peak = Math.max(peak, collectAndRead());
  return { peak: Math.max(0, peak), pausedMs };
}

type ArrayConstructor = new (...args: unknown[]) => ArrayBufferView | ArrayBuffer;

/** Bytes that a call of an array's constructor makes. */
function bytesOf(Type: ArrayConstructor, [first]: readonly unknown[]): number {
  const each = (Type as { BYTES_PER_ELEMENT?: number }).BYTES_PER_ELEMENT ?? 1;
  if (typeof first === 'number') return first * each;
  if (first instanceof ArrayBuffer || typeof first !== 'object' || first === null) return 0;
  return ((first as { length?: number }).length ?? 0) * each;
}

/** Have all arrays of bytes and numbers noted that are made by `new`, `from`, `slice`, `map` and `filter`; lists of a length, and texts. */
export function watchMemory(): void {
  watchLists();
  watchTexts();
  const names = [
    'ArrayBuffer',
    'Uint8Array',
    'Int8Array',
    'Uint8ClampedArray',
    'Uint16Array',
    'Int16Array',
    'Uint32Array',
    'Int32Array',
    'Float32Array',
    'Float64Array',
    'BigInt64Array',
    'BigUint64Array',
  ] as const;
  for (const name of names) {
    const Type = globalThis[name] as unknown as ArrayConstructor;
    const watched: ArrayConstructor = new Proxy(Type, {
      construct(target, args, newTarget) {
        const bytes = bytesOf(target, args);
        if (bytes > 0) note(bytes);
        return Reflect.construct(target, args, newTarget === watched ? target : newTarget) as object;
      },
    });
    Object.defineProperty(globalThis, name, { value: watched, configurable: true, writable: true });
  }
  watchMethods(Object.getPrototypeOf(Uint8Array.prototype) as Methods);
  watchMethods(ArrayBuffer.prototype as unknown as Methods);
}

type Methods = Record<string, (this: ArrayBuffer, ...args: unknown[]) => { byteLength: number }>;

function watchMethods(methods: Methods): void {
  for (const name of ['slice', 'map', 'filter']) {
    const method = methods[name];
    if (!method) continue;
    methods[name] = function (...args) {
      const made = method.apply(this, args);
      note(made.byteLength);
      return made;
    };
  }
}

/** Lists that are made of a length alone, such as a file's own numbers say. */
function watchLists(): void {
  const from = Array.from.bind(Array) as (...args: unknown[]) => unknown[];
  Array.from = function (source: unknown, ...more: unknown[]) {
    const { length } = (source ?? {}) as { length?: unknown };
    if (typeof length === 'number' && !Array.isArray(source)) note(8 * Math.max(0, length || 0));
    return from(source, ...more);
  } as typeof Array.from;
}

function watchTexts(): void {
  const { decode } = TextDecoder.prototype;
  TextDecoder.prototype.decode = function (...args) {
    const text = decode.apply(this, args);
    note(text.length);
    return text;
  };
}
