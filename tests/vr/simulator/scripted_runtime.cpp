#include "tests/vr/simulator/scripted_runtime.h"

#include "tests/support/effort.h"
#include "vr/simulator/control_api.h"

#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QLibrary>

namespace
{
template <class Function> Function function(const char* name)
{
    static QLibrary library(QStringLiteral(FETTLE_XR_LIBRARY));
    const auto found = reinterpret_cast<Function>(library.resolve(name));
    if (!found)
        qFatal("%s", qPrintable(library.errorString()));
    return found;
}

QStringList texts(const QJsonValue& value)
{
    QStringList list;
    for (const QJsonValue& text : value.toArray())
        list << text.toString();
    return list;
}
} // namespace

void ScriptedRuntime::choose()
{
    qputenv("XR_RUNTIME_JSON", FETTLE_XR_MANIFEST);
}

ScriptedRuntime::ScriptedRuntime(const QByteArray& script)
{
    choose();
    if (const QString complaint = load(script); !complaint.isEmpty())
        qFatal("%s", qPrintable(complaint));
}

QString ScriptedRuntime::load(const QByteArray& script)
{
    return QString::fromUtf8(function<const char* (*)(const char*)>("fettle_xr_load")(script));
}

void ScriptedRuntime::set(const QByteArray& step)
{
    if (const char* complaint = function<const char* (*)(const char*)>("fettle_xr_do")(step))
        qFatal("%s", complaint);
}

bool ScriptedRuntime::frames(int count)
{
    return function<int (*)(int, int)>("fettle_xr_frames")(count, longestWait) >= count;
}

QJsonObject ScriptedRuntime::report() const
{
    return QJsonDocument::fromJson(function<const char* (*)()>("fettle_xr_report")()).object();
}

QImage ScriptedRuntime::picture()
{
    const FettleXrPicture* shown = function<decltype(&fettle_xr_picture)>("fettle_xr_picture")();
    return shown ? QImage(shown->rgba, shown->width, shown->height, QImage::Format_RGBX8888).copy() : QImage();
}

QStringList ScriptedRuntime::clientErrors() const
{
    return texts(report()[QStringLiteral("client_errors")]);
}

QStringList ScriptedRuntime::clientWarnings() const
{
    return texts(report()[QStringLiteral("client_warnings")]);
}

QStringList layerComplaints(const QString& path)
{
    QFile file(path);
    if (!file.open(QIODevice::ReadOnly))
        return {};
    QStringList lines = QString::fromUtf8(file.readAll()).split(u'\n', Qt::SkipEmptyParts);
    lines.removeIf([](const QString& line) { return line.contains(QStringLiteral("[VALID_DEBUG |")); });
    return lines;
}
