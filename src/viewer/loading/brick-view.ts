// Shows a pyramid that is larger than the GPU: a coarse level as a whole, and bricks of finer ones over it. Loaded with the first such volume.
import { layBricks, shapeAtlas, slotsBelow, slotsWithin } from '../../bricks/brick-layout.ts';
import type { Brick } from '../../bricks/pyramid.ts';
import { ResidentBricks } from '../../bricks/resident-bricks.ts';
import { ResidentDetail } from '../../bricks/resident-detail.ts';
import { usualGpuBytes } from '../../formats/base/brick-limits.ts';
import type { LoadRequest } from '../../formats/base/load-request.ts';
import type { Device, Gl } from '../../renderer/device/device.ts';
import { uploadBricks } from '../../renderer/ray/modules/bricks.ts';
import type { FieldModule } from '../../renderer/ray/ray-module.ts';
import type { Upload } from '../../renderer/textures/fill-texture.ts';
import type { Volume, VolumeData } from '../../volume/volume.ts';
import { inPieces } from '../../core/in-pieces.ts';
import { socketOf } from '../model/view-socket.ts';
import type { SocketView, ViewPart, ViewSocket } from '../model/view-socket.ts';
import { BrickChoice } from './brick-choice.ts';
import { BrickLoading } from './brick-loading.ts';
import { describePicture, isSamePicture } from './brick-picture.ts';
import type { BrickPicture, KeyedPicture } from './brick-picture.ts';
import { BrickDrawing, takeTurn } from './brick-drawing.ts';
import { BrickRoom } from './brick-room.ts';
import type { KeptBricks } from './brick-room.ts';
import { BrickSource } from './brick-source.ts';
import { BrickTiles } from './brick-tiles.ts';

/** The room of this page: views that take turns leave and come within the grace, ms. */
const pageRoom = new BrickRoom(3000);

/** The view of a volume in bricks, and where its bricks come from. */
export interface BrickViewParts {
  readonly pinned: Volume;
  readonly request: LoadRequest;
  readonly view: SocketView;
  readonly socket: ViewSocket;
}

/**
 * The bricks of one view, as long as they are on a GPU: they are asked for when their textures are made, and are only kept, if there is room, after the last of
 * these. The error of the picture says which ones come next.
 */
export class BrickView implements ViewPart, KeptBricks {
  readonly key = 'bricks';
  readonly bricks: ResidentBricks;
  /** The pinned volume with its bricks. */
  readonly volume: Volume;
  readonly #detail: ResidentDetail;
  readonly #maxBytes: number;
  readonly #source: BrickSource;
  readonly #tiles: BrickTiles;
  readonly #choice: BrickChoice;
  /** Textures that have the bricks. */
  #users = 0;
  #life: AbortController | null = null;
  /** MAX_3D_TEXTURE_SIZE. */
  #maxSide = Infinity;
  #picture: KeyedPicture | null = null;
  /** Counts changes of the bricks. */
  #changes = 0;
  #loading: BrickLoading | null = null;
  readonly #drawing = new BrickDrawing();
  /** Whether the textures went before all bricks had come. */
  #gaveWay = false;
  #hasFailed = false;
  #whenSettled: Promise<void> | null = null;
  #settled: (() => void) | null = null;
  #wake: () => void = () => {};

  /** @returns null where the levels do not lie over each other as bricks have to */
  static create(parts: BrickViewParts): BrickView | null {
    const layout = layBricks(parts.pinned.grid, parts.pinned.levels!);
    return layout && new BrickView(parts, layout);
  }

