import type { ScanTarget } from '../../formats/base/choose-scan.ts';
import type { CoarseListener, LoadProgressListener, LoadRequest } from '../../formats/base/load-request.ts';
import type { Volume } from '../../volume/volume.ts';
import type { LoadOptions } from '../../worker/load.ts';
import type { ScanHost, ScanPlayer } from './scan-player.ts';

/** A file, or several files of one volume, and which scan of a manifest. */
export type SourceRequest = Pick<LoadRequest, 'url' | 'files' | 'scan' | 'data'>;

/** What an author says about the source. */
export interface Source {
  /** One URL, or several, separated by blanks. */
  readonly src: string;
  /** Whether several are the files of one volume, instead of scans in time. */
  readonly stack: boolean;
}

/** What opening a source needs of its caller. */
export interface SourceHost extends Omit<ScanHost, 'load'> {
  readonly load: (request: SourceRequest, options: LoadOptions) => Promise<Volume>;
  /** Called if the source has several scans: this player shows one after another. */
  readonly opened: (player: ScanPlayer) => void;
}

export interface Opening {
  /** The requested scan, where there are several. */
  readonly wanted: ScanTarget;
  readonly signal: AbortSignal;
  readonly onProgress: LoadProgressListener;
  /** Not called for scans that follow another one: a picture is already there. */
  readonly onCoarse: CoarseListener;
}
