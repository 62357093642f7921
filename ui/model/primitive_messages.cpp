#include "ui/model/primitive_messages.h"

#include <QLocale>

#include <cmath>

namespace ui
{
namespace
{
/// Returns the length rounded down to three significant digits, so that it is still allowed.
QString roundedDown(double mm)
{
    if (!(mm > 0))
        return QLocale().toString(0);
    const int decimals = 2 - static_cast<int>(std::floor(std::log10(mm)));
    const double digit = std::pow(10, -decimals);
    return QLocale().toString(std::floor(mm / digit) * digit, 'f', std::max(decimals, 0));
}
} // namespace

QString PrimitiveMessages::kind(core::Primitive::Kind kind)
{
    switch (kind) {
    case core::Primitive::Kind::Cuboid:
        return tr("Box");
    case core::Primitive::Kind::Ball:
        return tr("Ball");
    case core::Primitive::Kind::Cylinder:
        return tr("Cylinder");
    case core::Primitive::Kind::Cone:
        return tr("Cone");
    case core::Primitive::Kind::Capsule:
        return tr("Capsule");
    case core::Primitive::Kind::Torus:
        return tr("Torus");
    case core::Primitive::Kind::Lathe:
        return tr("Turned profile");
    case core::Primitive::Kind::Tube:
        return tr("Tube");
    }
    return {};
}

QString PrimitiveMessages::measure(core::Primitive::Measure measure)
{
    switch (measure) {
    case core::Primitive::Measure::Width:
        return tr("Width");
    case core::Primitive::Measure::Height:
        return tr("Height");
    case core::Primitive::Measure::Depth:
        return tr("Depth");
    case core::Primitive::Measure::Radius:
        return tr("Radius");
    case core::Primitive::Measure::TopRadius:
        return tr("Radius at the top");
    case core::Primitive::Measure::TubeRadius:
        return tr("Radius of the tube");
    }
    return {};
}

QString PrimitiveMessages::problem(const core::PrimitiveResult& result)
{
    switch (result.fault) {
    case core::PrimitiveFault::None:
        return {};
    case core::PrimitiveFault::Measure:
        //: %1: a measure, for example Height
        return tr("%1: it must be between a millionth of a millimetre and ten kilometres.")
            .arg(measure(result.measure));
    case core::PrimitiveFault::TubeTooThick:
        return tr("The radius of a torus must be larger than the radius of its tube.");
    case core::PrimitiveFault::CapsuleTooLow:
        return tr("The height of a capsule must be more than twice its radius.");
    case core::PrimitiveFault::Profile:
        return tr("A profile needs 2 to 1000 different points, none with a radius below 0; only its ends may be on the "
                  "axis.");
    case core::PrimitiveFault::Path:
        return tr(
            "A tube needs 2 to 1000 points, each at another place than the one before it, with radii that are not "
            "tiny beside their distance from the origin.");
    case core::PrimitiveFault::PathMeets:
        return tr("The tube crosses itself too often. Make it thinner, or its curve smoother.");
    case core::PrimitiveFault::ProfileMeets:
        return tr("The profile crosses or touches itself, or its walls are too thin for edges this long.");
    case core::PrimitiveFault::EdgeTooLong:
        return tr("For this shape, the edges may be %1 mm long at most.").arg(roundedDown(result.limit));
    case core::PrimitiveFault::TooManyFaces:
        return tr("This shape would need too many triangles (%1, at most 2 million): its edges would be too short for "
                  "its size.")
            .arg(QLocale().toString(std::round(result.faces), 'f', 0));
    }
    return {};
}
} // namespace ui
