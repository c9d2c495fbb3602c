import type { VolumeViewError } from '../../src/core/errors.ts';
import { SurfaceController } from '../../src/viewer/attachments/surface-controller.ts';
import type { WantedSurface } from '../../src/viewer/attachments/surface-attributes.ts';
import { noSurfaceTarget, SurfaceTarget } from '../../src/viewer/attachments/surface-target.ts';
import { socketOf } from '../../src/viewer/model/view-socket.ts';
import type { Surface } from '../../src/volume/surface.ts';
import type { Volume } from '../../src/volume/volume.ts';
import { AttachmentElement } from './attachment-element.ts';
import { emit } from './volume-view-events.ts';

/** An element that adds a surface to the scene of the `<volume-view>` around it. */
export abstract class SurfaceElement extends AttachmentElement<SurfaceTarget> {
  protected override readonly controller = new SurfaceController({
    localName: this.localName,
    wanted: (volume) => (this.hasAttribute('hidden') ? null : this.readWanted((name) => this.readText(name), volume)),
    target: () => this.target,
    came: (surface) => emit(this, 'load', this.describe(surface)),
    progress: ({ loaded, total, phase }) => emit(this, 'progress', { loaded, total, phase }),
    failed: (error) => this.reportError(error),
  });

  constructor() {
    super();
    new MutationObserver(() => this.requestUpdate()).observe(this, { attributes: true, attributeFilter: ['hidden'] });
  }

  /** Read which surface the attributes ask for. @throws {VolumeViewError} */
  protected abstract readWanted(read: (name: string) => string | null, volume: Volume | null): WantedSurface;

  /** The description of a surface that pages get. */
  protected abstract describe(surface: Surface): unknown;

  /** The surface that is shown. */
  protected get surface(): Surface | null {
    return this.controller.surface;
  }

  protected override refuse(around: HTMLElement | null): VolumeViewError | null {
    return around?.localName === 'volume-view' ? null : noSurfaceTarget(this.localName);
  }

  protected override join(view: HTMLElement): SurfaceTarget {
    return new SurfaceTarget(socketOf(view), this);
  }
}
