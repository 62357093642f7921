#pragma once

#include "app/analysis/idle_analysis.h"
#include "app/lesson/lesson_place.h"

#include "core/lesson/checkpoint.h"
#include "core/mesh/footprint.h"
#include "ui/util/background_thread.h"

namespace app
{
/// Checks whether the model meets a lesson step's checkpoint, whenever it has been idle for a moment.
class LessonChecker : public IdleAnalysis
{
    Q_OBJECT

public:
    LessonChecker(Document* document, SculptWorker* worker);
    ~LessonChecker() override;

    void setPosition(const LessonPlace& position);

Q_SIGNALS:
    /// `shades`: of the model's vertices as ui::PrintScale has them, 128 at the tolerance; null where there is no
    /// target.
    void finished(const core::CheckpointVerdict& verdict, const std::shared_ptr<const core::Footprint>& shades);

private:
    struct Result
    {
        core::CheckpointVerdict verdict;
        std::shared_ptr<const core::Footprint> shades;
    };
    static Result evaluate(const ModelCopy& copy, const LessonPlace& position, const std::stop_token& stop);
    void analyse(const std::shared_ptr<ModelCopy>& copy, const std::stop_token& stop) override;

    std::mutex m_mutex; ///< of the next one, which the mesh thread reads
    LessonPlace m_position;
    ui::BackgroundThread m_background; ///< last
};
} // namespace app
