#pragma once

namespace core
{
/// Combines one function for each alternative of a variant into one visitor for std::visit.
template <class... T> struct Overloaded : T...
{
    using T::operator()...;
};
template <class... T> Overloaded(T...) -> Overloaded<T...>;
} // namespace core
