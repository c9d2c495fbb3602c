import type { Matrix4 } from '../../volume/matrix.ts';

/** The camera: from where the scene is seen. */
export interface View {
  /** Row-major world-to-eye matrix. */
  readonly view: Matrix4;
  /** Row-major. */
  readonly projection: Matrix4;
}
