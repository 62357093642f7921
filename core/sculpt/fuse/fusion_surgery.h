#pragma once

#include "core/sculpt/edit/mirror_map.h"
#include "core/sculpt/select/region.h"
#include "core/sculpt/verify/verified_mesh.h"

#include <optional>

namespace core
{
/// Does the surgery of fusion, each verified by itself; in a mirror together with its image, or not at all. Remembers
/// where it has failed in this dab.
class FusionSurgery
{
public:
    /// Forgets the failures. `mirror`: null, or on; then regions and surgeries are of the half.
    void beginDab(MirrorMap* mirror);
    MirrorMap* mirror() const { return m_mirror; }

    /// Returns the surgery of a half with its image; nothing if it has none.
    std::optional<Surgery> withItsImage(const VerifiedMesh& surface, const std::optional<Surgery>& half) const;

    /// Does the surgery if no mask forbids it and the result is sound. Returns the vertices that came. Vertices that
    /// went leave the region; copies join it in their original's place.
    std::optional<std::vector<Slot>> operate(VerifiedMesh& surface, Region& region, const Surgery& surgery);

    /// Whether surgery at v has not failed too often in this dab.
    bool mayTry(Slot v) const { return !m_failed.contains(v) || m_failures[m_failed.position(v)] < maxFailures; }
    void countFailure(Slot v);

private:
    static constexpr int maxFailures = 2;

    void pairUp(const Mesh& mesh, const std::vector<Slot>& created);

    MirrorMap* m_mirror = nullptr;
    SparseIndex m_failed;        ///< vertices of joins and cuts that were not sound
    std::vector<int> m_failures; ///< by position among them
};
} // namespace core
