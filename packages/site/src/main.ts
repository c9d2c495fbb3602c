// The script of every page of the site: its search and its live examples. A page without it is whole, but for these two.
import { startExamples } from './live-examples.ts';
import { startSearch } from './search.ts';

/** Where the site begins, as seen from the page; it ends with a slash. */
const root = new URL(document.documentElement.dataset.root || './', location.href).href;

startSearch(root);
startExamples(root);
