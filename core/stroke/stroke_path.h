#pragma once

#include "core/stroke/stroke.h"

#include <functional>
#include <optional>

namespace core
{
/// Turns the samples of a stroke into dabs: one a sample with spacing 0, else evenly along the path of dab centres,
/// which runs straight between samples.
class StrokePath
{
public:
    /// More dabs than this between two samples are not placed: the path goes on at the later sample. A jump of
    /// kilometres would ask for more.
    static constexpr int maxDabsPerSample = 1'000'000;
    /// Nor more than this many times the number that the way to the later sample asks for when it arrives: dabs that
    /// raise the surface under the path make it longer, without end if they are stronger than far apart.
    static constexpr int maxLengthRatio = 2;

    /// Where the dab of a sample would stand on the surface as it is now; nothing if it would be empty.
    using CenterOf = std::function<std::optional<Vec3>(const Vec3& position, const Vec3& direction)>;

    struct Due
    {
        Dab dab;
        bool hasCenter; ///< false: the sample's ray misses, the dab is empty
    };

    explicit StrokePath(const StrokeSettings& settings) : m_settings(settings) {}

    void add(const StrokeSample& sample);
    /// The next dab that is due, or nothing until the next sample. Ask again after each dab: it may have moved the
    /// surface.
    std::optional<Due> next(const CenterOf& centerOf);

private:
    Due due(const StrokeSample& sample, const CenterOf& centerOf) const;
    Due arriveAtTarget(const Due& due);
    double stepOf(const Dab& dab) const;
    std::optional<Due> nextStamp(const Due& end, const CenterOf& centerOf);

    StrokeSettings m_settings;
    std::optional<StrokeSample> m_target; ///< the newest sample, until the path has reached it
    StrokeSample m_at;                    ///< where the path has been followed to
    std::optional<Vec3> m_center;         ///< the dab centre there; nothing before the path has met the surface
    double m_travelled = 0;               ///< since the last dab
    std::optional<Vec3> m_stamped;        ///< of Stamp: where the last dab stood
    std::optional<int> m_dabsLeft;        ///< until the target is reached
};
} // namespace core
