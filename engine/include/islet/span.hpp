// islet::span, a view of elements in a row: std::span of C++20, and with C++17 a class that does as much of it as Islet needs.
#pragma once

#include <cstddef>

#include "islet/standard.hpp"

#if ISLET_STD_SPAN

#include <span>

namespace islet {
using std::span;
}  // namespace islet

#else

#include <initializer_list>
#include <type_traits>
#include <utility>

namespace islet {

/// A pointer and a count. An array, or what has data() and size(), becomes a span by itself.
template <class T>
class span {
    // Pointers to T, or to what T is the const of, but not to a class derived from T, which has another size.
    template <class U>
    using IfArrayOf = std::enable_if_t<std::is_convertible_v<std::remove_reference_t<U> (*)[], T (*)[]>>;

public:
    constexpr span() = default;
    constexpr span(T* data, std::size_t size) : data_(data), size_(size) {}
    template <class U, std::size_t count, class = IfArrayOf<U>>
    constexpr span(U (&array)[count]) : data_(array), size_(count) {}
    template <class List, class = IfArrayOf<decltype(*std::declval<List&>().data())>, class = decltype(std::declval<List&>().size())>
    constexpr span(List& list) : data_(list.data()), size_(list.size()) {}
    template <class List, class = IfArrayOf<decltype(*std::declval<const List&>().data())>, class = decltype(std::declval<const List&>().size())>
    constexpr span(const List& list) : data_(list.data()), size_(list.size()) {}

    constexpr T* data() const { return data_; }
    constexpr std::size_t size() const { return size_; }
    constexpr std::size_t size_bytes() const { return size_ * sizeof(T); }
    constexpr bool empty() const { return size_ == 0; }
    constexpr T& operator[](std::size_t i) const { return data_[i]; }
    constexpr T& front() const { return data_[0]; }
    constexpr T& back() const { return data_[size_ - 1]; }
    constexpr T* begin() const { return data_; }
    constexpr T* end() const { return data_ + size_; }
    constexpr span first(std::size_t count) const { return {data_, count}; }
    constexpr span last(std::size_t count) const { return {data_ + size_ - count, count}; }
    constexpr span subspan(std::size_t offset) const { return {data_ + offset, size_ - offset}; }
    constexpr span subspan(std::size_t offset, std::size_t count) const { return {data_ + offset, count}; }

private:
    T* data_ = nullptr;
    std::size_t size_ = 0;
};

template <class T>
span(T*, std::size_t) -> span<T>;
template <class T, std::size_t count>
span(T (&)[count]) -> span<T>;
template <class List>
span(List&) -> span<std::remove_reference_t<decltype(*std::declval<List&>().data())>>;
template <class List>
span(const List&) -> span<std::remove_reference_t<decltype(*std::declval<const List&>().data())>>;

}  // namespace islet

#endif
