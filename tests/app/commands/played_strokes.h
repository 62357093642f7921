#pragma once

#include "core/io/mesh_io.h"

#include <nlohmann/json.hpp>

#include <QDir>
#include <QFile>
#include <QProcess>
#include <QTemporaryDir>

#include <optional>
#include <utility>
#include <vector>

/// Points as stroke files have them.
template <> struct nlohmann::adl_serializer<core::Vec3>
{
    static void to_json(json& array, const core::Vec3& point) { array = {point.x(), point.y(), point.z()}; }
};

/// Stroke files that tests make as a person would, and the program that plays them.
namespace played_strokes
{
struct Brush
{
    const char* tool;
    double radius;
    double strength = 1;
};

/// A sample whose ray, with "place": "ray", leads the hand.
struct Hand
{
    core::Vec3 position, direction;
};

inline nlohmann::json strokeOf(const Brush& brush, nlohmann::json samples, const nlohmann::json& settings)
{
    nlohmann::json stroke = {{"tool", brush.tool}, {"radius", brush.radius}, {"strength", brush.strength}};
    stroke.update(settings);
    stroke["samples"] = std::move(samples);
    return stroke;
}

inline nlohmann::json samplesAt(const std::vector<core::Vec3>& path)
{
    nlohmann::json samples = nlohmann::json::array();
    for (const core::Vec3& point : path)
        samples.push_back({{"position", point}});
    return samples;
}

inline nlohmann::json samplesOf(const std::vector<Hand>& hands)
{
    nlohmann::json samples = nlohmann::json::array();
    for (const Hand& hand : hands)
        samples.push_back({{"position", hand.position}, {"direction", hand.direction}});
    return samples;
}

inline nlohmann::json fileOf(const nlohmann::json& strokes)
{
    return {{"format", "fettle-strokes"}, {"version", 1}, {"strokes", strokes}};
}

struct Played
{
    core::TriangleMesh mesh;
    nlohmann::json stats; ///< what `--stats` says
};

/// Plays a stroke file with `fettle replay`, on the paper's sphere or on the model given. Returns nothing if the
/// program fails; it has told why on standard error then. The files of the last call stay in the folder that
/// FETTLE_KEEP_STROKES names, if it does: strokes.json, in.ply (the model given), out.ply and stats.json.
inline std::optional<Played> replay(const nlohmann::json& file, const core::TriangleMesh* start = nullptr)
{
    const QTemporaryDir folder;
    const QDir kept(qEnvironmentVariable("FETTLE_KEEP_STROKES", folder.path()));
    const auto path = [&](const char* name) { return kept.filePath(QString::fromLatin1(name)); };
    QFile strokes(path("strokes.json"));
    if (!strokes.open(QIODevice::WriteOnly) || strokes.write(file.dump().c_str()) < 0)
        return std::nullopt;
    strokes.close();
    QStringList arguments = {
        QStringLiteral("replay"), QStringLiteral("--strokes"), path("strokes.json"), QStringLiteral("--out"),
        path("out.ply"),          QStringLiteral("--stats"),   path("stats.json")};
    if (start) {
        core::writeMesh(path("in.ply").toStdString(), *start);
        arguments << QStringLiteral("--in") << path("in.ply");
    }
    QProcess program;
    program.setProcessChannelMode(QProcess::ForwardedErrorChannel);
    program.start(QStringLiteral(FETTLE_PROGRAM), arguments);
    if (!program.waitForFinished(-1) || program.exitStatus() != QProcess::NormalExit || program.exitCode() != 0)
        return std::nullopt;
    QFile stats(path("stats.json"));
    if (!stats.open(QIODevice::ReadOnly))
        return std::nullopt;
    return Played{core::readMesh(path("out.ply").toStdString()), nlohmann::json::parse(stats.readAll().toStdString())};
}
} // namespace played_strokes
