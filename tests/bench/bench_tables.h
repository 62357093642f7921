#pragma once

#include <benchmark/benchmark.h>

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace bench
{
/// A column of a table: a counter of a benchmark, or its ratio to that counter in another row.
struct Column
{
    std::string counter, heading;
    int digits = 2;
    /// index of the row whose counter is the divisor; none: the counter itself is printed
    std::optional<std::size_t> over = {};
};
struct Table
{
    std::string benchmark; ///< name of the benchmark's function
    std::string title;
    std::vector<Column> columns;
};

/// Prints a table for each benchmark that has one. Rows are named by their labels.
/// Repeated runs are reduced to the smallest value of each counter, because other load on the machine only adds to it.
class TableReporter : public benchmark::BenchmarkReporter
{
public:
    explicit TableReporter(std::vector<Table> tables) : m_tables(std::move(tables)) {}

    bool ReportContext(const Context& context) override;
    void ReportRuns(const std::vector<Run>& runs) override;
    void Finalize() override;

private:
    struct Row
    {
        std::string label;
        std::map<std::string, double> least; ///< smallest value of each counter; key: its name
    };
    using Rows = std::map<std::int64_t, Row>; ///< key: order of registration

    void print(const Table& table, const Rows& rows);

    std::vector<Table> m_tables;
    std::map<std::string, Rows> m_rows; ///< key: name of the benchmark
};
} // namespace bench
