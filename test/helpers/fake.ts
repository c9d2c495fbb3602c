// Stand-ins for what code under test is given. A test names the members that the code reads, and TypeScript checks them against the real type;
// code that reads another one fails with its name, and does not go on with `undefined`.
import type { Scene } from '../../src/viewer/model/scene.ts';
import type { SocketView, SocketViewer } from '../../src/viewer/model/view-socket.ts';
import type { ScenePlace } from '../../src/viewer/scenes/scene-controller.ts';

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

/** Some members of a type, and of the plain objects in it. */
export type Some<T> = T extends ((...given: never[]) => unknown) | readonly unknown[] | ArrayBufferView | Node
  ? T
  : T extends object
    ? { [K in keyof T]?: Some<T[K]> }
    : T;

/**
 * An object with some members of a type. Members of these may be given in part as well: where code may read more of one than is there, make
 * it a fake of its own.
 * @param name - in errors
 */
export function fakeOf<T extends object>(name: string, members: Some<T>): T {
  return new Proxy(members, {
    get: (target, key, receiver) => {
      if (typeof key === 'string' && !(key in target) && !askedOfAll.has(key))
        throw new TypeError(`this fake ${name} has no ${key}`);
      return Reflect.get(target, key, receiver) as unknown;
    },
  }) as T;
}

export const fakeScene = (members: Some<Scene> = {}): Scene => fakeOf<Scene>('Scene', members);
export const fakeSocketView = (members: Some<SocketView>): SocketView => fakeOf<SocketView>('SocketView', members);
export const fakeSocketViewer = (members: Some<SocketViewer>): SocketViewer =>
  fakeOf<SocketViewer>('SocketViewer', members);

/** A place in sight. */
export const fakePlace = (create: () => Promise<Scene>, host = document.createElement('div')): ScenePlace =>
  fakeOf<ScenePlace>('ScenePlace', {
    host,
    container: document.createElement('div'),
    visibility: { inSight: true, asked: false, mayBeNear: true, inHand: false },
    scenes: { create },
  });
