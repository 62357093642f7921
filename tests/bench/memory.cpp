// Measures the memory of a model of a million vertices: growth of the process in bytes per vertex.
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

/// Returns the resident bytes of this process after unused heap was returned to the system, or 0 if the system does not
/// report them.
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

/// Measures the mesh, octree and stamps, before and after a stroke; a full patch for a viewer; and the undo of a
/// stroke. The window keeps no copy of the patch; the graphics card keeps one with 50 % reserve.
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
