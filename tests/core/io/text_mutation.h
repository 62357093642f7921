#pragma once

#include <random>
#include <span>
#include <string>

/// Returns the text with one to three random changes: a byte replaced by a random one, up to eight erased, or a word
/// inserted. Precondition: the text is longer than 16 bytes, so that two changes cannot empty it, and `words` is not
/// empty.
inline std::string mutated(std::string text, std::span<const std::string> words, std::mt19937& engine)
{
    for (auto edits = 1 + engine() % 3; edits != 0; --edits) {
        const std::size_t at = engine() % text.size();
        switch (engine() % 3) {
        case 0:
            text[at] = static_cast<char>(engine());
            break;
        case 1:
            text.erase(at, 1 + engine() % 8);
            break;
        default:
            text.insert(at, words[engine() % words.size()]);
            break;
        }
    }
    return text;
}
