import { mount } from 'svelte';
import Scan from './scan.svelte';

mount(Scan, { target: document.getElementById('root') });
