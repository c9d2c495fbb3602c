import { isWebGl2 } from './device.ts';
import type { Gl } from './device.ts';

/** Source: Khronos, WebGL extension EXT_disjoint_timer_query_webgl2; the queries are WebGL 2's own. */
interface TimerTokens {
  readonly QUERY_COUNTER_BITS_EXT: number;
  readonly TIME_ELAPSED_EXT: number;
  readonly GPU_DISJOINT_EXT: number;
}

/** Source: Khronos, WebGL extension EXT_disjoint_timer_query; WebGL 1 has no other queries. */
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

/** Timer queries, the same for both versions of WebGL. */
interface Queries {
  /** Bits of the counter; 0 if the device has no counter. */
  readonly bits: number;
  create(): WebGLQuery | null;
  begin(query: WebGLQuery): void;
  end(): void;
  isAvailable(query: WebGLQuery): boolean;
  nanoseconds(query: WebGLQuery): number;
  delete(query: WebGLQuery): void;
  /** Whether the times measured since the last call are invalid, for example because the GPU changed its clock. */
  wasDisjoint(): boolean;
}

/**
 * How many turns of the page's event loop to wait for a result after the GPU has finished. The extension says that a result
 * becomes available only between turns; usually it is there in the first one.
 */
const maxTurns = 4;

/** Measures the time that the GPU needs for a drawing; one drawing at a time. */
export class GpuTimer {
  #query: WebGLQuery | null = null;

  private constructor(
    readonly gl: Gl,
    readonly queries: Queries,
  ) {}

  /** null if the browser or the device has no timer queries, or if the context is lost. */
  static create(gl: Gl): GpuTimer | null {
    const queries = gl.isContextLost() ? null : isWebGl2(gl) ? queriesOfWebGl2(gl) : queriesOfWebGl1(gl);
    return queries && queries.bits > 0 ? new GpuTimer(gl, queries) : null;
  }

  /** Time the drawing from now on; a time that nobody has read is dropped. */
  begin(): void {
    this.#drop();
    this.#query = this.queries.create();
    if (this.#query) this.queries.begin(this.#query);
  }

  end(): void {
    if (this.#query) this.queries.end();
  }

  /**
   * Get the time between `begin` and `end`. Call it when the GPU has finished.
   * @returns ms; null if there is no result, if it was read before, or if it is invalid
   */
  async read(): Promise<number | null> {
    const query = this.#query;
    if (!query) return null;
    for (let turn = 0; turn <= maxTurns && !this.gl.isContextLost(); turn++) {
      if (turn > 0) await new Promise((resolve) => setTimeout(resolve));
      if (query !== this.#query) return null; // Another `begin` or `dispose` dropped it meanwhile.
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
  return (
    tokens && {
      bits: gl.getQuery(tokens.TIME_ELAPSED_EXT, tokens.QUERY_COUNTER_BITS_EXT) as unknown as number,
      create: () => gl.createQuery(),
      begin: (query) => gl.beginQuery(tokens.TIME_ELAPSED_EXT, query),
      end: () => gl.endQuery(tokens.TIME_ELAPSED_EXT),
      isAvailable: (query) => gl.getQueryParameter(query, gl.QUERY_RESULT_AVAILABLE) === true,
      nanoseconds: (query) => gl.getQueryParameter(query, gl.QUERY_RESULT) as number,
      delete: (query) => gl.deleteQuery(query),
      wasDisjoint: () => gl.getParameter(tokens.GPU_DISJOINT_EXT) === true,
    }
  );
}

function queriesOfWebGl1(gl: WebGLRenderingContext): Queries | null {
  const ext = gl.getExtension('EXT_disjoint_timer_query') as TimerQueries | null;
  return (
    ext && {
      bits: ext.getQueryEXT(ext.TIME_ELAPSED_EXT, ext.QUERY_COUNTER_BITS_EXT),
      create: () => ext.createQueryEXT(),
      begin: (query) => ext.beginQueryEXT(ext.TIME_ELAPSED_EXT, query),
      end: () => ext.endQueryEXT(ext.TIME_ELAPSED_EXT),
      isAvailable: (query) => ext.getQueryObjectEXT(query, ext.QUERY_RESULT_AVAILABLE_EXT) === true,
      nanoseconds: (query) => ext.getQueryObjectEXT(query, ext.QUERY_RESULT_EXT) as number,
      delete: (query) => ext.deleteQueryEXT(query),
      wasDisjoint: () => gl.getParameter(ext.GPU_DISJOINT_EXT) === true,
    }
  );
}
