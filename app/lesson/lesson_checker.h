#pragma once

#include "app/document/idle_analysis.h"

#include "core/lesson/checkpoint.h"
#include "core/lesson/lesson.h"
#include "core/mesh/footprint.h"
#include "ui/util/background_thread.h"

#include <filesystem>

namespace app
{
/// Is the model what a lesson's step asks for? Answered whenever it has rested for a moment, while it is wanted.
class LessonInquiry : public RestingModel
{
    Q_OBJECT

public:
    LessonInquiry(Document* document, SculptWorker* worker);
    ~LessonInquiry() override;

    struct Place
    {
        std::shared_ptr<const core::Lesson> lesson; ///< null: none is open
        std::filesystem::path path;
        std::size_t step = 0;
    };
    void setPlace(const Place& place);

Q_SIGNALS:
    /// `shades`: of the model's vertices as ui::PrintScale has them, 128 at the tolerance; null where there is no
    /// target.
    void answered(const core::CheckpointVerdict& verdict, const std::shared_ptr<const core::Footprint>& shades);

private:
    struct Answer
    {
        core::CheckpointVerdict verdict;
        std::shared_ptr<const core::Footprint> shades;
    };
    static Answer judge(const ModelCopy& copy, const Place& place, const std::stop_token& stop);
    void look(const std::shared_ptr<ModelCopy>& copy, const std::stop_token& stop) override;

    std::mutex m_mutex; ///< of the next one, which the mesh thread reads
    Place m_place;
    ui::BackgroundThread m_aside; ///< last
};
} // namespace app
