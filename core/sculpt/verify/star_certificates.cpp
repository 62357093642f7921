#include "core/sculpt/verify/star_certificates.h"

#include "core/sculpt/verify/patch_certificate.h"
#include "core/util/parallel.h"

#include <algorithm>

namespace core
{
namespace
{
/// Stars that a core takes at a time: some ten microseconds of work, so that small dabs do not wake the others.
constexpr std::size_t starsPerChunk = 128;
} // namespace

void StarCertificates::clear()
{
    m_vertices.clear();
    m_isCertified.clear();
}

bool StarCertificates::certify(const Mesh& mesh)
{
    m_isCertified.resize(m_vertices.size());
    forEachChunk(m_vertices.size(), starsPerChunk, [&](std::size_t, std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i)
            m_isCertified[i] = certifyStar(mesh, m_vertices.slots()[i]);
    });
    return std::ranges::find(m_isCertified, 0) == m_isCertified.end();
}
} // namespace core
