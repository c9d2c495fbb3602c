// What the types are to refuse: test/bundlers/run.mjs counts the errors, one for each line that says so.
import type { Scan } from './scan';

declare const scan: Scan;
export const tour = scan.tour.nativeElement;
export const isOpen: boolean = tour.step === 2;

tour.step = 'two'; // wrong: a number
tour.htmlFor = 7; // wrong: an id
export const window: typeof scan.window = [0, 1, 2]; // wrong: two numbers
tour.addEventListener('step-change', (event: MouseEvent) => event); // wrong: another event
