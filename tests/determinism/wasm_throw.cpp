// WebAssembly's C++ library comes without exceptions. The scenes' loader throws where a scene cannot be made: here that ends the program.
#include <cstdlib>

extern "C" {
void* __cxa_allocate_exception(unsigned long) { std::abort(); }
void __cxa_throw(void*, void*, void (*)(void*)) { std::abort(); }
void __cxa_free_exception(void*) {}
}
