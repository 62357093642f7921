#pragma once

#include "core/analysis/mesh_check.h"
#include "core/geometry/box_tree.h"
#include "core/geometry/triangle_mesh.h"

#include <memory>
#include <optional>
#include <string>

namespace core
{
/// A closed model as a brush's shape: the middle of its box at the origin, its farthest corner at distance 1.
/// Immutable: any thread.
class BrushModel
{
public:
    /// Why a model is no brush.
    enum class Fault {
        None,
        Unsound,     ///< it does not bound a solid: `report` says why
        TooFlat,     ///< its box is thinner than `minThickness` of its length
        TooSmall,    ///< its box is shorter than `minLength`
        TooManyFaces ///< more than `maxFaces`
    };
    static constexpr std::size_t maxFaces = 250'000;
    static constexpr double minThickness = 1e-3, minLength = 1e-5; ///< mm

    struct Made
    {
        std::shared_ptr<const BrushModel> model; ///< null: refused
        Fault fault = Fault::None;
        MeshReport report;
    };
    /// Checks the model exactly. `source`: the path of its file, or empty. Cost: checkMesh, and a sort.
    static Made of(const TriangleMesh& mesh, std::string source);

    struct Span
    {
        double low, high;
    };
    /// Of the line through p along y, what around p lies inside; nothing if p is outside. Cost: the faces that the line
    /// meets.
    std::optional<Span> spanAt(const Vec3& p) const;

    const TriangleMesh& surface() const { return m_surface; }
    const std::string& source() const { return m_source; }
    /// Of its points and faces, in 16 hex digits.
    const std::string& fingerprint() const { return m_fingerprint; }

private:
    BrushModel(TriangleMesh surface, std::string source);

    TriangleMesh m_surface; ///< without colours
    std::string m_source, m_fingerprint;
    BoxTree m_columns; ///< the faces' boxes, seen along y
};
} // namespace core
