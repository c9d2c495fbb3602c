import { css } from 'lit';

export const styles = css`
  .bar {
    display: flex;
    flex-wrap: wrap;
    align-items: center;
    gap: 4px 8px;
    margin-block: 0 12px;
    font: 14px / 1.4 system-ui, sans-serif;
    font-variant-numeric: tabular-nums;
  }

  slot + .bar {
    margin-block: 12px 0;
  }

  button {
    display: grid;
    place-items: center;
    min-inline-size: 40px;
    min-block-size: 40px;
    padding: 0;
  }

  button:disabled {
    border-color: color-mix(in srgb, currentColor 20%, transparent);
    color: color-mix(in srgb, currentColor 40%, transparent);
    cursor: default;
  }

  ::slotted(:focus-visible) {
    outline: 2px solid var(--volume-view-focus-color, currentColor);
    outline-offset: 2px;
  }

  button.words {
    padding-inline: 14px;
  }

  svg {
    inline-size: 20px;
    block-size: 20px;
    fill: none;
    stroke: currentColor;
    stroke-width: 2;
    stroke-linecap: round;
    stroke-linejoin: round;
  }

  :host(:dir(rtl)) .turns {
    scale: -1 1;
  }

  .dots {
    display: flex;
    flex-wrap: wrap;
    margin: 0;
    padding: 0;
    list-style: none;
  }

  /* The place to press is larger than the dot. */
  .dots button {
    min-inline-size: 24px;
    min-block-size: 24px;
    border: 0;
    border-radius: 999px;
  }

  .dots button::before {
    content: '';
    box-sizing: border-box;
    inline-size: 12px;
    block-size: 12px;
    border: 2px solid currentColor;
    border-radius: 999px;
  }

  .dots [aria-current]::before {
    background: var(--volume-tour-color, currentColor);
    border-color: var(--volume-tour-color, currentColor);
  }

  /* Each text has the middle of the page for itself; CSS of the page overrides it. */
  @media screen {
    :host([by='scroll' i]) ::slotted(volume-step) {
      margin-block-end: 60vh;
    }

    :host([by='scroll' i]) .back {
      position: sticky;
      inset-block-end: 12px;
    }
  }

  .back button {
    background: Canvas;
    color: CanvasText;
  }

  .leave {
    margin-inline-start: auto;
  }

  .error,
  .hint {
    margin: 0 0 12px;
  }

  .hint {
    unicode-bidi: plaintext;
    overflow-wrap: anywhere;
  }

  @media print {
    .bar,
    .hint {
      display: none;
    }
  }

  @media (forced-colors: active) {
    .dots button::before {
      forced-color-adjust: none;
      border-color: ButtonText;
    }

    .dots [aria-current]::before {
      background: Highlight;
      border-color: Highlight;
    }

    button:disabled {
      color: GrayText;
    }
  }
`;
