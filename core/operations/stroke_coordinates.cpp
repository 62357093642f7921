#include "core/operations/stroke_coordinates.h"

#include "core/mesh/mesh.h"
#include "core/operations/mirror_image.h"
#include "core/operations/transform.h"

namespace core
{
namespace
{
constexpr int yAxis = 1;

Vec3 snapped(const Lattice& lattice, const Vec3& p)
{
    return {lattice.snap(p.x()), lattice.snap(p.y()), lattice.snap(p.z())};
}

/// Converts to the document's coordinates. Drops the symmetry if its plane is not the document's.
void shift(ViewArea& area, const Vec3& by)
{
    for (Vec3& p : area.outline)
        p -= by;
    if (area.eye)
        *area.eye -= by;
    if (area.symmetry != Symmetry::None && by[axisOf(area.symmetry)] != 0)
        area.symmetry = Symmetry::None;
}
} // namespace

Vec3 StrokeCoordinates::offset(const Mesh& mesh) const
{
    return mesh.frame().place - m_origin;
}

Stroke StrokeCoordinates::inDocument(const Stroke& stroke, const Mesh& mesh) const
{
    Stroke result = stroke;
    const Vec3 by = offset(mesh);
    if (by.isZero(0))
        return result;
    for (StrokeSample& sample : result.samples)
        sample.position -= sample.rotation * by;
    StrokeSettings& settings = result.settings;
    if (settings.symmetry != Symmetry::None && by[axisOf(settings.symmetry)] != 0)
        settings.symmetry = Symmetry::None;
    if (by.x() != 0 || by.z() != 0)
        settings.radial = 1;
    return result;
}

ModelChange StrokeCoordinates::apply(const Mesh& mesh, ModelCommand command, PartId part)
{
    const Vec3 by = offset(mesh);
    if (auto* const insert = std::get_if<Insert>(&command)) {
        insert->centre -= by;
        if (insert->primitive) {
            for (TubePoint& p : insert->primitive->path)
                p.position -= by;
        }
        if (insert->symmetry != Symmetry::None && by[axisOf(insert->symmetry)] != 0)
            insert->symmetry = Symmetry::None;
    }
    if (auto* const transform = std::get_if<Transform>(&command))
        transform->centre -= by;
    const auto shiftArea = [&](auto& any) {
        if constexpr (requires { any.area; })
            shift(any.area, by);
    };
    std::visit(shiftArea, command);
    if (const auto* const half = std::get_if<Symmetrize>(&command); half && by[axisOf(half->plane)] != 0)
        return symmetrizedBeside(mesh, *half, by);
    const bool isWhole = mesh.frame().parts.size() == 1;
    const bool movesPlace = isWhole && !by.isZero(0) && std::holds_alternative<Move>(command);
    ModelChange change = applyToCopy(mesh, movesPlace ? ModelCommand(Move{}) : command, {}, part);
    if (change.refusal != ModelRefusal::None)
        return change;
    const bool movesPart =
        !isWhole && (std::holds_alternative<Move>(command) || std::holds_alternative<Rotate>(command) ||
                     std::holds_alternative<Mirror>(command));
    if (!movesPart)
        follow(command, by, change.delta.frame);
    change.changes = change.changes || change.delta.frame != mesh.frame();
    if (change.delta.frame.place != m_origin)
        alignAfter(mesh, change);
    return change;
}

/// Appends the change of aligned() to `change`.
void StrokeCoordinates::alignAfter(const Mesh& mesh, ModelChange& change) const
{
    Mesh after = mesh;
    after.swap(change.delta);
    ModelChange alignment = aligned(after);
    if (alignment.changes) {
        after.swap(alignment.delta);
        Mesh both = mesh;
        both.beginStroke();
        both.assign(after);
        change.delta = both.endStroke();
        both.swap(change.delta);
    } else {
        after.swap(change.delta);
    }
}

/// Updates the place of the model after the command, and the origin of these coordinates.
void StrokeCoordinates::follow(const ModelCommand& command, const Vec3& offset, MeshFrame& frame)
{
    const bool isSame = offset.isZero(0);
    if (const auto* const move = std::get_if<Move>(&command); move && !isSame)
        frame.place += snapped(frame.lattice, move->by);
    if (const auto* const turn = std::get_if<Rotate>(&command); turn && !isSame)
        frame.place += snapped(frame.lattice, turn->rotation * offset - offset);
    if (const auto* const mirror = std::get_if<Mirror>(&command); mirror && !isSame)
        frame.place[mirror->axis] -= 2 * offset[mirror->axis];
    if (const auto* const scale = std::get_if<Scale>(&command))
        m_origin *= scale->factor;
    if (std::holds_alternative<Recentre>(command))
        m_origin.setZero();
    if (std::holds_alternative<PlaceOnBed>(command))
        m_origin[yAxis] = 0;
    if (isSame)
        m_origin = frame.place;
    if (std::holds_alternative<Reset>(command))
        m_origin = m_start;
}

/// Refuses to symmetrise at a plane beside the model: EmptyHalf if the model is on the side to be replaced, else
/// TooFar, because its image would be as far away on the other side.
ModelChange StrokeCoordinates::symmetrizedBeside(const Mesh& mesh, const Symmetrize& command, const Vec3& offset) const
{
    const int axis = axisOf(command.plane);
    const bool isPositive = boxOf(mesh).center()[axis] + offset[axis] > 0;
    ModelChange change;
    change.refusal = isPositive == (command.keep == Half::Positive) ? ModelRefusal::TooFar : ModelRefusal::EmptyHalf;
    return change;
}

ModelChange StrokeCoordinates::aligned(const Mesh& mesh) const
{
    const Vec3 by = offset(mesh);
    if (by.isZero(0))
        return {};
    const Box box = boxOf(mesh);
    const double reach = box.sizes().maxCoeff();
    Vec3 shift = Vec3::Zero();
    for (int axis = 0; axis < 3; ++axis)
        if (box.min()[axis] - reach < -by[axis] && -by[axis] < box.max()[axis] + reach)
            shift[axis] = by[axis];
    if (shift.isZero(0))
        return {};
    ModelChange change = applyToCopy(mesh, Move{shift});
    if (change.refusal != ModelRefusal::None)
        return {};
    for (int axis = 0; axis < 3; ++axis)
        if (shift[axis] != 0)
            change.delta.frame.place[axis] = m_origin[axis];
    return change;
}
} // namespace core
