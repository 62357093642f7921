#pragma once

#include "core/geometry/lattice_box.h"

namespace core
{
/// Decides whether a closed, embedded shell faces the right way at its nesting depth. It must face outwards (positive
/// volume) inside an even number of other shells, inwards inside an odd number. Exact: uses the integer volume and the
/// parity of the faces above one vertex of the shell.
class ShellOrientation
{
public:
    using Points = std::array<LatticePoint, 3>;

    ShellOrientation() = default;
    /// Tests a point instead of a shell: isInside() then returns whether the point is inside.
    explicit ShellOrientation(const LatticePoint& origin) : m_origin(origin) {}

    /// Adds a face of the shell itself.
    void addFace(const Points& points);
    /// Returns the box that every face above the shell's probe point meets. Precondition: the shell has a face.
    LatticeBox column() const;
    /// Counts a face of another shell if it is above the probe point. Precondition: the face does not touch this shell.
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
