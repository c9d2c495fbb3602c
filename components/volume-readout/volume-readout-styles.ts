import { css } from 'lit';
import { factsStyles } from '../internal/facts-styles.ts';
import { spokenStyles } from '../internal/spoken-styles.ts';

const ownStyles = css`
  /* The swatch is between names and texts, so that all texts begin at one line. */
  dl {
    column-gap: 2em;
  }

  .swatch {
    display: inline-block;
    margin-inline: -1.3em 0.5em;
    border-radius: 50%; /* Round, as a square would look like a checkbox. */
  }

  .swatch[hidden] {
    visibility: hidden;
  }

  .tools {
    align-items: center;
    gap: 0.75em;
  }

  .hint {
    margin: 0;
  }

  .keys {
    border-radius: 5px;
    padding: 0.25em 0.5em;
    box-shadow: inset 0 0 0 1px var(--_line);
  }

  .keys:focus-visible {
    outline: 2px solid var(--volume-view-focus-color, currentColor);
    outline-offset: 2px;
  }

  /* In a page written from right to left, English sentences and numbers with units keep their own direction. */
  .hint {
    unicode-bidi: plaintext;
  }
`;

export const styles = [factsStyles, ownStyles, spokenStyles];
