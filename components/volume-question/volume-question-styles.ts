import { css } from 'lit';

export const styles = css`
  form {
    --_right: var(--volume-question-right-color, #2c9a4b);

    display: grid;
    gap: 12px;
    margin: 0;
  }

  form > * {
    min-inline-size: 0;
    margin: 0;
  }

  ::slotted(:first-child) {
    margin-block-start: 0;
  }

  ::slotted(:last-child) {
    margin-block-end: 0;
  }

  /* The answers are shown as buttons below. */
  .choice ::slotted(:is(ul, ol)) {
    display: none !important;
  }

  /* An author may hide a hint from pages without scripts. */
  ::slotted([slot][hidden]) {
    display: block !important;
  }

  .error {
    margin: 0;
  }

  .answers {
    display: grid;
    gap: 6px;
    padding: 0;
    list-style: none;
  }

  .answers label {
    display: grid;
    grid-template-columns: auto 1fr auto;
    gap: 10px;
    align-items: baseline;
    box-sizing: border-box;
    min-block-size: 44px;
    padding: 9px 12px;
    border: 1px solid var(--_line);
    border-radius: 8px;
    cursor: pointer;
    overflow-wrap: anywhere;
  }

  .answers label:hover,
  .answers label:has(:checked) {
    border-color: currentColor;
  }

  .answers label:has(:disabled) {
    cursor: default;
  }

  .answers label:has(:focus-visible) {
    outline: 2px solid var(--volume-view-focus-color, currentColor);
    outline-offset: 2px;
  }

  .answers label:has(:focus-visible) input {
    outline: none;
  }

  .answers .right {
    border: 2px solid var(--_right);
  }

  .answers :is(p, div) {
    margin: 0;
  }

  .answers img {
    max-inline-size: 100%;
  }

  input[type='radio'],
  input[type='checkbox'] {
    inline-size: 18px;
    block-size: 18px;
    margin: 0;
    translate: 0 3px;
    accent-color: var(--volume-question-color, #2f7de1);
  }

  .field {
    display: flex;
    gap: 8px;
    align-items: center;
  }

  .field input {
    flex: 0 1 16em;
    box-sizing: border-box;
    min-inline-size: 0;
    min-block-size: 44px;
    padding: 8px 12px;
    border: 1px solid var(--_line);
    border-radius: 8px;
    background: transparent;
    color: inherit;
    font: inherit;
  }

  .value .field input {
    flex-basis: 8em;
  }

  .buttons {
    display: flex;
    flex-wrap: wrap;
    gap: 8px;
  }

  button {
    min-block-size: 44px;
    padding: 8px 16px;
  }

  :is(.field input, .feedback):focus-visible {
    outline: 2px solid var(--volume-view-focus-color, currentColor);
    outline-offset: 2px;
  }

  .feedback,
  .hint {
    padding-block: 4px;
    padding-inline: 14px 0;
    border-inline-start: 4px solid var(--_line);
  }

  .feedback.is-right {
    border-color: var(--_right);
  }

  .feedback.is-wrong {
    border-color: var(--volume-question-wrong-color, #d1632a);
  }

  :is(.feedback, .hint) > p {
    margin: 0;
  }

  .feedback > p + p,
  .feedback > slot {
    margin-block-start: 6px;
  }

  /* In a box of ours, the space between the author's paragraphs is ours too. */
  :is(.feedback, .hint) > slot {
    display: grid;
    gap: 6px;
  }

  ::slotted([slot]) {
    margin-block: 0 !important;
  }

  .head::before {
    margin-inline-end: 0.4em;
    font-weight: 700;
    content: '✗' / '';
  }

  .is-right .head::before {
    content: '✓' / '';
  }

  .head {
    font-weight: 600;
  }

  @media print {
    .buttons,
    .task {
      display: none;
    }

    form {
      break-inside: avoid;
    }
  }
`;
