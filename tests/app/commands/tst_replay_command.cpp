// What stroke files may hold: strokes in every tool and mode, and commands for the whole model.
#include "app/model/model_loader.h"
#include "core/geometry/face_geometry.h"
#include "core/io/mesh_io.h"
#include "core/operations/model_command.h"
#include "core/operations/starter_models.h"
#include "core/sculpt/sculptor.h"
#include "tests/support/solid_asserts.h"
#include "tests/support/test_main.h"

#include <nlohmann/json.hpp>

#include <QFile>
#include <QImage>
#include <QProcess>
#include <QTemporaryDir>
#include <QTest>

#include <cmath>

using Json = nlohmann::json;

namespace
{
const Json pullAtX = {{"tool", "pull"}, {"radius", 0.3}, {"samples", {{{"position", {1, 0, 0}}}}}};

/// As a script has it.
class Replay
{
public:
    QString path(const char* name) const { return m_folder.filePath(QString::fromLatin1(name)); }

    /// `in`: the model; empty: the paper's sphere.
    int operator()(const Json& entries, const QString& in = {})
    {
        QFile file(path("strokes.json"));
        if (!file.open(QIODevice::WriteOnly))
            return -1;
        file.write(Json{{"format", "fettle-strokes"}, {"version", 1}, {"strokes", entries}}.dump().c_str());
        file.close();
        QProcess program;
        QStringList arguments{
            QStringLiteral("replay"), QStringLiteral("--strokes"), path("strokes.json"), QStringLiteral("--out"),
            path("out.ply"),          QStringLiteral("--stats"),   path("stats.json")};
        if (!in.isEmpty())
            arguments << QStringLiteral("--in") << in;
        program.start(QStringLiteral(FETTLE_PROGRAM), arguments);
        if (!program.waitForFinished(-1) || program.exitStatus() != QProcess::NormalExit)
            return -1;
        complaint = program.readAllStandardError();
        return program.exitCode();
    }

    Json stats() const
    {
        QFile file(path("stats.json"));
        return file.open(QIODevice::ReadOnly) ? Json::parse(file.readAll().toStdString()) : Json();
    }

    QByteArray complaint;

private:
    QTemporaryDir m_folder;
};

void sculpt(core::Sculptor& sculptor)
{
    core::StrokeSettings settings;
    settings.radius = 0.3;
    core::StrokeSample sample;
    sample.position = {1, 0, 0};
    sculptor.beginStroke(settings);
    sculptor.addSample(sample);
    sculptor.endStroke();
}
} // namespace

class TestReplayCommand : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void everyToolAndMode_isPlayed();
    void commands_doWhatTheyDoInCore_data();
    void commands_doWhatTheyDoInCore();
    void inserted_isSoughtBesideTheStrokeFile();
    void shapes_areSoughtBesideTheStrokeFile();
    void badShapes_areBadInput_data();
    void badShapes_areBadInput();
    void refused_isTheAnswerNo();
    void strokesAfterACommand_areCheckedAgainstItsModel();
    void modelFarFromTheOrigin_isPlayedWhereItIs();
};

