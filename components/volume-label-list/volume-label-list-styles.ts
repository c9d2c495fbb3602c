import { css } from 'lit';
import { spokenStyles } from '../internal/spoken-styles.ts';

export const styles = [
  spokenStyles,
  css`
  :host {
    display: block;
    position: relative;
    font: inherit;
  }

  :host([hidden]) {
    display: none;
  }

  .list {
    display: flex;
    flex-direction: column;
    gap: 0.5em;
    block-size: 100%;
  }

  .tools {
    display: flex;
    flex-wrap: wrap;
    gap: 0.5em;
  }

  input[type='search'] {
    flex: 1 1 8em;
    min-inline-size: 0;
    box-sizing: border-box;
    min-block-size: 2em;
    padding: 0.2em 0.5em;
    border: 1px solid color-mix(in srgb, currentcolor 50%, transparent);
    border-radius: 0.3em;
    background: transparent;
    color: inherit;
    font: inherit;
  }

  input::placeholder {
    color: inherit;
    opacity: 0.75;
  }

  button {
    min-block-size: 2em;
    padding: 0.1em 0.6em;
    border: 1px solid color-mix(in srgb, currentcolor 50%, transparent);
    border-radius: 0.3em;
    background: transparent;
    color: inherit;
    font: inherit;
    cursor: pointer;
  }

  ul {
    margin: 0;
    padding: 0;
    overflow: auto;
    overscroll-behavior: contain;
    min-block-size: 0;
    max-block-size: var(--volume-label-list-height, 20rem);
    list-style: none;
  }

  /* Of a thousand rows, only the visible ones are laid out. */
  li {
    display: flex;
    align-items: center;
    gap: 0.5em;
    min-block-size: 2.1em;
    padding-inline: 0.25em;
    content-visibility: auto;
    contain-intrinsic-size: auto 2.1em;
  }

  li:hover {
    background: color-mix(in srgb, currentcolor 8%, transparent);
  }

  label {
    display: flex;
    flex: 1 1 auto;
    align-items: center;
    gap: 0.5em;
    min-inline-size: 0;
    padding-block: 0.25em;
    cursor: pointer;
  }

  input[type='checkbox'] {
    flex: none;
    inline-size: 1.15em;
    block-size: 1.15em;
    margin: 0;
    accent-color: var(--volume-label-list-accent, auto);
  }

  .swatch {
    flex: none;
    inline-size: 1em;
    block-size: 1em;
    border: 1px solid color-mix(in srgb, currentcolor 50%, transparent);
    border-radius: 0.2em;
  }

  bdi {
    min-inline-size: 0;
    overflow-wrap: anywhere;
  }

  .only {
    flex: none;
    font-size: 0.85em;
  }

  .count,
  .hint {
    margin: 0;
    font-size: 0.9em;
    unicode-bidi: plaintext; /* English text in a page written from right to left. */
  }

  :focus-visible {
    outline: 2px solid var(--volume-view-focus-color, currentcolor);
    outline-offset: -2px;
  }

  @media (pointer: coarse) {
    li {
      min-block-size: 2.75em;
      contain-intrinsic-size: auto 2.75em;
    }

    button,
    input[type='search'] {
      min-block-size: 2.75em;
    }
  }

  @media (forced-colors: active) {
    .swatch {
      forced-color-adjust: none;
    }
  }
`,
];
