#pragma once

#include <string>
#include <string_view>
#include <vector>

/// What a class declares; deleted and defaulted functions, friends and the functions of nested classes not counted.
struct ClassOutline
{
    std::string name; ///< "core::Mesh", "app::Document::State"; without anonymous namespaces
    int line = 0;
    int publicFunctions = 0;  ///< signals and slots included
    int privateFunctions = 0; ///< protected ones included
};

/// A function with a body.
struct FunctionOutline
{
    std::string name; ///< as in "core::Mesh::split"
    int line = 0;
    int lines = 0; ///< from the declaration to the closing brace
};

/// The classes and the functions that a C++ source defines.
struct SourceOutline
{
    std::vector<ClassOutline> classes;
    std::vector<FunctionOutline> functions;
    bool isBalanced = true; ///< false: the braces do not match, and the rest is not to be trusted
};

/// Reads the declarations of a source as this program writes them; no preprocessing: all branches of #if are read.
SourceOutline outlineOf(std::string_view source);
