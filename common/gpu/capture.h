// Captures of a frame for RenderDoc, through its in-application interface.
#pragma once
#include <string>

namespace lightwalk {

/// Loads RenderDoc's library, which has to be there before a device is made. Throws InputError if there is none, or
/// where the course was built without its header.
void load_renderdoc();

/// Whether its library is in this process: load_renderdoc loaded it, or RenderDoc started the program.
bool has_renderdoc();

/// All that is submitted while it lives, in one capture.
class Capture {
  public:
    Capture();
    ~Capture();
    Capture(const Capture&) = delete;

    /// Ends the capture and writes it to `file` (.rdc). Throws InputError if that cannot be, Failure if RenderDoc
    /// made none.
    void write(const std::string& file);

  private:
    bool ended_ = false;
};

}  // namespace lightwalk
