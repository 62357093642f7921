#pragma once

#include "app/analysis/idle_analysis.h"
#include "app/lesson/lesson_place.h"

#include "core/lesson/checkpoint.h"
#include "core/mesh/footprint.h"
#include "ui/util/background_thread.h"

namespace app
{
/// Checks whether the model meets the checkpoint of a lesson step, when it has not changed for 0.7 s.
class LessonChecker : public IdleAnalysis
{
    Q_OBJECT

public:
    LessonChecker(Document* document, SculptWorker* worker);
    ~LessonChecker() override;

    void setPosition(const LessonPlace& position);

Q_SIGNALS:
    /// `shades`: one value per vertex for drawing by ui::PrintScale, 128 at the tolerance; null if the checkpoint has
    /// no target.
    void finished(const core::CheckpointVerdict& verdict, const std::shared_ptr<const core::Footprint>& shades);

private:
    struct Result
    {
        core::CheckpointVerdict verdict;
        std::shared_ptr<const core::Footprint> shades;
    };
    static Result evaluate(const ModelCopy& copy, const LessonPlace& position, const std::stop_token& stop);
    void analyse(const std::shared_ptr<ModelCopy>& copy, const std::stop_token& stop) override;

    std::mutex m_mutex; ///< guards m_position, which the mesh thread reads
    LessonPlace m_position;
    ui::BackgroundThread m_background; ///< last member: its destructor waits for jobs that use the other members
};
} // namespace app
