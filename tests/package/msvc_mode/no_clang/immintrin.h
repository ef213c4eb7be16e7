#pragma once
struct __m128 {
    float f[4];
};
extern "C" {
__m128 _mm_set_ss(float);
__m128 _mm_sqrt_ss(__m128);
float _mm_cvtss_f32(__m128);
unsigned int _mm_getcsr();
void _mm_setcsr(unsigned int);
}
