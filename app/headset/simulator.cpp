#include "app/headset/simulator.h"

#include "app/commands/command_line.h"

#include "ui/headset/simulator_controls.h"
#include "vr/simulator/control_api.h"

#include <QDir>
#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QLibrary>

#include <cmath>
#include <numbers>

namespace app
{
namespace
{
/// Size of the only view, pixels: that of the simulator's window when it opens. Small enough for drawing in software.
constexpr int heightPixels = 720, widthPixels = 810;
constexpr int hertz = 60;

QByteArray text(const QJsonObject& object)
{
    return QJsonDocument(object).toJson(QJsonDocument::Compact);
}

/// Returns the start settings of a headset that is worn whenever VR is entered. The wands' aim equals their pose.
QJsonObject script()
{
    const auto degrees = [](double tangent) { return std::atan(tangent) * 180 / std::numbers::pi; };
    const double side = degrees(ui::SimulatorControls::sideTangent), up = degrees(ui::SimulatorControls::upTangent);
    const QJsonObject aim{{QStringLiteral("position"), QJsonArray{0, 0, 0}},
                          {QStringLiteral("rotation"), QJsonArray{0, 0, 0, 1}}};
    const QJsonArray blendModes{QStringLiteral("opaque"), QStringLiteral("alpha_blend")};
    return {{QStringLiteral("start"), QJsonObject{{QStringLiteral("pace"), QStringLiteral("live")},
                                                  {QStringLiteral("hz"), hertz},
                                                  {QStringLiteral("size"), QJsonArray{widthPixels, heightPixels}},
                                                  {QStringLiteral("fov"), QJsonArray{-side, side, up, -up}},
                                                  {QStringLiteral("views"), QStringLiteral("mono")},
                                                  {QStringLiteral("blend_modes"), blendModes},
                                                  {QStringLiteral("aim"), aim}}}};
}

/// Returns the folder with the simulator's module, in the build or the installation; empty if there is none.
QString folderOf(const QString& program)
{
    for (const char* way : {"/" FETTLE_SIMULATOR_FOLDER, "/../" FETTLE_SIMULATOR_FOLDER})
        if (const QString folder = program + QLatin1StringView(way);
            QFile::exists(folder + QStringLiteral("/fettle_simulator.json")))
            return QDir::cleanPath(folder);
    return {};
}

template <class Function> void resolve(QLibrary& library, const char* name, Function& function)
{
    function = reinterpret_cast<Function>(library.resolve(name));
    if (!function)
        throw CommandFailure{Simulator::tr("The VR simulator cannot be loaded: %1").arg(library.errorString())};
}
} // namespace

std::unique_ptr<Simulator> Simulator::open(const QString& program)
{
    const QString folder = folderOf(program);
    if (folder.isEmpty())
        throw CommandFailure{tr("The VR simulator is not installed with this program: there is no folder %1 beside it "
                                "with fettle_simulator.json.")
                                 .arg(QStringLiteral(FETTLE_SIMULATOR_FOLDER))};
    QLibrary library(folder + QStringLiteral("/libfettle_simulator"));
    Functions functions;
    resolve(library, "fettle_xr_load", functions.load);
    resolve(library, "fettle_xr_do", functions.apply);
    resolve(library, "fettle_xr_picture", functions.picture);
    qputenv("XR_RUNTIME_JSON", QFile::encodeName(folder + QStringLiteral("/fettle_simulator.json")));
    if (const char* complaint = functions.load(text(script())))
        throw CommandFailure{tr("The VR simulator cannot be loaded: %1").arg(QString::fromUtf8(complaint))};
    return std::unique_ptr<Simulator>(new Simulator(functions));
}

void Simulator::apply(const QJsonObject& step)
{
    [[maybe_unused]] const char* complaint = m_functions.apply(text(step));
    Q_ASSERT(!complaint);
}

QImage Simulator::picture()
{
    const FettleXrPicture* shown = m_functions.picture();
    return shown ? QImage(shown->rgba, shown->width, shown->height, QImage::Format_RGBX8888).copy() : QImage();
}
} // namespace app
