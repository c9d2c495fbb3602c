// Keeps the work in the browser, with its data, until the author begins another one.
import type { Lesson } from '../model/lesson.ts';
import type { History } from '../model/history.ts';
import type { LessonData } from './prepare.ts';

const databaseName = 'volume-view-studio';

/** Objects of the database: the one that is worked on, and data by their ids. */
const [workName, dataName] = ['work', 'data'] as const;

function open(): Promise<IDBDatabase> {
  return new Promise((resolve, reject) => {
    const request = indexedDB.open(databaseName, 1);
    request.onupgradeneeded = () => {
      request.result.createObjectStore(workName);
      request.result.createObjectStore(dataName);
    };
    request.onsuccess = () => resolve(request.result);
    request.onerror = () => reject(request.error);
    request.onblocked = () => reject(new Error('blocked'));
  });
}

/** Does something in one transaction. @param act - returns the request whose result is wanted */
async function inStores<T>(
  mode: IDBTransactionMode,
  act: (work: IDBObjectStore, data: IDBObjectStore) => IDBRequest<T> | null,
): Promise<T | undefined> {
  const database = await open();
  try {
    return await new Promise<T | undefined>((resolve, reject) => {
      const transaction = database.transaction([workName, dataName], mode);
      const request = act(transaction.objectStore(workName), transaction.objectStore(dataName));
      transaction.oncomplete = () => resolve(request?.result);
      transaction.onerror = transaction.onabort = () => reject(transaction.error);
    });
  } finally {
    database.close();
  }
}

/** @throws {Error} where the browser keeps nothing: a private window, no room */
export const keepWork = (history: History<Lesson>): Promise<unknown> =>
  inStores('readwrite', (work) => work.put(history, 'lesson'));

export const keepData = (data: LessonData): Promise<unknown> =>
  inStores('readwrite', (_, store) => store.put(data.files, data.id));

export const findWork = (): Promise<History<Lesson> | undefined> =>
  inStores('readonly', (work) => work.get('lesson') as IDBRequest<History<Lesson>>);

export async function findData(id: string): Promise<LessonData | null> {
  const files = await inStores('readonly', (_, data) => data.get(id) as IDBRequest<LessonData['files'] | undefined>);
  return files ? { id, files } : null;
}

/** Nothing is left. */
export const forgetWork = (): Promise<unknown> =>
  inStores('readwrite', (work, data) => {
    work.clear();
    data.clear();
    return null;
  });
