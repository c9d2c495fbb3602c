// From the files that an author chose to the files of a lesson's data.
import type { LessonFile } from '../../../lesson-writers/src/index.ts';
import { loadPart } from './parts.ts';
import type { PrepareAnswer, PrepareOrder } from './prepare-worker.ts';

/** The data of a lesson: files, of which the first is what `src` names. */
export interface LessonData {
  readonly id: string;
  readonly files: readonly LessonFile[];
}

/** @throws {Error} in words that are for the author, where no image can be made */
export async function prepareData(order: PrepareOrder): Promise<LessonData> {
  const script = new Blob([await loadPart('prepare-worker')], { type: 'text/javascript' });
  const address = URL.createObjectURL(script);
  try {
    const worker = new Worker(address);
    const answer = await new Promise<PrepareAnswer>((resolve, reject) => {
      worker.onmessage = ({ data }: MessageEvent<PrepareAnswer>) => resolve(data);
      worker.onerror = ({ message }) => reject(new Error(message));
      worker.postMessage(order);
    }).finally(() => worker.terminate());
    if ('problem' in answer) throw new Error(answer.problem);
    return {
      id: newDataId(),
      files: [
        { path: 'volume.json', bytes: new TextEncoder().encode(answer.manifest) },
        { path: 'volume.png', bytes: answer.image },
      ],
    };
  } finally {
    URL.revokeObjectURL(address);
  }
}

/** It says nothing about the data. */
export const newDataId = (): string => `data-${crypto.randomUUID?.() ?? `${Date.now()}-${Math.random()}`}`;

/** As a view takes them. */
export const asFiles = ({ files }: LessonData): File[] =>
  files.map(({ path, bytes }) => new File([bytes as Uint8Array<ArrayBuffer>], path));