/// Each at a place of its own around the sphere, and last a ball beside it.
void TestReplayCommand::everyToolAndMode_isPlayed()
{
    Json entries = Json::array();
    for (const std::string_view tool : core::toolNames()) {
        for (const char* brush : {"sphere", "ray"}) {
            for (const char* topology : {"adaptive", "uniform"}) {
                for (const char* symmetry : {"none", "x", "y", "z"}) {
                    const double angle = 0.4 * static_cast<double>(entries.size());
                    const Json sample = {{"position", {2 * std::cos(angle), 0.3, 2 * std::sin(angle)}},
                                         {"direction", {-std::cos(angle), -0.15, -std::sin(angle)}}};
                    entries.push_back({{"tool", tool},
                                       {"brush", brush},
                                       {"topology", topology},
                                       {"symmetry", symmetry},
                                       {"place", "ray"},
                                       {"radius", 0.25},
                                       {"strength", 0.5},
                                       {"color", {10, 20, 30}},
                                       {"samples", {sample}}});
                }
            }
        }
    }
    entries.push_back({{"tool", "pull"}, {"radius", 0.3}, {"add", true}, {"samples", {{{"position", {0, 2, 0}}}}}});
    std::array<Json, 2> stats;
    for (Json& each : stats) {
        Replay replay;
        QVERIFY2(replay(entries) == 0, replay.complaint.constData());
        each = replay.stats();
        const core::Lattice lattice =
            core::Lattice::forExtent(1); // the sphere's, on which it was sculpted: that of the file's extent is coarser
        const auto mesh = mesh_asserts::sculptable(core::readMesh(replay.path("out.ply").toStdString()), lattice);
        VERIFY_VALID(*mesh);
    }
    const Json& dabs = stats[0]["dabs"];
    QCOMPARE(dabs.size(), entries.size());
    for (std::size_t i = 0; i < dabs.size(); ++i) {
        if (entries[i]["tool"] == "stamp" &&
            dabs[i]["outcome"] != "committed") { // deep, and over what others have left
            QVERIFY2(dabs[i]["outcome"] == "careful" || dabs[i]["capped"] == true,
                     (entries[i].dump() + dabs[i].dump()).c_str());
            continue;
        }
        QVERIFY2(dabs[i]["outcome"] == (i + 1 < dabs.size() ? "committed" : "added"),
                 (entries[i].dump() + dabs[i].dump()).c_str());
    }
    QCOMPARE(stats[0]["components"].get<int>(), 2);
    QVERIFY(stats[0]["mesh_hash"] == stats[1]["mesh_hash"]);
}

void TestReplayCommand::commands_doWhatTheyDoInCore_data()
{
    QTest::addColumn<QByteArray>("entry");
    QTest::addColumn<core::ModelCommand>("command");
    const auto row = [](const Json& entry, const core::ModelCommand& command) {
        QTest::newRow(entry["command"].get<std::string>().c_str())
            << QByteArray::fromStdString(entry.dump()) << command;
    };
    row({{"command", "move"}, {"by", {0.5, 0.25, -1}}}, core::Move{{0.5, 0.25, -1}});
    row({{"command", "rotate"}, {"rotation", {0, 0.6, 0, 0.8}}}, core::Rotate{Eigen::Quaterniond(0.8, 0, 0.6, 0)});
    row({{"command", "scale"}, {"factor", 3}}, core::Scale{3});
    row({{"command", "mirror"}, {"plane", "x"}}, core::Mirror{0});
    row({{"command", "recentre"}}, core::Recentre{});
    row({{"command", "fill"}, {"color", {1, 2, 3}}}, core::Fill{{1, 2, 3}});
    row({{"command", "mask"}, {"how", "cavity"}}, core::MaskOperation{core::MaskOperation::Kind::Cavity});
    row({{"command", "remesh"}, {"detail_length", 0.2}}, core::RemeshUniformly{0.2});
    row({{"command", "symmetrize"}, {"plane", "x"}, {"keep", "negative"}},
        core::Symmetrize{core::Symmetry::X, core::Half::Negative});
    row({{"command", "reset"}}, core::Reset{});
}

/// Between two dabs, so that the engine sculpts on what a command has left.
void TestReplayCommand::commands_doWhatTheyDoInCore()
{
    QFETCH(QByteArray, entry);
    QFETCH(core::ModelCommand, command);
    const app::LoadedModel model = app::ModelLoader::sphere(1);
    const auto& sculptor = model.sculptor;
    if (auto* const reset = std::get_if<core::Reset>(&command))
        reset->start = model.start;
    sculpt(*sculptor);
    core::ModelChange change = core::applyToCopy(sculptor->mesh(), command);
    QVERIFY(change.changes);
    sculptor->swap(change.delta);
    sculpt(*sculptor);
    VERIFY_VALID(sculptor->mesh());

    const Json entries = {pullAtX, Json::parse(entry.toStdString()), pullAtX};
    std::array<std::string, 2> hashes;
    for (std::string& hash : hashes) {
        Replay replay;
        QVERIFY2(replay(entries) == 0, replay.complaint.constData());
        hash = replay.stats()["mesh_hash"];
    }
    QCOMPARE(hashes[0], hashes[1]);
    QCOMPARE(QString::fromStdString(hashes[0]),
             QStringLiteral("%1").arg(sculptor->mesh().meshHash(), 16, 16, QLatin1Char('0')));
}

