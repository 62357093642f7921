#pragma once

#include "core/analysis/mesh_check.h"
#include "core/geometry/box_tree.h"
#include "core/geometry/triangle_mesh.h"

#include <memory>
#include <optional>
#include <string>

namespace core
{
/// A closed model that serves as a brush's shape. It is scaled and moved so that the middle of its bounding box is the
/// origin and its farthest corner has distance 1. Immutable. Thread: any.
class BrushModel
{
public:
    /// The reason why a model cannot be a brush.
    enum class Fault {
        None,
        Unsound,     ///< it does not bound a solid: `report` gives details
        TooFlat,     ///< its bounding box is thinner than `minThickness` times its length
        TooSmall,    ///< its bounding box is shorter than `minLength`
        TooManyFaces ///< it has more than `maxFaces` faces
    };
    static constexpr std::size_t maxFaces = 250'000;
    static constexpr double minThickness = 1e-3,
                            minLength = 1e-5; ///< minThickness: ratio of thickness to length; minLength: mm

    struct Made
    {
        std::shared_ptr<const BrushModel> model; ///< null: the model was refused
        Fault fault = Fault::None;
        MeshReport report;
    };
    /// Checks the mesh exactly and makes a brush model of it. `source`: the path of its file, or empty. Cost:
    /// checkMesh(), plus a sort.
    static Made of(const TriangleMesh& mesh, std::string source);

    struct Span
    {
        double low, high;
    };
    /// Returns the range of y within which the vertical line through p is inside the model, around p; nothing if p is
    /// outside. Cost: the faces that the line meets.
    std::optional<Span> spanAt(const Vec3& p) const;

    const TriangleMesh& surface() const { return m_surface; }
    const std::string& source() const { return m_source; }
    /// Returns a fingerprint of the points and faces: 16 hexadecimal digits.
    const std::string& fingerprint() const { return m_fingerprint; }

private:
    BrushModel(TriangleMesh surface, std::string source);

    TriangleMesh m_surface;
    std::string m_source, m_fingerprint;
    BoxTree m_columns; ///< the faces' bounding boxes, projected along y
};
} // namespace core
