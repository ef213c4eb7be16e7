// As much of Microsoft's as Islet uses.
#pragma once
#include <immintrin.h>
extern "C" {
unsigned char _BitScanForward(unsigned long*, unsigned long);
unsigned char _BitScanReverse(unsigned long*, unsigned long);
unsigned long _byteswap_ulong(unsigned long);
__declspec(noreturn) void __fastfail(unsigned int);
}
