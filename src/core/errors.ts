/**
 * Every error that reaches an author. `code` is stable (pages may switch on it), `message` is in an author's words and
 * says what was got, what was expected and what to do.
 */
export type ErrorCode =
  /** The file could not be fetched: missing, refused, or no network. */
  | 'source/not-found'
  /** The server can not send the file now, or it broke off again and again. To try it again may help. */
  | 'source/unavailable'
  /** Nothing more of the file comes, or what decodes it no longer answers. To try it again may help. */
  | 'source/stalled'
  /** The server sends the file without permission for this page (CORS), or the page may not reach it. */
  | 'source/cross-origin'
  /** The bytes are of no type that is known here. */
  | 'format/unknown'
  /** The type is known, but this variant of it is not supported. */
  | 'format/unsupported'
  /** The file ends early or contradicts itself. */
  | 'format/corrupt'
  /** The header asks for more memory than is sane. */
  | 'format/too-large'
  /** The mosaic's tiles do not fit the image. */
  | 'mosaic/layout'
  /** A JSON manifest with a missing or wrong field. */
  | 'manifest/invalid'
  /** A transfer function that can not be read. */
  | 'transfer-function/syntax'
  /** Any other attribute with a value that can not be read. */
  | 'attribute/invalid'
  /** The device, browser or page has no WebGL. */
  | 'webgl/unavailable'
  /** WebGL is there, but lacks something that is needed. */
  | 'webgl/unsupported'
  /** The composed shader did not compile. */
  | 'webgl/shader'
  /** The GPU ran out of memory, or the context was lost and did not come back. */
  | 'webgl/context-lost'
  /** The GPU draws otherwise than `self-check` finds on the processor. */
  | 'webgl/inaccurate'
  /** x3dom could not be loaded. */
  | 'x3dom/unavailable'
  /** A mistake of this package, whatever the page and the file are; the message names what was being worked on. */
  | 'internal';

/** An error with a stable code and a message for the author of a page. */
export class VolumeViewError extends Error {
  readonly code: ErrorCode;
  /** What of an element it is about, where that has words of its own for readers. */
  topic?: 'labels';

  constructor(code: ErrorCode, message: string, options?: { cause?: unknown }) {
    super(message, options);
    this.name = 'VolumeViewError';
    this.code = code;
  }
}

/**
 * Whatever was thrown, as an error that a page can be told of. What has no words of its own is a mistake of this package.
 * @param subject - the attributes or the file that were being worked on
 */
export function asVolumeViewError(error: unknown, subject: string): VolumeViewError {
  if (error instanceof VolumeViewError) return error;
  return new VolumeViewError('internal', `volume-view failed at ${subject}, and the page is not to blame (${String(error)}). Please report it.`, { cause: error });
}

/** The error for an attribute that can't be read. The value is shortened: it may come from a stranger. */
export function invalidAttribute(name: string, value: string, expected: string): VolumeViewError {
  return new VolumeViewError('attribute/invalid', `${name} got "${value.slice(0, 60)}"${value.length > 60 ? ` and so on, ${value.length} characters` : ''}; expected ${expected}.`);
}
