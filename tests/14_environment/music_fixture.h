// Shared by the tests of music: sounds from formulas, and files made of them.
#pragma once
#include <vorbis/vorbisenc.h>

#include <cmath>
#include <filesystem>
#include <functional>
#include <string>

#include "14_environment/music.h"
#include "14_environment/music_truth.h"

namespace lightwalk {

/// `f` of the time in seconds.
inline Sound made(int rate_hz, double seconds, const std::function<double(double)>& f) {
    Sound sound{.rate_hz = rate_hz};
    for (int i = 0; i < static_cast<int>(seconds * rate_hz); ++i)
        sound.samples.push_back(static_cast<float>(f(double(i) / rate_hz)));
    return sound;
}

inline double tone(double frequency_hz, double t) { return std::sin(2 * M_PI * frequency_hz * t); }

/// An Ogg Vorbis file in memory, channel by channel. Streams in one file need different `serial` numbers.
inline std::string encoded(int rate_hz, const std::vector<std::vector<float>>& channels, int serial = 1) {
    std::string bytes;
    vorbis_info info;
    vorbis_info_init(&info);
    REQUIRE(vorbis_encode_init_vbr(&info, static_cast<long>(channels.size()), rate_hz, 0.6f) == 0);
    vorbis_comment comment;
    vorbis_comment_init(&comment);
    vorbis_dsp_state state;
    vorbis_analysis_init(&state, &info);
    vorbis_block block;
    vorbis_block_init(&state, &block);
    ogg_stream_state stream;
    ogg_stream_init(&stream, serial);
    ogg_page page;
    const auto append = [&] {
        bytes.append(reinterpret_cast<char*>(page.header), size_t(page.header_len));
        bytes.append(reinterpret_cast<char*>(page.body), size_t(page.body_len));
    };
    ogg_packet headers[3];
    vorbis_analysis_headerout(&state, &comment, &headers[0], &headers[1], &headers[2]);
    for (ogg_packet& header : headers) ogg_stream_packetin(&stream, &header);
    while (ogg_stream_flush(&stream, &page)) append();
    const size_t count = channels[0].size();
    for (size_t at = 0;;) {
        const size_t n = std::min<size_t>(1024, count - at);
        if (n > 0) {
            float** into = vorbis_analysis_buffer(&state, static_cast<int>(n));
            for (size_t c = 0; c < channels.size(); ++c)
                for (size_t i = 0; i < n; ++i) into[c][i] = channels[c][at + i];
        }
        vorbis_analysis_wrote(&state, static_cast<int>(n));  // none: the end
        at += n;
        while (vorbis_analysis_blockout(&state, &block) == 1) {
            vorbis_analysis(&block, nullptr);
            vorbis_bitrate_addblock(&block);
            for (ogg_packet packet; vorbis_bitrate_flushpacket(&state, &packet);) {
                ogg_stream_packetin(&stream, &packet);
                while (ogg_stream_pageout(&stream, &page)) append();
            }
        }
        if (n == 0) break;
    }
    while (ogg_stream_flush(&stream, &page)) append();
    ogg_stream_clear(&stream);
    vorbis_block_clear(&block);
    vorbis_dsp_clear(&state);
    vorbis_comment_clear(&comment);
    vorbis_info_clear(&info);
    return bytes;
}

/// The 2,048 samples around a time.
inline std::vector<float> around(const Sound& sound, double time_s) {
    std::vector<float> samples(2048);
    const int64_t first = std::llround(time_s * sound.rate_hz) - 1024;
    for (int64_t n = 0; n < 2048; ++n)
        if (const int64_t at = first + n; at >= 0 && at < int64_t(sound.samples.size()))
            samples[size_t(n)] = sound.samples[size_t(at)];
    return samples;
}

}  // namespace lightwalk
