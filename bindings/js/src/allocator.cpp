// malloc and free of the package, for the few blocks that its JavaScript takes: worlds, and room for what goes in and out. A tenth of the C library's size.
//
// Free blocks stand in a list in the order of their addresses. The first that is large enough is taken, and neighbours become one when they are freed.
#include <cstddef>
#include <cstdint>

extern "C" std::byte __heap_base;

namespace {

constexpr std::size_t page_bytes = 65536, most_pages = 65535;  // so that the end of the last block still is an address
constexpr std::size_t unit = 16;                               // bytes: what a block is aligned to, and its head

/// The head of a block. In blocks in use only `bytes` is set.
struct Block {
    std::size_t bytes;  // with the head
    Block* next;        // of the free ones
};

Block* first_free = nullptr;
std::size_t end = 0;  // of what the blocks have of the memory

std::size_t up(std::size_t bytes, std::size_t to) { return (bytes + to - 1) / to * to; }
bool meet(const Block* a, const Block* b) { return reinterpret_cast<std::uintptr_t>(a) + a->bytes == reinterpret_cast<std::uintptr_t>(b); }

void add(Block* block) {
    Block* before = nullptr;
    Block* after = first_free;
    while (after != nullptr && after < block) {
        before = after;
        after = after->next;
    }
    block->next = after;
    if (after != nullptr && meet(block, after)) {
        block->bytes += after->bytes;
        block->next = after->next;
    }
    if (before == nullptr) {
        first_free = block;
    } else if (meet(before, block)) {
        before->bytes += block->bytes;
        before->next = block->next;
    } else {
        before->next = block;
    }
}

void* take(std::size_t bytes) {
    for (Block** link = &first_free; *link != nullptr; link = &(*link)->next) {
        Block* const block = *link;
        if (block->bytes < bytes) continue;
        if (block->bytes - bytes >= 2 * unit) {
            auto* const rest = reinterpret_cast<Block*>(reinterpret_cast<std::byte*>(block) + bytes);
            *rest = {block->bytes - bytes, block->next};
            *link = rest;
            block->bytes = bytes;
        } else {
            *link = block->next;
        }
        return reinterpret_cast<std::byte*>(block) + unit;
    }
    return nullptr;
}

/// Adds the memory that is there but has no block yet, and so many bytes more. False if there are no more.
bool grow(std::size_t bytes) {
    const std::size_t pages = __builtin_wasm_memory_size(0), more = up(bytes, page_bytes) / page_bytes;
    if (pages + more > most_pages || __builtin_wasm_memory_grow(0, more) == SIZE_MAX) return false;
    const std::size_t begin = end != 0 ? end : up(reinterpret_cast<std::uintptr_t>(&__heap_base), unit);
    end = (pages + more) * page_bytes;
    auto* const block = reinterpret_cast<Block*>(begin);
    block->bytes = end - begin;
    add(block);
    return true;
}

}  // namespace

extern "C" {

/// Aligned to 16 bytes. Null if there is no room.
void* malloc(std::size_t bytes) {
    if (bytes > most_pages * page_bytes) return nullptr;
    const std::size_t all = up(bytes + unit, unit);
    if (void* const found = take(all)) return found;
    return grow(all) ? take(all) : nullptr;
}

void free(void* p) {
    if (p != nullptr) add(reinterpret_cast<Block*>(static_cast<std::byte*>(p) - unit));
}
}
