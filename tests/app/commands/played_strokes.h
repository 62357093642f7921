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

/// Converts points to the form of stroke files.
template <> struct nlohmann::adl_serializer<core::Vec3>
{
    static void to_json(json& array, const core::Vec3& point) { array = {point.x(), point.y(), point.z()}; }
};

/// Creates stroke files as a user would, and replays them with the program.
namespace played_strokes
{
struct Brush
{
    const char* tool;
    double radius;
    double strength = 1;
};

/// Position and direction of one sample of a stroke with "place": "ray".
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
    nlohmann::json stats; ///< output of `--stats`
};

/// Plays a stroke file with `fettle replay`, on the given model or on the paper's sphere.
/// Returns nothing if the program fails, which it reports on standard error.
/// FETTLE_KEEP_STROKES=FOLDER keeps the files of the last call: strokes.json, in.ply (the given model), out.ply and
/// stats.json.
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
