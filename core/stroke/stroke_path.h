#pragma once

#include "core/stroke/resting_hand.h"
#include "core/stroke/sample_curve.h"

#include <functional>
#include <optional>

namespace core
{
/// Turns the samples of a stroke into dabs. With spacing 0 each sample makes one dab. Otherwise dabs are spaced evenly
/// along the path of dab centres, which is curved (SampleCurve) except for Stamp. An anchored stroke makes one dab, at
/// its end.
class StrokePath
{
public:
    /// Largest number of dabs between two samples; the rest of the path up to the later sample gets none. A jump of
    /// kilometres would need more.
    static constexpr int maxDabsPerSample = 1'000'000;
    /// Limits the dabs between two samples to this many times the number that fit between them when the later sample
    /// arrives. Dabs that raise the surface lengthen the path along it; strong dabs with a small spacing would lengthen
    /// it without end.
    static constexpr int maxLengthRatio = 2;

    /// Returns the centre of the dab of a sample; nothing if the dab would be empty. Position and direction are in
    /// model space.
    using CenterOf = std::function<std::optional<Vec3>(const Vec3& position, const Vec3& direction)>;

    struct Due
    {
        Dab dab;
        bool hasCenter;           ///< false: the sample's ray misses the surface, so the dab is empty
        bool isResting = false;   ///< an airbrush dab, made while the pointer is at rest (StrokeSettings::airbrush)
        Vec3 hand = Vec3::Zero(); ///< the sample's position in model space, mm
    };

    explicit StrokePath(const StrokeSettings& settings) : m_settings(settings), m_rest(settings) {}

    void add(const StrokeSample& sample);
    /// Declares that no further sample follows.
    void finish() { m_isFinished = true; }
    /// Returns the next dab that is due; nothing until the next sample. To be called again after each dab, because the
    /// dab may have moved the surface, and after finish(). Dabs between the first two samples of a path wait for the
    /// third sample, which determines the curve, except those of Stamp.
    std::optional<Due> next(const CenterOf& centerOf);

private:
    std::optional<Due> nextAnchored(const CenterOf& centerOf);
    void dragOut(Due& due, const StrokeSample& last) const;
    bool isWaiting() const { return !m_before && !m_after && !m_isFinished; }
    Due due(const StrokeSample& sample, const CenterOf& centerOf) const;
    void arriveAtTarget(const Due& due);
    std::optional<Due> nextResting(const CenterOf& centerOf);
    std::optional<Due> nextOnCurve(const Due& end, const CenterOf& centerOf);
    SampleCurve curveTo(const Due& end, const CenterOf& centerOf) const;
    double stepOf(const Dab& dab) const;
    std::optional<Due> nextStamp(const Due& end, const CenterOf& centerOf);

    StrokeSettings m_settings;
    std::optional<StrokeSample> m_target; ///< the sample that the path leads to; empty once it is reached
    std::optional<StrokeSample> m_after;  ///< the sample after the target, while dabs wait for it
    std::optional<PlacedSample> m_from;   ///< the sample where the current segment starts; empty at the start of a path
    std::optional<PlacedSample> m_before; ///< the sample before m_from
    SampleCurve m_curve;                  ///< curve from m_from to the target
    double m_at = 0;                      ///< position reached on m_curve, 0 to 1
    std::optional<Vec3> m_center; ///< centre of the last dab, or the last point of the path if no dab was made there
    bool m_isFinished = false;
    RestingHand m_rest;
    double m_travelled = 0;        ///< distance along the path since the last dab, mm
    std::optional<Vec3> m_stamped; ///< Stamp: centre of the last dab
    std::optional<int> m_dabsLeft; ///< number of dabs still allowed before the target
};
} // namespace core
