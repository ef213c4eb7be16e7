import type {Theme} from 'vitepress';
import Base from 'vitepress/theme-without-fonts'; // the system's fonts: nothing is fetched for them
import ReferenceLanguage from './ReferenceLanguage.vue';
import './style.css';

export default {
    extends: Base,
    enhanceApp({app}) {
        app.component('ReferenceLanguage', ReferenceLanguage);
        if (!import.meta.env.SSR) {
            void import('./world');
            void import('./pgs');
        }
    },
} satisfies Theme;
