import { css } from 'lit';

/** Styles of an element that stands in a page as a block, with an error in words. */
export const blockStyles = css`
  :host {
    display: block;
    box-sizing: border-box;
    min-inline-size: 0;
  }

  :host([hidden]) {
    display: none;
  }

  .error {
    margin: 0 0 8px;
    padding: 0.75em 1em;
    background: var(--volume-view-error-background, rgb(60 14 14 / 0.94));
    color: var(--volume-view-error-color, #fff1ee);
    unicode-bidi: plaintext;
    overflow-wrap: anywhere;
  }
`;

/** Styles of buttons between the texts of a page: they have its colours. `--_line` is the colour of a thin line. */
export const textButtonStyles = css`
  :host {
    --_line: color-mix(in srgb, currentColor 45%, transparent);
  }

  button {
    box-sizing: border-box;
    margin: 0;
    border: 1px solid var(--_line);
    border-radius: 8px;
    background: transparent;
    color: inherit;
    font: inherit;
    cursor: pointer;
    touch-action: manipulation;
  }

  button:hover:enabled {
    border-color: currentColor;
  }

  button:focus-visible {
    outline: 2px solid var(--volume-view-focus-color, currentColor);
    outline-offset: 2px;
  }
`;
