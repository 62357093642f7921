#pragma once

#include <QCoreApplication>
#include <QImage>
#include <QJsonObject>

#include <memory>

struct FettleXrPicture;

namespace app
{
/// The VR simulator in this process: an OpenXR runtime of our own (vr/simulator), which takes a headset's place. It
/// stays to the end of the process. Thread: gui.
class Simulator
{
    Q_DECLARE_TR_FUNCTIONS(app::Simulator)

public:
    /// Loads what lies beside the program, or where it is installed, and makes it the OpenXR runtime of this process;
    /// before VR is first asked for. `program`: the folder of the program. Throws CommandFailure where it is missing or
    /// cannot be loaded.
    static std::unique_ptr<Simulator> open(const QString& program = QCoreApplication::applicationDirPath());

    /// How head and wands are from the next frame on, in the words of vr/simulator/control_api.h.
    void apply(const QJsonObject& step);
    /// What the eye saw in the newest frame since this was last asked, which asks for the next; null: nothing new.
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
