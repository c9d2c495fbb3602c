// Stand-ins for what code under test is given. A test names the members that the code reads, and TypeScript checks them against the real type;
// code that reads another one fails with its name, and does not go on with `undefined`.
import type { Scene } from '../../src/viewer/model/scene.ts';

/** Members that are read of any object: by `await`, by assertions and by their messages. */
const askedOfAll = new Set([
  'then',
  'toJSON',
  'constructor',
  'nodeType',
  'length',
  'inspect',
  'asymmetricMatch',
  '$$typeof',
]);

/** An object with some members of a type. @param name - in errors */
export function fakeOf<T extends object>(name: string, members: Partial<T>): T {
  return new Proxy(members, {
    get: (target, key, receiver) => {
      if (typeof key === 'string' && !(key in target) && !askedOfAll.has(key))
        throw new TypeError(`this fake ${name} has no ${key}`);
      return Reflect.get(target, key, receiver) as unknown;
    },
  }) as T;
}

export const fakeScene = (members: Partial<Scene> = {}): Scene => fakeOf('Scene', members);
