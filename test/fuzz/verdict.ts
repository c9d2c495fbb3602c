import { VolumeViewError } from '../../src/core/errors.ts';
import { measureSlowness } from './machine-speed.ts';

/** Milliseconds of the processor's time, on a quiet machine. */
export const maxMs = 2000;
/** Bytes that a case may hold: so many for each byte of its files, and so many more. */
export const maxPerByte = 1100;
export const maxFree = 64 * 2 ** 20;
/** Bytes of the heap that code and the runtime itself need while a case runs. */
export const forRuntime = 8 * 2 ** 20;

export interface Verdict {
  /** 'volume', or the code of the error. */
  readonly outcome: string;
  /** What the error says. */
  readonly words?: string;
  /** What should not be; null where all is well. */
  readonly finding: Finding | null;
  readonly ms: number;
  /** Bytes that were held at the worst, and those of the files. */
  readonly peak: number;
  readonly size: number;
}

export interface Finding {
  /** The sort of a finding: 'time', 'memory', 'not finite', or an exception and where it was thrown. */
  readonly kind: string;
  readonly detail: string;
}

export function judgeCost(ms: number, peak: number, size: number): Finding | null {
  const allowed = maxPerByte * size + maxFree + forRuntime;
  if (peak > allowed)
    return { kind: 'memory', detail: `${megabytes(peak)} MB for ${size} bytes; at most ${megabytes(allowed)} MB` };
  if (ms <= maxMs) return null;
  const max = maxMs * measureSlowness();
  return ms > max
    ? { kind: 'time', detail: `${Math.round(ms)} ms; at most ${Math.round(max)} ms as the machine is now` }
    : null;
}

const megabytes = (bytes: number): string => (bytes / 2 ** 20).toFixed(1);

/** The outcome of what may throw one of our errors, and nothing else. */
export async function runSafely(
  run: () => Finding | null | Promise<Finding | null>,
): Promise<Pick<Verdict, 'outcome' | 'words' | 'finding'>> {
  try {
    return { outcome: 'volume', finding: await run() };
  } catch (error) {
    if (error instanceof VolumeViewError && error.code !== 'internal')
      return { outcome: error.code, words: error.message.slice(0, 300), finding: judgeWords(error) };
    const cause = error instanceof VolumeViewError ? (error.cause ?? error) : error;
    return {
      outcome: 'exception',
      finding: {
        kind: `exception: ${describe(cause)}`,
        detail: cause instanceof Error ? (cause.stack ?? '') : String(cause),
      },
    };
  }
}

/** A message is for people, and a file can not make it long. */
function judgeWords({ code, message }: VolumeViewError): Finding | null {
  if (message.length < 10) return { kind: `words: ${code}`, detail: `"${message}" says nothing` };
  return message.length > 2000
    ? { kind: `words: ${code}`, detail: `a message of ${message.length} characters: ${message.slice(0, 200)}` }
    : null;
}

/** The error with the function that threw it: one mistake is one finding. */
function describe(error: unknown): string {
  if (!(error instanceof Error)) return String(error);
  const where = /\n\s+at (?:async )?(?:new )?([\w.#<>]+)/.exec(error.stack ?? '')?.[1] ?? '';
  return `${error.name}: ${error.message.replace(/-?\d[\d.e+]*/g, 'N').slice(0, 60)} in ${where}`;
}
