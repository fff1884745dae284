// Scene files of the editor: opened, saved whole or not at all, and saved by themselves beside the file.
#pragma once
#include "18_playground/commands.h"

namespace lightwalk {

/// A document as a scene file, and which entries its objects and lights are.
struct Exported {
    SceneFile scene;
    std::vector<EntryId> objects;  ///< of scene.objects: each parent before its children
    std::vector<EntryId> lights;   ///< of scene.lights
};
Exported exported(const Document& document);
Light light_of(const Entry& entry);  ///< an entry that is one, as in a scene file

/// Why `file` could not be read back with this entry in it; empty where it could.
Said cannot_be_saved(const Entry& entry, const std::filesystem::path& file);

/// A document's file. The text is the same for equal documents, to the byte.
class SceneStore {
  public:
    std::filesystem::path path;    ///< empty: never saved
    std::optional<Camera> camera;  ///< to be saved instead of the document's

    /// Reads a scene file, or a model file, which makes a scene. Throws InputError, and nothing has changed.
    Document open(const std::filesystem::path& file);
    Document open_empty();

    /// Whether the file is another one than was read or saved last: somebody else has written it.
    bool changed_on_disk() const;
    /// Whether one of the files that it includes holds something else than when the scene was read.
    bool includes_changed_on_disk() const;

    /// Writes the document to `path`: beside it first, then on the disk, then renamed. Throws InputError where that is
    /// not possible; the file is then as it was. Says where included files could not be kept.
    Said save(const Document& document);
    Said save_as(const Document& document, const std::filesystem::path& file);

    bool has_unsaved(const Document& document) const { return document.state() != saved_state_; }

    // Autosave beside the file: unsaved changes. Locked while its editor lives, so that no other one offers, writes
    // or removes it; each has its own. Removed when the document is saved.
    std::filesystem::path autosave_file() const;
    /// Writes it if something changed since the last time; false if there was nothing to write. Throws. An existing
    /// file keeps another name. `said`: that, or that another editor has the scene open.
    bool autosave(const Document& document, Said* said = nullptr);
    void forget_autosave();
    /// A file that a crash has left: no editor holds it, and it is newer than the scene file. It is this editor's then.
    /// `said`: another editor has the scene open.
    bool has_recovery(Said* said = nullptr);
    /// Throws InputError where it cannot be read. `said`: which files that it names are gone; the rest is there.
    Document recover(Said* said = nullptr);
    /// Renames a crash's autosave so that nothing overwrites it; returns its path, empty if there is none.
    std::filesystem::path set_aside();
    void forget_recovery();

    std::string text(const Document& document, Said* said = nullptr) const;

  private:
    struct HeldFile;
    /// The document is now that of the file, whose bytes have this hash.
    void take(const Document& document, const std::filesystem::path& file, std::vector<std::string> includes,
              uint64_t hash);
    std::filesystem::path autosave_name(int number) const;
    std::filesystem::path free_autosave_file(Said* said) const;
    std::shared_ptr<HeldFile> own_, left_;  ///< this editor's autosave; a crash's, until decided
    std::vector<std::string> includes_;
    std::string included_;  ///< text of the included files
    uint64_t hash_ = 0, saved_state_ = 0, autosaved_state_ = 0;
};

}  // namespace lightwalk
