declare module 'virtual:solver-settings' {
    export interface Setting {
        readonly key: string;
        readonly label: string;
        readonly kind: 'switch' | 'choice' | 'number' | 'count';
        readonly usual: number | boolean | string;
        readonly unit: string;
        readonly doc: string;
        readonly values?: readonly {readonly key: string; readonly label: string; readonly doc: string}[];
        readonly least?: number;
        readonly above?: boolean;
        readonly most?: number;
    }
    const settings: readonly Setting[];
    export default settings;
}
