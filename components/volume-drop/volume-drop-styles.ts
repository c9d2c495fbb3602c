import { css } from 'lit';

export const styles = css`
  :host {
    display: block;
    font: inherit;
  }

  :host([hidden]) {
    display: none;
  }

  .drop {
    display: grid;
    gap: 0.6em;
    padding: 0.75em;
    border: 1px dashed color-mix(in srgb, currentcolor 45%, transparent);
    border-radius: 0.5em;
  }

  .over {
    border-style: solid;
    background: color-mix(in srgb, currentcolor 8%, transparent);
  }

  .buttons {
    display: flex;
    flex-wrap: wrap;
    gap: 0.5em;
  }

  button {
    min-block-size: 44px;
    padding: 0.2em 0.9em;
    border: 1px solid color-mix(in srgb, currentcolor 50%, transparent);
    border-radius: 0.4em;
    background: transparent;
    color: inherit;
    font: inherit;
    cursor: pointer;
  }

  button:hover {
    background: color-mix(in srgb, currentcolor 10%, transparent);
  }

  :focus-visible {
    outline: 2px solid var(--volume-view-focus-color, currentcolor);
    outline-offset: 1px;
  }

  p {
    margin: 0;
    font-size: 0.9em;
    unicode-bidi: plaintext;
  }

  .status:empty {
    display: none;
  }

  /* Over the picture, above all else of the page: files must fall through to it. */
  .frame {
    position: fixed;
    inset: auto;
    box-sizing: border-box;
    margin: 0;
    padding: 0;
    border: 3px dashed var(--volume-drop-color, #fff);
    border-radius: 0.5em;
    background: rgb(0 0 0 / 45%);
    color: var(--volume-drop-color, #fff);
    font: 600 1.1em system-ui, sans-serif;
    pointer-events: none;
  }

  .frame:popover-open {
    display: grid;
    place-items: center;
  }

  @media (forced-colors: active) {
    .frame {
      border-color: Highlight;
    }
  }
`;
