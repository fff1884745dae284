// Frame captures through RenderDoc's in-application API.
#pragma once
#include <string>

namespace lightwalk {

/// Loads RenderDoc's library, before the device is created. Throws InputError if it is not installed or built in.
void load_renderdoc();

/// True if RenderDoc's library is loaded, by load_renderdoc() or because RenderDoc launched the program.
bool has_renderdoc();

/// Captures everything submitted during its lifetime.
class Capture {
  public:
    Capture();
    ~Capture();
    Capture(const Capture&) = delete;

    /// Ends the capture and writes it to `file` (.rdc). Throws InputError (not writable) or Failure (no capture).
    void write(const std::string& file);

  private:
    bool ended_ = false;
};

}  // namespace lightwalk
