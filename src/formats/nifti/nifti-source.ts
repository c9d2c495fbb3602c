import type { DecodeInput, DecodeSettings } from '../base/decoded-volume.ts';
import type { ReadContext } from '../base/format.ts';
import type { SeriesInfo } from '../base/scan-data.ts';
import type { StreamSource } from '../base/piece-reader.ts';

/** The numbers of a NIfTI file, and what its volumes may be opened with. */
export interface NiftiSource extends StreamSource {
  /** The file's bytes, unpacked, in pieces. */
  readonly pieces: AsyncIterable<Uint8Array<ArrayBuffer>>;
  /** Set where several volumes may be opened as scans. */
  readonly scans?: readonly [input: DecodeInput, settings: DecodeSettings, context: ReadContext];
  /** The header, where it is in a file of its own. */
  readonly head?: Uint8Array<ArrayBuffer>;
  /** What a file whose header only looks like NIfTI's says of all its volumes instead. */
  readonly describe?: (
    volumes: Pick<SeriesInfo, 'grid' | 'format' | 'left'>,
  ) => Pick<SeriesInfo, 'grid' | 'format' | 'left'>;
}
