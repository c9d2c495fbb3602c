import { noteTextStyles } from './note-text-styles.ts';

/** Styles of notes over a picture. They go into the shadow root of the view. */
export const noteStyles = `
.notes, .pins {
  position: absolute;
  inset: 0;
  pointer-events: none;
}
.notes {
  overflow: clip;
  font: 13px / 1.35 system-ui, sans-serif;
}
.pins svg {
  position: absolute;
  inset: 0;
  inline-size: 100%;
  block-size: 100%;
  overflow: visible;
}
.pins path {
  fill: none;
  stroke: var(--_line, var(--volume-note-line-color, #fff));
  stroke-width: 1.25;
  stroke-opacity: 0.85;
}
.pins path[data-sight='veiled'], .pins path[data-sight='hidden'] {
  stroke-dasharray: 2 4;
}
.pins path.active {
  stroke-width: 2.25;
  stroke-opacity: 1;
}
.pin {
  position: absolute;
  translate: -50% -50%;
  box-sizing: border-box;
  inline-size: 9px;
  block-size: 9px;
  border: 1.5px solid #fff;
  border-radius: 50%;
  background: var(--_color, var(--volume-note-color, #2f7de1));
  box-shadow: 0 0 0 1.5px rgb(13 16 22 / 0.8);
  cursor: pointer;
  pointer-events: auto;
}
.pin::after {
  content: '';
  position: absolute;
  inset: -8px;
}
.pin[data-sight='veiled'] { opacity: 0.7; }
.pin[data-sight='hidden'] { opacity: 0.45; }
.pin.active {
  scale: 1.5;
  opacity: 1;
}
.pins .away:not(.active), .pins .out {
  display: none;
}
.note {
  position: absolute;
  inset: 0 auto auto 0;
  box-sizing: border-box;
  display: flex;
  gap: 6px;
  align-items: center;
  block-size: var(--_line-height);
  min-block-size: 0;
  min-inline-size: var(--_line-height);
  max-inline-size: var(--_max-width);
  margin: 0;
  border: 0;
  padding: 0 9px;
  border-radius: 999px;
  background: var(--_background, var(--volume-note-background, rgb(13 16 22 / 0.82)));
  color: var(--_text, var(--volume-note-text-color, #f4f7fb));
  font: inherit;
  font-weight: 550;
  text-align: start;
  white-space: nowrap;
  cursor: pointer;
  pointer-events: auto;
  touch-action: manipulation;
  -webkit-tap-highlight-color: transparent;
}
.note bdi {
  overflow: hidden;
  text-overflow: ellipsis;
}
.note .number {
  display: none;
  font-variant-numeric: tabular-nums;
}
.note .number:only-child, .notes.short .number {
  display: block;
}
.notes.short .note {
  justify-content: center;
  padding: 0 2px;
}
.notes.short .note:not(:hover, :focus-visible, [aria-expanded='true']) .number + bdi {
  position: absolute;
  inline-size: 1px;
  clip-path: inset(50%);
}
.notes.short .note:is(:hover, :focus-visible, [aria-expanded='true']) {
  padding-inline: 9px;
  z-index: 2;
}
.note[data-sight='veiled'] { opacity: 0.78; }
.note[data-sight='hidden'] { opacity: 0.6; }
.note.away:not(:focus-visible, .active) {
  opacity: 0;
  pointer-events: none;
}
.note.active, .note:hover, .note[aria-expanded='true'] {
  opacity: 1;
  background: var(--_active, var(--volume-note-active-background, #1d5fb8));
}
.note:focus-visible {
  z-index: 2;
  opacity: 1;
  outline: 3px solid var(--volume-view-focus-color, #7db4ff);
  outline-offset: 1px;
}
${noteTextStyles}
.note-text[hidden] {
  display: none;
}
.note-text > :first-child, .note-text ::slotted(*) {
  margin-block: 0;
}
@media (any-pointer: coarse) {
  /* A finger finds a text although it is low. */
  .note::after {
    content: '';
    position: absolute;
    inset: -2px -6px;
  }
}
@media (forced-colors: active) {
  .note, .note-text {
    border: 1px solid CanvasText;
  }
  .pins path {
    stroke: CanvasText;
  }
  .pin {
    border-color: CanvasText;
    background: Highlight;
  }
}
@media print {
  :host {
    block-size: auto !important;
    max-block-size: none !important;
    aspect-ratio: auto !important;
    contain: none !important;
    overflow: visible !important;
  }
  :host::before {
    aspect-ratio: var(--_noted-aspect, 4 / 3);
  }
  .picture, .pins {
    inset-block-end: auto;
    block-size: auto;
    aspect-ratio: var(--_noted-aspect, 4 / 3);
  }
  .notes {
    position: static;
    overflow: visible;
    padding-block-start: 4px;
    background: #fff;
  }
  .notes .note.linked { display: none; }
  .pins path { display: none; }
  .pins .pin, .pins .pin.away {
    display: block;
    inline-size: 18px;
    block-size: 18px;
    border: 0;
    opacity: 1;
    scale: none;
    background: #fff;
    color: #000;
    font: 700 11px / 18px system-ui, sans-serif;
    text-align: center;
  }
  .pins .pin.out { display: none; }
  .pin::after {
    content: attr(data-number);
    position: static;
  }
  .notes .note, .notes .note.away:not(:focus-visible, .active) {
    position: static;
    opacity: 1;
    block-size: auto;
    max-inline-size: none;
    padding: 6px 0 0;
    background: none;
    color: #000;
    transform: none !important;
    white-space: normal;
  }
  .notes .note .number { display: block; }
  .notes.short .note .number + bdi {
    position: static !important;
    inline-size: auto !important;
    clip-path: none !important;
  }
  .note-text, .note-text[hidden] {
    display: block;
    position: static;
    inline-size: auto;
    max-inline-size: none;
    max-block-size: none;
    overflow: visible;
    padding: 0;
    background: none;
    color: #000;
    box-shadow: none;
    transform: none !important;
    break-inside: avoid;
  }
}`;
