#pragma once

#include "core/sculpt/edit/mirror_map.h"
#include "core/sculpt/select/region.h"
#include "core/sculpt/verify/verified_mesh.h"

#include <optional>

namespace core
{
/// Performs the surgeries of fusion and verifies each of them. With a mirror, each is done together with its image, or
/// not at all. Records where surgery has failed in this dab.
class FusionSurgery
{
public:
    /// Clears the recorded failures. `mirror`: null, or on; then regions and surgeries cover only the positive side.
    void beginDab(MirrorMap* mirror);
    MirrorMap* mirror() const { return m_mirror; }

    /// Returns the surgery combined with its mirror image; nothing if that is impossible. Without a mirror, returns
    /// `half`.
    std::optional<Surgery> withItsImage(const VerifiedMesh& surface, const std::optional<Surgery>& half) const;

    /// Performs the surgery if no affected vertex is masked and the result is sound. Returns the new vertices; nothing
    /// if it was not done. Removed vertices leave the region; copies of vertices join it with their originals' values.
    std::optional<std::vector<Slot>> operate(VerifiedMesh& surface, Region& region, const Surgery& surgery);

    /// Returns whether surgery at v may be tried: it has failed less than maxFailures times in this dab.
    bool mayTry(Slot v) const { return !m_failed.contains(v) || m_failures[m_failed.position(v)] < maxFailures; }
    void countFailure(Slot v);

private:
    static constexpr int maxFailures = 2;

    void pairUp(const Mesh& mesh, const std::vector<Slot>& created);

    MirrorMap* m_mirror = nullptr;
    SparseIndex m_failed;        ///< vertices at joins and cuts that were not sound
    std::vector<int> m_failures; ///< number of failures, by position in m_failed
};
} // namespace core