  private constructor(
    readonly parts: BrickViewParts,
    layout: NonNullable<ReturnType<typeof layBricks>>,
  ) {
    const { pinned, request } = parts;
    const levels = pinned.levels!;
    this.#maxBytes = request.settings?.maxGpuBytes ?? usualGpuBytes();
    this.bricks = new ResidentBricks(pinned, layout, (gl: Gl, volume: VolumeData, device: Device) =>
      this.#upload(gl, volume, device),
    );
    this.bricks.moving = true;
    this.bricks.atlas = shapeAtlas(pinned.grid.dimensions, Math.ceil(this.#maxBytes / this.bricks.bytesOfBrick));
    this.#detail = new ResidentDetail(pinned, this.bricks);
    this.#choice = new BrickChoice(this.bricks, this.#detail);
    this.#source = new BrickSource({
      request,
      pinned: pinned.grid,
      levels,
      fetch: parts.view.host.fetch,
    });
    this.#tiles = new BrickTiles({
      volume: pinned,
      levels,
      bricks: this.bricks,
      // Bricks that lie next to a plane may not be there.
      read: (brick, signal) => this.#source.read(brick, signal, false),
      failed: (error) => this.#reportOnce(error),
    });
    this.bricks.planes = this.#tiles;
    this.volume = {
      ...pinned,
      levels: undefined,
      // A finer level may have places without data where this one has none.
      hasNoData: pinned.hasNoData || pinned.samples instanceof Float32Array,
      macrocells: this.bricks.macrocells,
      finer: this.bricks,
    };
  }

  /** Slots that the share of this view, and its device, have room for. */
  get #capacity(): number {
    const { atlas, layout, maxSlots } = this.bricks;
    const bytes = Math.min(this.#maxBytes, pageRoom.share);
    const within = slotsWithin(bytes, atlas, layout, this.parts.pinned.samples.BYTES_PER_ELEMENT);
    return Math.min(within, slotsBelow(atlas, this.#maxSide), maxSlots);
  }

  // What the socket calls.

  /** A picture has been drawn. */
  place(shown: BrickPicture['view']): void {
    const { view } = this.parts;
    const { look, viewer } = view;
    if (this.#users === 0 || !look.current || viewer?.volume !== this.volume) return;
    const picture = describePicture(view, shown, { optics: look.current, cuts: viewer.shown.cuts });
    if (this.#picture && isSamePicture(picture, this.#picture)) return;
    // Views without a picture had theirs before.
    if (!this.#picture && this.#gaveWay) takeTurn(view, this.#life!.signal, this.#whenSettled!);
    this.#picture = picture;
    this.#begin();
  }

  cutsChanged(): void {
    const { socket, view } = this.parts;
    if (this.#users === 0 && view.viewer?.volume !== this.volume) void socket.leave(this);
  }

  // What the room calls.

  get keptBytes(): number {
    return this.#users > 0 ? 0 : this.bricks.count * this.bricks.bytesOfBrick;
  }

  dropKept(): void {
    this.bricks.fit(0);
  }

  // The life of the bricks.

  *#upload(gl: Gl, volume: VolumeData, device: Device): Upload<FieldModule> {
    this.#maxSide = device.max3dTextureSize;
    this.#enter();
    let isThere = true;
    const leave = (): void => {
      if (isThere) this.#leave();
      isThere = false;
    };
    let field: FieldModule | null = null;
    try {
      field = yield* uploadBricks(gl, volume, device);
    } finally {
      if (!field) leave();
    }
    const { dispose } = field;
    return Object.assign(field, {
      dispose: () => {
        dispose.call(field);
        leave();
      },
    });
  }

  #enter(): void {
    if (this.#users++ > 0) return;
    const life = (this.#life = new AbortController()).signal;
    this.#picture = null;
    this.#drawing.restart();
    this.#loading = this.#createLoading(life);
    this.bricks.fit(this.#capacity);
    this.#tiles.wake();
    this.bricks.moving = false;
    this.#begin();
    const { socket } = this.parts;
    if (!socket.parts.includes(this)) void socket.join(this);
    void this.#run(life);
  }

  #leave(): void {
    if (--this.#users > 0) return;
    const { view } = this.parts;
    this.#life!.abort();
    this.#loading?.close();
    this.#loading = null;
    this.#tiles.rest();
    pageRoom.keep(this);
    const isShown = view.viewer?.volume === this.volume;
    // Scripts go on waiting, and so does the reader: the view asks for its context again. It is still moving.
    if (isShown && this.bricks.moving) view.viewer.invalidate();
    this.#gaveWay = isShown && view.viewer.loop.dirty;
    void this.#waitForContext();
    this.#wake();
  }

  /** Scripts wait as long as the view may get its context again. */
  async #waitForContext(): Promise<void> {
    const { view } = this.parts;
    const { viewer } = view;
    const mayGetIt = (): boolean =>
      this.#users === 0 && this.bricks.moving && view.viewer === viewer && viewer?.volume === this.volume;
    while (mayGetIt()) await viewer!.loop.change();
    if (this.#users === 0) this.#settled?.();
  }

  /** More is to come for the present view: scripts that want its picture wait. */
  #begin(): void {
    if (!this.bricks.moving) {
      this.bricks.moving = true;
      this.#settled?.();
      this.#whenSettled = new Promise<void>((resolve) => (this.#settled = resolve));
      this.parts.view.track(this.#whenSettled);
      this.parts.view.viewer?.invalidate();
    }
    this.#wake();
  }

  /** All is there that the view gets: its picture is drawn once more, and measured. */
  #rest(): void {
    if (!this.bricks.moving) return;
    this.bricks.moving = false;
    this.parts.view.viewer?.invalidate();
    this.#settled?.();
  }

  async #run(life: AbortSignal): Promise<void> {
    const { errors } = this.parts.view;
    try {
      await this.#source.open(life);
      await this.#load(life);
    } catch (error) {
      if (life.aborted) return;
      errors.report('source', error);
      this.#loading?.close();
      this.#tiles.rest();
      this.#rest();
    }
  }

  /** Where one brick can't be read, many can't. */
  #reportOnce(error: unknown): void {
    if (!this.#hasFailed) this.parts.view.errors.report('source', error);
    this.#hasFailed = true;
  }

  /** Without a table, what bricks hide is learnt from those that come. */
  async #readTable(life: AbortSignal): Promise<void> {
    try {
      const found = await this.#source.readTable(life);
      if (found && !life.aborted) this.#detail.take(found.table, found.levels);
    } catch (error) {
      if (!life.aborted) this.parts.view.errors.report('source', error);
    }
  }

  #createLoading(life: AbortSignal): BrickLoading {
    const { bricks } = this;
    const { bytesOfBrick } = bricks;
    const capacity = (): number => this.#capacity;
    return new BrickLoading({
      bricks,
      bytesOfBrick,
      room: {
        get share() {
          return capacity() * bytesOfBrick;
        },
        enter: (changed) => pageRoom.enter(changed, this.#maxBytes),
        leave: (changed) => pageRoom.leave(changed),
      },
      read: async (brick, signal) => {
        const samples = await this.#source.read(brick, signal, true);
        this.#detail.measure(brick, samples);
        return samples;
      },
      changed: () => {
        if (life.aborted) return;
        bricks.fit(this.#capacity);
        this.#changes++;
        this.#begin();
        const { viewer } = this.parts.view;
        if (viewer) void this.#drawing.drawSoon(viewer, () => this.#users > 0 && bricks.moving);
      },
      grew: () => {
        if (bricks.count < bricks.capacity) return;
        bricks.fit(this.#capacity);
        this.#changes++;
        this.#begin();
      },
      failed: (error) => {
        this.#reportOnce(error);
        this.#wake();
      },
    });
  }

  async #load(life: AbortSignal): Promise<void> {
    const { bricks } = this;
    const loading = this.#loading!;
    let isAsking = true;
    void this.#readTable(life).finally(() => {
      isAsking = false;
      this.#changes++;
      this.#wake();
    });
    while (!life.aborted) {
      const picture = this.#picture;
      const changes = this.#changes;
      let isExchange = false;
      await inPieces(bricks.settle(), () => !life.aborted);
      const work = picture && (await this.#choice.estimate(this.volume, picture));
      const found = work && (await inPieces(work, () => !life.aborted));
      if (life.aborted) return;
      if (found) {
        const chosen = this.#choice.choose(found, {
          key: picture.key,
          maxError: this.parts.view.settings.quality.value?.maxError ?? 1,
          slots: this.#capacity,
          isAsking,
          isRefused: (brick) => loading.isRefused(brick),
        });
        ({ isExchange } = chosen);
        bricks.error = chosen.error;
        loading.drop(chosen.tooFine);
        loading.want({ missing: chosen.missing, worth: (brick) => found.gains.worth(brick) / bricks.bytesOfBrick });
        if (chosen.probes.length > 0) {
          await Promise.all(chosen.probes.map((brick) => this.#probe(brick, life)));
          continue;
        }
        this.#detail.forgetProbes();
        if (chosen.again) continue;
        const isFull = bricks.count >= this.#capacity && this.#changes === changes;
        if (isFull && chosen.missing.length > 0 && loading.requests === 0) {
          this.#choice.endExchanges();
          continue;
        }
      }
      const isOver = loading.requests === 0 && !isAsking;
      if (picture && isOver && this.#picture === picture && this.#changes === changes) this.#rest();
      // Until the list is used up, or there is another view.
      const isDue = (): boolean =>
        life.aborted ||
        this.#picture !== picture ||
        (loading.requests === 0 &&
          (this.#changes !== changes || (this.bricks.moving && !isAsking)) &&
          this.#picture !== null);
      while (!isDue()) await new Promise<void>((resolve) => (this.#wake = resolve));
      if (isExchange && !life.aborted) this.#choice.hasExchanged();
    }
  }

  /** Looks at a brick, without a place for it on the GPU. */
  async #probe(brick: Brick, life: AbortSignal): Promise<void> {
    try {
      const samples = await this.#source.read(brick, life, true);
      this.#detail.measure(brick, samples, true);
    } catch (error) {
      if (life.aborted) return;
      this.#choice.leaveOut(brick);
      this.#reportOnce(error);
    }
  }
}

/** What takes the volume of a view. */
export interface BrickLoader {
  readonly parts: { readonly presenter: SocketView };
}

/**
 * A coarse level of a pyramid with bricks of finer ones over it, for a view that will show it.
 * @param again - loads the volume as a whole: where labels lie over it, or the levels do not fit bricks
 */
export async function follow(
  pinned: Volume,
  request: LoadRequest,
  loader: BrickLoader,
  again: (request: LoadRequest) => Promise<Volume>,
): Promise<Volume> {
  const view = loader.parts.presenter;
  const isLabelled = pinned.isDiscrete || view.host.querySelector('volume-labels') !== null;
  const socket = socketOf(view.host);
  const bricked = isLabelled ? null : BrickView.create({ pinned, request, view, socket });
  // Already now: a scene that is filled when a part joins is filled again.
  if (bricked) void socket.join(bricked);
  return bricked?.volume ?? again({ ...request, finer: false });
}
