#include "rescue.h"

#include "document.h"
#include "model_loader.h"

#include "ui/settings.h"

#include <QDateTime>
#include <QDir>
#include <QFileInfo>
#include <QStandardPaths>

#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <future>

namespace app
{
namespace
{
using namespace std::chrono_literals;

constexpr auto mostPatience = 60s; ///< with what the mesh thread is at

/// "head-20261121-173005.glb"
QString pathFor(const QString& name)
{
    const QDir folder(QStandardPaths::writableLocation(QStandardPaths::AppLocalDataLocation) + QStringLiteral("/rescued"));
    folder.mkpath(QStringLiteral("."));
    const QString now = QDateTime::currentDateTime().toString(QStringLiteral("yyyyMMdd-HHmmss"));
    return folder.filePath(QStringLiteral("%1-%2.glb").arg(QFileInfo(name).completeBaseName(), now));
}

void say(const QString& sentence)
{
    std::fprintf(stderr, "fettle: %s\n", qPrintable(sentence));
}
} // namespace

Rescue* Rescue::s_present = nullptr;

Rescue::Rescue(Document* document, SculptWorker* worker) : m_document(document), m_worker(worker)
{
    Q_ASSERT(!s_present);
    s_present = this;
    std::atexit(atExit);
}

Rescue::~Rescue()
{
    s_present = nullptr;
}

void Rescue::atExit()
{
    if (s_present && s_present->m_document->isModified())
        s_present->keepModel();
}

void Rescue::keepModel() const
{
    const auto model = std::make_shared<std::promise<std::shared_ptr<const core::Snapshot>>>();
    auto answer = model->get_future();
    m_worker->post([model](core::Sculptor& sculptor) { model->set_value(core::snapshotOf(sculptor.mesh())); });
    if (answer.wait_for(mostPatience) != std::future_status::ready)
        return say(tr("The program ended before the changes to the model could be kept."));
    const QString path = pathFor(m_document->facts().name);
    const auto kept = answer.get();
    core::DocumentNotes notes = m_document->facts().notes;
    notes.frame = kept->frame;
    const QString problem = ModelLoader::save(path, kept->surface, notes);
    if (!problem.isEmpty())
        return say(problem);
    ui::Settings().addRecentFile(path);
    say(tr("The program ended from outside; the model was kept in %1.").arg(QDir::toNativeSeparators(path)));
}
} // namespace app
