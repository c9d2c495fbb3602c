import { sceneDepthModule } from '../renderer/ray/modules/scene-depth.ts';
import { readAuthorCamera } from './author-camera.ts';
import type { AuthorCamera } from './author-camera.ts';
import { AuthorNodes } from './author-nodes.ts';
import { SceneDepth } from './scene-depth.ts';
import { SceneLines } from './scene-lines.ts';
import type { StartedCanvas } from './start-canvas.ts';
import type { X3dom } from './x3dom-types.ts';

/** What only scenes need that hold more than a volume: the author's nodes, lines, and the depth at which these end rays. */
export class OtherShapes {
  readonly author: AuthorNodes;
  readonly lines: SceneLines;
  readonly depth: SceneDepth;
  /** Ends rays at that depth. */
  readonly depthModule = sceneDepthModule;

  /** @param host - the element whose X3D children join the scene */
  constructor(x3dom: X3dom, readonly started: StartedCanvas, host: Element) {
    const { canvas, document } = started;
    this.author = new AuthorNodes(x3dom, document, host);
    this.lines = new SceneLines(document);
    this.depth = new SceneDepth(canvas.gl!);
  }

  /** The author's viewpoint as a camera, or null where there is none. */
  get camera(): AuthorCamera | null {
    return readAuthorCamera(this.author, this.started.element);
  }

  dispose(): void {
    this.author.dispose();
    this.depth.dispose();
  }
}
