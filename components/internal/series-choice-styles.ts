import { css } from 'lit';

/** Styles of the list of series. */
export const seriesChoiceStyles = css`
  .series {
    display: grid;
    grid-template-columns: repeat(auto-fill, minmax(min(100%, 15em), 1fr));
    gap: 0.4em;
    margin: 0;
    padding: 2px;
    max-block-size: var(--volume-series-height, 20rem);
    overflow: auto;
    overscroll-behavior: contain;
    list-style: none;
  }

  .series label {
    display: flex;
    align-items: center;
    gap: 0.6em;
    min-block-size: 44px;
    padding: 0.3em 0.5em;
    border: 1px solid color-mix(in srgb, currentcolor 30%, transparent);
    border-radius: 0.4em;
    cursor: pointer;
  }

  .series label:hover {
    background: color-mix(in srgb, currentcolor 8%, transparent);
  }

  .series label:has(:checked) {
    border-color: currentcolor;
    background: color-mix(in srgb, currentcolor 10%, transparent);
  }

  .series input {
    flex: none;
    inline-size: 1.15em;
    block-size: 1.15em;
    margin: 0;
    accent-color: var(--volume-series-accent, auto);
  }

  .series label:has(:focus-visible) {
    outline: 2px solid var(--volume-view-focus-color, currentcolor);
  }

  .series input:focus-visible {
    outline: none;
  }

  .picture {
    display: grid;
    flex: none;
    place-items: center;
    inline-size: 48px;
    block-size: 48px;
    overflow: hidden;
    border-radius: 0.25em;
    background: #000;
  }

  canvas {
    max-inline-size: 48px;
    max-block-size: 48px;
    inline-size: 48px;
    object-fit: contain;
  }

  .words {
    display: grid;
    min-inline-size: 0;
    font-variant-numeric: tabular-nums;
  }

  .words > bdi {
    overflow-wrap: anywhere;
    font-size: 0.9em;
    opacity: 0.8;
  }

  .words > .name {
    font-size: 1em;
    font-weight: 600;
    opacity: 1;
  }
`;
