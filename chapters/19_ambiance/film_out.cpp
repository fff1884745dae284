#include "19_ambiance/film_out.h"

#include <fcntl.h>
#include <spawn.h>
#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cctype>
#include <cerrno>
#include <cmath>
#include <csignal>
#include <cstdlib>
#include <cstring>

#include "19_ambiance/ways.h"
#include "common/app/headless.h"
#include "common/app/render.h"
#include "common/base/error.h"
#include "common/base/files.h"
#include "common/base/patience.h"

extern char** environ;

namespace lightwalk {

namespace {

// Raw frames come in on standard input; of the music the same part.
std::vector<std::string> ffmpeg(const FilmOut& out, const Reel& reel, glm::uvec2 size, int first, int end,
                                const std::filesystem::path& into) {
    const double fps = double(out.fps);
    std::vector<std::string> words{"ffmpeg",   "-v",
                                   "error",    "-y",
                                   "-f",       "rawvideo",
                                   "-pix_fmt", "rgba",
                                   "-s",       fmt::format("{}x{}", size.x, size.y),
                                   "-r",       fmt::format("{:g}", fps),
                                   "-i",       "-"};
    if (const SceneMusic& music = reel.film().music)
        words.insert(words.end(),
                     {"-ss", fmt::format("{:.9f}", reel.film().music.from_s + first / fps), "-t",
                      fmt::format("{:.9f}", (end - first) / fps), "-i", find_asset(music.file).string(), "-af",
                      fmt::format("volume={:g}dB", reel.film().music.gain_db), "-c:a", "aac", "-b:a", "160k"});
    if (out.codec.is("h264"))
        words.insert(words.end(), {"-c:v", "libx264", "-preset", "medium", "-crf", "17"});
    else
        words.insert(words.end(), {"-c:v", "libsvtav1", "-preset", "8", "-crf", "26"});
    // Both encode pairs of rows and columns. Players assume ITU-R BT.709 above standard definition; without these
    // filters colours are converted by BT.601, and no file says so. Pictures carry the tags: ffmpeg 7 ignores options.
    words.insert(
        words.end(),
        {"-vf",
         "pad=ceil(iw/2)*2:ceil(ih/2)*2,scale=out_color_matrix=bt709:out_range=tv:flags=accurate_rnd+full_chroma_int,"
         "format=yuv420p,setparams=range=tv:colorspace=bt709:color_primaries=bt709:color_trc=bt709"});
    words.insert(words.end(),
                 {"-movflags", "+faststart", "-f", into.extension() == ".mkv" ? "matroska" : "mp4", into.string()});
    return words;
}

// A file in a folder of its own beside `path`: nobody else can have put a link there. Both are removed, by SIGTERM too, unless
// the file was moved to where it belongs.
class Unfinished {
  public:
    explicit Unfinished(const std::filesystem::path& path) {
        folder_ = (path.parent_path() / ".film.XXXXXX").string();
        if (!mkdtemp(folder_.data())) throw InputError("--film {}: no folder can be made beside it", path.string());
        file = std::filesystem::path(folder_) / path.filename();
        path_ = file.string();
        folder_to_remove = folder_.c_str();
        file_to_remove = path_.c_str();
        for (const int number : {SIGTERM, SIGINT, SIGHUP}) std::signal(number, end);
    }
    ~Unfinished() {
        for (const int number : {SIGTERM, SIGINT, SIGHUP}) std::signal(number, SIG_DFL);
        remove();
    }
    Unfinished(const Unfinished&) = delete;

    std::filesystem::path file;

