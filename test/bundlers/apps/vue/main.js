import { createApp } from 'vue';
import Scan from './scan.vue';

createApp(Scan).mount('#root');
