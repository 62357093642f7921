// Prints tables of costs: of a dab (the paper's Table 1, scale, large dabs, strength, tools), drawings, the print
// check, files, booleans, the journal and memory. Run by hand, on a release build:
//   fettle_bench
//   [--benchmark_filter=table1|peersStroke|largeDab|strength|tools|drags|drawing|print|files|memory|boolean|parts]
//   [--benchmark_filter=strongPulls|journal]
//   FETTLE_AGED_DABS=100000 fettle_bench --benchmark_filter=agedStroke
// Each row is run five times, interleaved; the smallest value of each counter is printed. A quick estimate:
// --benchmark_repetitions=1.

#include "tests/bench/bench_tables.h"

namespace
{
const std::vector<bench::Column> dabColumns = {
    {"vertices", "vertices", 0}, {"touched", "touched", 0},     {"cpu", "cpu", 0},       {"cpu", "/ row 1", 2, 0},
    {"cpu", "/ row 2", 2, 1},    {"per_vertex", "a vertex", 3}, {"cpu_p99", "p99", 0},   {"cpu_first", "first", 0},
    {"wall", "wall", 0},         {"wall_p99", "wall p99", 0},   {"verify", "verify", 0}, {"patch", "patch", 0},
    {"stroke", "stroke", 0},     {"whole", "whole", 3},
};

std::vector<bench::Table> tables()
{
    const std::vector<bench::Column> largeColumns = {{"touched", "touched", 0},     {"cpu", "cpu", 0},
                                                     {"cpu_all", "all threads", 0}, {"wall", "wall", 0},
                                                     {"wall_p99", "wall p99", 0},   {"per_vertex", "a vertex", 3},
                                                     {"verify", "verify", 0},       {"whole", "whole", 3}};
    return {
        {"table1",
         "Table 1 of the paper: milliseconds an operation, mean of 20 (wall times; cpu: the thread's; p: the paper's, "
         "on an i7-11700F)",
         {{"touched", "touched", 0},
          {"select", "select", 4},
          {"paper_select", "p", 4},
          {"optimise", "optimise", 4},
          {"paper_optimise", "p", 4},
          {"deform", "deform", 4},
          {"paper_deform", "p", 4},
          {"fuse", "fuse", 4},
          {"verify", "verify", 4},
          {"patch", "patch", 4},
          {"cpu", "cpu", 4},
          {"total", "total", 4},
          {"paper_total", "p", 4}}},
        {"peersStroke",
         "Scale: microseconds a dab of 0.02 radii (medians; cpu is the thread's; stroke: to begin and end it)",
         dabColumns},
        {"agedStroke", "Scale, after many dabs: microseconds a dab", dabColumns},
        {"largeDab", "Large dabs: microseconds a dab", largeColumns},
        {"strength",
         "Five times the displacement: microseconds a dab",
         {{"touched", "touched", 0},
          {"cpu", "cpu", 0},
          {"cpu", "/ row 1", 2, 0},
          {"wall", "wall", 0},
          {"per_vertex", "a vertex", 3},
          {"whole", "whole", 3}}},
        {"strongPulls",
         "2,000 pulls by 0.4 to 1 radii: % that reach 95 % of it, % that end early, milliseconds a dab, what is left",
         {{"whole", "whole", 2},
          {"early", "early", 2},
          {"cpu", "median", 1},
          {"cpu_p99", "p99", 1},
          {"cpu_most", "most", 1},
          {"genus", "genus", 0},
          {"parts", "parts", 0}}},
        {"tools",
         "Tools, 40,962 vertices, radius 0.2, strength 1: microseconds a dab",
         {{"touched", "touched", 0},
          {"cpu", "cpu", 0},
          {"per_vertex", "a vertex", 3},
          {"per_vertex", "/ pull", 2, 0},
          {"verify", "verify", 0},
          {"whole", "whole", 3}}},
        {"drags",
         "Drags along the surface, dabs of 0.1 radii, 40,962 vertices, radius 0.2: microseconds a dab",
         {{"touched", "touched", 0},
          {"cpu", "cpu", 0},
          {"cpu_p99", "p99", 0},
          {"per_vertex", "a vertex", 3},
          {"per_vertex_mean", "in all", 3},
          {"whole", "whole", 3}}},
        {"drawing", "Drawings of 1,004,892 vertices, three views: milliseconds", {{"wall", "wall", 1}}},
        {"drawingStroke",
         "The same while a stroke goes on, each fifth dab drawn: milliseconds",
         {{"apply", "patch", 1}, {"wall", "all", 1}, {"worst", "worst", 1}}},
        {"files",
         "Files of 1,004,892 vertices, read in no order: milliseconds; plain: as many bytes, without a look at them",
         {{"megabytes", "MB", 0},
          {"plain", "plain read", 1},
          {"read", "read", 1},
          {"read_plain", "/ plain", 2},
          {"assimp", "Assimp", 0},
          {"build", "document", 0},
          {"plain_write", "plain write", 0},
          {"write", "write", 0}}},
        {"boolean",
         "Two balls of 1,003,520 triangles, combined and judged: milliseconds",
         {{"faces", "triangles", 0}, {"wall", "wall", 0}}},
        {"parts",
         "A stroke on one part of 50,412 vertices, alone and among 19 others: microseconds a dab",
         {{"vertices", "vertices", 0},
          {"touched", "touched", 0},
          {"cpu", "cpu", 0},
          {"cpu_p99", "p99", 0},
          {"wall", "wall", 0},
          {"verify", "verify", 0},
          {"patch", "patch", 0},
          {"stroke", "stroke", 0},
          {"undo", "undo", 0}}},
        {"print", "Print check of 1,004,892 vertices: milliseconds", {{"wall", "wall", 1}}},
        {"journal",
         "Journal, strokes of 24 dabs: microseconds of the mesh thread without it and with it, bytes a dab, "
         "milliseconds of its own threads",
         {{"without_dab_us", "dab", 0},
          {"with_dab_us", "with", 0},
          {"without_dab_p99_us", "dab p99", 0},
          {"with_dab_p99_us", "with", 0},
          {"without_end_us", "end", 0},
          {"copy_us", "copy", 0},
          {"copy_worst_us", "worst", 0},
          {"bytes_a_dab", "bytes", 0},
          {"start_ms", "start", 1},
          {"pack_ms_a_stroke", "pack", 2},
          {"write_ms_a_stroke", "write", 2},
          {"worst_written_ms", "written", 1},
          {"worst_synced_ms", "synced", 1},
          {"compactions", "bases", 0},
          {"recover_ms", "recover", 0}}},
        {"memory",
         "Memory: bytes a vertex",
         {{"opened", "opened", 0},
          {"sculpted", "after a stroke", 0},
          {"patch_copy", "whole patch", 0},
          {"patch_bytes", "of it values", 0},
          {"card", "graphics card", 0}}},
    };
}
} // namespace

int main(int count, char** arguments)
{
    char repetitions[] = "--benchmark_repetitions=5", interleaving[] = "--benchmark_enable_random_interleaving=true";
    std::vector<char*> all = {arguments[0], repetitions,
                              interleaving}; // placed first, because later options of the caller override them
    all.insert(all.end(), arguments + 1, arguments + count);
    int allCount = static_cast<int>(all.size());
    benchmark::Initialize(&allCount, all.data());
    if (benchmark::ReportUnrecognizedArguments(allCount, all.data()))
        return 2;
    bench::TableReporter reporter(tables());
    benchmark::RunSpecifiedBenchmarks(&reporter);
    benchmark::Shutdown();
    return 0;
}
