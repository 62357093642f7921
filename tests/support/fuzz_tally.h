#pragma once

#include "core/sculpt/sculptor.h"

#include <array>
#include <cstdint>
#include <iosfwd>
#include <map>
#include <string>

/// Statistics of the dabs of fuzzer runs, in total and by class.
struct FuzzTally
{
    /// Statistics of those dabs that had something to move.
    struct Share
    {
        std::uint64_t dabs = 0, whole = 0, endedEarly = 0;
        std::uint64_t contact = 0; ///< dabs stopped at surfaces that must not be joined: no valid motion was left
        double ms = 0;

        double wholePercent() const;
        /// Percentage of whole dabs among those not counted in `contact`.
        double wholeOfLegalPercent() const;
    };

    std::uint64_t dabs = 0, committed = 0, fallback = 0, empty = 0, added = 0, refused = 0;
    std::uint64_t strokes = 0, commands = 0, runs = 0, judged = 0;
    std::uint64_t fusions = 0, separations = 0;
    std::array<std::uint64_t, 3> tiers{};
    std::uint64_t digest = 0; ///< hash of all end states, equal on every machine and in every build
    Share all;
    std::map<std::string, Share> classes; ///< key: tool and fusion, shape, brush, topology …

    void add(const core::StrokeSettings& settings, const core::DabReport& report, const std::string& shape);
    void add(const core::SculptorTotals& totals);
    /// Prints all counts in one line.
    void print(std::ostream& out) const;
    /// Prints one line for each class.
    void printClasses(std::ostream& out) const;
};
