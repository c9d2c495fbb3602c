import { css } from 'lit';
import { spokenStyles } from '../internal/spoken-styles.ts';

const ownStyles = css`
  :host {
    --_notice-top: 28px; /* Below the text of the window. */
    --_rim: 0 0 1px #000, 0 0 2px #000, 0 0 2px #000, 0 0 3px #000, 0 0 3px #000, 0 0 5px #000, 0 0 5px #000;
    display: block;
    position: relative;
    box-sizing: border-box;
    overflow: hidden;
    aspect-ratio: 1;
    max-block-size: 100vh;
    contain: strict;
    container-type: size;
    contain-intrinsic-inline-size: min(300px, 100vw);
    color: #e8ecf2;
    background: #000;
    font: 12px / 1.4 system-ui, sans-serif;
    font-variant-numeric: tabular-nums;
    -webkit-print-color-adjust: exact;
    print-color-adjust: exact;
  }

  :host([hidden]) {
    display: none;
  }

  .picture,
  canvas {
    position: absolute;
    inset: 0;
    inline-size: 100%;
    block-size: 100%;
    display: block;
  }

  .picture {
    direction: ltr;
    outline: none;
    cursor: crosshair;
    overflow: hidden;
    touch-action: pan-y;
    user-select: none;
    -webkit-user-select: none;
  }

  .picture:focus-visible::after {
    content: '';
    position: absolute;
    inset: 0;
    border: 3px solid var(--volume-view-focus-color, #7db4ff);
    pointer-events: none;
  }

  .line {
    position: absolute;
    background: var(--volume-slice-crosshair-color, #ffd24dcc);
    pointer-events: none;
  }

  .across {
    inset-inline: 0;
    block-size: 1px;
  }

  .up {
    inset-block: 0;
    inline-size: 1px;
  }

  .text {
    position: absolute;
    padding: 6px 8px;
    white-space: nowrap;
    /* Several shadows on top of each other make a dark rim, so that white text is readable over bright tissue too. */
    text-shadow: var(--_rim);
    pointer-events: none;
  }

  .top.left { top: 0; left: 0; }
  /* When the mouse rests on it, its title says in words what it means. */
  .top.right { top: 0; right: 0; text-align: end; white-space: pre; pointer-events: auto; }
  .bottom.left { bottom: 26px; left: 0; }
  .bottom.right { bottom: 26px; right: 0; max-inline-size: calc(50% - 1.5em); text-align: end; white-space: normal; overflow-wrap: anywhere; }

  /* The name of a label may be long. */
  .bottom.right .told {
    display: -webkit-box;
    -webkit-box-orient: vertical;
    -webkit-line-clamp: 4;
    overflow: hidden;
  }

  select {
    position: absolute;
    top: 26px;
    right: 6px;
    min-block-size: 26px;
    max-inline-size: min(12em, 50%);
    margin: 0;
    padding: 1px 4px;
    border: 1px solid rgb(255 255 255 / 0.4);
    border-radius: 6px;
    color: inherit;
    color-scheme: dark;
    background: rgb(13 16 22 / 0.75);
    font: inherit;
    text-overflow: ellipsis;
  }

  select:focus-visible {
    outline: 3px solid var(--volume-view-focus-color, #7db4ff);
  }

  /* The sign for what is left out is below it. */
  select ~ .notice {
    --_notice-top: 56px;
  }

  .side {
    position: absolute;
    padding: 4px 6px;
    font-weight: 600;
    color: #ffd9a0;
    text-shadow: var(--_rim);
    pointer-events: none;
  }

  .side.l { left: 0; top: 50%; translate: 0 -50%; }
  .side.r { right: 0; top: 50%; translate: 0 -50%; }
  .side.t { top: 0; left: 50%; translate: -50% 0; }
  .side.b { bottom: 26px; left: 50%; translate: -50% 0; }

  @container (inline-size < 220px) {
    .text,
    .side {
      padding: 3px 4px;
      font-size: 10px;
    }

    select {
      top: 20px;
      font-size: 11px;
    }

    .bottom.left,
    .bottom.right,
    .side.b {
      bottom: 24px;
    }
  }

  .bar {
    box-sizing: border-box;
    block-size: 6px;
    border: 1px solid currentColor;
    border-block-start: 0;
    box-shadow: 0 1px 2px #000;
  }

  input {
    position: absolute;
    inset-block-end: 2px;
    inset-inline: 8px;
    inline-size: calc(100% - 16px);
    block-size: 22px;
    margin: 0;
    opacity: 0.55;
    accent-color: var(--volume-slice-accent, #ffd24d);
  }

  :host(:hover) input,
  input:focus-visible {
    opacity: 1;
  }

  input:focus-visible {
    outline: 2px solid var(--volume-view-focus-color, #7db4ff);
  }

  .hint,
  .loading,
  .problem {
    position: absolute;
    inset: auto 0 0;
    margin: 0;
    padding: 10px 12px;
    overflow-wrap: anywhere;
  }

  .loading {
    display: grid;
    gap: 4px;
  }

  progress {
    inline-size: 100%;
  }

  /* In a page written from right to left, English sentences and numbers with units keep their own direction. */
  .text,
  .told,
  .hint,
  .problem p,
  .problem {
    unicode-bidi: plaintext;
  }

  @media (forced-colors: active) {
    :host {
      outline: 1px solid CanvasText;
      outline-offset: -1px;
    }
  }

  .problem {
    max-block-size: 100%;
    box-sizing: border-box;
    overflow: auto;
    color: var(--volume-view-error-color, #fff);
    background: var(--volume-view-error-background, #7c1d1de8);
  }
`;

export const styles = [ownStyles, spokenStyles];
