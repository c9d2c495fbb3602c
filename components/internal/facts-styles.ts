import { css } from 'lit';

/** Styles of a companion that lists facts and values: names next to their texts, a hint, and buttons below. */
export const factsStyles = css`
  :host {
    --_soft: color-mix(in srgb, currentColor 72%, transparent);
    --_line: color-mix(in srgb, currentColor 30%, transparent);

    display: block;
    position: relative;
    box-sizing: border-box;
    min-inline-size: 0;
    font: 14px / 1.45 system-ui, sans-serif;
    font-variant-numeric: tabular-nums;
  }

  :host([hidden]) {
    display: none;
  }

  dl {
    display: grid;
    grid-template-columns: max-content 1fr;
    column-gap: 1em;
    margin: 0;
  }

  /* Names and texts are the grid's cells. */
  .row {
    display: contents;
  }

  dt,
  .hint {
    color: var(--_soft);
  }

  dd {
    margin: 0;
    min-inline-size: 0;
    overflow-wrap: anywhere;
  }

  .swatch {
    inline-size: 0.8em;
    block-size: 0.8em;
    border-radius: 3px;
    box-shadow: 0 0 0 1px var(--_line);
    forced-color-adjust: none;
  }

  .tools {
    display: flex;
    margin-block-start: 0.5em;
  }

  button {
    flex: none;
    min-block-size: 44px;
    padding-inline: 0.9em;
    border: 1px solid var(--_line);
    border-radius: 6px;
    background: transparent;
    color: inherit;
    font: inherit;
    cursor: pointer;
  }

  button[aria-pressed='true'] {
    background: color-mix(in srgb, currentColor 16%, transparent);
  }

  button:focus-visible {
    outline: 2px solid var(--volume-view-focus-color, currentColor);
    outline-offset: 2px;
  }

  /* In a page written from right to left, English sentences and numbers with units keep their own direction. */
  p,
  .hint {
    unicode-bidi: plaintext;
  }
`;
