// The line at the lower edge of a picture while a finer one is in progress: loaded with the first picture that takes long.
import type { RenderStats } from '../model/render-stats.ts';
import { applySheet } from '../overlays/apply-sheet.ts';

/** An element whose pictures become finer at rest. */
export interface RefinedView extends HTMLElement {
  readonly renderStats: RenderStats | null;
  readonly paused: boolean;
}

const styles = `
.refining {
  position: absolute;
  inset-inline: 0;
  inset-block-end: 0;
  block-size: 3px;
  overflow: hidden;
  pointer-events: none;
  background: rgb(128 128 128 / 0.3);
}
.refining > div {
  block-size: 100%;
  inline-size: calc(100% * var(--_share, 0.25));
  background: var(--volume-view-refining-color, #9db8de);
  transition: inline-size 0.2s linear;
}
.refining > .unknown {
  animation: refining 1.6s ease-in-out infinite alternate;
}
@keyframes refining {
  to { margin-inline-start: 75%; }
}
@media (prefers-reduced-motion: reduce) {
  .refining > div {
    animation: none;
    transition: none;
  }
}
@media (forced-colors: active) {
  .refining {
    background: Canvas;
    border-block-start: 1px solid CanvasText;
  }
  .refining > div {
    forced-color-adjust: none;
    background: Highlight;
  }
}
@media print {
  .refining { display: none; }
}`;

/** How often the sign is updated, ms: it stays while the picture is coarse, and nothing runs after that. */
const pace = 100;

/**
 * Show that a finer picture is in progress, and its progress where it is known; resolves when the picture is final.
 * @param refined - returns the pictures; null where no finer one is in progress
 */
export async function showSign(
  view: RefinedView,
  refined: () => { readonly gathered: number | null } | null,
): Promise<void> {
  const { shadowRoot: root, ownerDocument: document } = view;
  if (!root) return;
  applySheet(root, styles);
  const sign = document.createElement('div');
  sign.className = 'refining';
  sign.setAttribute('part', 'refining');
  sign.ariaHidden = 'true'; // Screen readers report what the picture shows, and the sign does not change that.
  const line = sign.appendChild(document.createElement('div'));
  root.append(sign);
  // At the final picture the sign goes at once: who waits for `whenRendered()` may take a screenshot.
  const removeWhenFinal = (): void => void (refined() || sign.remove());
  view.addEventListener('render', removeWhenFinal);
  for (let pictures = refined(); pictures; pictures = refined()) {
    const { gathered } = pictures;
    line.classList.toggle('unknown', gathered === null);
    if (gathered === null) line.style.removeProperty('--_share');
    else line.style.setProperty('--_share', gathered.toFixed(3));
    await new Promise((resolve) => setTimeout(resolve, pace));
  }
  view.removeEventListener('render', removeWhenFinal);
  sign.remove();
}
