#include "app/document/print_analysis.h"

#include "app/document/document.h"

#include "ui/print/print_legend.h"

namespace app
{
PrintInquiry::PrintInquiry(Document* document, SculptWorker* worker) : RestingModel(document, worker)
{
    connect(this, &RestingModel::outdated, this, [this] {
        m_wish.request_stop();
        m_measured.reset();
    });
}

PrintInquiry::~PrintInquiry()
{
    end();
}

void PrintInquiry::setWishes(const Wishes& wishes)
{
    m_wishes = wishes;
    if (m_measured)
        answer();
}

void PrintInquiry::look(const std::shared_ptr<ModelCopy>& copy, const std::stop_token& stop)
{
    const auto tell = [this, stop](double share) {
        const auto pass = [this, stop, share] {
            if (!stop.stop_requested())
                Q_EMIT progressed(share);
        };
        QMetaObject::invokeMethod(this, pass, Qt::QueuedConnection);
    };
    m_aside.run(
        [copy, stop, tell] {
            return std::make_shared<const Measured>(core::measureForPrint(std::move(copy->mesh), {stop, tell}),
                                                    std::move(copy->slots));
        },
        [this, stop](std::shared_ptr<const Measured> measured) { take(std::move(measured), stop); });
}

void PrintInquiry::take(std::shared_ptr<const Measured> measured, const std::stop_token& stop)
{
    if (stop.stop_requested())
        return;
    setAnswered();
    m_measured = std::move(measured);
    answer();
}

void PrintInquiry::answer()
{
    m_wish.request_stop();
    m_wish = {};
    m_aside.run([measured = m_measured, wishes = m_wishes] { return judge(*measured, wishes); },
                [this, measured = m_measured, stop = m_wish.get_token()](const Answer& answer) {
                    if (!stop.stop_requested())
                        Q_EMIT answered(measured->measures.report, answer.report, answer.shades);
                });
}

PrintInquiry::Answer PrintInquiry::judge(const Measured& measured, const Wishes& wishes)
{
    Answer answer{core::checkForPrint(measured.measures, wishes.limits), {}};
    if (!wishes.picture)
        return answer;
    const bool isThickness = *wishes.picture == core::PrintPicture::Thickness;
    const ui::PrintScale scale{*wishes.picture, isThickness ? wishes.limits.minWall : wishes.limits.overhang};
    answer.shades = ui::shadesOf(measured.slots, core::pictureOf(measured.measures, *wishes.picture), scale);
    return answer;
}
} // namespace app
