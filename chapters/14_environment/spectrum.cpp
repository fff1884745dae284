#include "14_environment/spectrum.h"

#include <kissfft/kiss_fftr.h>

#include <memory>

#include "common/base/error.h"

namespace lightwalk {
namespace {

struct Free {
    void operator()(kiss_fftr_cfg plan) const { kiss_fftr_free(plan); }
};

}  // namespace

std::vector<std::complex<float>> spectrum_of(std::span<const float> samples) {
    if (samples.empty() || samples.size() % 2) throw Failure("a spectrum of {} samples", samples.size());
    // kissfft's plan for a length is kept for the next call. One plan must not run twice at once.
    thread_local std::unique_ptr<kiss_fftr_state, Free> plan;
    thread_local size_t planned = 0;
    if (planned != samples.size()) {
        plan.reset(kiss_fftr_alloc(static_cast<int>(samples.size()), 0, nullptr, nullptr));
        planned = samples.size();
    }
    std::vector<std::complex<float>> bins(samples.size() / 2 + 1);
    kiss_fftr(plan.get(), samples.data(), reinterpret_cast<kiss_fft_cpx*>(bins.data()));
    return bins;
}

}  // namespace lightwalk
