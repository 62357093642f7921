#pragma once

namespace core
{
/// Functions for the alternatives of a variant, as one: for std::visit.
template <class... T> struct Overloaded : T...
{
    using T::operator()...;
};
template <class... T> Overloaded(T...) -> Overloaded<T...>;
} // namespace core
