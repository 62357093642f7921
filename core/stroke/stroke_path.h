#pragma once

#include "core/stroke/resting_hand.h"
#include "core/stroke/sample_curve.h"

#include <functional>
#include <optional>

namespace core
{
/// Turns the samples of a stroke into dabs: one a sample with spacing 0, else evenly along the path of dab centres,
/// which is curved (SampleCurve); that of Stamp is straight. An anchored stroke is one dab, due at its end.
class StrokePath
{
public:
    /// More dabs than this between two samples are not placed: the path goes on at the later sample. A jump of
    /// kilometres would ask for more.
    static constexpr int maxDabsPerSample = 1'000'000;
    /// Nor more than this many times the number that the way to the later sample asks for when it arrives: dabs that
    /// raise the surface under the path make it longer, without end if they are stronger than far apart.
    static constexpr int maxLengthRatio = 2;

    /// Returns where the dab of a sample is to be; nothing if it would be empty.
    using CenterOf = std::function<std::optional<Vec3>(const Vec3& position, const Vec3& direction)>;

    struct Due
    {
        Dab dab;
        bool hasCenter;           ///< false: the sample's ray misses, the dab is empty
        bool isResting = false;   ///< by StrokeSettings::airbrush
        Vec3 hand = Vec3::Zero(); ///< the sample's position, in the model's space
    };

    explicit StrokePath(const StrokeSettings& settings) : m_settings(settings), m_rest(settings) {}

    void add(const StrokeSample& sample);
    /// Tells that no sample follows.
    void finish() { m_isFinished = true; }
    /// Returns the next dab that is due, or nothing until the next sample. Ask again after each dab, as it may have
    /// moved the surface, and after finish(): dabs between the first two samples of a path wait for the third, which
    /// says how it is curved.
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
    std::optional<StrokeSample> m_target; ///< the sample that the path runs to, until it has reached it
    std::optional<StrokeSample> m_after;  ///< the sample after that, where it waited for it
    std::optional<PlacedSample> m_from;   ///< the sample that the path comes from; nothing where it begins
    std::optional<PlacedSample> m_before; ///< the sample before that
    SampleCurve m_curve;                  ///< to the target
    double m_at = 0;                      ///< how far it was followed, 0 to 1
    std::optional<Vec3> m_center;         ///< of the last dab, or where the path has passed without one
    bool m_isFinished = false;
    RestingHand m_rest;
    double m_travelled = 0;        ///< since the last dab
    std::optional<Vec3> m_stamped; ///< of Stamp: where the last dab stood
    std::optional<int> m_dabsLeft; ///< until the target is reached
};
} // namespace core
