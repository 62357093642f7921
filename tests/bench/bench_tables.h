#pragma once

#include <benchmark/benchmark.h>

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace bench
{
/// A counter of a benchmark as it is printed, or its ratio to that of another row.
struct Column
{
    std::string counter, heading;
    int digits = 2;
    std::optional<std::size_t> over = {}; ///< the row that it is divided by
};
struct Table
{
    std::string benchmark; ///< its function's name
    std::string title;
    std::vector<Column> columns;
};

/// Prints a table for each benchmark that has one, its rows named by their labels. Of repeated runs, the least value of
/// each counter: on a shared machine only the least is the program's own.
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
        std::map<std::string, double> least; ///< by counter
    };
    using Rows = std::map<std::int64_t, Row>; ///< by the order of registration

    void print(const Table& table, const Rows& rows);

    std::vector<Table> m_tables;
    std::map<std::string, Rows> m_rows; ///< by benchmark
};
} // namespace bench
