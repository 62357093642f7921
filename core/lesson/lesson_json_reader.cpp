// lesson.json is small and is parsed into a JSON tree. Then each value is stored in its member, and each referenced
// file is read and parsed.
#include "core/lesson/lesson_json_reader.h"

#include "core/io/mesh_io.h"

#include <algorithm>
#include <set>

namespace core
{
namespace
{
constexpr int version = 1;
constexpr std::string_view formatName = "fettle-lesson";
constexpr int maxDepth = 6; ///< deepest allowed nesting: file, steps, step, checkpoint, fact, bound
constexpr double minTolerance = 1e-3, maxTolerance = 1e4; ///< mm

/// Returns whether the code has the form of "de", "zh_CN" or "pt-BR".
bool isLanguage(std::string_view code)
{
    const auto isLetter = [](char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); };
    const std::string_view plain = code.substr(0, code.find_first_of("_-"));
    const std::string_view country = code.substr(std::min(plain.size() + 1, code.size()));
    return (plain.size() == 2 || plain.size() == 3) && country.size() <= 8 &&
           (country.size() >= 2 || plain.size() == code.size()) && std::ranges::all_of(plain, isLetter) &&
           std::ranges::all_of(country, [&](char c) { return isLetter(c) || (c >= '0' && c <= '9'); });
}

bool isPicture(std::string_view bytes)
{
    return bytes.starts_with("\x89PNG\r\n\x1a\n") || bytes.starts_with("\xff\xd8\xff");
}
} // namespace

LessonError LessonJsonReader::errorHere(Kind kind, std::string key) const
{
    LessonError error(kind, m_files.path);
    error.step = m_step;
    constexpr std::size_t longest = 60;
    error.key = key.substr(0, longest);
    return error;
}

void LessonJsonReader::refuseBeyond(Kind kind, const std::string& key, double max, double min) const
{
    LessonError error = errorHere(kind, key);
    error.min = min;
    error.max = max;
    throw error;
}

Lesson LessonJsonReader::read()
{
    const std::optional<std::string> text = m_files.read(lessonJsonName, LessonLimits::maxJsonBytes);
    if (!text)
        refuse(Kind::NoLesson);
    if (text->size() > LessonLimits::maxJsonBytes) {
        LessonError error = errorHere(Kind::TooLarge);
        error.file = lessonJsonName;
        error.max = LessonLimits::maxJsonBytes;
        throw error;
    }
    const Json root = parse(*text);
    requireFormat(root);
    knowsOnly(root, "", {"format", "version", "title", "summary", "start", "steps"});
    m_lesson.title = this->text(required(root, "title"), "title");
    if (root.contains("summary"))
        m_lesson.summary = this->text(root["summary"], "summary");
    m_lesson.start = start(required(root, "start"));
    const Json& steps = required(root, "steps");
    if (!steps.is_array() || steps.empty())
        refuse(Kind::WrongType, "steps");
    if (steps.size() > LessonLimits::maxSteps)
        refuseBeyond(Kind::TooMany, "steps", LessonLimits::maxSteps);
    for (std::size_t i = 0; i < steps.size(); ++i) {
        m_step = i;
        m_lesson.steps.push_back(step(steps[i]));
    }
    return std::move(m_lesson);
}

/// Parses the text and refuses deep nesting and duplicate keys. The JSON library parses any depth and builds an equally
/// deep tree, and of two equal keys it keeps the last.
LessonJsonReader::Json LessonJsonReader::parse(const std::string& text) const
{
    std::vector<std::set<std::string>> keys;
    const auto look = [&](int depth, Json::parse_event_t event, Json& value) {
        if (depth > maxDepth)
            refuse(Kind::TooDeep);
        if (event == Json::parse_event_t::object_start)
            keys.emplace_back();
        else if (event == Json::parse_event_t::object_end)
            keys.pop_back();
        else if (event == Json::parse_event_t::key && !keys.back().insert(value.get<std::string>()).second)
            refuse(Kind::DuplicateKey, value.get<std::string>());
        return true;
    };
    try {
        return Json::parse(text, look);
    } catch (const Json::parse_error& problem) {
        LessonError error = errorHere(Kind::Syntax);
        const std::size_t at = std::min(std::max<std::size_t>(problem.byte, 1) - 1, text.size());
        error.line = 1 + static_cast<std::size_t>(std::count(text.begin(), text.begin() + static_cast<long>(at), '\n'));
        error.byte = at + 1;
        throw error;
    } catch (const Json::exception&) { // a number too large for a double
        refuse(Kind::Syntax);
    }
}

