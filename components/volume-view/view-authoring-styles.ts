/** Styles of the panel for authors of notes. They go into the shadow root of the view. */
export const authoringStyles = `
.authoring {
  position: absolute;
  z-index: 4;
  inset-block-start: 8px;
  inset-inline: 8px;
  box-sizing: border-box;
  inline-size: fit-content;
  max-inline-size: min(27em, 100% - 16px);
  margin-inline: auto;
  display: grid;
  grid-template-columns: minmax(0, 1fr);
  gap: 6px;
  padding: 6px;
  border-radius: 10px;
  background: var(--volume-view-controls-background, rgb(13 16 22 / 0.97));
  color: var(--volume-view-controls-color, #f2f5fa);
}
.authoring:has(textarea) {
  inline-size: 100%;
}
.authoring.low {
  inset-block: auto 8px;
  margin-inline: 0 auto;
}
.authoring .line {
  display: flex;
  align-items: center;
  gap: 4px;
}
.authoring p {
  margin: 0 6px;
}
.authoring .said {
  font-size: 13px;
}
.authoring button, .authoring input[type='text'], .authoring textarea {
  box-sizing: border-box;
  margin: 0;
  border: 1px solid color-mix(in srgb, currentColor 40%, transparent);
  border-radius: 7px;
  background: transparent;
  color: inherit;
  font: inherit;
}
.authoring button {
  flex: none;
  display: grid;
  place-items: center;
  min-inline-size: 44px;
  min-block-size: 44px;
  padding: 0 10px;
  border-color: transparent;
  cursor: pointer;
  touch-action: manipulation;
}
.authoring .copy, .authoring .wide {
  border-color: color-mix(in srgb, currentColor 40%, transparent);
}
.authoring button:hover {
  background: rgb(255 255 255 / 0.14);
}
.authoring svg {
  inline-size: 22px;
  block-size: 22px;
  fill: none;
  stroke: currentColor;
  stroke-width: 1.8;
  stroke-linecap: round;
}
.authoring input[type='text'] {
  flex: 1;
  min-inline-size: 0;
  min-block-size: 44px;
  padding: 0 10px;
}
.authoring input::placeholder {
  color: inherit;
  opacity: 0.7;
}
.authoring .middle {
  display: flex;
  align-items: center;
  gap: 8px;
  min-block-size: 28px;
  margin-inline: 6px;
}
.authoring .middle input {
  flex: none;
  inline-size: 18px;
  block-size: 18px;
  margin: 0;
}
.authoring textarea {
  inline-size: 100%;
  padding: 6px 8px;
  font: 12px / 1.4 ui-monospace, monospace;
  overflow-wrap: anywhere;
  resize: none;
  field-sizing: content;
  min-block-size: calc(2lh + 14px);
  max-block-size: calc(4lh + 14px);
}
.authoring :focus-visible {
  outline: 3px solid var(--volume-view-focus-color, #7db4ff);
  outline-offset: -2px;
}
@media (forced-colors: active) {
  .authoring { border: 1px solid CanvasText; }
}
@media print {
  .authoring { display: none; }
}`;
