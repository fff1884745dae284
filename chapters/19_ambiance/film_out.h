// The film as a file: frames into a pipe to the ffmpeg program, or raw.
#pragma once
#include <sys/types.h>

#include <cstddef>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "19_ambiance/reel.h"
#include "common/app/options.h"

namespace lightwalk {

class FramePipe {
  public:
    /// To a file. Throws Failure.
    explicit FramePipe(const std::filesystem::path& file);
    /// To a program, looked for in $PATH. Throws Failure where it cannot be started.
    explicit FramePipe(const std::vector<std::string>& command);
    ~FramePipe();
    FramePipe(const FramePipe&) = delete;

    /// Throws Failure where not all was taken: the disk is full, or the program has ended.
    void write(std::span<const std::byte> bytes);

    /// After the last frame. Throws Failure where the file is not whole, or the program failed.
    void finish();

  private:
    void end_program();
    std::string last_words() const;  ///< of the program's messages
    std::string name_;
    int output_ = -1, messages_ = -1;
    pid_t program_ = -1;
    int ended_with_ = 0;
};

/// Each frame is a picture of its own: any part of the film can be written by itself, and parts join without a seam.
struct FilmOut : Module {
    FilmOut(Module& owner, std::string name) : Module(owner, std::move(name), "film_out") {}

    Knob<float> fps{*this, "fps", 30.0f, {1.0f, 240.0f}, "Frames of the film in a second", "1/s"};
    Knob<float> shutter{
        *this,
        "shutter",
        0.0f,
        {0.0f, 1.0f},
        "Part of a frame's time over which the pictures of --samples are spread; 0.5 is a shutter of 180 "
        "degrees"};
    Choice codec{*this, "codec", {"h264", "av1"}, "h264", "Encoding of the film: H.264 (x264) or AV1 (SVT-AV1)"};
    Knob<int> frames_from{*this, "frames_from", 0, {0, 1000000}, "First frame that is written"};
    Knob<int> frames_to{*this, "frames_to", -1, {-1, 1000000}, "Frame before which writing ends; -1: the film's end"};

    /// How much later than its frame's time a sample is drawn, in seconds; all the same frame where only one is drawn.
    double later_s(int sample, int samples) const {
        return samples > 1 ? double(shutter) / double(fps) * (sample + 0.5) / samples : 0.0;
    }
    double latest_s(int samples) const { return later_s(samples - 1, samples); }

    /// Writes frames_from to frames_to of the chapter's film, with its sound. A file that ends with .raw gets the
    /// input of ffmpeg: RGBA, 8 bits each, frame after frame, no sound. The file is there whole, or as it was before.
    /// Returns the exit code: 1 if ffmpeg is missing or ends early, or the disk is full, after a line that says so.
    int write(Chapter& chapter, Reel& reel, const std::string& file, const Options& options, std::unique_ptr<Gpu>& gpu);
};

}  // namespace lightwalk
