#include "tests/bench/bench_tables.h"

#include <algorithm>
#include <iomanip>
#include <sstream>

namespace bench
{
namespace
{
using Lines = std::vector<std::vector<std::string>>;

std::string toText(double value, int digits)
{
    std::ostringstream text;
    text << std::fixed << std::setprecision(digits) << value;
    return text.str();
}

/// Returns whether a run failed. Google Benchmark 1.8 has the reason `skipped` in place of the flag `error_occurred`.
template <typename Run> bool hasFailed(const Run& run)
{
    if constexpr (requires { run.error_occurred; })
        return run.error_occurred;
    else
        return static_cast<bool>(run.skipped);
}

/// Prints the lines as a table: the first column is aligned left, numbers are aligned right.
void printAligned(std::ostream& out, const Lines& lines)
{
    std::vector<std::size_t> widths(lines.front().size());
    for (const auto& line : lines) {
        for (std::size_t i = 0; i < line.size(); ++i)
            widths[i] = std::max(widths[i], line[i].size());
    }
    for (const auto& line : lines) {
        out << std::left << std::setw(static_cast<int>(widths[0])) << line[0] << std::right;
        for (std::size_t i = 1; i < line.size(); ++i)
            out << "  " << std::setw(static_cast<int>(widths[i])) << line[i];
        out << '\n';
    }
}
} // namespace

bool TableReporter::ReportContext(const Context&)
{
    return true;
}

void TableReporter::ReportRuns(const std::vector<Run>& runs)
{
    for (const Run& run : runs) {
        if (run.run_type != Run::RT_Iteration || hasFailed(run))
            continue;
        Row& row = m_rows[run.run_name.function_name][run.per_family_instance_index];
        row.label = run.report_label;
        for (const auto& [name, counter] : run.counters) {
            const auto [known, isNew] = row.least.try_emplace(name, counter.value);
            known->second = std::min<double>(known->second, counter.value);
        }
    }
}

void TableReporter::Finalize()
{
    for (const Table& table : m_tables) {
        if (m_rows.contains(table.benchmark))
            print(table, m_rows.at(table.benchmark));
    }
}

void TableReporter::print(const Table& table, const Rows& rows)
{
    Lines lines(1, {""});
    for (const Column& column : table.columns)
        lines[0].push_back(column.heading);
    for (const auto& [index, row] : rows) {
        lines.push_back({row.label});
        for (const Column& column : table.columns) {
            const auto value = row.least.find(column.counter);
            const bool isKnown = value != row.least.end() && (!column.over || rows.contains(*column.over));
            const double unit = isKnown && column.over ? rows.at(*column.over).least.at(column.counter) : 1;
            lines.back().push_back(isKnown ? toText(value->second / unit, column.digits) : "-");
        }
    }
    GetOutputStream() << '\n' << table.title << "\n\n";
    printAligned(GetOutputStream(), lines);
    GetOutputStream().flush();
}
} // namespace bench
