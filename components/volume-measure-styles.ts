import { css } from 'lit';
import { spokenStyles } from './spoken-styles.ts';

const ownStyles = css`
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

  .name {
    display: flex;
    align-items: center;
    gap: 0.5em;
    margin: 0;
    font-weight: 600;
  }

  .swatch {
    inline-size: 0.8em;
    block-size: 0.8em;
    border-radius: 3px;
    box-shadow: 0 0 0 1px var(--_line);
    forced-color-adjust: none;
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

  .hint,
  .problem {
    margin: 0.25em 0 0;
  }

  .problem {
    padding: 0.5em 0.75em;
    background: var(--volume-view-error-background, rgb(60 14 14 / 0.94));
    color: var(--volume-view-error-color, #fff1ee);
    overflow-wrap: anywhere;
  }

  .tools {
    display: flex;
    flex-wrap: wrap;
    gap: 0.5em;
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
`;

export const styles = [ownStyles, spokenStyles];
