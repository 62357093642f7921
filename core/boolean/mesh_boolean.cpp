// 1. lattice   puts all solids on one lattice                                                      solid_soup
// 2. cross     finds the faces that meet other solids                                              crossing_faces
// 3. part      divides the others into kept and dropped, by the solids that they lie in            solid_parts
// 4. cut       cuts crossing faces and those near, selects by winding number, rounds, cuts again   cut_region
// 5. judge     checks the whole result
// 6. separate  moves parts apart that touch at edges and points                            core/repair/resolution
// If rounding comes to no end, or moves the surface too far, all steps are repeated on finer lattices. If that does not
// help, all faces that meet any other are cut with a tolerance.

#include "core/boolean/mesh_boolean.h"

#include "core/boolean/crossing_faces.h"
#include "core/boolean/cut_region.h"
#include "core/repair/cleanup.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <tuple>

namespace core::boolean
{
namespace
{
/// Progress, 0 to 1, at the end of each step.
constexpr double afterCutting = 0.3, afterChecking = 0.7, afterSeparating = 0.9;

/// The finest lattice is 2^finest times finer than that of an import. A finer one would leave no room around the
/// solids.
constexpr int finest = 2;

/// An operation in progress.
class Boolean
{
public:
    Boolean(SetOperation operation, std::span<const TriangleMesh> solids, const JobControl& control)
        : m_operation(operation)
        , m_solids(solids)
        , m_control(control)
        , m_soup(soupOf(operation, solids))
    {}
    /// Tries one lattice only, whose points the solids have.
    Boolean(const Lattice& lattice, SetOperation operation, std::span<const TriangleMesh> solids,
            const JobControl& control)
        : m_operation(operation)
        , m_solids(solids)
        , m_control(control)
        , m_isLatticeFixed(true)
        , m_soup(soupOn({lattice, Vec3::Zero()}, operation, solids))
    {}

    BooleanResult run()
    {
        const bool isAnswered = cutExactly() || m_result.mesh || cutWithTolerance() || m_result.mesh;
        if (m_control.isCancelled())
            return {std::nullopt, BooleanRefusal::Stopped, std::nullopt, {}};
        if (!isAnswered)
            m_result.refusal = BooleanRefusal::Unresolved;
        m_control.reportProgress(1);
        return std::move(m_result);
    }

private:
    /// Tries the lattice of an import, then finer ones whose points are exact in float32. Returns whether there is a
    /// good answer.
    bool cutExactly()
    {
        if (attempt(crossingFaces(m_soup, m_control.stop), 0, m_control.part(0, afterChecking)))
            return true;
        for (int finer = 1; finer <= finest && !m_isLatticeFixed && !m_control.isCancelled(); ++finer) {
            SolidSoup soup = soupOf(m_operation, m_solids, finer);
            if (soup.placement.lattice == m_soup.placement.lattice)
                return false;
            m_soup = std::move(soup);
            if (attempt(crossingFaces(m_soup, m_control.stop), 0, {m_control.stop, {}}))
                return true;
        }
        return false;
    }

    /// Merges near points of faces that meet, on the lattice of an import, then on the finest. Returns whether there is
    /// a good answer.
    bool cutWithTolerance()
    {
        constexpr double tolerances[] = {2, 16, 128}; // lattice units; the last is 1/10,000 of the size
        for (const int finer : {0, finest}) {
            if (m_control.isCancelled() || m_result.mesh)
                return false;
            if (!m_isLatticeFixed)
                m_soup = soupOf(m_operation, m_solids, finer);
            else if (finer > 0)
                return false;
            const std::vector<Slot> meeting = meetingFaces(m_soup, m_control.stop);
            for (const double tolerance : tolerances)
                if (!m_control.isCancelled() && attempt(meeting, tolerance, {m_control.stop, {}}))
                    return true;
        }
        return false;
    }

