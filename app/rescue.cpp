#include "rescue.h"

#include "document.h"
#include "model_loader.h"

#include "core/mesh_build.h"
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

/// "head-20261121-173005.ply"
QString pathFor(const QString& name)
{
    const QDir folder(QStandardPaths::writableLocation(QStandardPaths::AppLocalDataLocation) + QStringLiteral("/rescued"));
    folder.mkpath(QStringLiteral("."));
    const QString now = QDateTime::currentDateTime().toString(QStringLiteral("yyyyMMdd-HHmmss"));
    return folder.filePath(QStringLiteral("%1-%2.ply").arg(QFileInfo(name).completeBaseName(), now));
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
    const auto surface = std::make_shared<std::promise<core::TriangleMesh>>();
    auto answer = surface->get_future();
    m_worker->post([surface](core::Sculptor& sculptor) { surface->set_value(core::extractMesh(sculptor.mesh())); });
    if (answer.wait_for(mostPatience) != std::future_status::ready)
        return say(tr("The program ended before the changes to the model could be kept."));
    const QString path = pathFor(m_document->facts().name);
    const QString problem = ModelLoader::save(path, answer.get());
    if (!problem.isEmpty())
        return say(problem);
    ui::Settings().addRecentFile(path);
    say(tr("The program ended from outside; the model was kept in %1.").arg(QDir::toNativeSeparators(path)));
}
} // namespace app
