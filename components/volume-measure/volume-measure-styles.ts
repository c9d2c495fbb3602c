import { css } from 'lit';
import { factsStyles } from '../internal/facts-styles.ts';
import { spokenStyles } from '../internal/spoken-styles.ts';

const ownStyles = css`
  .name {
    display: flex;
    align-items: center;
    gap: 0.5em;
    margin: 0;
    font-weight: 600;
  }

  .swatch {
    forced-color-adjust: none;
  }

  .hint,
  .problem {
    margin: 0.25em 0 0;
  }

  .problem {
    padding: 0.5em 0.75em;
    background: var(--volume-view-error-background, rgb(60 14 14 / 0.94));
    color: var(--volume-view-error-color, #fff1ee);
    overflow-wrap: anywhere;
  }

  .tools {
    flex-wrap: wrap;
    gap: 0.5em;
  }

  /* In a page written from right to left, English sentences and numbers with units keep their own direction. */
  .hint,
  .problem {
    unicode-bidi: plaintext;
  }
`;

export const styles = [factsStyles, ownStyles, spokenStyles];
