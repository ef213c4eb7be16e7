// The floats of an RP2040's ROM, by those of the compiler: subnormal numbers count as zero, in arguments and in results. The Pico SDK and Arduino put the
// ROM's in the place of the compiler's by the linker's option --wrap, as tools/boards.sh does with these.
#include <cstdint>

namespace {

using Bits = std::uint32_t;  // of a float, as they are passed without a floating-point unit

Bits flushed(Bits x) { return (x & 0x7f800000u) == 0 ? x & 0x80000000u : x; }

}  // namespace

#define ROM_FLOAT(name)                                     \
    extern "C" Bits __real___aeabi_f##name(Bits a, Bits b); \
    extern "C" Bits __wrap___aeabi_f##name(Bits a, Bits b) { return flushed(__real___aeabi_f##name(flushed(a), flushed(b))); }
ROM_FLOAT(add)
ROM_FLOAT(sub)
ROM_FLOAT(mul)
ROM_FLOAT(div)

#define ROM_COMPARISON(name)                                  \
    extern "C" int __real___aeabi_fcmp##name(Bits a, Bits b); \
    extern "C" int __wrap___aeabi_fcmp##name(Bits a, Bits b) { return __real___aeabi_fcmp##name(flushed(a), flushed(b)); }
ROM_COMPARISON(eq)
ROM_COMPARISON(lt)
ROM_COMPARISON(le)
ROM_COMPARISON(gt)
ROM_COMPARISON(ge)
