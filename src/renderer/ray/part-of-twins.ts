import type { Later } from './ray-twin.ts';

/** One export of some code that is loaded later. */
export function partOf<T, P>(from: Later<T>, choose: (code: T) => P): Later<P> {
  return {
    load: async () => choose(await from.load()),
    get code() {
      return choose(from.code);
    },
  };
}
