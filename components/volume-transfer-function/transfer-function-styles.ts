import { css } from 'lit';
import { chartStyles } from './transfer-function-chart-styles.ts';
import { planeStyles } from './transfer-function-plane-styles.ts';
import { spokenStyles } from '../internal/spoken-styles.ts';
import { controlStyles } from './transfer-function-control-styles.ts';

const frameStyles = css`
  :host {
    --_accent: var(--volume-accent, #3873e0);
    --_focus: var(--volume-view-focus-color, #7db4ff);
    --_soft: color-mix(in srgb, currentColor 72%, transparent);
    --_line: color-mix(in srgb, currentColor 24%, transparent);
    --_field: color-mix(in srgb, currentColor 6%, transparent);

    display: block;
    box-sizing: border-box;
    min-inline-size: 0;
    font: 14px / 1.45 system-ui, sans-serif;
    font-variant-numeric: tabular-nums;
  }

  :host([hidden]) {
    display: none;
  }

  .editor {
    display: grid;
    gap: 12px;
  }

  p {
    margin: 0;
  }

  .hint {
    display: grid;
    place-content: center;
    min-block-size: 9rem;
    padding: 1rem;
    border: 1px dashed var(--_line);
    border-radius: 8px;
    color: var(--_soft);
    text-align: center;
  }

  .problem {
    padding: 0.5em 0.75em;
    border-radius: 6px;
    background: var(--volume-view-error-background, #5c1414);
    color: var(--volume-view-error-color, #fff1ee);
  }

  .fields,
  .factors,
  .buttons,
  .foot {
    display: flex;
    flex-wrap: wrap;
    align-items: end;
    gap: 8px 12px;
  }

  .foot {
    align-items: center;
    justify-content: space-between;
  }

  .said {
    min-block-size: 1.45em;
    color: var(--_soft);
    font-size: 12px;
  }

  /* In a page written from right to left, English sentences and numbers with units keep their own direction. */
  p,
  .hint,
  .problem {
    unicode-bidi: plaintext;
  }
`;

export const styles = [frameStyles, chartStyles, planeStyles, controlStyles, spokenStyles];