void LessonJsonReader::requireFormat(const Json& root) const
{
    if (!root.is_object() || !root.contains("format") || root["format"] != formatName)
        refuse(Kind::NotALesson);
    const Json& number = required(root, "version");
    if (!number.is_number_unsigned())
        refuse(Kind::WrongType, "version");
    LessonError newer = errorHere(Kind::Newer, "version");
    newer.version = number.get<std::uint64_t>();
    if (newer.version > version)
        throw newer;
    if (newer.version < version)
        refuseBeyond(Kind::OutOfRange, "version", version, version);
}

void LessonJsonReader::knowsOnly(const Json& object, const std::string& key,
                                 std::initializer_list<std::string_view> known) const
{
    if (!object.is_object())
        refuse(Kind::WrongType, key);
    for (const auto& item : object.items())
        if (std::ranges::find(known, std::string_view(item.key())) == known.end())
            refuse(Kind::UnknownKey, item.key());
}

const LessonJsonReader::Json& LessonJsonReader::required(const Json& object, const std::string& key) const
{
    const auto found = object.find(key);
    if (found == object.end())
        refuse(Kind::MissingKey, key);
    return *found;
}

const std::string& LessonJsonReader::word(const Json& value, const std::string& key) const
{
    if (!value.is_string())
        refuse(Kind::WrongType, key);
    return value.get_ref<const std::string&>();
}

double LessonJsonReader::number(const Json& value, const std::string& key, double min, double max) const
{
    if (!value.is_number())
        refuse(Kind::WrongType, key);
    const double number = value.get<double>();
    if (!(number >= min && number <= max))
        refuseBeyond(Kind::OutOfRange, key, max, min);
    return number;
}

LessonText LessonJsonReader::text(const Json& value, const std::string& key) const
{
    if (!value.is_object())
        refuse(Kind::WrongType, key);
    LessonText text;
    for (const auto& item : value.items()) {
        if (!isLanguage(item.key()))
            refuse(Kind::UnknownKey, item.key());
        const std::string& words = word(item.value(), key);
        if (words.find_first_not_of(" \t\r\n") == std::string::npos)
            refuse(Kind::NoWords, key);
        if (words.size() > LessonLimits::maxTextBytes)
            refuseBeyond(Kind::TooLong, key, LessonLimits::maxTextBytes);
        text.words.emplace(item.key(), words);
    }
    if (text.words.empty())
        refuse(Kind::NoWords, key);
    return text;
}

std::variant<Starter, std::string> LessonJsonReader::start(const Json& value)
{
    if (value.is_object()) {
        knowsOnly(value, "start", {"file"});
        return model(word(required(value, "file"), "file"), "file");
    }
    const std::string& name = word(value, "start");
    if (const auto starter = starterNamed(name))
        return *starter;
    refuse(Kind::UnknownValue, name);
}

LessonStep LessonJsonReader::step(const Json& object)
{
    knowsOnly(object, "steps", {"title", "text", "picture", "tools", "view", "strokes", "checkpoint"});
    LessonStep step;
    step.title = text(required(object, "title"), "title");
    step.text = text(required(object, "text"), "text");
    if (object.contains("picture"))
        step.picture = picture(object["picture"]);
    if (object.contains("tools"))
        step.tools = tools(object["tools"]);
    if (object.contains("view")) {
        const Json& view = object["view"];
        knowsOnly(view, "view", {"yaw_deg", "pitch_deg"});
        step.view = LessonView{number(required(view, "yaw_deg"), "yaw_deg", -180, 180),
                               number(required(view, "pitch_deg"), "pitch_deg", -90, 90)};
    }
    if (object.contains("strokes")) {
        step.strokesFile = word(object["strokes"], "strokes");
        step.strokes = strokes(step.strokesFile);
    }
    if (object.contains("checkpoint"))
        step.checkpoint = checkpoint(object["checkpoint"]);
    return step;
}

std::vector<Tool> LessonJsonReader::tools(const Json& list) const
{
    if (!list.is_array() || list.empty())
        refuse(Kind::WrongType, "tools");
    std::vector<Tool> tools;
    for (const Json& entry : list) {
        const auto tool = named<Tool>(word(entry, "tools"));
        if (!tool || std::ranges::find(tools, *tool) != tools.end())
            refuse(Kind::UnknownValue, word(entry, "tools"));
        tools.push_back(*tool);
    }
    return tools;
}

