#include "core/analysis/mesh_check.h"

#include "core/analysis/nesting.h"
#include "core/geometry/face_geometry.h"
#include "core/geometry/lattice_placement.h"
#include "core/parts/part_split.h"
#include "core/util/parallel.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <functional>
#include <utility>

namespace core
{
namespace
{
/// Progress, 0 to 1, at the end of each step.
constexpr double afterDegenerate = 0.02, afterTopology = 0.15, afterIntersections = 0.95;

constexpr std::size_t facesPerChunk = 1 << 14, pointsPerChunk = 1 << 14;

/// Sums over faces. They are added chunk by chunk in a fixed order, so that they do not depend on the threads.
struct Measures
{
    double area = 0, volume = 0;
    double minSquaredEdge = std::numeric_limits<double>::infinity(), maxSquaredEdge = 0;

    void addFace(const Vec3& a, const Vec3& b, const Vec3& c)
    {
        const Vec3 ab = b - a, ac = c - a;
        area += std::sqrt(ab.cross(ac).squaredNorm()) / 2;
        volume += a.dot(b.cross(c)) / 6;
        for (const double squared : {ab.squaredNorm(), ac.squaredNorm(), (c - b).squaredNorm()}) {
            minSquaredEdge = std::min(minSquaredEdge, squared);
            maxSquaredEdge = std::max(maxSquaredEdge, squared);
        }
    }
    void add(const Measures& other)
    {
        area += other.area;
        volume += other.volume;
        minSquaredEdge = std::min(minSquaredEdge, other.minSquaredEdge);
        maxSquaredEdge = std::max(maxSquaredEdge, other.maxSquaredEdge);
    }
};

Measures measure(const TriangleMesh& mesh, const Vec3& centre)
{
    std::vector<Measures> parts(chunksOf(mesh.triangles.size(), facesPerChunk));
    forEachChunk(mesh.triangles.size(), facesPerChunk, [&](std::size_t chunk, std::size_t begin, std::size_t end) {
        const auto point = [&](Slot corner) -> Vec3 { return mesh.points[corner].cast<double>() - centre; };
        for (std::size_t f = begin; f < end; ++f) {
            const auto& [a, b, c] = mesh.triangles[f];
            parts[chunk].addFace(point(a), point(b), point(c));
        }
    });
    Measures all;
    for (const Measures& part : parts)
        all.add(part);
    return all;
}

void addTopology(MeshReport& report, const TriangleMesh& mesh)
{
    MeshTopology topology = topologyOf(mesh.points.size(), mesh.triangles);
    report.vertices = topology.vertices;
    report.unusedVertices = mesh.points.size() - topology.vertices;
    report.closed = topology.openEdges.count == 0;
    report.manifold = topology.nonManifoldEdges.count == 0 && topology.nonManifoldVertices.count == 0;
    report.oriented = topology.misorientedEdges.count == 0 && topology.nonManifoldEdges.count == 0;
    report.components =
        report.manifold ? componentsOf(mesh.points.size(), mesh.triangles).count : edgeComponents(mesh.triangles);
    if (report.closed && report.manifold && report.oriented && report.degenerateFaces.count == 0) {
        const auto euler = static_cast<std::int64_t>(topology.vertices + mesh.triangles.size()) -
                           static_cast<std::int64_t>(topology.edges);
        report.genus = static_cast<std::int64_t>(report.components) - euler / 2;
    }
    report.openEdges = std::move(topology.openEdges);
    report.nonManifoldEdges = std::move(topology.nonManifoldEdges);
    report.nonManifoldVertices = std::move(topology.nonManifoldVertices);
    report.misorientedEdges = std::move(topology.misorientedEdges);
}

void addMeasures(MeshReport& report, const TriangleMesh& mesh, const Box& box)
{
    const Measures measures = measure(mesh, box.center());
    report.size = box.sizes();
    report.area = measures.area;
    report.minEdge = std::sqrt(measures.minSquaredEdge);
    report.maxEdge = std::sqrt(measures.maxSquaredEdge);
    if (report.closed && report.oriented)
        report.volume = measures.volume;
}

/// Returns the model's points snapped to its lattice; empty if all points are on the lattice already.
std::vector<LatticePoint> latticeImage(const TriangleMesh& mesh, const Box& box)
{
    const LatticePlacement placement = placeOnLattice(box);
    std::vector<LatticePoint> points(mesh.points.size());
    std::atomic<bool> changed = false;
    forEachChunk(points.size(), pointsPerChunk, [&](std::size_t, std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            points[i] = placement.toLattice(mesh.points[i]);
            if (!changed.load(std::memory_order_relaxed) && placement.lattice.toPoint(points[i]) != mesh.points[i])
                changed = true;
        }
    });
    if (!changed)
        points.clear();
    return points;
}

/// Checks a mesh of one part. `box`: the box of the whole model, which determines the lattice.
MeshReport checkPart(const TriangleMesh& mesh, const Box& box, const JobControl& control)
{
    MeshReport report;
    report.faces = mesh.triangles.size();
    std::vector<Slot> degenerate = degenerateFaces<FloatPredicates>(mesh.points, mesh.triangles);
    report.degenerateFaces.count = degenerate.size();
    degenerate.resize(std::min(degenerate.size(), Finding::maxFirst));
    report.degenerateFaces.firstFaces = std::move(degenerate);
    control.reportProgress(afterDegenerate);
    addTopology(report, mesh);
    control.reportProgress(afterTopology);
    addMeasures(report, mesh, box);
    const bool hasArea = report.degenerateFaces.count == 0; // every face has area; otherwise there may be no lattice
    const std::vector<LatticePoint> image = hasArea ? latticeImage(mesh, box) : std::vector<LatticePoint>();
    bool staysValid = image.empty() || degenerateFaces<LatticePredicates>(image, mesh.triangles).empty();
    if (staysValid && !image.empty()) {
        SurfaceAndImage both = selfIntersections(mesh.points, image, mesh.triangles, Finding::maxFirst, control.stop);
        report.intersections = std::move(both.surface);
        staysValid = !both.imageMeets;
    } else {
        report.intersections =
            selfIntersections<FloatPredicates>(mesh.points, mesh.triangles, Finding::maxFirst, control.stop);
    }
    control.reportProgress(afterIntersections);
    if (control.isCancelled() || !hasArea || report.intersections.count != 0)
        return report;

    if (report.closed && report.manifold && report.oriented)
        report.boundsSolid = boundsSolid(mesh.points, mesh.triangles);
    report.latticeOk = staysValid && !isTooFarForFloats(box, report.area, report.faces) &&
                       (image.empty() || !report.printReady() || boundsSolid(image, mesh.triangles));
    control.reportProgress(1);
    return report;
}

// --- a mesh of several parts

void add(Finding& all, const Finding& own, std::span<const Slot> faces)
{
    all.count += own.count;
    for (const Slot f : own.firstFaces)
        all.firstFaces.push_back(faces[f]);
    std::ranges::sort(all.firstFaces);
    all.firstFaces.resize(std::min(all.firstFaces.size(), Finding::maxFirst));
}

void add(IntersectionReport& all, const IntersectionReport& own, std::span<const Slot> faces)
{
    all.count += own.count;
    for (const FacePair& pair : own.pairs)
        all.pairs.push_back({faces[pair.first], faces[pair.second]});
    std::ranges::sort(all.pairs);
    all.pairs.resize(std::min(all.pairs.size(), Finding::maxFirst));
}

/// Combines values that are missing if one of them is.
template <class Value, class Operation>
void combine(std::optional<Value>& all, const std::optional<Value>& own, Operation operation)
{
    all = all && own ? std::optional<Value>(operation(*all, *own)) : std::nullopt;
}

/// Adds the report on a part. `faces`: index of each of its faces in the whole mesh.
void add(MeshReport& all, const MeshReport& own, std::span<const Slot> faces)
{
    all.vertices += own.vertices;
    all.closed = all.closed && own.closed;
    all.manifold = all.manifold && own.manifold;
    all.oriented = all.oriented && own.oriented;
    combine(all.boundsSolid, own.boundsSolid, std::logical_and());
    combine(all.latticeOk, own.latticeOk, std::logical_and());
    combine(all.genus, own.genus, std::plus());
    combine(all.volume, own.volume, std::plus());
    all.components += own.components;
    all.area += own.area;
    all.minEdge = std::min(all.minEdge, own.minEdge);
    all.maxEdge = std::max(all.maxEdge, own.maxEdge);
    add(all.openEdges, own.openEdges, faces);
    add(all.nonManifoldEdges, own.nonManifoldEdges, faces);
    add(all.nonManifoldVertices, own.nonManifoldVertices, faces);
    add(all.misorientedEdges, own.misorientedEdges, faces);
    add(all.degenerateFaces, own.degenerateFaces, faces);
    add(all.intersections, own.intersections, faces);
}

MeshReport checkParts(const TriangleMesh& mesh, const Box& box, const JobControl& control)
{
    MeshReport report;
    report.faces = mesh.triangles.size();
    report.size = box.sizes();
    report.closed = report.manifold = report.oriented = true;
    report.boundsSolid = report.latticeOk = true;
    report.genus = 0;
    report.volume = 0;
    report.minEdge = std::numeric_limits<double>::infinity();
    std::size_t done = 0;
    for (const PartPiece& piece : splitByPart(mesh)) {
        const std::size_t before = std::exchange(done, done + piece.faces.size());
        const auto share = [&](std::size_t faces) { return double(faces) / double(mesh.triangles.size()); };
        add(report, checkPart(piece.mesh, box, control.part(share(before), share(done))), piece.faces);
    }
    report.unusedVertices = mesh.points.size() - report.vertices;
    return report;
}
} // namespace

MeshReport checkMesh(const TriangleMesh& mesh, const JobControl& control)
{
    if (mesh.triangles.empty())
        return {};
    const Box box = boxOf(mesh);
    return mesh.parts.empty() ? checkPart(mesh, box, control) : checkParts(mesh, box, control);
}
} // namespace core
