#pragma once

#include "core/sculpt/verify/dirty_neighbourhood.h"

namespace core
{
/// The faces of a neighbourhood, divided into patches that edges connect. A patch with dirty faces gets a certificate
/// if it can: then no two of its faces meet where they may not. Functions name a face by its index in the
/// neighbourhood. Owns scratch memory.
class PatchComponents
{
public:
    /// Precondition: the neighbourhood is gathered and indexed. Cost: its faces.
    void find(const Mesh& mesh, const DirtyNeighbourhood& neighbourhood);

    Slot size() const { return static_cast<Slot>(m_components.size()); }
    Slot of(Slot index) const { return m_component[index]; }
    /// Whether no edge of the patch leads out of the neighbourhood.
    bool isClosed(Slot component) const { return m_components[component].isClosed; }
    bool isCertified(Slot component) const { return m_components[component].isCertified; }
    bool areInOneCertified(Slot i, Slot j) const
    {
        return m_component[i] == m_component[j] && m_components[m_component[i]].isCertified;
    }
    /// Whether there are patches with dirty faces, and each has its certificate.
    bool areCertified() const;

private:
    struct Component
    {
        bool isClosed = true;
        bool isCertified = false;
    };
    void add(const Mesh& mesh, const DirtyNeighbourhood& neighbourhood, Slot seed);

    std::vector<Slot> m_component; ///< by index in the neighbourhood
    std::vector<Component> m_components;
    Slot m_dirtyComponents = 0;           ///< the first ones, which hold dirty faces
    std::vector<PatchFace> m_patch;       ///< faces of the component that is being added
    std::vector<BoundaryEdge> m_boundary; ///< likewise
    std::vector<Slot> m_front;            ///< indices of faces whose neighbours are still to be visited
};

/// Returns a half-edge with its ends' lattice points.
BoundaryEdge boundaryEdge(const Mesh& mesh, Slot h);
} // namespace core
