import { html, svg } from 'lit';
import type { Camera } from '../../src/optics/rays/camera.ts';
import { listSides, placeMarks } from '../../src/viewer/camera/orientation-marks.ts';
import type { OrientationMark } from '../../src/viewer/camera/orientation-marks.ts';
import type { StandardView } from '../../src/viewer/camera/standard-views.ts';
import type { VolumeInfo } from '../../src/viewer/model/volume-info.ts';
import type { ControlMessages } from '../../src/messages/messages.ts';

/** Distance from the middle to a letter, as a share of the side of the marker. */
const reach = 0.37;

/** A letter nearer to the middle than this share of `reach` is hidden where another letter is in front of it. */
const covered = 0.3;

/**
 * Letters around a point, as their directions are in the picture; each one turns the view to its side. Empty where the sides are unknown.
 */
export function renderMarker(
  volume: VolumeInfo,
  camera: Camera,
  messages: ControlMessages,
  turn: (view: StandardView) => void,
): unknown {
  const marks = placeMarks(camera, listSides(volume));
  if (marks.length === 0) return '';
  const button = ({ view, x, y, towards }: OrientationMark): unknown => html`<button
    type="button"
    part="marker-side"
    class="${towards < -0.05 ? 'back' : ''} ${towards < 0 && Math.hypot(x, y) < covered ? 'covered' : ''} ${view.name}"
    .style=${`left: ${percent(x)}; top: ${percent(-y)}; z-index: ${Math.round(4 + 4 * towards)}`}
    aria-label=${messages.view[view.name]}
    title=${messages.view[view.name]}
    @click=${() => turn(view)}
  >${messages.letter[view.name]}</button>`;
  return html`<div class="marker" part="marker" role="group" aria-label=${messages.orientation}>
    <svg viewBox="-50 -50 100 100" aria-hidden="true">${marks.map(({ x, y, towards }) => svg`<line x2=${100 * reach * x} y2=${-100 * reach * y} class=${towards < -0.05 ? 'back' : ''}></line>`)}</svg>
    ${marks.map(button)}
  </div>`;
}

function percent(share: number): string {
  return `${(50 + 100 * reach * share).toFixed(2)}%`;
}
