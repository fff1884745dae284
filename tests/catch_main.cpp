// The tests' main (Catch2 2 wants one from us; Catch2 3 links its own), and a reporter of one JSON object a case.
#include <chrono>
#include <cstdio>
#include <nlohmann/json.hpp>
#if __has_include(<catch2/catch_all.hpp>)
#include <catch2/catch_all.hpp>
using Reporter = Catch::StreamingReporterBase;
using Ended = void;
#else
#define CATCH_CONFIG_MAIN
#include <catch2/catch.hpp>
struct Rows;
using Reporter = Catch::StreamingReporterBase<Rows>;
using Ended = bool;
#endif

namespace {

[[maybe_unused]] const Catch::TestCaseInfo& info(const Catch::TestCaseInfo& one) { return one; }
[[maybe_unused]] const Catch::TestCaseInfo& info(const Catch::TestCaseInfo* one) { return *one; }

}  // namespace

// Catch2's XML counts checks only of cases with sections, or with every check spelt out: 40 of chapter 05's 50 seconds.
struct Rows : Reporter {
    using Reporter::Reporter;
    static std::string getDescription() {
        return "a JSON object a line: case, ok, checks, seconds, and the first failure";
    }

    void testCaseStarting(const Catch::TestCaseInfo& one) override {
        Reporter::testCaseStarting(one);
        start_ = std::chrono::steady_clock::now();
        failure_.clear();
    }
    void assertionStarting(const Catch::AssertionInfo&) override {}
    Ended assertionEnded(const Catch::AssertionStats& stats) override {
        const Catch::AssertionResult& result = stats.assertionResult;
        if (!result.isOk() && failure_.empty())
            failure_ =
                result.hasExpandedExpression() ? result.getExpandedExpression() : std::string(result.getMessage());
        return Ended(true);
    }
    void testCaseEnded(const Catch::TestCaseStats& stats) override {
        const auto took = std::chrono::steady_clock::now() - start_;
        const nlohmann::json row = {{"case", info(stats.testInfo).name},
                                    {"ok", stats.totals.assertions.allOk()},
                                    {"checks", stats.totals.assertions.total()},
                                    {"seconds", std::chrono::duration<double>(took).count()},
                                    {"failure", failure_}};
        std::printf("%s\n", row.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace).c_str());
        Reporter::testCaseEnded(stats);
    }

  private:
    std::chrono::steady_clock::time_point start_;
    std::string failure_;
};

CATCH_REGISTER_REPORTER("rows", Rows)
