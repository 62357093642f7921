#include "tests/support/mirror_asserts.h"

#include <algorithm>
#include <map>
#include <set>
#include <sstream>

using core::Mesh;
using core::Slot;
using core::Triangle;

namespace
{
using Bits = std::array<std::int32_t, 3>;

Bits bitsOf(const core::LatticePoint& p)
{
    return {p.x(), p.y(), p.z()};
}

Triangle turned(Triangle t)
{
    std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
    return t;
}

std::string at(const char* what, const Mesh& mesh, Slot v)
{
    std::ostringstream text;
    text << what << ' ' << v << " at " << mesh.latticePoint(v).transpose() << " (lattice units)";
    return text.str();
}
/// Returns the first vertex or face without an equal image, as a text, or an empty text. `imageOf` maps a lattice point
/// to its image. `isTurnedOver`: the image of a face has its corners in reverse order.
template <class ImageOf> std::string unlikeImage(const Mesh& mesh, ImageOf imageOf, bool isTurnedOver)
{
    std::map<Bits, Slot> vertices;
    for (Slot v = 0; v < mesh.slots().vertices; ++v) {
        if (mesh.isVertex(v) && !vertices.emplace(bitsOf(mesh.latticePoint(v)), v).second)
            return at("two vertices in one place, one of them", mesh, v);
    }
    std::map<Slot, Slot> images;
    for (const auto& [bits, v] : vertices) {
        const auto found = vertices.find(imageOf(bits));
        if (found == vertices.end())
            return at("no image of vertex", mesh, v);
        if (mesh.color(found->second) != mesh.color(v))
            return at("the image has another colour than vertex", mesh, v);
        images[v] = found->second;
    }
    std::set<Triangle> faces;
    for (Slot f = 0; f < mesh.slots().faces; ++f) {
        if (mesh.isFace(f))
            faces.insert(turned(mesh.corners(f)));
    }
    for (const Triangle& t : faces) {
        if (!faces.contains(turned({images[t[0]], images[t[isTurnedOver ? 2 : 1]], images[t[isTurnedOver ? 1 : 2]]})))
            return at("no image of a face with vertex", mesh, t[0]);
    }
    return {};
}
} // namespace

std::string mirror_asserts::asymmetry(const Mesh& mesh, core::Symmetry plane)
{
    const std::size_t axis = static_cast<std::size_t>(plane) - static_cast<std::size_t>(core::Symmetry::X);
    const auto imageOf = [axis](Bits bits) {
        bits[axis] = -bits[axis];
        return bits;
    };
    return unlikeImage(mesh, imageOf, true);
}

std::string mirror_asserts::turnedAsymmetry(const Mesh& mesh, int parts)
{
    const auto imageOf = [parts](const Bits& bits) {
        return parts == 2 ? Bits{-bits[0], bits[1], -bits[2]} : Bits{bits[2], bits[1], -bits[0]};
    };
    return unlikeImage(mesh, imageOf, false);
}
