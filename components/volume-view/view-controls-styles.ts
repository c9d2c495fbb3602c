import { css } from 'lit';

/** Styles of the controls over a picture. They are added to the styles of <volume-view> when the controls are loaded. */
export const styles = css`
  :host(:fullscreen) {
    inline-size: 100%;
    block-size: 100%;
    max-inline-size: none;
    max-block-size: none;
    aspect-ratio: auto;
  }

  .controls {
    --_back: var(--volume-view-controls-background, rgb(13 16 22 / 0.86));
    --_ink: var(--volume-view-controls-color, #f2f5fa);

    position: absolute;
    inset-block-end: 8px;
    inset-inline: 8px;
    container-type: inline-size;
    max-block-size: calc(100% - 16px);
    display: flex;
    flex-direction: column;
    align-items: flex-end;
    gap: 6px;
    pointer-events: none;
    color: var(--_ink);
  }

  /* An error message is at the bottom: the buttons move to the top, and their panels are above the message. */
  :host(:is(:state(error), [data-state-error])) .controls {
    z-index: 1;
    inset-block: 8px auto;
    flex-direction: column-reverse;
  }

  .row {
    display: flex;
    align-items: flex-end;
    justify-content: flex-end;
    gap: 6px;
    max-inline-size: 100%;
  }

  .panel,
  .bar,
  .hint {
    pointer-events: auto;
    border-radius: 10px;
    background: var(--_back);
  }

  .bar {
    flex: none;
    max-inline-size: 100%;
    display: flex;
    flex-wrap: wrap;
    justify-content: flex-end;
  }

  .controls button {
    display: flex;
    align-items: center;
    justify-content: center;
    min-inline-size: 44px;
    min-block-size: 44px;
    margin: 0;
    border: 0;
    padding: 0 10px;
    border-radius: 10px;
    background: transparent;
    color: inherit;
    font: inherit;
    text-align: start;
    cursor: pointer;
    touch-action: manipulation;
  }

  .controls button:hover {
    background: rgb(255 255 255 / 0.14);
  }

  .controls :focus-visible {
    outline: 3px solid var(--volume-view-focus-color, #7db4ff);
    outline-offset: -3px;
  }

  .controls svg {
    inline-size: 24px;
    block-size: 24px;
    fill: none;
    stroke: currentColor;
    stroke-width: 1.8;
    stroke-linecap: round;
    stroke-linejoin: round;
  }

  .controls path[d^='M5 12h'] {
    stroke-width: 3.2;
  }

  .panel {
    display: grid;
    gap: 2px;
    padding: 4px;
    min-block-size: 0;
    max-inline-size: 100%;
    box-sizing: border-box;
    overflow: auto;
  }

  .panel.views {
    grid-template-columns: repeat(2, auto);
  }

  .panel button {
    justify-content: flex-start;
  }

  .panel p,
  .panel dl {
    margin: 6px 10px;
    overflow-wrap: anywhere;
  }

  .panel dl {
    display: grid;
    grid-template-columns: auto 1fr;
    gap: 4px 12px;
  }

  .panel dt {
    font-weight: 600;
  }

  .panel dd {
    margin: 0;
  }

  .panel textarea {
    box-sizing: border-box;
    inline-size: 100%;
    min-block-size: 5em;
    margin: 0;
    border: 1px solid currentColor;
    border-radius: 6px;
    padding: 6px;
    background: transparent;
    color: inherit;
    font: 13px / 1.4 ui-monospace, monospace;
    resize: vertical;
  }

  .controls .hint {
    align-self: center;
    margin: 0;
    padding: 4px 12px;
    pointer-events: none;
  }

  /* On a phone everything is in one row: rarely used buttons are under "More", and the hint is small. */
  .controls .narrow {
    display: none;
  }

  @container (inline-size < 560px) {
    .hinted .wide {
      display: none;
    }

    .row {
      align-items: stretch;
    }

    .controls .hint {
      display: flex;
      align-items: center;
      padding: 2px 8px;
      font-size: 12px;
      line-height: 1.3;
      max-block-size: 44px;
      box-sizing: border-box;
      overflow: hidden;
    }
  }

  /* The bar with all buttons would take a second row. */
  @container (inline-size < 264px) {
    .bar .wide {
      display: none;
    }

    .panel .narrow {
      display: flex;
    }
  }

  @container (inline-size < 352px) {
    .long .wide {
      display: none;
    }

    .long .narrow {
      display: flex;
    }
  }

  /* There is no room for the text. */
  @container (inline-size < 250px) {
    .controls .hint {
      display: none;
    }
  }

  @media (forced-colors: active) {
    .panel,
    .bar,
    .hint {
      border: 1px solid CanvasText;
    }
  }

  @media print {
    .controls {
      display: none;
    }
  }

  /* In a page written from right to left, English sentences and numbers with units keep their own direction. */
  .hint,
  .panel p,
  .panel dt,
  .panel dd,
  .panel button {
    unicode-bidi: plaintext;
  }
`;
