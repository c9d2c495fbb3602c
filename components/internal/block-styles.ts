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
