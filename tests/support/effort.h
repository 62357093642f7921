#pragma once

#include <cstdlib>
#include <string_view>

/// How much of what could be tested without end a run tests: FETTLE_EFFORT=small, long or soak. test.sh --long and
/// --soak set it.
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
constexpr bool isSlowBuild = true; ///< 5 to 30 times slower
#endif

/// Milliseconds after which a test gives up what it waits for. Only a test that fails takes so long, on a busy machine
/// too.
constexpr int longestWait = isSlowBuild ? 1'200'000 : 120'000;

/// Returns the number of rounds, files, dabs or the like for this run. A soak without a number of its own is a long
/// run.
template <class Number> Number byEffort(Number small, Number large)
{
    return effort() == Effort::Small ? small : large;
}

template <class Number> Number byEffort(Number small, Number large, Number soak)
{
    return effort() == Effort::Soak ? soak : byEffort(small, large);
}
