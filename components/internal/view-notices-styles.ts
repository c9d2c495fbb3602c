/** Styles of the sign for parts of a file that are not in the picture. They go into the shadow root of the element around it. */
export const noticeStyles = `
.notice {
  position: absolute;
  z-index: 2; /* Its text lies above the letters of a marker. */
  inset: 4px;
  inset-block-start: var(--_notice-top, 4px);
  container-type: size;
  display: flex;
  flex-direction: column;
  align-items: flex-end;
  pointer-events: none;
  color: var(--volume-view-notice-color, #f2f5fa);
}
:host(:is(:state(error), [data-state-error])) .notice {
  inset-block-start: 56px;
}
.notice > button {
  flex: none;
  display: grid;
  place-items: center;
  inline-size: 32px;
  block-size: 32px;
  min-block-size: 0;
  margin: 0;
  border: 0;
  padding: 0;
  border-radius: 50%;
  background: transparent;
  color: inherit;
  opacity: 0.75;
  cursor: pointer;
  pointer-events: auto;
  touch-action: manipulation;
}
.notice > button:is(:hover, :focus-visible, [aria-expanded='true']) {
  opacity: 1;
}
.notice :focus-visible {
  outline: 3px solid var(--volume-view-focus-color, #7db4ff);
  outline-offset: -3px;
}
.notice svg {
  inline-size: 20px;
  block-size: 20px;
  overflow: visible;
  fill: var(--volume-view-notice-background, rgb(13 16 22 / 0.86));
  stroke: currentColor;
  stroke-width: 2;
  stroke-linecap: round;
}
/* A thumbnail is not covered by its sign. */
@container (max-width: 150px) {
  .notice > button {
    inline-size: 16px;
    block-size: 16px;
  }
  .notice svg {
    inline-size: 12px;
    block-size: 12px;
  }
}
.notice .told {
  box-sizing: border-box;
  min-block-size: 0;
  max-inline-size: min(100%, 34em);
  overflow: auto;
  padding: 8px 12px;
  border-radius: 10px;
  background: var(--volume-view-notice-background, rgb(13 16 22 / 0.97));
  font: 13px / 1.4 system-ui, sans-serif;
  overflow-wrap: anywhere;
  pointer-events: auto;
  cursor: auto;
}
.notice .told[hidden] {
  display: none;
}
.notice p {
  margin: 0;
  font-weight: 600;
}
.notice ul {
  margin: 4px 0 0;
  padding-inline-start: 1.2em;
}
.notice li {
  unicode-bidi: plaintext;
  text-align: start;
}
@media print {
  .notice { display: none; }
}
@media (forced-colors: active) {
  .notice .told {
    border: 1px solid CanvasText;
  }
  .notice svg {
    fill: Canvas;
    stroke: CanvasText;
  }
}`;
