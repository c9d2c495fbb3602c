/**
 * Every error that reaches an author. `code` is stable (pages may switch on it). `message` is in the words of an author, and says what was
 * received, what was expected and what to do.
 */
export type ErrorCode =
  /** The file could not be fetched: missing, refused, or no network. */
  | 'source/not-found'
  /** The server can't send the file now, or the connection broke several times. Trying again may help. */
  | 'source/unavailable'
  /** No more bytes of the file arrive, or its decoder no longer answers. Trying again may help. */
  | 'source/stalled'
  /** The server sends the file without permission for this page (CORS), or the page may not reach it. */
  | 'source/cross-origin'
  /** The type of the bytes is unknown. */
  | 'format/unknown'
  /** The type is known, but this variant of it is not supported. */
  | 'format/unsupported'
  /** The file ends early or contradicts itself. */
  | 'format/corrupt'
  /** The header asks for more memory than is reasonable. */
  | 'format/too-large'
  /** The tiles of the mosaic do not fit the image. */
  | 'mosaic/layout'
  /** A JSON manifest with a missing or wrong field. */
  | 'manifest/invalid'
  /** A transfer function that can not be read. */
  | 'transfer-function/syntax'
  /** Any other attribute with a value that can not be read. */
  | 'attribute/invalid'
  /** The device, browser or page has no WebGL. */
  | 'webgl/unavailable'
  /** WebGL is there, but a feature that is needed is missing. */
  | 'webgl/unsupported'
  /** The composed shader did not compile. */
  | 'webgl/shader'
  /** The GPU ran out of memory, or the context was lost and was not restored. */
  | 'webgl/context-lost'
  /** The GPU draws something different from what `self-check` computes on the CPU. */
  | 'webgl/inaccurate'
  /** x3dom could not be loaded. */
  | 'x3dom/unavailable'
  /** A mistake in this package, not in the page or the file; the message names the task that failed. */
  | 'internal';

/** An error with a stable code and a message for the author of a page. */
export class VolumeViewError extends Error {
  readonly code: ErrorCode;
  /** The part of an element that the error is about, where readers get a message of its own for it. */
  topic?: 'labels';

  constructor(code: ErrorCode, message: string, options?: { cause?: unknown }) {
    super(message, options);
    this.name = 'VolumeViewError';
    this.code = code;
  }
}

/**
 * Turn anything that was thrown into an error for the page. An error of an unknown kind is a mistake in this package.
 * @param subject - the attributes or the file of the task that failed
 */
export function asVolumeViewError(error: unknown, subject: string): VolumeViewError {
  if (error instanceof VolumeViewError) return error;
  return new VolumeViewError('internal', `volume-view failed at ${subject}: ${String(error)}. Please report it.`, {
    cause: error,
  });
}

/** The error for an attribute that can't be read. The value is shortened, as it may come from an unknown source. */
export function invalidAttribute(name: string, value: string, expected: string): VolumeViewError {
  return new VolumeViewError(
    'attribute/invalid',
    `${name} got "${value.slice(0, 60)}"${value.length > 60 ? ` and so on, ${value.length} characters` : ''}; expected ${expected}.`,
  );
}
