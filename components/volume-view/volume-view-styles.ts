import { css } from 'lit';

export const styles = css`
  :host {
    display: block;
    position: relative;
    box-sizing: border-box;
    /* Not "hidden": the browser could scroll such a box to show the element with the focus. */
    overflow: clip;
    min-inline-size: 0;
    min-block-size: 0;
    max-block-size: 100vh;
    /* Where nothing sets the width, it is that of replaced elements; the contents never change it. */
    contain: inline-size layout paint style;
    contain-intrinsic-inline-size: min(300px, 100vw);
    color: #e8ecf2;
    background: radial-gradient(circle at 50% 45%, #262d3a, #0d1016 75%);
    font: 14px / 1.45 system-ui, sans-serif;
    /* The picture keeps its background on paper too. */
    -webkit-print-color-adjust: exact;
    print-color-adjust: exact;
  }

  :host([hidden]) {
    display: none;
  }

  /* The height where nothing sets it. An aspect ratio on the host itself would override the insets of an absolute box, and would make a
     box with a set height narrow. */
  :host::before {
    content: '';
    display: block;
    inline-size: 100%;
    aspect-ratio: 4 / 3;
  }

  .picture,
  .scene,
  .poster,
  x3d,
  canvas {
    position: absolute;
    inset: 0;
    inline-size: 100%;
    block-size: 100%;
    margin: 0;
    border: 0;
    padding: 0;
    display: block;
  }

  .picture {
    outline: none;
  }

  .picture[tabindex] {
    cursor: grab;
    touch-action: pan-y;
    user-select: none;
    -webkit-user-select: none;
  }

  .picture[tabindex]:active {
    cursor: grabbing;
  }

  .picture:focus-visible::after {
    content: '';
    position: absolute;
    inset: 0;
    border: 3px solid var(--volume-view-focus-color, #7db4ff);
    box-shadow: inset 0 0 0 2px #0d1016;
    pointer-events: none;
  }

  .scene,
  .labels {
    pointer-events: none;
  }

  .labels {
    position: absolute;
    inset: 0;
    overflow: hidden;
  }

  .labels span {
    position: absolute;
    translate: -50% -50%;
    font-size: 12px;
    line-height: 1;
    white-space: nowrap;
    color: var(--volume-view-label-color, #fff);
    text-shadow: 0 0 3px #000, 0 0 2px #000, 0 1px 1px #000;
  }

  .poster {
    object-fit: contain;
    pointer-events: none;
  }

  .progress {
    position: absolute;
    inset-inline: 0;
    inset-block-end: 0;
    pointer-events: none;
  }

  progress {
    display: block;
    inline-size: 100%;
    block-size: 4px;
    appearance: none;
    border: 0;
    background: rgb(128 128 128 / 0.35);
  }

  progress::-webkit-progress-bar {
    background: transparent;
  }

  progress::-webkit-progress-value {
    background: var(--volume-view-progress-color, #4a8cf5);
  }

  progress::-moz-progress-bar {
    background: var(--volume-view-progress-color, #4a8cf5);
  }

  .error {
    position: absolute;
    inset-inline: 0;
    inset-block-end: 0;
    max-block-size: 100%;
    overflow: auto;
    box-sizing: border-box;
    padding: 0.75em 1em;
    background: var(--volume-view-error-background, rgb(60 14 14 / 0.94));
    color: var(--volume-view-error-color, #fff1ee);
    overflow-wrap: anywhere;
  }

  .error p {
    margin: 0;
  }

  button {
    min-block-size: 44px;
    margin-block-start: 0.5em;
    font: inherit;
  }

  .status {
    position: absolute;
    inline-size: 1px;
    block-size: 1px;
    overflow: hidden;
    clip-path: inset(50%);
    white-space: nowrap;
  }

  @media print {
    /* Paper has another width, and the picture is not drawn again for it. */
    canvas {
      object-fit: contain;
    }

    .picture:focus-visible::after {
      display: none;
    }
  }

  @media (forced-colors: active) {
    .picture:focus-visible::after {
      border-color: Highlight;
    }
  }

  /* In a page written from right to left, English sentences and numbers with units keep their own direction. */
  .labels span,
  .error p,
  .error button {
    unicode-bidi: plaintext;
  }

  /* In this mode the background and the page have the same colour. */
  @media (forced-colors: active) {
    :host {
      outline: 1px solid CanvasText;
      outline-offset: -1px;
    }

    .error {
      border: 1px solid CanvasText;
    }
  }
`;
