#include "app/analysis/print_analysis.h"

#include "app/document/document.h"

#include "ui/print/print_legend.h"

namespace app
{
PrintAnalysis::PrintAnalysis(Document* document, SculptWorker* worker)
    : IdleAnalysis(document, worker, AnalysedParts::Visible)
{
    connect(this, &IdleAnalysis::outdated, this, [this] {
        m_stopEvaluation.request_stop();
        m_measured.reset();
    });
}

PrintAnalysis::~PrintAnalysis()
{
    cancel();
}

void PrintAnalysis::setOptions(const Options& options)
{
    m_options = options;
    if (m_measured)
        evaluateAgain();
}

void PrintAnalysis::analyse(const std::shared_ptr<ModelCopy>& copy, const std::stop_token& stop)
{
    const auto onProgress = [this, stop](double share) {
        const auto pass = [this, stop, share] {
            if (!stop.stop_requested())
                Q_EMIT progressed(share);
        };
        QMetaObject::invokeMethod(this, pass, Qt::QueuedConnection);
    };
    m_background.run(
        [copy, stop, onProgress] {
            return std::make_shared<const Measurement>(core::measureForPrint(std::move(copy->mesh), {stop, onProgress}),
                                                       std::move(copy->slots));
        },
        [this, stop](std::shared_ptr<const Measurement> measured) { onMeasured(std::move(measured), stop); });
}

void PrintAnalysis::onMeasured(std::shared_ptr<const Measurement> measured, const std::stop_token& stop)
{
    if (stop.stop_requested())
        return;
    setFinished();
    m_measured = std::move(measured);
    evaluateAgain();
}

void PrintAnalysis::evaluateAgain()
{
    m_stopEvaluation.request_stop();
    m_stopEvaluation = {};
    m_background.run([measured = m_measured, options = m_options] { return evaluate(*measured, options); },
                     [this, measured = m_measured, stop = m_stopEvaluation.get_token()](const Result& result) {
                         if (!stop.stop_requested())
                             Q_EMIT finished(measured->measures.report, result.report, result.shades);
                     });
}

PrintAnalysis::Result PrintAnalysis::evaluate(const Measurement& measured, const Options& options)
{
    Result result{core::checkForPrint(measured.measures, options.limits), {}};
    if (!options.picture)
        return result;
    const bool isThickness = *options.picture == core::PrintPicture::Thickness;
    const ui::PrintScale scale{*options.picture, isThickness ? options.limits.minWall : options.limits.overhang};
    result.shades = ui::shadesOf(measured.slots, core::pictureOf(measured.measures, *options.picture), scale);
    return result;
}
} // namespace app
