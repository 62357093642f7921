#include "app/analysis/print_analysis.h"

#include "app/document/document.h"

#include "ui/print/print_legend.h"

#include <algorithm>
#include <numeric>
#include <tuple>
#include <utility>

namespace app
{
namespace
{
using core::Slot;
using core::Vec3f;

bool isBefore(const Vec3f& a, const Vec3f& b)
{
    return std::tie(a.x(), a.y(), a.z()) < std::tie(b.x(), b.y(), b.z());
}

/// Returns the indices of points that are also in `known`, which may have one several times, and for each the slot of
/// the known point.
std::pair<std::vector<Slot>, std::vector<Slot>>
equalPoints(const std::vector<Vec3f>& points, const std::vector<Vec3f>& known, const std::vector<Slot>& slots)
{
    std::vector<Slot> order(known.size());
    std::iota(order.begin(), order.end(), Slot(0));
    const auto pointOf = [&known](Slot i) -> const Vec3f& { return known[i]; };
    std::ranges::sort(order, isBefore, pointOf);
    std::pair<std::vector<Slot>, std::vector<Slot>> found;
    for (Slot v = 0; v < points.size(); ++v)
        for (const Slot i : std::ranges::equal_range(order, points[v], isBefore, pointOf)) {
            found.first.push_back(v);
            found.second.push_back(slots[i]);
        }
    return found;
}
} // namespace

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
            return std::make_shared<const Measurement>(measure(*copy, {stop, onProgress}));
        },
        [this, stop](std::shared_ptr<const Measurement> measured) { onMeasured(std::move(measured), stop); });
}

PrintAnalysis::Measurement PrintAnalysis::measure(ModelCopy& copy, const core::JobControl& control)
{
    const double afterUnion = copy.mesh.parts.empty() ? 0 : 0.3;
    Measurement measured;
    const std::vector<core::Vec3f> points = copy.mesh.parts.empty() ? std::vector<core::Vec3f>() : copy.mesh.points;
    measured.parts = core::uniteParts(copy.mesh, copy.lattice, control.part(0, afterUnion));
    if (measured.parts == core::PartUnion::Done) {
        std::tie(measured.vertices, measured.slots) = equalPoints(copy.mesh.points, points, copy.slots);
    } else {
        measured.vertices.resize(copy.slots.size());
        std::iota(measured.vertices.begin(), measured.vertices.end(), core::Slot(0));
        measured.slots = std::move(copy.slots);
    }
    measured.measures = core::measureForPrint(std::move(copy.mesh), control.part(afterUnion, 1));
    return measured;
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
                             Q_EMIT finished(measured->measures.report, result.report, measured->parts, result.shades);
                     });
}

PrintAnalysis::Result PrintAnalysis::evaluate(const Measurement& measured, const Options& options)
{
    Result result{core::checkForPrint(measured.measures, options.limits), {}};
    if (!options.picture)
        return result;
    const bool isThickness = *options.picture == core::PrintPicture::Thickness;
    const ui::PrintScale scale{*options.picture, isThickness ? options.limits.minWall : options.limits.overhang};
    const std::vector<float> all = core::pictureOf(measured.measures, *options.picture);
    std::vector<float> values;
    values.reserve(measured.vertices.size());
    for (const core::Slot v : measured.vertices)
        values.push_back(all[v]);
    result.shades = ui::shadesOf(measured.slots, values, scale);
    return result;
}
} // namespace app
