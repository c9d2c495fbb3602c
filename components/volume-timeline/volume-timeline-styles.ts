import { css } from 'lit';

export const styles = css`
  :host {
    --_soft: color-mix(in srgb, currentColor 72%, transparent);
    --_line: color-mix(in srgb, currentColor 30%, transparent);
    --_thumb: 18px;

    display: block;
    box-sizing: border-box;
    min-inline-size: 0;
    font: 14px / 1.4 system-ui, sans-serif;
    font-variant-numeric: tabular-nums;
    container-type: inline-size;
  }

  :host([hidden]) {
    display: none;
  }

  .timeline {
    display: grid;
    grid-template: auto / auto minmax(7.5rem, auto) minmax(0, 1fr);
    align-items: center;
    gap: 8px 16px;
  }

  /* Time runs from left to right, as in most media players. */
  .buttons,
  .track {
    direction: ltr;
  }

  .buttons {
    display: flex;
    gap: 4px;
  }

  button {
    display: grid;
    place-items: center;
    inline-size: 40px;
    block-size: 40px;
    margin: 0;
    padding: 0;
    border: 1px solid var(--_line);
    border-radius: 8px;
    background: transparent;
    color: inherit;
    cursor: pointer;
    touch-action: manipulation;
  }

  button:hover:enabled {
    border-color: currentColor;
  }

  button:disabled {
    color: var(--_line);
    cursor: default;
  }

  button:focus-visible,
  input:focus-visible {
    outline: 2px solid var(--volume-view-focus-color, currentColor);
    outline-offset: 2px;
  }

  svg {
    inline-size: 20px;
    block-size: 20px;
    fill: currentColor;
  }

  .time {
    display: grid;
    grid-template-columns: auto auto;
    justify-content: space-between;
    column-gap: 1em;
    align-items: baseline;
    line-height: 1.25;
  }

  .problem {
    grid-column: 1 / -1;
    margin: 0;
    padding: 0.5em 0.75em;
    background: var(--volume-view-error-background, rgb(60 14 14 / 0.94));
    color: var(--volume-view-error-color, #fff1ee);
  }

  .clock {
    font-size: 1.3em;
    font-weight: 600;
  }

  .day,
  .count,
  .hint {
    color: var(--_soft);
    font-size: 12px;
    white-space: nowrap;
  }

  .day {
    grid-area: 2 / 1 / 3 / 3;
  }

  .count {
    grid-area: 1 / 2;
  }

  .hint {
    grid-column: 1 / 3;
    white-space: normal;
  }

  .track {
    position: relative;
    min-inline-size: 0;
  }

  input {
    display: block;
    box-sizing: border-box;
    inline-size: 100%;
    block-size: 24px;
    margin: 0;
    appearance: none;
    border-radius: 4px;
    background: transparent;
    color: inherit;
    cursor: pointer;
  }

  input:disabled {
    opacity: 0.4;
    cursor: default;
  }

  input::-webkit-slider-runnable-track {
    block-size: 4px;
    border-radius: 2px;
    background: var(--_line);
  }

  input::-moz-range-track {
    block-size: 4px;
    border-radius: 2px;
    background: var(--_line);
  }

  input::-webkit-slider-thumb {
    appearance: none;
    inline-size: var(--_thumb);
    block-size: var(--_thumb);
    margin-block-start: -7px;
    border: 0;
    border-radius: 50%;
    background: var(--volume-timeline-accent, currentColor);
  }

  input::-moz-range-thumb {
    inline-size: var(--_thumb);
    block-size: var(--_thumb);
    border: 0;
    border-radius: 50%;
    background: var(--volume-timeline-accent, currentColor);
  }

  /* It is loading. The animation starts after a delay, or it would flicker with every scan. */
  [aria-busy='true'] input {
    animation: wait 1s 0.3s ease-in-out infinite alternate;
  }

  @keyframes wait {
    to {
      opacity: 0.35;
    }
  }

  .ticks {
    position: relative;
    block-size: 1.9em;
    margin-inline: calc(var(--_thumb) / 2);
    font-size: 11px;
    color: var(--_soft);
  }

  .tick {
    position: absolute;
    inset-block-start: 0;
    inset-inline-start: calc(100% * var(--at));
    inline-size: 1px;
    block-size: 5px;
    background: var(--_line);
  }

  /* Names at the ends stay within the length of the slider. */
  .name {
    position: absolute;
    inset-block-start: 6px;
    white-space: nowrap;
    translate: calc(-9px + (18px - 100%) * var(--at)) 0;
  }

  @container (max-width: 34rem) {
    .timeline {
      grid-template: auto auto / auto minmax(0, 1fr);
    }

    .track {
      grid-column: 1 / 3;
    }
  }

  @media (prefers-reduced-motion: reduce) {
    [aria-busy='true'] input {
      animation: none;
      opacity: 0.6;
    }
  }

  @media (forced-colors: active) {
    input::-webkit-slider-runnable-track {
      background: CanvasText;
    }

    input::-moz-range-track {
      background: CanvasText;
    }

    input::-webkit-slider-thumb {
      background: Highlight;
    }

    input::-moz-range-thumb {
      background: Highlight;
    }

    button:disabled {
      color: GrayText;
    }

    .tick {
      background: CanvasText;
    }
  }

  /* In a page written from right to left, English sentences and numbers with units keep their own direction. */
  .hint {
    unicode-bidi: plaintext;
  }
`;
