import { applySheet } from './apply-sheet.ts';

const styles = `
.handles {
  position: absolute;
  inset: 0;
  overflow: clip;
  pointer-events: none;
}
.handle {
  position: absolute;
  translate: -50% -50%;
  box-sizing: border-box;
  inline-size: 24px;
  block-size: 24px;
  min-block-size: 0;
  margin: 0;
  border: 0;
  padding: 0;
  border-radius: 50%;
  background: transparent;
  cursor: move;
  pointer-events: auto;
  touch-action: none;
  user-select: none;
  -webkit-user-select: none;
  -webkit-tap-highlight-color: transparent;
}
.handle::before {
  content: '';
  position: absolute;
  inset: 50%;
  margin: -7px;
  border: 2px solid #fff;
  border-radius: 50%;
  background: var(--_color, var(--volume-view-handle-color, #2f7de1));
  box-shadow: 0 0 0 1.5px #10141c, inset 0 0 0 1px #10141c;
}
.handle:hover::before {
  margin: -8px;
}
.handle:focus-visible {
  z-index: 1;
  outline: 3px solid var(--volume-view-focus-color, #7db4ff);
  outline-offset: -2px;
  box-shadow: 0 0 0 2px #10141c;
}
@media (any-pointer: coarse) {
  .handle {
    inline-size: 44px;
    block-size: 44px;
  }
}
@media (forced-colors: active) {
  .handle::before {
    border-color: ButtonText;
    background: ButtonFace;
  }
}
@media print {
  .handles {
    display: none;
  }
}`;

/** Give a view's shadow root the styles of its handles. */
export function applyHandleStyles(root: ShadowRoot): void {
  applySheet(root, styles);
}
