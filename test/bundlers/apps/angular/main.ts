import '@angular/compiler'; // Templates are compiled in the browser.
import { provideZonelessChangeDetection } from '@angular/core';
import { bootstrapApplication } from '@angular/platform-browser';
import { Scan } from './scan';

await bootstrapApplication(Scan, { providers: [provideZonelessChangeDetection()] });