void TestReplayCommand::inserted_isSoughtBesideTheStrokeFile()
{
    Replay replay;
    core::writeMesh(replay.path("other.ply").toStdString(), core::icosphere(2, 0.5));
    QVERIFY2(replay(Json::array(
                 {{{"command", "insert"}, {"file", "other.ply"}, {"where", "centre"}, {"centre", {0, 3, 0}}}})) == 0,
             replay.complaint.constData());
    QCOMPARE(replay.stats()["components"].get<int>(), 2);
    const auto mesh = mesh_asserts::sculptable(core::readMesh(replay.path("out.ply").toStdString()));
    VERIFY_VALID(*mesh);
    QCOMPARE(replay(Json::array({{{"command", "insert"}, {"file", "missing.ply"}}})), 2);
    QVERIFY(replay.complaint.contains("missing.ply"));
}

void TestReplayCommand::shapes_areSoughtBesideTheStrokeFile()
{
    Replay replay;
    QImage bright(8, 8, QImage::Format_Grayscale8), dim = bright;
    bright.fill(255), dim.fill(60);
    QVERIFY(bright.save(replay.path("bright.png")) && dim.save(replay.path("dim.png")));
    core::writeMesh(replay.path("brush.ply").toStdString(), core::starterModel(core::Starter::Torus));
    const auto hashWith = [&](const Json& more) {
        Json stroke = pullAtX;
        stroke.update(more);
        return replay(Json::array({stroke})) == 0 ? replay.stats()["mesh_hash"].get<std::string>() : std::string();
    };
    const std::string strong = hashWith({{"alpha", "bright.png"}}), weak = hashWith({{"alpha", "dim.png"}});
    QVERIFY2(!strong.empty() && !weak.empty() && strong != weak, replay.complaint.constData());
    QCOMPARE(hashWith({{"alpha", replay.path("bright.png").toStdString()}}), strong);
    const std::string ball = hashWith({{"tool", "stamp"}}),
                      torus = hashWith({{"tool", "stamp"}, {"model", "brush.ply"}});
    QVERIFY2(!ball.empty() && !torus.empty() && ball != torus, replay.complaint.constData());
    const auto mesh = mesh_asserts::sculptable(core::readMesh(replay.path("out.ply").toStdString()));
    VERIFY_VALID(*mesh);
    QCOMPARE(
        hashWith({{"tool", "stamp"}, {"model", "brush.ply"}, {"add", true}, {"samples", {{{"position", {0, 3, 0}}}}}})
            .size(),
        std::size_t(16));
    QCOMPARE(replay.stats()["genus"].get<int>(), 1);
}

void TestReplayCommand::badShapes_areBadInput_data()
{
    QTest::addColumn<QByteArray>("key");
    QTest::addColumn<QByteArray>("value");
    QTest::addColumn<QByteArray>("reason");
    QTest::newRow("no such alpha") << QByteArray("alpha") << QByteArray("spots") << QByteArray("there is no such file");
    QTest::newRow("no image") << QByteArray("alpha") << QByteArray("text.png") << QByteArray("not an image");
    QTest::newRow("changed") << QByteArray("alpha") << QByteArray("white.png") << QByteArray("not what it was");
    QTest::newRow("no such model") << QByteArray("model") << QByteArray("none.stl") << QByteArray("none.stl");
    QTest::newRow("open model") << QByteArray("model") << QByteArray("open.ply") << QByteArray("open edges: 3");
    QTest::newRow("no model") << QByteArray("model") << QByteArray("text.png") << QByteArray("text.png");
}

