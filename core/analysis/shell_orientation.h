#pragma once

#include "core/geometry/lattice_box.h"

namespace core
{
/// Does a closed, embedded shell face the right way at its depth: outwards (positive volume) inside an even number of
/// other shells, inwards inside an odd number? Exact: integer volume, and the parity of the faces above one of its
/// vertices.
class ShellOrientation
{
public:
    using Points = std::array<LatticePoint, 3>;

    ShellOrientation() = default;
    /// Of a point instead of a shell: then isInside() is the question.
    explicit ShellOrientation(const LatticePoint& origin) : m_origin(origin) {}

    /// A face of the shell itself.
    void addFace(const Points& points);
    /// The other faces that can lie above the probe meet this box. Precondition: the shell has a face.
    LatticeBox column() const;
    /// A face of another shell; it does not touch this one.
    void castAt(const Points& points);
    bool isInside() const { return m_odd; }
    bool isCorrectlyOriented() const { return (m_sixVolumes > 0) == !m_odd; }

private:
    __extension__ using Int128 = __int128;

    Int128 m_sixVolumes = 0;
    LatticePoint m_origin = LatticePoint::Constant(std::numeric_limits<int>::min());
    bool m_odd = false;
};
} // namespace core
