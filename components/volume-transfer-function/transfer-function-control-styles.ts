import { css } from 'lit';

/** Styles of the fields, sliders and buttons of the editor. */
export const controlStyles = css`
  .buttons {
    gap: 6px;
  }

  label {
    unicode-bidi: plaintext; /* English text in a page written from right to left. */
    display: grid;
    gap: 3px;
    color: var(--_soft);
    font-size: 12px;
  }

  input,
  button,
  textarea {
    box-sizing: border-box;
    margin: 0;
    color: inherit;
    font: inherit;
  }

  input[type='number'],
  textarea,
  button {
    min-block-size: 32px;
    border: 1px solid var(--_line);
    border-radius: 6px;
    background: var(--_field);
    font-size: 14px;
  }

  input[type='number'] {
    inline-size: max(6em, calc(var(--digits, 0) * 1ch + 2.6em));
    max-inline-size: 100%;
    padding: 0 6px;
  }

  .fields label,
  .by-hand {
    color: inherit;
  }

  textarea {
    inline-size: 100%;
    padding: 6px;
    font: 12px / 1.5 ui-monospace, monospace;
    resize: vertical;
  }

  button {
    padding: 0 11px;
    cursor: pointer;
  }

  button:hover:enabled {
    border-color: var(--_accent);
  }

  button:disabled {
    opacity: 0.45;
    cursor: default;
  }

  input[type='color'] {
    inline-size: 44px;
    block-size: 32px;
    padding: 0;
    border: 1px solid var(--_line);
    border-radius: 6px;
    background: none;
    cursor: pointer;
  }

  input[type='color']::-webkit-color-swatch-wrapper {
    padding: 0;
  }

  input[type='color']::-webkit-color-swatch,
  input[type='color']::-moz-color-swatch {
    border: 0;
    border-radius: 5px;
  }

  input[type='range'] {
    min-inline-size: 0;
    block-size: 24px;
    accent-color: var(--_accent);
    cursor: pointer;
  }

  :is(input, button, textarea):focus-visible {
    outline: 3px solid var(--_focus);
    outline-offset: 1px;
    box-shadow: 0 0 0 1px #0d1016;
  }

  .factors {
    gap: 6px 24px;
  }

  .factor {
    flex: 1 1 13rem;
    grid-template-columns: auto minmax(0, 1fr) 4em;
    align-items: center;
    gap: 8px;
    color: inherit;
    font-size: 13px;
  }

  .told {
    color: var(--_soft);
    font-size: 12px;
    text-align: end;
    white-space: nowrap;
  }

  .bands {
    columns: 16rem;
    column-gap: 24px;
    margin: 0;
    padding: 0;
    list-style: none;
  }

  .bands li {
    display: grid;
    grid-template-columns: 32px 7.2em minmax(0, 1fr) 4.5em;
    align-items: center;
    gap: 8px;
    min-block-size: 30px;
    break-inside: avoid;
    font-size: 13px;
  }

  .bands .range {
    white-space: nowrap;
  }

  .bands input[type='color'] {
    inline-size: 32px;
    block-size: 24px;
  }
`;
