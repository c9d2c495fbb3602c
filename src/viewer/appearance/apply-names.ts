// What attributes say by a name: a ready-made look, and a window of the file. Loaded with the first page that has such a name.
import type { ScanModel } from '../model/scan-model.ts';
import type { AppearanceSettings } from '../model/settings.ts';
import { findWindow } from './find-window.ts';
import { applyNamedLook } from './named-looks.ts';
import type { ResolvedSettings } from './named-looks.ts';

/** @throws {VolumeViewError} `attribute/invalid` where a name is not known */
export function applyNames(settings: AppearanceSettings, volume: ScanModel): ResolvedSettings {
  const resolved = { ...settings, window: findWindow(settings.window, volume) };
  return settings.named === null ? resolved : applyNamedLook(resolved, settings.named, volume);
}