/// One line that names the stroke, status 2, and nothing written.
void TestReplayCommand::badShapes_areBadInput()
{
    QFETCH(QByteArray, key);
    QFETCH(QByteArray, value);
    QFETCH(QByteArray, reason);
    Replay replay;
    QImage white(2, 2, QImage::Format_Grayscale8);
    white.fill(255);
    QVERIFY(white.save(replay.path("white.png")));
    QFile text(replay.path("text.png"));
    QVERIFY(text.open(QIODevice::WriteOnly) && text.write("no image") > 0);
    text.close();
    core::TriangleMesh open = core::icosphere(2, 1);
    open.triangles.pop_back();
    core::writeMesh(replay.path("open.ply").toStdString(), open);
    Json stroke = pullAtX;
    stroke[key.toStdString()] = value.toStdString();
    stroke[key.toStdString() + "_hash"] = "0000000000000000";
    QCOMPARE(replay(Json::array({pullAtX, stroke})), 2);
    QVERIFY2(replay.complaint.contains("strokes[1]") && replay.complaint.contains(reason) &&
                 replay.complaint.count('\n') == 1,
             replay.complaint.constData());
    QVERIFY(!QFile::exists(replay.path("out.ply")));
}

void TestReplayCommand::refused_isTheAnswerNo()
{
    Replay replay;
    core::writeMesh(replay.path("same.ply").toStdString(), core::icosphere(4, 1));
    QCOMPARE(replay(Json::array({pullAtX, {{"command", "insert"}, {"file", "same.ply"}, {"where", "as_it_is"}}})), 1);
    QVERIFY2(replay.complaint.contains("strokes[1]") && replay.complaint.contains("same.ply"),
             replay.complaint.constData());
    QVERIFY(!QFile::exists(replay.path("out.ply")) && !QFile::exists(replay.path("stats.json")));
}

void TestReplayCommand::strokesAfterACommand_areCheckedAgainstItsModel()
{
    Json far = pullAtX;
    far["samples"][0]["position"] = {50, 0, 0};
    far["radius"] = 0.2;
    Replay replay;
    QCOMPARE(replay(Json::array({far})), 2); // outside of the working volume
    QVERIFY(replay.complaint.contains("strokes[0]"));
    QCOMPARE(replay(Json::array({{{"command", "scale"}, {"factor", 50}}, far})),
             2); // inside, but the brush is too fine now
    QCOMPARE(replay(Json::array({pullAtX, {{"command", "recentre"}}, far})), 2);
    QVERIFY(replay.complaint.contains("strokes[2]"));
    QVERIFY(!QFile::exists(replay.path("out.ply")));
    far["radius"] = 15;
    QVERIFY2(replay(Json::array({{{"command", "scale"}, {"factor", 50}}, far})) == 0, replay.complaint.constData());
}

/// `check` says that such a model can be sculpted. Strokes have the file's coordinates, and so has the result.
void TestReplayCommand::modelFarFromTheOrigin_isPlayedWhereItIs()
{
    core::TriangleMesh far = core::icosphere(4, 1);
    for (core::Vec3f& p : far.points)
        p += core::Vec3f(12, 10, 0);
    Replay replay;
    core::writeMesh(replay.path("far.ply").toStdString(), far);
    Json pull = pullAtX;
    pull["samples"][0]["position"] = {13, 10, 0};
    QVERIFY2(replay(Json::array({pull}), replay.path("far.ply")) == 0, replay.complaint.constData());
    const core::Box box = core::boxOf(core::readMesh(replay.path("out.ply").toStdString()));
    QVERIFY(box.max().x() > 13.01 && std::abs(box.min().x() - 11) < 0.001 && std::abs(box.center().y() - 10) < 0.01);
}

FETTLE_TEST(TestReplayCommand, QCoreApplication)
#include "tst_replay_command.moc"
