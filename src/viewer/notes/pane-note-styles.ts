import { noteTextStyles } from './note-text-styles.ts';

/** Styles of notes in a pane of a slice. They go into the shadow root of the pane. */
export const paneNoteStyles = `
.notes {
  position: absolute;
  inset: 0;
  overflow: clip;
  direction: ltr;
  pointer-events: none;
}
.notes [hidden], .notes[hidden] {
  display: none;
}
.pin {
  position: absolute;
  inset: 0 auto auto 0;
  inline-size: 10px;
  block-size: 10px;
  min-block-size: 0;
  margin: -5px 0 0 -5px;
  border: 0;
  padding: 0;
  background: none;
  color: #fff;
  font: 550 12px / 20px system-ui, sans-serif;
  cursor: pointer;
  touch-action: manipulation;
  -webkit-tap-highlight-color: transparent;
}
.pin::before {
  content: '';
  position: absolute;
  inset: 0;
  box-sizing: border-box;
  border: 1.5px solid #fff;
  border-radius: 50%;
  background: var(--_color, var(--volume-note-color, #2f7de1));
  box-shadow: 0 0 0 1.5px rgb(13 16 22 / 0.8);
}
/* What a finger hits. */
.pin::after {
  content: '';
  position: absolute;
  inset: -7px;
  border-radius: 50%;
  pointer-events: auto;
}
.pin bdi {
  position: absolute;
  inset-block-start: -5px;
  max-inline-size: 16em;
  overflow: hidden;
  padding: 0 6px;
  border-radius: 999px;
  background: rgb(13 16 22 / 0.72);
  white-space: nowrap;
  text-overflow: ellipsis;
  pointer-events: auto;
}
.pin.near {
  opacity: 0.4;
}
.pin.near::before {
  scale: 0.7;
}
.pin.near::after {
  pointer-events: none;
}
.pin.near bdi, .pin.crowded:not(:hover, :focus-visible, .active) bdi {
  visibility: hidden;
}
.pin:is(:hover, :focus-visible, .active):not(.near) {
  z-index: 2;
}
.pin:is(:hover, .active) bdi {
  background: var(--volume-note-active-background, #1d5fb8);
}
.pin.active::before {
  scale: 1.3;
}
.pin:focus-visible {
  outline: none;
}
.pin:focus-visible::before {
  outline: 3px solid var(--volume-view-focus-color, #7db4ff);
  outline-offset: 2px;
}
${noteTextStyles}
.note-text > :first-child {
  margin-block-start: 0;
}
.note-text > :last-child {
  margin-block-end: 0;
}
@media (forced-colors: active) {
  .pin::before {
    border-color: CanvasText;
    background: Highlight;
  }
  .pin bdi, .note-text {
    border: 1px solid CanvasText;
  }
}`;
