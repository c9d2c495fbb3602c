// In place of culori.ts, in the modules for bundlers: not every bundler finds culori's exports, so the package contains them.
export * from 'built:culori';
