import type { Camera, Orbit } from '../../optics/rays/camera.ts';
import { orbitOf } from '../../optics/rays/camera.ts';
import { findCrosshair } from '../../panes/crosshair.ts';
import { placeFromEarth } from '../../radar/place-from-earth.ts';
import { add, subtract } from '../../volume/matrix.ts';
import type { Vector3 } from '../../volume/matrix.ts';
import { socketOf } from '../model/view-socket.ts';
import type { ViewPart } from '../model/view-socket.ts';
import type { TimeChangeDetail } from '../loading/scan-player.ts';
import { matchScan } from './match-scan.ts';
import { SharedCamera } from './shared-camera.ts';
import type { FollowingView } from './shared-camera.ts';

/** What a pair needs of its views. */
export interface PairedView extends HTMLElement {
  readonly times: readonly (string | null)[];
  readonly scan: TimeChangeDetail | null;
  readonly paused: boolean;
  pause(): void;
  showScan(index: number): void;
}

/** The camera of one view of a pair. */
class PairedCamera implements FollowingView {
  constructor(
    readonly view: PairedView,
    readonly first: PairedView,
  ) {}

  get camera(): Camera | null {
    const viewer = socketOf(this.view).view?.viewer;
    return viewer?.volume && viewer.scene ? viewer.rig.cameraAt(viewer.rig.goal) : null;
  }

  /** Radars measure from their antenna: where both say where it is, the second one lies there in the world of the first. */
  get origin(): Vector3 {
    const [here, there] = [this.first, this.view].map((view) => socketOf(view).volume?.radar?.site);
    const [from, to] = [here, there].map((site) =>
      site?.latitude === undefined || site.longitude === undefined
        ? null
        : { latitude: site.latitude, longitude: site.longitude },
    );
    return from && to && from !== to ? [...placeFromEarth(from, to), 0] : [0, 0, 0];
  }

  follow(camera: Camera): void {
    const viewer = socketOf(this.view).view!.viewer!;
    const { rig } = viewer;
    const { theta, phi, radius }: Orbit = orbitOf(camera);
    rig.turnTo(theta, phi); // By the shorter way, and around the axis of the world.
    rig.aim({ ...rig.goal, radius, target: camera.target, fieldOfView: camera.fieldOfView }, true);
    viewer.invalidate();
  }
}

/** Keeps two views together: camera, time, and the crosshair of their panes. @returns a function that ends it */
export function pair(first: PairedView, second: PairedView): () => void {
  const views = [first, second] as const;
  const cameras = views.map((view) => new PairedCamera(view, first)) as [PairedCamera, PairedCamera];
  const shared = new SharedCamera(cameras);
  const abort = new AbortController();
  const { signal } = abort;
  /** The scans that views were sent to: they do not lead for these. */
  const sent = [-1, -1];
  let isMoving = false;
  views.forEach((view, i) => {
    const [index, other] = [i as 0 | 1, views[1 - i]];
    const part: ViewPart = { key: 'compare', place: () => shared.update(index) };
    void socketOf(view).join(part);
    view.addEventListener(
      'time-change',
      () => {
        const { scan } = view;
        if (!scan || scan.index === sent[index]) return;
        sent[index] = -1;
        if (other.times.length < 2) return;
        const match = matchScan(scan.time, scan.index, other.times);
        if (match === other.scan?.index) return;
        if (!other.paused) other.pause();
        sent[1 - i] = match;
        other.showScan(match);
      },
      { signal },
    );
    const crosshairs = [findCrosshair(null, view), findCrosshair(null, other)];
    const ignore = crosshairs[0].listen(() => {
      const { place } = crosshairs[0];
      if (!place || isMoving) return;
      isMoving = true; // The other crosshair does not send this one back by a rounding.
      crosshairs[1].moveTo(subtract(add(place, cameras[index].origin), cameras[1 - i].origin));
      isMoving = false;
    });
    signal.addEventListener('abort', () => {
      ignore();
      void socketOf(view).leave(part);
    });
  });
  return () => abort.abort();
}
