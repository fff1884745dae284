#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <map>
#include <regex>
#include <set>
#include <sstream>

#include "common/base/exercise.h"
#include "common/base/files.h"
#include "common/base/names.h"
#include "common/gpu/glsl.h"

namespace lightwalk {
namespace fs = std::filesystem;
namespace {

// Chapter number of a path: "02" for "02_lambert_phong/x.glsl" and for tests/02_lambert_phong; "00" for common.
std::string chapter_of(const std::string& name) {
    for (const fs::path& folder : fs::path(name))
        if (std::isdigit(static_cast<unsigned char>(folder.native()[0]))) return folder.string().substr(0, 2);
    return "00";
}

// Path below $LIGHTWALK_OVERLAY if the file exists there: shader changes without editing the tree.
fs::path overlaid(const fs::path& file) {
    const char* const overlay = std::getenv("LIGHTWALK_OVERLAY");
    if (!overlay || !*overlay) return file;
    const fs::path other = fs::path(overlay) / fs::relative(file, course_root());
    return fs::exists(other) ? other : file;
}

// #line would attribute errors to another file; #version is added.
void refuse_line_numbers(const std::string& text, const std::string& shown) {
    static const std::regex directive(R"re(^\s*#\s*(line|version)\b.*)re");
    std::istringstream in(text);
    std::string line;
    std::smatch match;
    for (int number = 1; std::getline(in, line); ++number)
        if (std::regex_match(line, match, directive))
            throw ShaderError("{}:{}: no shader has a #{}; leave it out", shown, number, match[1].str());
}

// Test shader, on disk or inline. `#pragma replaces "05_shadow_maps/x.glsl"` makes includes of that file empty.
bool is_of_tests(const std::string& shown) { return shown.starts_with("tests/") || !shown.starts_with("shaders/"); }

// The two nearest names in the folder of a missing file.
std::string near(const std::string& name) {
    const fs::path folder = fs::path(name).parent_path();
    std::set<std::pair<size_t, std::string>> ranked;
    for (const fs::path& below : {folder, folder / "exercise"}) {
        std::error_code error;
        for (const auto& entry : fs::directory_iterator(course_root() / "shaders" / below, error))
            if (const fs::path file = entry.path().filename(); entry.is_regular_file())
                ranked.emplace(edit_distance(fs::path(name).filename().string(), file.string()), file.string());
    }
    std::string nearest;
    for (auto one = ranked.begin(); one != ranked.end() && std::distance(ranked.begin(), one) < 2; ++one)
        nearest += (nearest.empty() ? "" : " and ") + one->second;
    return nearest.empty() ? "" : fmt::format("; the nearest in {}: {}", folder.string(), nearest);
}

class Flattener {
  public:
    explicit Flattener(const Macros& macros) : macros_(macros) {}
    FlatShader result;

    void include(const std::string& name, const std::string& from) {
        if (name.empty()) throw ShaderError("{}: the pipeline names no shader, a path below shaders/", from);
        const fs::path file = resolve(name, from);
        if (!seen_.insert(file).second) return;
        if (!fs::is_regular_file(overlaid(file)))  // a device file may be endless
            throw ShaderError("{}: shaders/{} is not a regular file", from, name);
        result.files.push_back(file);
        std::string text;
        try {
            text = read_file(overlaid(file));
        } catch (const InputError& e) { throw ShaderError(e.what()); }
        if (text.starts_with("\xEF\xBB\xBF")) text.erase(0, 3);  // UTF-8 byte order mark
        const std::string shown = fs::relative(file, course_root()).string();
        refuse_line_numbers(text, shown);
        add(text, shown, chapter_of(name));
    }

