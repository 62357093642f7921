#pragma once

#include "core/sculpt/verify/dirty_neighbourhood.h"

namespace core
{
/// Divides the faces of a neighbourhood into patches that are connected by edges. Tries to certify each patch that
/// contains dirty faces; no two faces of a certified patch intersect. Functions identify a face by its index in the
/// neighbourhood. Owns scratch memory.
class PatchComponents
{
public:
    /// Finds the patches. Preconditions: gather() and buildIndex() of the neighbourhood were called. Cost: its faces.
    void find(const Mesh& mesh, const DirtyNeighbourhood& neighbourhood);

    Slot size() const { return static_cast<Slot>(m_components.size()); }
    Slot of(Slot index) const { return m_component[index]; }
    /// Returns whether the patch is a closed surface: none of its edges leads out of the neighbourhood.
    bool isClosed(Slot component) const { return m_components[component].isClosed; }
    bool isCertified(Slot component) const { return m_components[component].isCertified; }
    bool areInOneCertified(Slot i, Slot j) const
    {
        return m_component[i] == m_component[j] && m_components[m_component[i]].isCertified;
    }
    /// Returns whether there are patches with dirty faces and all of these are certified.
    bool areCertified() const;

private:
    struct Component
    {
        bool isClosed = true;
        bool isCertified = false;
    };
    void add(const Mesh& mesh, const DirtyNeighbourhood& neighbourhood, Slot seed);

    std::vector<Slot> m_component; ///< number of the patch of each face, by index in the neighbourhood
    std::vector<Component> m_components;
    Slot m_dirtyComponents = 0;           ///< number of patches with dirty faces; they are the first in m_components
    std::vector<PatchFace> m_patch;       ///< faces of the patch being added
    std::vector<BoundaryEdge> m_boundary; ///< boundary of the patch being added
    std::vector<Slot> m_front;            ///< indices of faces whose neighbours have not been visited yet
};

/// Returns the half-edge with its ends' lattice points.
BoundaryEdge boundaryEdge(const Mesh& mesh, Slot h);
} // namespace core
