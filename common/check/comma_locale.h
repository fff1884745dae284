// Locale with a decimal comma, for C and C++, independent of installed locales.
#pragma once
#include <clocale>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <locale>
#include <string>

namespace lightwalk {

struct CommaPoint : std::numpunct<char> {
    char do_decimal_point() const override { return ','; }
    char do_thousands_sep() const override { return '.'; }
    std::string do_grouping() const override { return "\3"; }
};

/// Active during its lifetime. C's locale is loaded from a temporary file in glibc's binary format.
class CommaLocale {
  public:
    CommaLocale() {
        char folder[] = "/tmp/lightwalk.XXXXXX";
        if (!mkdtemp(folder)) return;
        folder_ = folder;
        std::filesystem::create_directory(folder_ / "comma");
        // Magic number, entry count, offsets; decimal point, separator, grouping, wide versions, encoding.
        const uint32_t head[] = {0x20031115u ^ LC_NUMERIC, 6, 32, 34, 36, 40, 44, 48};
        const char data[] = ",\0.\0\3\3\0\0,\0\0\0.\0\0\0UTF-8";
        std::ofstream out(folder_ / "comma" / "LC_NUMERIC", std::ios::binary);
        out.write(reinterpret_cast<const char*>(head), sizeof head).write(data, sizeof data);
        out.close();
        setenv("LOCPATH", folder, 1);
        setlocale(LC_NUMERIC, "comma");
    }
    ~CommaLocale() {
        setlocale(LC_NUMERIC, "C");
        unsetenv("LOCPATH");
        std::error_code ignored;
        if (!folder_.empty()) std::filesystem::remove_all(folder_, ignored);
        std::locale::global(before_);
    }
    CommaLocale(const CommaLocale&) = delete;

  private:
    std::locale before_ = std::locale::global(std::locale(std::locale::classic(), new CommaPoint));
    std::filesystem::path folder_;
};

}  // namespace lightwalk
