#include "app/model/slicer_check.h"

#include "ui/files/slicer.h"

#include <QElapsedTimer>
#include <QFile>
#include <QProcess>
#include <QTemporaryDir>

namespace app
{
namespace
{
constexpr int pollMs = 50, timeoutMs = 180'000;
constexpr qsizetype maxComplaint = 160;

QString lastLineOf(const QByteArray& text)
{
    const QList<QByteArray> lines = text.trimmed().split('\n');
    return QString::fromUtf8(lines.constLast().trimmed()).left(maxComplaint);
}
} // namespace

QString SlicerCheck::run(const QString& model, const core::JobControl& control)
{
    const QTemporaryDir folder;
    const QString gcode = folder.filePath(QStringLiteral("trial.gcode"));
    QProcess slicer;
    QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
    environment.insert(QStringLiteral("LC_ALL"), QStringLiteral("C"));
    slicer.setProcessEnvironment(environment);
    slicer.setProcessChannelMode(QProcess::MergedChannels);
    slicer.setStandardInputFile(QProcess::nullDevice());
    slicer.start(ui::installedSlicer(), {QStringLiteral("--export-gcode"), QStringLiteral("--output"), gcode, model});
    QElapsedTimer time;
    time.start();
    while (!slicer.waitForFinished(pollMs) && slicer.state() != QProcess::NotRunning && !control.isCancelled() &&
           !time.hasExpired(timeoutMs)) {
    }
    if (slicer.state() != QProcess::NotRunning) {
        slicer.kill();
        slicer.waitForFinished();
        return control.isCancelled() ? tr("PrusaSlicer was stopped.")
                                     : tr("PrusaSlicer took longer than three minutes and was stopped.");
    }
    if (slicer.exitStatus() != QProcess::NormalExit || slicer.exitCode() != 0 || !QFile::exists(gcode))
        return tr("PrusaSlicer cannot slice it: %1").arg(lastLineOf(slicer.readAll()));
    return resultIn(gcode);
}

QString SlicerCheck::resultIn(const QString& gcode)
{
    QFile file(gcode);
    if (!file.open(QIODevice::ReadOnly))
        return tr("The sliced file cannot be read: %1").arg(file.errorString());
    static const QByteArray timeMark = "; estimated printing time (normal mode) = ";
    int layers = 0;
    QString time;
    while (!file.atEnd()) {
        const QByteArray line = file.readLine();
        layers += line.startsWith(";LAYER_CHANGE") ? 1 : 0;
        if (line.startsWith(timeMark))
            time = QString::fromUtf8(line.mid(timeMark.size()).trimmed());
    }
    return tr("PrusaSlicer slices it: layers %1, time %2.")
        .arg(layers)
        .arg(QString(time).replace(QLatin1Char(' '), QChar::Nbsp));
}
} // namespace app
