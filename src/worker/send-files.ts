// Chosen files on their way to a worker. For each file that a page sends the browser looks at the disk, while the page
// waits: 600 of them at once keep it busy for 170 ms (Chromium).
import type { LoadRequest } from '../formats/base/load-request.ts';
import type { FileGroup } from '../sources/receive-files.ts';
import type { WorkerOrder } from './worker-messages.ts';

/** Files that are sent at once: 5 ms. */
const together = 16;

/**
 * Sends the chosen files of a load in groups, and lets the page do other work between them.
 * @param signal - of the load; once it is given up, no more are sent
 * @returns the order's request, with a port in place of the files; itself where there are none, and without files where it needs none
 */
export function sendFiles(request: WorkerOrder['request'], signal: AbortSignal): WorkerOrder['request'] {
  const { local, data } = request as Partial<LoadRequest>;
  if (!local) return request;
  // One of several times has its own files with it, as a browser keeps them.
  if (data) return { ...request, local: { ...local, files: [] } };
  const { port1, port2 } = new MessageChannel();
  void sendGroups(local.files, port1, signal);
  return { ...request, local: { ...local, files: [], rest: port2 } };
}

async function sendGroups(files: readonly unknown[], port: MessagePort, signal: AbortSignal): Promise<void> {
  const { port1: here, port2: there } = new MessageChannel();
  for (let at = 0; !signal.aborted; at += together) {
    const group = files.slice(at, at + together);
    const isLast = at + together >= files.length;
    try {
      port.postMessage({ files: group, isLast } satisfies FileGroup);
    } catch {
      // What can't be sent is no file: the worker says so.
      const sound = group.map((one) => (one instanceof Blob ? one : null));
      port.postMessage({ files: sound, isLast } satisfies FileGroup);
    }
    if (isLast) break;
    await new Promise((resolve) => {
      here.onmessage = resolve;
      there.postMessage(null);
    });
  }
  here.close();
}
