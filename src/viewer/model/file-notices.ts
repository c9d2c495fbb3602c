import type { VolumeInfo } from './volume-info.ts';

/** What of a file attached to the volume is not in the picture, or is changed in it. */
export interface FileNotices {
  /** The name of the file, as people know it; '' where it has none. */
  readonly name: string;
  /** In words. */
  readonly notices: readonly string[];
}

/** Where the notices are kept and shown. */
export interface NoticePlace {
  readonly fileNotices: Map<object, readonly FileNotices[]>;
  readonly user: { changed(): void };
}

/** A file, and which parts of it are not in the picture; an empty list where all are. */
export type ReportedFile = readonly [url: string, notices: readonly string[]];

/** Whether something of a volume's file, or of the files shown with it, is not in the picture, or is changed there. */
export function hasNotices(
  info: Pick<VolumeInfo, 'notices' | 'reduced'> | null,
  attached: ReadonlyMap<object, readonly FileNotices[]>,
): boolean {
  return attached.size > 0 || Boolean(info?.notices?.length || info?.reduced);
}
