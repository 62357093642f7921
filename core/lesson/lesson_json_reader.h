#pragma once

// Used by the reader of lessons only.

#include "core/lesson/lesson_source.h"

#include <nlohmann/json.hpp>

#include <initializer_list>

namespace core
{
/// Builds a lesson from lesson.json and the files that it references. Throws LessonError at the first thing that the
/// format does not allow.
class LessonJsonReader
{
public:
    explicit LessonJsonReader(const LessonFiles& files) : m_files(files) {}
    Lesson read();

private:
    using Json = nlohmann::json;
    using Kind = LessonError::Kind;

    LessonError errorHere(Kind kind, std::string key = {}) const;
    [[noreturn]] void refuse(Kind kind, std::string key = {}) const { throw errorHere(kind, std::move(key)); }
    [[noreturn]] void refuseBeyond(Kind kind, const std::string& key, double max, double min = 0) const;

    Json parse(const std::string& text) const;
    void requireFormat(const Json& root) const;
    void knowsOnly(const Json& object, const std::string& key, std::initializer_list<std::string_view> known) const;
    const Json& required(const Json& object, const std::string& key) const;
    const std::string& word(const Json& value, const std::string& key) const;
    double number(const Json& value, const std::string& key, double min, double max) const;
    LessonText text(const Json& value, const std::string& key) const;

    std::variant<Starter, std::string> start(const Json& value);
    LessonStep step(const Json& object);
    std::vector<Tool> tools(const Json& list) const;
    std::string picture(const Json& value);
    std::vector<FileEntry> strokes(const std::string& name);
    Checkpoint checkpoint(const Json& object);
    FactBounds bounds(Fact fact, const Json& value) const;
    CheckpointTarget target(const Json& object);
    std::string model(const std::string& name, const std::string& key);

    std::string bytesOf(const std::string& name, const std::string& key, std::size_t max);
    void addFile(const std::string& name, std::string bytes) { m_lesson.files.try_emplace(name, std::move(bytes)); }

    const LessonFiles& m_files;
    Lesson m_lesson;
    std::optional<std::size_t> m_step;           ///< index of the step that is being read
    std::size_t m_left = LessonLimits::maxBytes; ///< bytes that may still be read from referenced files
};
} // namespace core