std::string LessonJsonReader::picture(const Json& value)
{
    const std::string& name = word(value, "picture");
    std::string bytes = bytesOf(name, "picture", LessonLimits::maxPictureBytes);
    if (!isPicture(bytes)) {
        LessonError error = errorHere(Kind::NotAPicture);
        error.file = name;
        throw error;
    }
    addFile(name, std::move(bytes));
    return name;
}

std::vector<FileEntry> LessonJsonReader::strokes(const std::string& name)
{
    LessonError error = errorHere(Kind::Strokes);
    error.file = name;
    try {
        std::vector<FileEntry> entries = parseStrokes(bytesOf(name, "strokes", LessonLimits::maxStrokeBytes));
        for (std::size_t i = 0; i < entries.size(); ++i) {
            const auto* const stroke = std::get_if<Stroke>(&entries[i]);
            if (stroke ? stroke->alpha.file.empty() && stroke->model.file.empty()
                       : std::get<FileCommand>(entries[i]).file.empty())
                continue;
            error.kind = Kind::NamesFiles;
            error.strokes.emplace(StrokeFileError::Kind::UnknownValue);
            error.strokes->stroke = i;
            throw error;
        }
        return entries;
    } catch (const StrokeFileError& problem) {
        error.strokes = problem;
        throw error;
    }
}

Checkpoint LessonJsonReader::checkpoint(const Json& object)
{
    if (!object.is_object())
        refuse(Kind::WrongType, "checkpoint");
    Checkpoint checkpoint;
    for (const auto& item : object.items()) {
        const auto fact = std::ranges::find(factTable, std::string_view(item.key()), &FactInfo::key);
        if (item.key() == "target")
            checkpoint.target = target(item.value());
        else if (fact != std::end(factTable))
            checkpoint.facts.push_back(bounds(static_cast<Fact>(fact - std::begin(factTable)), item.value()));
        else
            refuse(Kind::UnknownKey, item.key());
    }
    if (checkpoint.asksNothing())
        refuse(Kind::WrongType, "checkpoint");
    std::ranges::sort(checkpoint.facts, {}, &FactBounds::fact);
    return checkpoint;
}

FactBounds LessonJsonReader::bounds(Fact fact, const Json& value) const
{
    const std::string key(info(fact).key);
    if (fact == Fact::PrintReady) {
        if (value != true)
            refuse(Kind::WrongType, key);
        return {fact, 1, 1};
    }
    const auto bound = [&](const Json& number) {
        const double asked = this->number(number, key, 0, info(fact).max);
        if (info(fact).isWhole && !number.is_number_unsigned())
            refuse(Kind::WrongType, key);
        return asked;
    };
    if (!value.is_object())
        return {fact, bound(value), bound(value)};
    knowsOnly(value, key, {"least", "most"});
    FactBounds bounds{fact};
    if (value.contains("least"))
        bounds.min = bound(value["least"]);
    if (value.contains("most"))
        bounds.max = bound(value["most"]);
    if (value.empty() || bounds.min > bounds.max)
        refuse(Kind::WrongType, key);
    return bounds;
}

CheckpointTarget LessonJsonReader::target(const Json& object)
{
    knowsOnly(object, "target", {"file", "tolerance_mm"});
    CheckpointTarget target;
    target.tolerance = number(required(object, "tolerance_mm"), "tolerance_mm", minTolerance, maxTolerance);
    if (object.contains("file"))
        target.file = model(word(object["file"], "file"), "file");
    return target;
}

std::string LessonJsonReader::model(const std::string& name, const std::string& key)
{
    LessonError error = errorHere(Kind::Unsound);
    error.file = name;
    std::string bytes = bytesOf(name, key, LessonLimits::maxBytes);
    error.report = checkMesh(parseMesh(m_files.path / pathOfUtf8(name), bytes));
    if (!error.report.printReady())
        throw error;
    addFile(name, std::move(bytes));
    return name;
}

std::string LessonJsonReader::bytesOf(const std::string& name, const std::string& key, std::size_t max)
{
    if (!isLessonName(name))
        refuse(Kind::BadName, name);
    LessonError error = errorHere(Kind::MissingFile, key);
    error.file = name;
    max = std::min(max, m_left);
    std::optional<std::string> bytes = m_files.read(name, max);
    if (!bytes)
        throw error;
    if (bytes->size() > max) {
        error.kind = Kind::TooLarge;
        error.max = static_cast<double>(max);
        throw error;
    }
    m_left -= bytes->size();
    return std::move(*bytes);
}
} // namespace core