  private:
    static void remove() {
        unlink(file_to_remove);
        rmdir(folder_to_remove);
    }
    static void end(int number) {
        remove();
        _exit(128 + number);
    }
    inline static const char* folder_to_remove = "";
    inline static const char* file_to_remove = "";
    std::string folder_, path_;
};

}  // namespace

int FilmOut::write(Chapter& chapter, Reel& reel, const std::string& file, const Options& options,
                   std::unique_ptr<Gpu>& gpu) {
    const std::filesystem::path path(file);
    const std::string ending = path.extension().string();
    if (ending != ".mp4" && ending != ".mkv" && ending != ".raw")
        throw InputError("--film {}: expected a name that ends with .mp4, .mkv or .raw", file);
    check_writable(path);
    chapter.plays = true;
    gpu = make_gpu(options);
    load_scene(chapter, *gpu, options.scene.empty() ? chapter.default_scene() : options.scene);
    if (!reel.is_open()) throw InputError("--film: {} is no film", options.scene);
    if (options.automatic) choose_ways(chapter, reel, *gpu, options);
    const int last = static_cast<int>(std::lround(reel.film().duration_s * double(fps)));
    const int end = frames_to < 0 ? last : std::min(int(frames_to), last);
    if (frames_from >= end) throw InputError("--film: there is no frame from {} to {}", int(frames_from), end);

    const Unfinished unfinished(path);
    {
        FramePipe pipe = ending == ".raw"
                             ? FramePipe(unfinished.file)
                             : FramePipe(ffmpeg(*this, reel, options.size, frames_from, end, unfinished.file));
        ReadBack written;
        Frame frame(*gpu);
        frame.set_frames_in_flight(2);
        frame.on_ended = [&, before = uint64_t(0)](const std::vector<PassTime>&) mutable {
            if (std::exchange(before, written.number()) != before) pipe.write(written.bytes());
        };
        Patience patience("writing", "frames");
        for (int i = frames_from; i < end; ++i) {
            Picture picture{options.size, static_cast<float>(i / double(fps)), options.seed, {}};
            picture.written = &written;
            render(chapter, frame, picture);
            patience.show(i + 1 - frames_from, end - frames_from);
        }
        frame.finish();
        pipe.finish();
    }
    std::filesystem::rename(unfinished.file, path);
    return 0;
}

FramePipe::FramePipe(const std::filesystem::path& file) : name_(file.string()) {
    std::signal(SIGXFSZ, SIG_IGN);  // a file that grows beyond a limit is an error, and no death
    output_ = open(file.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0644);
    if (output_ < 0) throw Failure("{}: {}", name_, std::strerror(errno));
}

FramePipe::FramePipe(const std::vector<std::string>& command) : name_(command.front()) {
    std::signal(SIGPIPE, SIG_IGN);  // a write to a program that has ended is an error, and no death
    int ends[2];
    if (pipe2(ends, O_CLOEXEC) != 0) throw Failure("{}: {}", name_, std::strerror(errno));
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_adddup2(&actions, ends[0], 0);
    messages_ = memfd_create("messages", MFD_CLOEXEC);
    if (messages_ >= 0) posix_spawn_file_actions_adddup2(&actions, messages_, 2);
    std::vector<char*> words;
    for (const std::string& word : command) words.push_back(const_cast<char*>(word.c_str()));
    words.push_back(nullptr);
    const int wrong = posix_spawnp(&program_, words[0], &actions, nullptr, words.data(), environ);
    posix_spawn_file_actions_destroy(&actions);
    close(ends[0]);
    output_ = ends[1];
    if (wrong) {
        program_ = -1;
        throw Failure("{} cannot be started: {}{}", name_, std::strerror(wrong),
                      wrong == ENOENT
                          ? "; it writes films (Debian's package ffmpeg); a name that ends with .raw needs none"
                          : "");
    }
}

FramePipe::~FramePipe() {
    if (output_ >= 0) close(output_);
    end_program();
    if (messages_ >= 0) close(messages_);
}

std::string FramePipe::last_words() const {
    char text[2000];
    const ssize_t size = messages_ < 0 ? 0 : lseek(messages_, 0, SEEK_END);
    const ssize_t got =
        size <= 0 ? 0 : pread(messages_, text, sizeof text, std::max<ssize_t>(0, size - ssize_t(sizeof text)));
    std::string said(text, size_t(std::max<ssize_t>(got, 0)));
    while (!said.empty() && std::isspace(static_cast<unsigned char>(said.back()))) said.pop_back();
    said.erase(0, said.rfind('\n') + 1);
    return said.empty() ? "" : ": " + said;
}

void FramePipe::end_program() {
    if (program_ < 0) return;
    int status = 0;
    while (waitpid(program_, &status, 0) < 0 && errno == EINTR) {}
    ended_with_ = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
    program_ = -1;
}

void FramePipe::write(std::span<const std::byte> bytes) {
    while (!bytes.empty()) {
        const ssize_t taken = ::write(output_, bytes.data(), bytes.size());
        if (taken < 0 && errno == EINTR) continue;
        if (taken <= 0) {
            const int why = errno;
            const bool is_program = program_ >= 0;
            close(output_);
            output_ = -1;
            end_program();
            if (is_program)
                throw Failure("{} ended before the last frame, with code {}{}", name_, ended_with_, last_words());
            throw Failure("{}: {}", name_, std::strerror(why));
        }
        bytes = bytes.subspan(static_cast<size_t>(taken));
    }
}

void FramePipe::finish() {
    const bool is_program = program_ >= 0;
    const int wrong = close(output_);
    output_ = -1;
    end_program();
    if (is_program && ended_with_ != 0) throw Failure("{} failed, with code {}{}", name_, ended_with_, last_words());
    if (wrong != 0) throw Failure("{}: {}", name_, std::strerror(errno));
}

}  // namespace lightwalk
