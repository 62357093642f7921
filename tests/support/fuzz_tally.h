#pragma once

#include "core/sculpt/sculptor.h"

#include <array>
#include <cstdint>
#include <iosfwd>
#include <map>
#include <string>

/// What a fuzzer's dabs came to, in all and by class.
struct FuzzTally
{
    /// Of the dabs that had something to do.
    struct Share
    {
        std::uint64_t dabs = 0, whole = 0, endedEarly = 0;
        std::uint64_t contact = 0; ///< stopped at surfaces that may not be joined: nothing valid could follow
        double ms = 0;

        double wholePercent() const;
        /// Of those that were not stopped so.
        double wholeOfLegalPercent() const;
    };

    std::uint64_t dabs = 0, committed = 0, fallback = 0, empty = 0, added = 0, refused = 0;
    std::uint64_t strokes = 0, commands = 0, runs = 0, judged = 0;
    std::uint64_t fusions = 0, separations = 0;
    std::array<std::uint64_t, 3> tiers{};
    std::uint64_t digest = 0; ///< of all end states: the same on every machine and in every build
    Share all;
    std::map<std::string, Share> classes; ///< by tool and fusion, by shape, ...

    void add(const core::StrokeSettings& settings, const core::DabReport& report, const std::string& shape);
    void add(const core::SculptorTotals& totals);
    /// One line of counts.
    void print(std::ostream& out) const;
    /// A line for each class.
    void printClasses(std::ostream& out) const;
};
