import { isWebGl2 } from './device.ts';
import type { Gl } from './device.ts';

/** Source: Khronos, WebGL extension EXT_disjoint_timer_query_webgl2; the queries are WebGL 2's own. */
interface TimerTokens {
  readonly QUERY_COUNTER_BITS_EXT: number;
  readonly TIME_ELAPSED_EXT: number;
  readonly GPU_DISJOINT_EXT: number;
}

/** Source: Khronos, WebGL extension EXT_disjoint_timer_query; WebGL 1 has no queries but these. */
interface TimerQueries extends TimerTokens {
  readonly QUERY_RESULT_EXT: number;
  readonly QUERY_RESULT_AVAILABLE_EXT: number;
  getQueryEXT(target: number, what: number): number;
  createQueryEXT(): WebGLQuery | null;
  deleteQueryEXT(query: WebGLQuery): void;
  beginQueryEXT(target: number, query: WebGLQuery): void;
  endQueryEXT(target: number): void;
  getQueryObjectEXT(query: WebGLQuery, what: number): unknown;
}

/** Timer queries in the words of neither version. */
interface Queries {
  /** Of the counter; a device without one says 0. */
  readonly bits: number;
  create(): WebGLQuery | null;
  begin(query: WebGLQuery): void;
  end(): void;
  isAvailable(query: WebGLQuery): boolean;
  nanoseconds(query: WebGLQuery): number;
  delete(query: WebGLQuery): void;
  /** Whether times since this was last asked are void: the GPU changed its clock, say. */
  wasDisjoint(): boolean;
}

/**
 * Turns of the page's loop that a result is waited for once the GPU has finished; it changes in none of them, says the
 * extension, and it is there in the first as a rule.
 */
const maxTurns = 4;

/** Takes the time that the GPU spends on a drawing, one at a time. */
export class GpuTimer {
  #query: WebGLQuery | null = null;

  private constructor(
    readonly gl: Gl,
    readonly queries: Queries,
  ) {}

  /** null where the browser or the device has no timer queries, and where the context is lost. */
  static create(gl: Gl): GpuTimer | null {
    const queries = gl.isContextLost() ? null : isWebGl2(gl) ? queriesOfWebGl2(gl) : queriesOfWebGl1(gl);
    return queries && queries.bits > 0 ? new GpuTimer(gl, queries) : null;
  }

  /** What is drawn from now on is timed; a time that nobody read is dropped. */
  begin(): void {
    this.#drop();
    this.#query = this.queries.create();
    if (this.#query) this.queries.begin(this.#query);
  }

  end(): void {
    if (this.#query) this.queries.end();
  }

  /**
   * The time between `begin` and `end`, to be asked for when the GPU has finished.
   * @returns ms; null where it is not to be had, was asked for before, or means nothing
   */
  async read(): Promise<number | null> {
    const query = this.#query;
    if (!query) return null;
    for (let turn = 0; turn <= maxTurns && !this.gl.isContextLost(); turn++) {
      if (turn > 0) await new Promise((resolve) => setTimeout(resolve));
      if (query !== this.#query) return null; // Dropped meanwhile.
      if (!this.queries.isAvailable(query)) continue;
      const ms = this.queries.nanoseconds(query) / 1e6;
      this.#drop();
      return this.queries.wasDisjoint() ? null : ms;
    }
    if (query === this.#query) this.#drop();
    return null;
  }

  dispose(): void {
    this.#drop();
  }

  #drop(): void {
    if (this.#query) this.queries.delete(this.#query);
    this.#query = null;
  }
}

function queriesOfWebGl2(gl: WebGL2RenderingContext): Queries | null {
  const tokens = gl.getExtension('EXT_disjoint_timer_query_webgl2') as TimerTokens | null;
  return tokens && {
    bits: gl.getQuery(tokens.TIME_ELAPSED_EXT, tokens.QUERY_COUNTER_BITS_EXT) as unknown as number,
    create: () => gl.createQuery(),
    begin: (query) => gl.beginQuery(tokens.TIME_ELAPSED_EXT, query),
    end: () => gl.endQuery(tokens.TIME_ELAPSED_EXT),
    isAvailable: (query) => gl.getQueryParameter(query, gl.QUERY_RESULT_AVAILABLE) === true,
    nanoseconds: (query) => gl.getQueryParameter(query, gl.QUERY_RESULT) as number,
    delete: (query) => gl.deleteQuery(query),
    wasDisjoint: () => gl.getParameter(tokens.GPU_DISJOINT_EXT) === true,
  };
}

function queriesOfWebGl1(gl: WebGLRenderingContext): Queries | null {
  const ext = gl.getExtension('EXT_disjoint_timer_query') as TimerQueries | null;
  return ext && {
    bits: ext.getQueryEXT(ext.TIME_ELAPSED_EXT, ext.QUERY_COUNTER_BITS_EXT),
    create: () => ext.createQueryEXT(),
    begin: (query) => ext.beginQueryEXT(ext.TIME_ELAPSED_EXT, query),
    end: () => ext.endQueryEXT(ext.TIME_ELAPSED_EXT),
    isAvailable: (query) => ext.getQueryObjectEXT(query, ext.QUERY_RESULT_AVAILABLE_EXT) === true,
    nanoseconds: (query) => ext.getQueryObjectEXT(query, ext.QUERY_RESULT_EXT) as number,
    delete: (query) => ext.deleteQueryEXT(query),
    wasDisjoint: () => gl.getParameter(ext.GPU_DISJOINT_EXT) === true,
  };
}
