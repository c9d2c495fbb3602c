/** A group of chosen files, as a page sends them to a worker. */
export interface FileGroup {
  readonly files: readonly unknown[];
  readonly isLast: boolean;
}

/** The files that a page sends in groups. @throws the signal's reason */
export function receiveFiles(port: MessagePort, signal?: AbortSignal): Promise<readonly unknown[]> {
  const all: unknown[] = [];
  return new Promise<readonly unknown[]>((resolve, reject) => {
    signal?.addEventListener('abort', () => reject(signal.reason as Error));
    signal?.throwIfAborted();
    port.onmessage = ({ data: { files, isLast } }: MessageEvent<FileGroup>) => {
      all.push(...files);
      if (isLast) resolve(all);
    };
  }).finally(() => port.close());
}
