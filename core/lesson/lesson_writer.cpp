// Writes lessons in the form that the reader accepts. A zip replaces an existing file atomically. A folder gets its
// final name when all its files are written.
#include "core/lesson/lesson_source.h"

#include "core/io/mesh/zip_writer.h"
#include "core/util/atomic_file.h"
#include "core/util/system_path.h"

#include <nlohmann/json.hpp>

#include <sstream>

namespace core
{
namespace
{
using Json = nlohmann::ordered_json;

Json jsonOf(const LessonText& text)
{
    Json json = Json::object();
    for (const auto& [language, words] : text.words)
        json[language] = words;
    return json;
}

/// Writes whole numbers without a fraction, as the reader requires.
Json jsonOf(double value, Fact fact)
{
    return info(fact).isWhole ? Json(static_cast<std::uint64_t>(value)) : Json(value);
}

Json jsonOf(const FactBounds& bounds)
{
    if (bounds.fact == Fact::PrintReady)
        return true;
    if (bounds.min == bounds.max)
        return jsonOf(bounds.min, bounds.fact);
    Json json = Json::object();
    if (bounds.min > 0 || bounds.max == FactBounds::unbounded)
        json["least"] = jsonOf(bounds.min, bounds.fact);
    if (bounds.max < FactBounds::unbounded)
        json["most"] = jsonOf(bounds.max, bounds.fact);
    return json;
}

Json jsonOf(const Checkpoint& checkpoint)
{
    Json json;
    for (const FactBounds& bounds : checkpoint.facts)
        json[info(bounds.fact).key] = jsonOf(bounds);
    if (checkpoint.target) {
        if (!checkpoint.target->file.empty())
            json["target"]["file"] = checkpoint.target->file;
        json["target"]["tolerance_mm"] = checkpoint.target->tolerance;
    }
    return json;
}

Json jsonOf(const LessonStep& step)
{
    Json json = {{"title", jsonOf(step.title)}, {"text", jsonOf(step.text)}};
    if (!step.picture.empty())
        json["picture"] = step.picture;
    for (const Tool tool : step.tools)
        json["tools"].push_back(name(tool));
    if (step.view)
        json["view"] = {{"yaw_deg", step.view->yaw}, {"pitch_deg", step.view->pitch}};
    if (!step.strokesFile.empty())
        json["strokes"] = step.strokesFile;
    if (!step.checkpoint.asksNothing())
        json["checkpoint"] = jsonOf(step.checkpoint);
    return json;
}

void writeZip(const std::filesystem::path& path, const std::map<std::string, std::string>& files)
{
    io::ZipWriter zip;
    for (const auto& [name, bytes] : files)
        zip.add(name.c_str(), bytes, io::ZipWriter::Packing::Deflated);
    AtomicFile out(path);
    zip.writeTo(out);
    out.commit();
}

/// A temporary folder beside its final path. The destructor removes it with its content unless commit() renamed it.
class HalfWritten
{
public:
    explicit HalfWritten(const std::filesystem::path& path) : m_path(path), m_half(path)
    {
        m_half += ".part";
        std::error_code problem;
        if (std::filesystem::exists(path, problem))
            problem = std::make_error_code(std::errc::file_exists);
        else if (!std::filesystem::create_directory(m_half, problem) && !problem)
            problem = std::make_error_code(std::errc::file_exists);
        else
            m_isOurs = !problem;
        checkWritten(problem, path);
    }
    ~HalfWritten()
    {
        std::error_code ignored;
        if (m_isOurs)
            std::filesystem::remove_all(m_half, ignored);
    }
    HalfWritten(const HalfWritten&) = delete;
    HalfWritten& operator=(const HalfWritten&) = delete;

    void add(const std::string& name, const std::string& bytes)
    {
        std::error_code problem;
        const std::filesystem::path file = m_half / pathOfUtf8(name);
        std::filesystem::create_directories(file.parent_path(), problem);
        checkWritten(problem, m_path);
        AtomicFile out(file);
        out.write(bytes);
        out.commit();
    }

    void commit()
    {
        std::error_code problem;
        std::filesystem::rename(m_half, m_path, problem);
        checkWritten(problem, m_path);
        m_isOurs = false;
    }

private:
    std::filesystem::path m_path, m_half;
    bool m_isOurs = false;
};

bool isZipName(const std::filesystem::path& path)
{
    const std::string ending = path.extension().string();
    return ending == ".zip" || ending == ".ZIP";
}
} // namespace

std::map<std::string, std::string> filesOf(const Lesson& lesson)
{
    std::map<std::string, std::string> files = lesson.files;
    files[lessonJsonName] = lessonJson(lesson);
    for (const LessonStep& step : lesson.steps)
        if (!step.strokesFile.empty())
            files[step.strokesFile] = strokesText(step);
    return files;
}

std::string lessonJson(const Lesson& lesson)
{
    Json json = {{"format", "fettle-lesson"}, {"version", 1}, {"title", jsonOf(lesson.title)}};
    if (!lesson.summary.words.empty())
        json["summary"] = jsonOf(lesson.summary);
    if (const auto* const starter = std::get_if<Starter>(&lesson.start))
        json["start"] = name(*starter);
    else
        json["start"]["file"] = std::get<std::string>(lesson.start);
    for (const LessonStep& step : lesson.steps)
        json["steps"].push_back(jsonOf(step));
    return json.dump(1, ' ') + "\n";
}

std::string strokesText(const LessonStep& step)
{
    std::ostringstream text;
    writeStrokes(text, step.strokes);
    return text.str();
}

void writeLesson(const std::filesystem::path& path, const Lesson& lesson)
{
    const std::map<std::string, std::string> files = filesOf(lesson);
    if (isZipName(path))
        return writeZip(path, files);
    HalfWritten folder(path);
    for (const auto& [name, bytes] : files)
        folder.add(name, bytes);
    folder.commit();
}
} // namespace core
