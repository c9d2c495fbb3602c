import type { Matrix4 } from '../../volume/matrix.ts';

/** Where the scene is looked at from. */
export interface View {
  /** Row-major world-to-eye matrix. */
  readonly view: Matrix4;
  /** Row-major. */
  readonly projection: Matrix4;
}