    void add(const std::string& text, const std::string& shown, const std::string& chapter) {
        static const std::regex directive(R"re(^\s*#\s*include\s+"([^"]+)".*)re");
        static const std::regex replaces(R"re(^\s*#\s*pragma\s+replaces\s+"([^"]+)".*)re");
        std::istringstream in(text);
        std::string line;
        int number = 0, depth = 0;
        result.text += fmt::format("#line 1 \"{}\"\n", shown);
        while (std::getline(in, line)) {
            ++number;
            const size_t hash = line.find_first_not_of(" \t");
            const bool is_directive = hash != line.npos && line[hash] == '#';
            const auto starts = [&](const char* word) {
                const size_t at = line.find_first_not_of(" \t", hash + 1);
                return is_directive && at != line.npos && line.compare(at, std::strlen(word), word) == 0;
            };
            if (starts("if")) ++depth;
            if (starts("endif")) --depth;
            std::smatch match;
            if (starts("pragma") && std::regex_match(line, match, replaces)) {
                if (!is_of_tests(shown)) throw ShaderError("{}:{}: only tests replace a shader", shown, number);
                if (!seen_.insert(resolve(match[1], fmt::format("{}:{}", shown, number))).second)
                    throw ShaderError("{}:{}: shaders/{} was read before it is replaced", shown, number,
                                      std::string(match[1]));
                result.text += "\n";
                continue;
            }
            if (!starts("include")) {
                result.text += line + "\n";
                continue;
            }
            if (!std::regex_match(line, match, directive)) {  // <...>: C++ header of a shared struct
                static const std::regex bracketed(R"re(.*<([^>]+\.glsl)>.*)re");
                if (std::regex_match(line, match, bracketed))
                    throw ShaderError("{}:{}: a shader is included as \"{}\"", shown, number, match[1].str());
                result.text += "\n";
                continue;
            }
            std::string name = match[1];
            const auto other = macros_.files().find(name);
            const bool replaced = other != macros_.files().end();
            if (replaced) name = other->second;
            const fs::path below = name.starts_with("../tests/") ? name.substr(3) : name;
            if (below.is_absolute() || std::ranges::count(below, fs::path("..")))
                throw ShaderError("{}:{}: #include \"{}\": an include is a path below shaders/", shown, number, name);
            // Files are included once; within #if, inclusion would depend on file order.
            if (depth > 0) throw ShaderError("{}:{}: #include within #if; move it to the top", shown, number);
            for (const char* const version : {"exercise", "solution"})
                if (!replaced && std::ranges::count(below, fs::path(version)) && !is_of_tests(shown))
                    throw ShaderError("{}:{}: #include \"{}\": leave out {}/; --use chooses the version", shown, number,
                                      name, version);
            if (chapter_of(name) > chapter && !replaced)
                throw ShaderError("{}:{}: chapter {} may not include the later chapter's {}", shown, number, chapter,
                                  name);
            include(name, fmt::format("{}:{}", shown, number));
            result.text += fmt::format("#line {} \"{}\"\n", number + 1, shown);
        }
    }

  private:
    fs::path resolve(const std::string& name, const std::string& from) const {
        const fs::path root = course_root() / "shaders";
        if (fs::exists(root / name)) return root / name;
        const fs::path folder = fs::path(name).parent_path(), file = fs::path(name).filename();
        const fs::path exercise = root / folder / "exercise" / file;
        if (fs::exists(exercise)) {
            const std::string id = chapter_of(name) + "." + file.stem().string();
            return Exercises::uses_solution(id) ? root / folder / "solution" / file : exercise;
        }
        fs::path beside = fs::path(from).parent_path().lexically_relative("shaders");
        if (beside.filename() == "exercise" || beside.filename() == "solution") beside = beside.parent_path();
        if (folder.empty() && (fs::exists(root / beside / file) || fs::exists(root / beside / "exercise" / file)))
            throw ShaderError("{}: no file shaders/{}; write \"{}\"", from, name, (beside / file).string());
        throw ShaderError("{}: no file shaders/{}{}", from, name,
                          name.starts_with("shaders/") ? "; leave out shaders/" : near(name));
    }

    const Macros& macros_;
    std::set<fs::path> seen_;
};

bool is_word(char c) { return std::isalnum(static_cast<unsigned char>(c)) || c == '_'; }

// Names that a text defines at file scope, each with the types of a function's parameters; blocks and shared variables are
// others' to name.
std::set<std::pair<std::string, std::string>> definitions_of(const std::string& text) {
    static const std::regex definition(
        R"((?:^|[;}])\s*(?:(?:const|precise|highp|mediump)\s+)*)"
        R"((?:struct\s+(\w+)|\w+\s*(?:\[\w*\])?\s+(\w+)\s*(?:\(([^()]*)\)\s*(?=\})|(?=[=;,\[]))))");
    static const std::regex parameter_name(R"(\s*\w+\s*((\[\w*\])?\s*(,|$)))");
    std::string outside;  // of braces, comments and directives
    int depth = 0;
    bool line_start = true;
    for (size_t at = 0; at < text.size(); ++at) {
        const size_t from = at;
        if (text.compare(at, 2, "//") == 0 || (line_start && text[at] == '#')) at = text.find('\n', at);
        if (text.compare(from, 2, "/*") == 0) at = std::min(text.find("*/", at), text.size()) + 1;
        if (at >= text.size()) break;
        const char c = at == from || text[at] == '\n' ? text[at] : ' ';
        line_start = c == '\n' || (line_start && std::isspace(static_cast<unsigned char>(c)));
        depth += (c == '{') - (c == '}');
        if (depth == 0) outside += c;
    }
    std::set<std::pair<std::string, std::string>> found;
    for (std::sregex_iterator one(outside.begin(), outside.end(), definition), end; one != end; ++one) {
        const std::smatch& match = *one;
        const std::string types = std::regex_replace(match[3].str(), parameter_name, "$1");
        found.emplace(match[1].matched ? match[1] : match[2], types + (match[3].matched ? "()" : ""));
    }
    return found;
}

// An exercise's names at file scope are its own: one that another file defines too gets a name that nobody else has. The
// lines of the exercise keep their numbers.
std::string apart(std::string text) {
    static const std::string begins = "#line ";
    if (text.find("/exercise/") == text.npos) return text;
    struct Piece {
        size_t begin, end;
        std::string file;
    };
    std::vector<Piece> pieces;
    std::map<std::string, std::string> whole;
    for (size_t at = text.starts_with(begins) ? 0 : text.find("\n" + begins) + 1; at < text.size();) {
        const size_t next = std::min(text.find("\n" + begins, at), text.size() - 1) + 1;
        const size_t quote = text.find('"', at), last = text.find('"', quote + 1);
        pieces.push_back({at, next, text.substr(quote + 1, last - quote - 1)});
        whole[pieces.back().file] += text.substr(last + 1, next - last - 1);
        at = next;
    }
    std::map<std::pair<std::string, std::string>, int> files;  // that define a name
    for (const auto& [file, words] : whole)
        for (const auto& one : definitions_of(words)) ++files[one];
    std::map<std::string, std::pair<std::string, std::string>> around;
    for (const auto& [file, words] : whole) {
        if (file.find("/exercise/") == file.npos) continue;
        for (const auto& one : definitions_of(words)) {
            auto& [before, after] = around[file];
            if (files[one] < 2 || before.find(" " + one.first + " ") != before.npos) continue;
            std::string own = "check_own_" + one.first + "_" + file;
            std::ranges::replace_if(
                own, [](char c) { return !is_word(c); }, '_');
            before += fmt::format("#define {} {}\n", one.first, own);
            after += fmt::format("#undef {}\n", one.first);
        }
    }
    for (auto piece = pieces.rbegin(); piece != pieces.rend(); ++piece)
        if (const auto found = around.find(piece->file); found != around.end()) {
            text.insert(piece->end, (text[piece->end - 1] == '\n' ? "" : "\n") + found->second.second);
            text.insert(piece->begin, found->second.first);
        }
    return text;
}

FlatShader included(const std::string& name, const Macros& macros, const std::string& stated) {
    Flattener flattener(macros);
    flattener.include(name, stated);
    flattener.result.text = apart(std::move(flattener.result.text));
    return std::move(flattener.result);
}

std::vector<std::string_view> words_of(std::string_view line) {
    std::vector<std::string_view> words;
    line = line.substr(0, std::min(line.find("//"), line.size()));
    for (size_t at = 0; at < line.size();) {
        size_t end = at;
        while (end < line.size() && is_word(line[end])) ++end;
        if (end > at && !std::isdigit(static_cast<unsigned char>(line[at]))) words.push_back(line.substr(at, end - at));
        at = std::max(end, at + 1);
    }
    return words;
}

// The defined macro that a name in #ifdef was meant to be, which would silently be false; empty: none.
std::string misspelt(std::string_view word, const Macros& macros) {
    for (const auto& [name, value] : macros) {
        if (name.size() >= 8 && name != word && edit_distance(name, word) <= 2) return name;
    }
    return "";
}

// Defined macros of which a name is the end, as METHOD is of TINT_METHOD; empty: none.
std::string longer_names(std::string_view word, const Macros& macros) {
    std::string names;
    for (const auto& [name, value] : macros)
        if (name.size() > word.size() && name.ends_with(word) && name[name.size() - word.size() - 1] == '_')
            names += (names.empty() ? "" : " or ") + name;
    return names;
}

// The choice that an option in #if is not compared with: an option alone is a constant. Empty: none.
std::string uncompared(std::string_view option, std::string_view line, const Macros& macros) {
    if (line.find_first_of("=<>") != line.npos) return "";
    if (!macros.values().contains(std::string(option))) return "";
    for (const auto& [name, value] : macros)
        if (option.size() > name.size() && option.starts_with(name) && option[name.size()] == '_') return name;
    return "";
}

// GLSL evaluates undefined macros in #if as 0, which would silently compile the wrong branch.
void refuse_unknown_macros(const std::string& text, const Macros& macros) {
    std::set<std::string, std::less<>> known;
    for (const auto& [name, value] : macros) known.insert(name);
    std::istringstream in(text);
    std::string line, file;
    int number = 1;
    const auto refuse = [&](const std::string& why) {
        throw ShaderError("{}:{}: {}\n    {}", file.size() > 2 ? file.substr(1, file.size() - 2) : file, number, why,
                          line);
    };
    const auto check_spelling = [&](std::string_view word) {
        if (known.count(word)) return;
        if (const std::string meant = misspelt(word, macros); !meant.empty())
            refuse(fmt::format("nobody defines {}; did you mean {}?", word, meant));
    };
    const auto check_compared = [&](std::string_view word) {
        if (const std::string choice = uncompared(word, line, macros); !choice.empty())
            refuse(fmt::format("{0} is an option's number; write {1} == {0}", word, choice));
    };
    for (; std::getline(in, line); ++number) {
        const size_t hash = line.find_first_not_of(" \t");
        if (hash == line.npos || line[hash] != '#') continue;
        const std::vector<std::string_view> words = words_of(line);
        if (words.empty()) continue;
        if (words[0] == "line") {
            std::istringstream numbers(line.substr(line.find("line") + 4));
            numbers >> number >> file;
            --number;
        } else if ((words[0] == "define" || words[0] == "ifndef" || words[0] == "ifdef") && words.size() > 1) {
            if (words[0] != "define") {
                check_spelling(words[1]);
                check_compared(words[1]);
            }
            known.emplace(words[1]);  // tested for definition first
        } else if (words[0] == "if" || words[0] == "elif") {
            for (size_t i = 1; i < words.size(); ++i) {
                if (words[i] == "defined") {
                    if (++i < words.size()) check_spelling(words[i]);
                } else if (!known.count(words[i]) && !words[i].starts_with("GL_")) {
                    check_spelling(words[i]);
                    if (const std::string longer = longer_names(words[i], macros); !longer.empty())
                        refuse(fmt::format("nobody defines {}; did you mean {}?", words[i], longer));
                    refuse(fmt::format("nobody defines {}; does the pass state `.with` the module it belongs to?",
                                       words[i]));
                } else {
                    check_compared(words[i]);
                }
            }
        }
    }
}

// Unnamed macros would create needless variants.
FlatShader with_header(FlatShader shader, const Macros& macros) {
    refuse_unknown_macros(shader.text, macros);
    std::string header =
        "#version 460\n"
        "#extension GL_EXT_scalar_block_layout : require\n"
        "#extension GL_GOOGLE_cpp_style_line_directive : require\n";
    for (const char* cpp : {"BEGIN_SHARED", "END_SHARED", "SHARED_FUNCTION"})  // macros of shaders/common/shared.h
        if (names_macro(shader.text, cpp)) header += fmt::format("#define {}\n", cpp);
    for (const auto& [name, value] : macros)
        if (names_macro(shader.text, name)) header += fmt::format("#define {} {}\n", name, value);
    shader.text.insert(0, header);
    return shader;
}

}  // namespace

bool is_macro_word(std::string_view name) {
    return !name.empty() && std::isalpha(static_cast<unsigned char>(name[0])) && std::ranges::all_of(name, is_word);
}

bool names_macro(std::string_view text, std::string_view name) {
    for (size_t at = text.find(name); at != text.npos; at = text.find(name, at + 1)) {
        const size_t end = at + name.size();
        if ((at == 0 || !is_word(text[at - 1])) && (end == text.size() || !is_word(text[end]))) return true;
    }
    return false;
}

FlatShader flatten_bare(const std::string& name, const Macros& files, const std::string& stated) {
    return included(name, files, stated);
}

FlatShader flatten(const std::string& name, const Macros& macros, const std::string& stated) {
    return with_header(included(name, macros, stated), macros);
}

FlatShader flatten_text(const std::string& text, const std::string& name, const std::string& chapter,
                        const Macros& macros) {
    Flattener flattener(macros);
    flattener.add(text, name, chapter);
    flattener.result.text = apart(std::move(flattener.result.text));
    return with_header(std::move(flattener.result), macros);
}

Stage stage_of(const std::string& file_name) {
    const std::string extension = fs::path(file_name).extension().string();
    if (extension == ".vert") return Stage::vertex;
    if (extension == ".geom") return Stage::geometry;
    if (extension == ".frag") return Stage::fragment;
    if (extension == ".comp") return Stage::compute;
    throw ShaderError("{}: a shader ends in .vert, .geom, .frag or .comp", file_name);
}

}  // namespace lightwalk
