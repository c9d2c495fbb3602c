import { css } from 'lit';

export const styles = css`
  :host {
    --_soft: color-mix(in srgb, currentColor 72%, transparent);
    --_line: color-mix(in srgb, currentColor 30%, transparent);

    display: block;
    box-sizing: border-box;
    min-inline-size: 0;
    font: 12px / 1.4 system-ui, sans-serif;
    font-variant-numeric: tabular-nums;
  }

  :host([hidden]) {
    display: none;
  }

  :host([orientation='vertical']) {
    display: inline-block;
  }

  .hint {
    margin: 0;
    color: var(--_soft);
  }

  .title {
    display: flex;
    justify-content: space-between;
    gap: 1em;
    margin-block-end: 4px;
  }

  .unit {
    color: var(--_soft);
  }

  .upright .title {
    justify-content: start;
    gap: 0.5em;
    margin-block-end: 8px;
  }

  .bar {
    display: grid;
    overflow: hidden;
    border-radius: 5px;
    /* As behind a volume: pale colours stay visible on pale pages too. */
    background: var(--volume-legend-background, linear-gradient(#262d3a, #0d1016));
    box-shadow: 0 0 0 1px var(--_line);
  }

  svg {
    display: block;
    inline-size: 100%;
    block-size: 100%;
  }

  .opacity {
    opacity: 0.75;
  }

  .flat .bar {
    grid-template-rows: 26px 12px;
  }

  .upright .scale {
    display: flex;
    gap: 6px;
  }

  .upright .bar {
    grid-template-columns: 12px 26px;
    block-size: var(--volume-legend-length, 14rem);
  }

  .upright .colors {
    order: -1;
  }

  .channels ul {
    display: grid;
    gap: 4px 1.2em;
    grid-template-columns: repeat(auto-fill, minmax(min(100%, 15em), 1fr));
    margin: 0;
    padding: 0;
    list-style: none;
  }

  .channels li {
    display: flex;
    align-items: center;
    gap: 0.6em;
    min-inline-size: 0;
  }

  .channels bdi {
    overflow: hidden;
    text-overflow: ellipsis;
    white-space: nowrap;
  }

  .light {
    flex: none;
    inline-size: 3.2em;
    block-size: 1em;
    border-radius: 5px;
    background: linear-gradient(to right, #0d1016, var(--light));
    box-shadow: 0 0 0 1px var(--_line);
  }

  .window {
    flex: none;
    margin-inline-start: auto;
    color: var(--_soft);
    direction: ltr;
  }

  /* Values rise from left to right, and numbers are to the right of a vertical scale, in any writing direction of the page. */
  .scale {
    direction: ltr;
  }

  .ticks {
    position: relative;
    color: var(--_soft);
  }

  .flat .ticks {
    block-size: 1.7em;
    margin-block-start: 4px;
  }

  .offset {
    color: var(--_soft);
    white-space: nowrap;
  }

  .upright .ticks {
    min-inline-size: 3.2em;
  }

  .ticks span {
    position: absolute;
    white-space: nowrap;
  }

  /* Numbers at the ends stay within the length of the scale. */
  .flat .ticks span {
    inset-inline-start: calc(100% * var(--at));
    translate: calc(-100% * var(--shift)) 0;
  }

  .upright .ticks span {
    inset-block-end: calc(100% * var(--at));
    translate: 0 calc(100% * var(--shift));
  }

  /* In a page written from right to left, English sentences and numbers with units keep their own direction. */
  .title > *,
  .hint,
  .ticks span {
    unicode-bidi: plaintext;
  }

  @media (forced-colors: active) {
    .bar,
    .light {
      forced-color-adjust: none;
      outline: 1px solid CanvasText;
    }
  }
`;