    /// Cuts the faces that meet others. Returns whether there is a good answer.
    bool attempt(std::span<const Slot> meeting, double tolerance, const JobControl& control)
    {
        const std::vector<Fate> fates = fatesOf(m_soup, meeting);
        CutRegion region(m_soup, fates);
        const repair::Resolution resolution = region.cut(tolerance, control.part(0, afterCutting));
        note(resolution);
        if (!resolution.isDone || m_control.isCancelled())
            return false;
        PlacedSurface placed = region.merged(m_solids);
        if (accept({placed.points, placed.surface.colors, placed.surface.triangles}, placed.exactVolume,
                   control.part(afterCutting, afterChecking)))
            return true;
        return !m_control.isCancelled() && separate(placed, control.part(afterChecking, 1));
    }

    /// Takes the mesh as the result if it is empty, or print-ready and better than the one before. Returns whether it
    /// is good: its surface is within about one lattice unit of the exact one. `exactVolume`: lattice units^3.
    bool accept(TriangleMesh mesh, double exactVolume, const JobControl& control)
    {
        constexpr double good = 1, worst = 4; // mean distances from the exact surface, lattice units
        if (mesh.triangles.empty()) {
            m_result = {std::nullopt, BooleanRefusal::LeavesNothing, std::nullopt, {}};
            return true;
        }
        MeshReport report = checkMesh(mesh, control);
        if (!report.printReady() || m_control.isCancelled())
            return false;
        const double unit = m_soup.placement.lattice.unit();
        const double distance = std::abs(*report.volume - exactVolume * unit * unit * unit) / report.area;
        if (distance < std::min(m_distance, worst * unit)) {
            m_distance = distance;
            m_result = {std::move(mesh), BooleanRefusal::None, std::nullopt, std::move(report)};
        }
        return distance <= good * unit;
    }

    bool separate(PlacedSurface& placed, const JobControl& control)
    {
        constexpr std::uint64_t maxCutAgain = 5'000; // pairs of faces: about a second
        std::uint64_t budget = maxCutAgain;
        std::map<std::tuple<int, int, int>, Vec3f> off; // points off the lattice, by the nearest lattice point
        repair::TriangleSoup& surface = placed.surface;
        for (std::size_t v = 0; v < surface.points.size(); ++v)
            if (const LatticePoint& p = surface.points[v]; m_soup.pointAt(p) != placed.points[v])
                off.emplace(std::tuple(p.x(), p.y(), p.z()), placed.points[v]);
        repair::weld(surface);
        repair::cleanUp(surface, repair::Duplicates::Cancel);
        const repair::Resolution resolution = repair::resolveIntersections(surface, repair::Inside::Positive, {}, 0,
                                                                           budget, control.part(0, afterSeparating));
        note(resolution);
        if (m_control.isCancelled())
            return false;
        repair::weld(surface);
        TriangleMesh mesh{{}, surface.colors, surface.triangles};
        TriangleMesh rounded = mesh;
        for (const LatticePoint& p : surface.points) {
            rounded.points.push_back(m_soup.pointAt(p));
            const auto found = off.find({p.x(), p.y(), p.z()});
            mesh.points.push_back(found == off.end() ? rounded.points.back() : found->second);
        }
        return accept(std::move(mesh), placed.exactVolume, control.part(afterSeparating, 1)) ||
               (!off.empty() && accept(std::move(rounded), placed.exactVolume, {m_control.stop, {}}));
    }

    void note(const repair::Resolution& resolution)
    {
        if (resolution.unresolved && !m_result.mesh)
            m_result.place = m_soup.pointAt(*resolution.unresolved).cast<double>();
    }

    SetOperation m_operation;
    std::span<const TriangleMesh> m_solids;
    const JobControl& m_control;
    bool m_isLatticeFixed = false;
    SolidSoup m_soup;
    BooleanResult m_result;
    double m_distance = std::numeric_limits<double>::infinity(); ///< mean distance of the result from the exact one, mm
};
} // namespace
} // namespace core::boolean

namespace core
{
BooleanResult combine(SetOperation operation, std::span<const TriangleMesh> solids, const JobControl& control)
{
    return boolean::Boolean(operation, solids, control).run();
}

BooleanResult combineOn(const Lattice& lattice, SetOperation operation, std::span<const TriangleMesh> solids,
                        const JobControl& control)
{
    return boolean::Boolean(lattice, operation, solids, control).run();
}
} // namespace core
