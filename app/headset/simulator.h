#pragma once

#include <QCoreApplication>
#include <QImage>
#include <QJsonObject>

#include <memory>

struct FettleXrPicture;

namespace app
{
/// The VR simulator, loaded into this process: Fettle's own OpenXR runtime (vr/simulator), used instead of a headset.
/// It stays loaded until the process ends. Thread: gui.
class Simulator
{
    Q_DECLARE_TR_FUNCTIONS(app::Simulator)

public:
    /// Loads the simulator from the program's folder or its installation, and makes it the OpenXR runtime of this
    /// process. Precondition: OpenXR has not been used yet. `program`: folder of the program. Throws CommandFailure if
    /// the simulator is missing or cannot be loaded.
    static std::unique_ptr<Simulator> open(const QString& program = QCoreApplication::applicationDirPath());

    /// Sets the state of head and wands from the next frame on. `step`: see vr/simulator/control_api.h.
    void apply(const QJsonObject& step);
    /// Returns the newest frame that the eye saw, and requests the next one; null if there is no new one since the last
    /// call.
    QImage picture();

private:
    struct Functions
    {
        const char* (*load)(const char* script) = nullptr;
        const char* (*apply)(const char* step) = nullptr;
        const FettleXrPicture* (*picture)() = nullptr;
    };

    explicit Simulator(const Functions& functions) : m_functions(functions) {}

    Functions m_functions;
};
} // namespace app
