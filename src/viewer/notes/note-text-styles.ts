/** Styles of the text that a note opens, over a picture and in a pane. */
export const noteTextStyles = `
.note-text {
  position: absolute;
  inset: 0 auto auto 0;
  z-index: 3;
  box-sizing: border-box;
  inline-size: max-content;
  max-inline-size: min(22em, 100% - 16px);
  max-block-size: 70%;
  overflow: auto;
  padding: 10px 14px;
  border-radius: 10px;
  background: var(--_panel, var(--volume-note-text-background, rgb(13 16 22 / 0.95)));
  color: var(--_text, var(--volume-note-text-color, #f4f7fb));
  font: 13px / 1.35 system-ui, sans-serif;
  box-shadow: 0 3px 16px rgb(0 0 0 / 0.4);
  overflow-wrap: anywhere;
  cursor: auto;
  pointer-events: auto;
  user-select: text;
  -webkit-user-select: text;
}
.note-text:focus-visible {
  outline: 3px solid var(--volume-view-focus-color, #7db4ff);
}`;
