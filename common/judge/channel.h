// Protocol between the grader's check program and the process with the student's code: a length, then a record.
#pragma once
#include "common/judge/wire.h"

namespace lightwalk::channel {

enum class Kind : uint32_t { result, input_error, exception, lost };

/// `id` is an exercise's, or "02.record_mist try_record_mist" for a trial of it. An answer that does not have the
/// request's nonce answers nothing: none can be written before the question.
struct Request {
    uint64_t nonce;
    std::string id;
    bool commas;  ///< numbers are written 1,5 in the locale in force
    std::string arguments;
};

struct Reply {
    uint64_t nonce = 0;
    Kind kind = Kind::lost;
    uint32_t exceptions = 0;  ///< floating-point ones, as <cfenv> has them
    std::string bytes;        ///< the result, or the text of an exception
};

template <class Record>
std::string packed(const Record& record) {
    std::string body, message;
    wire::put(body, record);
    wire::put(message, uint64_t(body.size()));
    return message + body;
}

}  // namespace lightwalk::channel
