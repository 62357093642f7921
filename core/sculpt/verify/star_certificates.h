#pragma once

#include "core/mesh/mesh.h"
#include "core/util/sparse_index.h"

namespace core
{
/// Certificates of the faces around vertices (certifyStar). Owns scratch memory.
class StarCertificates
{
public:
    void clear();
    void add(Slot v) { m_vertices.add(v); }
    /// Tries to certify the stars of the vertices that were added. False if one has no certificate.
    bool certify(const Mesh& mesh);
    bool isCertified(Slot v) const { return m_vertices.contains(v) && m_isCertified[m_vertices.position(v)]; }

private:
    SparseIndex m_vertices;
    std::vector<char> m_isCertified; ///< by position among them
};
} // namespace core
