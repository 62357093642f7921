#pragma once

#include <cstdlib>
#include <string_view>

/// Amount of random and exhaustive testing in this run, from FETTLE_EFFORT=small, long or soak. test.sh --long
/// and --soak set the variable.
enum class Effort { Small, Long, Soak };

inline std::string_view effortName()
{
    const char* word = std::getenv("FETTLE_EFFORT");
    const std::string_view name = word ? word : "";
    return name == "soak" || name == "long" ? name : "small";
}

inline Effort effort()
{
    return effortName() == "soak" ? Effort::Soak : effortName() == "long" ? Effort::Long : Effort::Small;
}

#if defined(NDEBUG) && !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
constexpr bool isSlowBuild = false;
#else
constexpr bool isSlowBuild = true; ///< sanitizer and debug builds are 5 to 30 times slower
#endif

/// Milliseconds after which a test stops waiting and fails. Generous, so that no test fails only because the machine is
/// busy.
constexpr int longestWait = isSlowBuild ? 1'200'000 : 120'000;

/// Returns the count (rounds, files, dabs …) for the effort of this run. Without a soak count, a soak run uses the long
/// one.
template <class Number> Number byEffort(Number small, Number large)
{
    return effort() == Effort::Small ? small : large;
}

template <class Number> Number byEffort(Number small, Number large, Number soak)
{
    return effort() == Effort::Soak ? soak : byEffort(small, large);
}
