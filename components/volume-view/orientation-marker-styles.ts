import { css } from 'lit';

/** Styles of the marker in a corner of a picture. They are added to the styles of <volume-view> when the marker is loaded. */
export const styles = css`
  .marker {
    --_side: min(var(--volume-view-marker-size, 96px), 45%);

    position: absolute;
    inset-block-start: 8px;
    inset-inline-start: 8px;
    inline-size: var(--_side);
    aspect-ratio: 1;
    pointer-events: none;
    color: var(--volume-view-marker-color, #f2f5fa);
  }

  .marker svg {
    position: absolute;
    inset: 0;
    inline-size: 100%;
    block-size: 100%;
  }

  .marker line {
    stroke: currentColor;
    stroke-width: 1.5;
    opacity: 0.8;
  }

  .marker line.back {
    opacity: 0.35;
  }

  .marker button {
    position: absolute;
    translate: -50% -50%;
    box-sizing: border-box;
    inline-size: 24px;
    block-size: 24px;
    min-block-size: 0;
    margin: 0;
    border: 0;
    padding: 0;
    border-radius: 50%;
    background: var(--volume-view-marker-background, rgb(13 16 22 / 0.86));
    color: inherit;
    font: 600 13px / 1 system-ui, sans-serif;
    cursor: pointer;
    pointer-events: auto;
    touch-action: manipulation;
  }

  /* Touch areas are larger than the letters. */
  .marker button::before {
    content: '';
    position: absolute;
    inset: -6px;
  }

  .marker button.back {
    color: color-mix(in srgb, currentColor 62%, #0d1016);
    font-weight: 400;
  }

  .marker button.covered {
    opacity: 0;
    pointer-events: none;
  }

  .marker button:hover {
    background: var(--volume-view-marker-hover, rgb(66 78 98 / 0.95));
  }

  .marker button:focus-visible {
    z-index: 9 !important;
    opacity: 1;
    outline: 3px solid var(--volume-view-focus-color, #7db4ff);
    outline-offset: -1px;
  }

  @media (forced-colors: active) {
    .marker button {
      border: 1px solid ButtonText;
    }
  }
`;
