// The values of the stroke file: their types, their ranges and the members that store them.
#include "core/io/stroke/stroke_json_reader.h"

#include "core/sculpt/deform/alpha.h"
#include "core/stroke/radial_symmetry.h"
#include "core/util/fingerprint.h"

#include <cmath>
#include <limits>

namespace core
{
namespace
{
/// Smallest spacing apart from 0, in radii, so that a typing error cannot request 10^12 dabs.
constexpr double minSpacing = 1e-3;
constexpr double minFactor = 1e-6; ///< smallest scale factor; the largest is 1 / minFactor

/// The xz plane (paper, section 3.5.2), which is the meaning of `"symmetry": true`.
constexpr Symmetry paperPlane = Symmetry::Y;

Eigen::Quaterniond turnAboutY(double degrees)
{
    constexpr double halfDegree = 3.14159265358979323846 / 360;
    const Turn half = Turn::by(std::remainder(degrees, 360.0) * halfDegree);
    return Eigen::Quaterniond(half.cosine, 0, half.sine, 0).normalized();
}
} // namespace

double StrokeJsonReader::inRange(double value, double min, double max, bool orZero) const
{
    if ((value >= min && value <= max) || (orZero && value == 0))
        return value;
    StrokeFileError error = errorHere(Kind::OutOfRange, std::string(keyName()));
    error.min = min;
    error.max = max;
    error.orZero = orZero;
    throw error;
}

double StrokeJsonReader::inRange(double value, Parameter parameter) const
{
    return inRange(value, info(parameter).min, info(parameter).max);
}

/// Returns the number of values in the current key's list; 0 if the key has no list.
std::size_t StrokeJsonReader::vectorLength() const
{
    const auto isAmong = [this](auto... keys) { return ((m_key == keys) || ...); };
    if (m_level == Level::Stroke && m_key == OutlineKey)
        return m_inOutline ? 3 : 0;
    if (m_level == Level::Stroke)
        return m_inProfile                                                                 ? (m_key == PathKey ? 4 : 2)
               : isAmong(TurnKey, StretchAxesKey)                                          ? 4
               : isAmong(ColorKey, TagKey, ByKey, CentreKey, EyeKey, AlongKey, StretchKey) ? 3
                                                                                           : 0;
    if (m_level == Level::Sample)
        return m_key == RotationKey ? 4 : m_key == PositionKey || m_key == DirectionKey || m_key == UpKey ? 3 : 0;
    return 0;
}

void StrokeJsonReader::endVector()
{
    m_inVector = false;
    if (isPartList())
        return;
    if (m_count != vectorLength())
        refuse(Kind::WrongType);
    const Vec3 vector(m_vector[0], m_vector[1], m_vector[2]);
    if (m_level == Level::Stroke)
        return strokeVector(vector);
    StrokeSample& sample = stroke().samples.back();
    if (m_key == UpKey && vector.cwiseAbs().maxCoeff() < minDirection)
        refuse(Kind::OutOfRange);
    if (m_key == RotationKey)
        sample.rotation = unitRotation();
    else if (m_key == UpKey)
        sample.up = vector;
    else
        (m_key == PositionKey ? sample.position : sample.direction) = vector;
}

void StrokeJsonReader::strokeVector(const Vec3& vector)
{
    const auto byte = [](double value) { return static_cast<std::uint8_t>(value); };
    const Rgb color = {byte(vector.x()), byte(vector.y()), byte(vector.z())};
    switch (m_key) {
    case ColorKey:
        stroke().settings.color = color;
        break;
    case TagKey:
        m_command.tag = color;
        break;
    case ByKey:
        m_command.by = vector;
        break;
    case CentreKey:
        m_command.centre = vector;
        break;
    case StretchKey:
        m_command.scale = vector;
        break;
    case StretchAxesKey:
        m_command.scaleAxes = unitRotation();
        break;
    case OutlineKey:
        if (m_command.area.outline.size() == ViewArea::maxCorners)
            refuse(Kind::OutOfRange);
        m_command.area.outline.push_back(vector);
        break;
    case EyeKey:
        m_command.eye = vector;
        break;
    case AlongKey:
        if (vector.cwiseAbs().maxCoeff() < minDirection)
            refuse(Kind::OutOfRange);
        m_command.area.direction = m_command.primitive.axis = vector;
        break;
    case ProfileKey:
        if (m_command.primitive.profile.size() == PrimitiveLimits::maxProfile)
            refuse(Kind::OutOfRange);
        m_command.primitive.profile.push_back({vector.x(), vector.y()});
        break;
    case PathKey:
        if (m_command.primitive.path.size() == PrimitiveLimits::maxProfile)
            refuse(Kind::OutOfRange);
        m_command.primitive.path.push_back({vector, m_vector[3]});
        break;
    default:
        m_command.rotation = unitRotation();
    }
}

Eigen::Quaterniond StrokeJsonReader::unitRotation() const
{
    const Eigen::Quaterniond rotation(m_vector[3], m_vector[0], m_vector[1], m_vector[2]);
    const double length = rotation.squaredNorm();
    if (!(std::abs(length - 1) <= rotationTolerance))
        refuse(Kind::OutOfRange);
    return std::abs(length - 1) > 8 * std::numeric_limits<double>::epsilon() ? rotation.normalized() : rotation;
}

/// Returns the value if it is a whole number from 0 to `max`.
double StrokeJsonReader::wholeIn(double value, double max) const
{
    inRange(value, 0, max);
    if (value != std::trunc(value))
        refuse(Kind::WrongType);
    return value;
}

PartId StrokeJsonReader::partIn(double value) const
{
    return static_cast<PartId>(wholeIn(value, maxPartId));
}

bool StrokeJsonReader::number(double value)
{
    if (m_level == Level::Start)
        refuse(Kind::NotStrokes);
    if (!std::isfinite(value))
        refuse(Kind::NotANumber);
    if (m_inVector && isPartList()) {
        if (m_command.parts.size() == PartList::maxParts)
            refuse(Kind::OutOfRange);
        m_command.parts.push_back(partIn(value));
    } else if (m_inVector) {
        if (m_count == vectorLength())
            refuse(Kind::WrongType);
        const bool isScale = m_level == Level::Stroke && m_key == StretchKey;
        m_vector[m_count++] = isColorKey() ? wholeIn(value, 255)
                              : isScale    ? inRange(value, Transform::minScale, 1 / Transform::minScale)
                                           : inRange(value, -maxSampleMagnitude, maxSampleMagnitude);
    } else if (m_level == Level::Sample) {
        sampleNumber(value);
    } else if (m_level == Level::Stroke) {
        strokeNumber(value);
    } else if (m_level != Level::File || m_key != Version) {
        refuse(Kind::WrongType);
    } else if (value != 1) {
        StrokeFileError error = errorHere(Kind::NotStrokes, std::string(keyName()));
        error.version = value;
        throw error;
    }
    return true;
}

void StrokeJsonReader::strokeNumber(double value)
{
    StrokeSettings& settings = stroke().settings;
    switch (m_key) {
    case RadiusKey:
        settings.radius = inRange(value, Parameter::Radius);
        m_command.primitive.length(Primitive::Measure::Radius) = value;
        break;
    case StrengthKey:
        settings.strength = inRange(value, Parameter::Strength);
        break;
    case DetailKey:
        settings.detail = inRange(value, Parameter::Detail);
        break;
    case DetailLengthKey:
        settings.detailLength = inRange(value, Parameter::Radius);
        break;
    case PartKey:
        settings.part = partIn(value);
        break;
    case ListPositionKey:
        m_command.position = static_cast<std::size_t>(wholeIn(value, double(PartList::maxParts)));
        break;
    case TurntableKey:
        m_turntable = inRange(value, -maxSampleMagnitude, maxSampleMagnitude);
        break;
    case SpacingKey:
        settings.spacing = inRange(value, minSpacing, info(Parameter::Spacing).max, true);
        break;
    case AirbrushKey:
        settings.airbrush = inRange(value, minAirbrush, maxAirbrush, true);
        break;
    case RadialKey:
        settings.radial = static_cast<int>(inRange(value, 1, maxRadial));
        if (value != std::trunc(value))
            refuse(Kind::WrongType);
        break;
    case FalloffKey:
        inRange(value, minFalloff, info(Parameter::Falloff).max, true);
        if (value != std::trunc(value))
            refuse(Kind::WrongType);
        settings.falloff = static_cast<int>(value);
        break;
    default:
        commandNumber(value);
    }
}

void StrokeJsonReader::commandNumber(double value)
{
    const auto extent = [&](bool orZero = false) {
        return inRange(value, ModelLimits::minExtent, ModelLimits::maxExtent, orZero);
    };
    Primitive& primitive = m_command.primitive;
    switch (m_key) {
    case FactorKey:
        m_command.factor = inRange(value, minFactor, 1 / minFactor);
        break;
    case WidthKey:
        primitive.length(Primitive::Measure::Width) = extent();
        break;
    case HeightKey:
        primitive.length(Primitive::Measure::Height) = extent();
        break;
    case DepthKey:
        primitive.length(Primitive::Measure::Depth) = extent();
        break;
    case TopRadiusKey:
        primitive.length(Primitive::Measure::TopRadius) = extent(true);
        break;
    case TubeRadiusKey:
        primitive.length(Primitive::Measure::TubeRadius) = extent();
        break;
    case EdgeLengthKey:
        primitive.edge = extent();
        break;
    default:
        refuse(Kind::WrongType);
    }
}

void StrokeJsonReader::sampleNumber(double value)
{
    StrokeSample& sample = stroke().samples.back();
    switch (m_key) {
    case TimeKey:
        sample.time = inRange(value, -maxSampleMagnitude, maxSampleMagnitude);
        break;
    case PressureKey:
        sample.pressure = inRange(value, 0, 1);
        break;
    case SampleRadiusKey:
        sample.radius = inRange(value, Parameter::Radius);
        break;
    case SampleStrengthKey:
        sample.strength = inRange(value, Parameter::Strength);
        break;
    default:
        refuse(Kind::WrongType);
    }
}

bool StrokeJsonReader::boolean(bool value)
{
    if (m_level == Level::Start)
        refuse(Kind::NotStrokes);
    if (m_level != Level::Stroke || m_inVector || m_inOutline ||
        (m_key != FusionKey && m_key != SymmetryKey && m_key != AddKey && m_key != JoinKey && m_key != InvertKey &&
         m_key != AlphaFollowsKey && m_key != AnchoredKey && m_key != LockedKey && m_key != FrontKey))
        refuse(Kind::WrongType);
    if (m_key == SymmetryKey)
        stroke().settings.symmetry = value ? paperPlane : Symmetry::None;
    if (m_key == AddKey)
        stroke().settings.add = value;
    else if (m_key == LockedKey)
        m_command.isLocked = value;
    else if (m_key == FrontKey)
        m_command.area.isFrontOnly = value;
    else if (m_key == JoinKey)
        stroke().settings.join = value;
    else if (m_key == AlphaFollowsKey)
        stroke().settings.alphaFollows = value;
    else if (m_key == AnchoredKey)
        stroke().settings.anchored = value;
    else if (m_key == InvertKey)
        stroke().settings.inverted = value;
    else if (m_key == FusionKey)
        stroke().settings.fusion = value;
    return true;
}

bool StrokeJsonReader::string(string_t& value)
{
    if (m_level == Level::Start)
        refuse(Kind::NotStrokes);
    if (m_level == Level::Stroke && !m_inVector && !m_inOutline)
        strokeWord(value);
    else if (m_level != Level::File || m_key != Format)
        refuse(Kind::WrongType);
    else if (value != "fettle-strokes")
        refuse(Kind::NotStrokes);
    return true;
}

void StrokeJsonReader::strokeWord(const std::string& word)
{
    StrokeSettings& settings = stroke().settings;
    m_words = {};
    const auto take = [&]<class Value>(Value& setting) {
        m_words = valueNames<Value>;
        const std::optional<Value> value = named<Value>(word);
        setting = value.value_or(setting);
        return value.has_value();
    };
    bool known = true;
    switch (m_key) {
    case ToolKey:
        known = take(settings.tool);
        break;
    case BrushKey:
        known = take(settings.brush);
        break;
    case TopologyKey:
        known = take(settings.topology);
        break;
    case SymmetryKey:
        known = take(settings.symmetry);
        break;
    case PlaceKey:
        known = take(settings.place);
        break;
    case AlphaKey:
        settings.alpha = builtInAlpha(word);
        stroke().alpha.file = settings.alpha ? "" : word;
        known = !word.empty();
        break;
    case BrushModelKey:
        stroke().model.file = word;
        known = !word.empty();
        break;
    case AlphaPrintKey:
        stroke().alpha.fingerprint = word;
        known = isFingerprint(word);
        break;
    case BrushModelPrintKey:
        stroke().model.fingerprint = word;
        known = isFingerprint(word);
        break;
    default:
        known = commandWord(word);
    }
    if (known)
        return;
    StrokeFileError error = errorHere(Kind::UnknownValue, std::string(keyName()) + ": \"" + word.substr(0, 60) + '"');
    error.words.assign(m_words.begin(), m_words.end());
    throw error;
}

void StrokeJsonReader::endStroke()
{
    for (const auto& [print, what] :
         {std::pair(AlphaPrintKey, AlphaKey), std::pair(BrushModelPrintKey, BrushModelKey)}) {
        if (!(m_seen & bit(what)))
            requireNoneOf(bit(print));
    }
    Stroke& stroke = this->stroke();
    const bool alongRays = stroke.settings.place == Placement::Ray || stroke.settings.brush == BrushShape::Ray;
    const auto refuseDirection = [&](Kind kind, std::size_t sample) {
        StrokeFileError error = errorHere(kind, "direction");
        error.sample = sample;
        throw error;
    };
    if (alongRays && m_undirected)
        refuseDirection(Kind::MissingKey, *m_undirected);
    for (std::size_t i = 0; i < stroke.samples.size(); ++i) {
        StrokeSample& sample = stroke.samples[i];
        if (alongRays && sample.direction.cwiseAbs().maxCoeff() < minDirection)
            refuseDirection(Kind::OutOfRange, i);
        if (m_turntable != 0)
            sample.rotation = turnAboutY(m_turntable * sample.time) * sample.rotation;
    }
}
} // namespace core
