/// 1, 2 or 5 times a power of ten that is at least so long.
export function roundLength(least) {
    const power = 10 ** Math.floor(Math.log10(least));
    return [1, 2, 5].map((digit) => digit * power).find((length) => length >= least) ?? 10 * power;
}
