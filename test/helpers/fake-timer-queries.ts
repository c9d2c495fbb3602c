import type { Gl } from '../../src/renderer/device/device.ts';

/** The behaviour of a device with timer queries in a test. */
export interface FakeTimes {
  /** How many turns of the page's event loop a query takes after its end until it has a result. */
  readonly turns?: number;
  readonly nanoseconds?: number;
  readonly disjoint?: boolean;
  /** Bits of the counter; 0 for a device without one. */
  readonly bits?: number;
}

/** A context that behaves as the extension specifies, throws on forbidden calls, and counts the queries that exist. */
export interface FakeGl {
  readonly gl: Gl;
  /** The queries that were created and not deleted. */
  readonly alive: Set<object>;
  /** Lose the context: from now on calls do nothing, and getters return null. */
  lose(): void;
}

interface FakeQuery {
  turnsLeft: number;
  ended: boolean;
}

/**
 * Source: Khronos, WebGL extensions EXT_disjoint_timer_query and EXT_disjoint_timer_query_webgl2: a result appears
 * only between turns of the page's event loop, one query of a kind is active at a time, and reading GPU_DISJOINT resets it.
 */
export function fakeTimerQueries(
  version: 1 | 2,
  { turns = 2, nanoseconds = 5e6, disjoint = false, bits = 64 }: FakeTimes = {},
): FakeGl {
  const alive = new Set<object>();
  let active: FakeQuery | null = null;
  let isLost = false;
  let isDisjoint = disjoint;
  const tokens = {
    QUERY_COUNTER_BITS_EXT: 1,
    TIME_ELAPSED_EXT: 2,
    GPU_DISJOINT_EXT: 3,
    QUERY_RESULT_EXT: 4,
    QUERY_RESULT_AVAILABLE_EXT: 5,
  };
  const check = (holds: boolean, what: string): void => {
    if (!holds) throw new Error(`INVALID_OPERATION: ${what}`);
  };
  const count = (query: FakeQuery): void => {
    query.turnsLeft--;
    if (query.turnsLeft > 0) setTimeout(() => count(query));
  };
  const create = (): FakeQuery | null => {
    if (isLost) return null;
    const query = { turnsLeft: turns, ended: false };
    alive.add(query);
    return query;
  };
  const remove = (query: FakeQuery): void => {
    check(isLost || query !== active, 'deleted while active');
    alive.delete(query);
  };
  const begin = (target: number, query: FakeQuery): void => {
    if (isLost) return;
    check(target === tokens.TIME_ELAPSED_EXT && active === null && alive.has(query) && !query.ended, 'begun');
    active = query;
  };
  const end = (): void => {
    if (isLost) return;
    check(active !== null, 'ended without a begin');
    active!.ended = true;
    const query = active!;
    if (turns > 0 && turns < Infinity) setTimeout(() => count(query));
    active = null;
  };
  const ask = (available: number, query: FakeQuery, what: number): unknown => {
    if (isLost) return null;
    check(query.ended && alive.has(query), 'asked while active, or after its end');
    const isThere = query.turnsLeft <= 0;
    if (what === available) return isThere;
    check(isThere, 'a result that is not there: a real context would stop the page until it is');
    return nanoseconds;
  };
  const getParameter = (what: number): unknown => {
    if (what !== tokens.GPU_DISJOINT_EXT || isLost) return null;
    const was = isDisjoint;
    isDisjoint = false;
    return was;
  };
  const extension =
    version === 2
      ? tokens
      : {
          ...tokens,
          getQueryEXT: () => bits,
          createQueryEXT: create,
          deleteQueryEXT: remove,
          beginQueryEXT: begin,
          endQueryEXT: end,
          getQueryObjectEXT: (query: FakeQuery, what: number) => ask(tokens.QUERY_RESULT_AVAILABLE_EXT, query, what),
        };
  const common = {
    isContextLost: () => isLost,
    getParameter,
    getExtension: (name: string) =>
      name === (version === 2 ? 'EXT_disjoint_timer_query_webgl2' : 'EXT_disjoint_timer_query') ? extension : null,
  };
  const { QUERY_RESULT_AVAILABLE } = WebGL2RenderingContext;
  const own =
    version === 1
      ? common
      : {
          ...common,
          getQuery: () => bits,
          createQuery: create,
          deleteQuery: remove,
          beginQuery: begin,
          endQuery: end,
          getQueryParameter: (query: FakeQuery, what: number) => ask(QUERY_RESULT_AVAILABLE, query, what),
        };
  const prototype = (version === 2 ? WebGL2RenderingContext : WebGLRenderingContext).prototype as object;
  const gl = Object.create(prototype, Object.getOwnPropertyDescriptors(own)) as Gl;
  return { gl, alive, lose: () => void (isLost = true) };
}
