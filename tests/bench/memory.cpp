// What a model of a million vertices holds, by how much the process grows, in bytes a vertex.
#include "tests/bench/bench_models.h"
#include "tests/bench/bench_stroke.h"

#include <fstream>
#include <unistd.h>

#ifdef __GLIBC__
#include <malloc.h>
#endif

namespace
{
using core::MeshPatch;
using core::Sculptor;

/// Resident bytes of this process without what is free, 0 where that is not told.
double residentBytes()
{
#ifdef __GLIBC__
    malloc_trim(0);
#endif
    double pages = 0, resident = 0;
    std::ifstream statm("/proc/self/statm");
    statm >> pages >> resident;
    return resident * static_cast<double>(sysconf(_SC_PAGESIZE));
}

std::size_t bytesOf(const MeshPatch& patch)
{
    return patch.vertices.size() * sizeof(core::DrawVertex) + patch.faces.size() * sizeof(core::Triangle);
}

/// Mesh, octree and stamps, before and after a stroke; a whole patch for a viewer (the window keeps no copy of it, the
/// graphics card one with half as much again in reserve); one stroke's undo.
void memory(benchmark::State& state)
{
    const core::TriangleMesh& source = bench::geodesicSphere(317);
    state.SetLabel("1,004,892 vertices");
    for ([[maybe_unused]] auto round : state) {
        const double before = residentBytes();
        Sculptor sculptor(bench::opened(source));
        const double vertices = sculptor.mesh().live().vertices;
        state.counters["opened"] = (residentBytes() - before) / vertices;
        bench::measure(state, sculptor, {.radius = 0.0126});
        state.counters["sculpted"] = (residentBytes() - before) / vertices;
        const double beforePatch = residentBytes();
        const MeshPatch patch = sculptor.wholePatch();
        state.counters["patch_copy"] = (residentBytes() - beforePatch) / vertices;
        state.counters["patch_bytes"] = static_cast<double>(bytesOf(patch)) / vertices;
        state.counters["card"] = 1.5 * static_cast<double>(bytesOf(patch)) / vertices;
    }
}
BENCHMARK(memory)->Iterations(1)->UseManualTime();
} // namespace
