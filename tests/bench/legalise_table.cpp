// Prints a table of what legalise does to each bad model, or to the given files. CGAL's verdict is the last column but
// one.
#include "core/io/mesh_io.h"
#include "core/repair/repair.h"
#include "tests/support/bad_models.h"
#include "tests/support/cgal_judge.h"

#include <chrono>
#include <cstdio>

namespace
{
using namespace core;

std::string whatIsWrong(const TriangleMesh& mesh)
{
    const MeshReport r = checkMesh(mesh);
    std::string words;
    const auto add = [&](std::uint64_t count, const char* what) {
        if (count > 0)
            words += (words.empty() ? "" : ", ") + std::to_string(count) + " " + what;
    };
    add(r.openEdges.count, "open");
    add(r.nonManifoldEdges.count, "edges");
    add(r.nonManifoldVertices.count, "vertices");
    add(r.misorientedEdges.count, "turned");
    add(r.degenerateFaces.count, "flat");
    add(r.intersections.count, "meeting");
    if (words.empty())
        words = r.printReady() ? "nothing" : "no solid";
    return words;
}

void row(const std::string& name, const TriangleMesh& mesh)
{
    const auto start = std::chrono::steady_clock::now();
    const RepairResult result = repairMesh(mesh);
    const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    const RepairReport& r = result.report;
    std::printf("| %s | %zu | %s | ", name.c_str(), mesh.triangles.size(), whatIsWrong(mesh).c_str());
    if (!result.mesh) {
        std::printf("refused (%d) | | | | | | %.2f |\n", static_cast<int>(result.refusal), seconds);
        return;
    }
    const auto verdict = judgedByCgal(*result.mesh);
    std::printf("%zu | welded %zu joined %zu in %.4f mm flat %zu double %zu turned %zu sheets %zu holes %zu inner %zu "
                "meeting %llu in %zu "
                "apart %zu+%zu%s"
                " | %.4f, %.5f | %.4f, %.5f | %s | %.2f |\n",
                result.mesh->triangles.size(), r.welded, r.joined, r.joinedWithin, r.degenerateFaces, r.duplicateFaces,
                r.turnedFaces, r.membraneFaces + r.sheets, r.holes, r.innerParts,
                static_cast<unsigned long long>(r.intersections), r.rounds, r.touchingEdges, r.touchingVertices,
                r.remeshedAt ? (" remeshed at " + std::to_string(*r.remeshedAt)).c_str() : "", r.fromOld.largest,
                r.fromOld.mean, r.fromNew.largest, r.fromNew.mean, verdict && verdict->allWell() ? "sound" : "WRONG",
                seconds);
}
} // namespace

int main(int argc, char** argv)
{
    std::puts(
        "| model | faces | wrong | faces after | done | from the old: largest, mean mm | from the new | CGAL | s |");
    std::puts("|---|---|---|---|---|---|---|---|---|");
    if (argc < 2)
        for (const BadModel& bad : badModels())
            row(bad.name, bad.mesh);
    for (int i = 1; i < argc; ++i)
        row(argv[i], readMesh(argv[i]));
}
