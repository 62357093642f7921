#include "tests/support/fuzz_tally.h"

#include <iomanip>
#include <ostream>

using core::DabOutcome;
using core::DabReport;
using core::StrokeSettings;

namespace
{
/// Share of the requested displacement above which a dab counts as whole, as in core::DabReport::isWhole().
constexpr double wholeShare = 0.95;

double percent(std::uint64_t part, std::uint64_t of)
{
    return of > 0 ? 100.0 * static_cast<double>(part) / static_cast<double>(of) : 100;
}
} // namespace

double FuzzTally::Share::wholePercent() const
{
    return percent(whole, dabs);
}

double FuzzTally::Share::wholeOfLegalPercent() const
{
    return percent(whole, dabs - contact);
}

void FuzzTally::add(const StrokeSettings& settings, const DabReport& report, const std::string& shape)
{
    ++dabs;
    committed += report.outcome == DabOutcome::Committed;
    fallback += report.outcome == DabOutcome::Fallback;
    empty += report.outcome == DabOutcome::Empty;
    added += report.outcome == DabOutcome::Added;
    refused += report.outcome == DabOutcome::Refused;
    const bool sculpts = report.outcome != DabOutcome::Empty && report.outcome != DabOutcome::Added &&
                         report.outcome != DabOutcome::Refused && !paintsAttribute(settings.tool);
    if (!sculpts)
        return;
    const auto count = [&](Share& share) {
        ++share.dabs;
        const bool whole = report.reached >= wholeShare * report.asked;
        share.whole += whole;
        share.contact += !whole && report.contact;
        share.endedEarly += report.outcome == DabOutcome::EndedEarly;
        share.ms += report.totalMs;
    };
    count(all);
    count(classes[std::string(name(settings.tool)) + (settings.fusion ? ", fusion" : ", no fusion")]);
    count(classes["on " + shape]);
    count(classes["brush " + std::string(name(settings.brush))]);
    count(classes["topology " + std::string(name(settings.topology))]);
    if (settings.symmetry != core::Symmetry::None)
        count(classes[report.asymmetric ? "mirrored, as two dabs" : "mirrored, exactly"]);
    if (settings.radial > 1)
        count(classes[report.sequential ? "radial, not exactly" : "radial"]);
}

void FuzzTally::add(const core::SculptorTotals& totals)
{
    for (std::size_t i = 0; i < tiers.size(); ++i)
        tiers[i] += totals.verifyTiers[i];
    fusions += totals.fusions;
    separations += totals.separations;
}

void FuzzTally::print(std::ostream& out) const
{
    out << "fuzzer: " << dabs << " dabs, " << strokes << " strokes, " << commands << " commands, " << runs << " runs, "
        << judged << " CGAL checks; " << committed << " committed, " << fallback << " careful, " << all.endedEarly
        << " ended early (" << percent(all.endedEarly, all.dabs) << " %), " << empty << " empty, " << added
        << " spheres added, " << refused << " refused; of " << all.dabs << " that were to move something " << all.whole
        << " reached 95 % of what was asked (" << all.wholePercent() << " %, " << all.wholeOfLegalPercent()
        << " % without the " << all.contact
        << " stopped by contact that may not be joined); proved by patch, stars, pairs: " << tiers[0] << ' ' << tiers[1]
        << ' ' << tiers[2] << "; " << fusions << " fusions, " << separations << " separations; digest " << std::hex
        << digest << std::dec << std::endl;
}

void FuzzTally::printClasses(std::ostream& out) const
{
    out << std::fixed << std::setprecision(2);
    for (const auto& [name, share] : classes) {
        out << std::left << std::setw(24) << name << std::right << std::setw(8) << share.dabs << " dabs, whole "
            << std::setw(6) << share.wholePercent() << " %, without contact " << std::setw(6)
            << share.wholeOfLegalPercent() << " %, ended early " << std::setw(5)
            << percent(share.endedEarly, share.dabs) << " %, " << share.ms / static_cast<double>(share.dabs)
            << " ms a dab\n";
    }
    out << std::defaultfloat << std::setprecision(6) << std::flush;
}
