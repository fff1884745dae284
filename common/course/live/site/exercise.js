"use strict";

// An exercise in the page: its file in an editor, what the check says, and its picture.
class Exercise {
  static all = new Map();

  // A button below what the lesson says of the exercise.
  static offer(anchor) {
    const id = anchor.id, heading = Exercise.section(anchor)[0];
    if (!heading) return;
    const button = make("button", {type: "button", className: "live-open md-button", textContent: "Solve it here"});
    button.dataset.exercise = id;
    button.onclick = () => {
      new Exercise(id, Exercise.section(anchor), button);
    };
    Exercise.section(anchor).pop().after(button);
  }

  // The heading behind an exercise's anchor, and what follows until the next heading.
  static section(anchor) {
    const found = [];
    for (let at = (anchor.parentElement.tagName === "P" ? anchor.parentElement : anchor).nextElementSibling; at; at = at.nextElementSibling) {
      if (found.length && (/^H[123]$/.test(at.tagName) || at.matches("a.exercise") || at.querySelector("a.exercise"))) break;
      found.push(at);
    }
    return found;
  }

  constructor(id, section, place) {
    Object.assign(this, {id, section});
    Exercise.all.set(id, this);
    this.status = make("span", {className: "live-said", textContent: "reading"});
    this.verdict = make("div", {className: "live-verdict"});
    this.place = make("div", {className: "live-editor"});
    const check = make("button", {type: "button", className: "live-check", textContent: "Check", title: "Ctrl+Enter"});
    check.onclick = () => this.check();
    const save = make("button", {type: "button", className: "live-save", textContent: "Save", title: "Ctrl+S; it is saved as you type, too"});
    save.onclick = () => this.save();
    this.element = make("div", {className: "live-exercise"}, make("div", {className: "live-head"}, save, check, this.version_choice(), this.status),
                        this.place, this.verdict);
    this.element.exercise = this;
    place.replaceWith(this.element);
    this.open().catch(error => { this.status.textContent = error.message; });
  }

  async open() {
    const {text, version, file, chapter} = await Live.get(`exercise/${this.id}`);
    Object.assign(this, {version, file, chapter, saved: text, is_cpp: file.endsWith(".cpp")});
    this.editor = CodeMirror(this.place, {value: text, mode: this.is_cpp ? "text/x-c++src" : "x-shader/x-fragment",
      lineNumbers: true, indentUnit: 4, lineWrapping: true, matchBrackets: true, autoCloseBrackets: true, viewportMargin: Infinity,
      gutters: ["CodeMirror-linenumbers", "live-gutter"],
      extraKeys: {"Ctrl-S": () => this.save(), "Cmd-S": () => this.save(), "Ctrl-Enter": () => this.check(),
        "Ctrl-/": "toggleComment", Tab: editor => editor.somethingSelected() ? editor.indentSelection("add") : editor.replaceSelection("    "),
        Esc: () => this.element.querySelector(".live-save").focus()}}); // the way out for the keyboard
    this.status.textContent = file;
    this.editor.on("change", () => {
      clearTimeout(this.typing);
      if (!this.conflict) this.typing = setTimeout(() => this.save(), 900);
      if (this.editor.getValue() !== this.saved) this.status.textContent = "edited";
    });
    addEventListener("beforeunload", event => { if (this.editor.getValue() !== this.saved) event.preventDefault(); });
    Live.send({do: "watch", exercise: this.id});
    Live.on("connected", () => Live.send({do: "watch", exercise: this.id}));
    for (const [event, act] of [["disk", one => this.changed_on_disk(one)], ["working", one => { this.status.textContent = one.words; }],
                                ["checked", one => this.show_verdict(one.result)], ["built", one => this.built(one)]])
      Live.on(event, one => { if ((one.exercise ?? one.result?.exercise) === this.id) act(one); });
    this.show_picture();
  }

  // Mine, the reference, or both under a slider.
  version_choice() {
    const choice = make("span", {className: "live-versions"});
    for (const version of Live.course.solutions ? ["mine", "reference", "split"] : ["mine"]) {
      const button = make("button", {type: "button", textContent: version});
      button.dataset.version = version;
      button.onclick = () => this.show_version(version);
      choice.append(button);
    }
    return choice;
  }

  get mine() {
    return Live.course.solutions ? `solution,${this.id}=exercise` : "exercise";
  }

  show_version(version) {
    for (const button of this.element.querySelectorAll("[data-version]"))
      button.classList.toggle("on", button.dataset.version === version);
    if (!this.picture) return;
    this.picture.state.use = version === "reference" ? "solution" : this.mine;
    this.picture.split(version === "split" ? {use: "solution"} : null, ["mine", "reference"]);
  }

  // The shot that the lesson names for it, else one that shots.json does.
  shot() {
    const {shots} = Live.course.chapters[this.chapter];
    for (const part of this.section)
      for (const [, name] of part.textContent.matchAll(/--shot (\w+)/g)) if (shots[name]) return name;
    return Object.keys(shots).find(name => shots[name].exercises?.includes(this.id));
  }

  show_picture() {
    const shot = this.shot();
    if (!shot) return this.element.querySelector(".live-versions").remove();
    const image = make("img", {alt: `${shot}, with your ${this.id}`}), frame = make("span", {}, image);
    image.src = new URL(`golden/${this.chapter}/${shot}`, Live.base);
    this.verdict.after(frame);
    const size = Live.course.chapters[this.chapter].shots[shot].size ?? [960, 540];
    this.picture = new Picture(frame, this.chapter, [{image, shot}]);
    this.picture.aspect = size[1] / size[0];
    this.picture.fixed = true;
    this.picture.listeners.push(({answer, i}) => { if (answer && !i) this.mark_errors(answer.errors ?? []); });
    image.onerror = () => { image.onerror = null; image.removeAttribute("src"); };
    this.show_version("mine");
  }

  async save() {
    clearTimeout(this.typing);
    if (!this.editor || this.conflict) return;
    const text = this.editor.getValue();
    if (text === this.saved) return;
    if (this.saving) return this.saving.then(() => this.save());
    this.saving = Live.put(`exercise/${this.id}`, {text, base: this.version}).catch(error => ({status: 0, error: error.message}));
    const said = await this.saving;
    this.saving = null;
    if (said.status === 409) return this.changed_on_disk(said);
    if (said.status !== 200) {
      this.status.textContent = `not saved: ${said.error}`;
      return;
    }
    [this.saved, this.version] = [text, said.version];
    this.status.textContent = `saved ${this.file}`;
    Live.send({do: "watch", exercise: this.id});
    if (!this.is_cpp) this.picture?.draw(true);
  }

  async check() {
    await this.save();
    if (this.conflict || this.editor.getValue() !== this.saved) return;
    Live.send({do: "check", exercise: this.id});
  }

  built() {
    this.status.textContent = "built";
    this.picture?.draw(true);
  }

  // Someone else wrote the file. Nothing that was typed here is lost, and nothing there is overwritten unasked.
  changed_on_disk({version, text}) {
    if (version === this.version || this.saving) return;
    if (this.editor.getValue() === this.saved) {
      [this.saved, this.version] = [text, version];
      this.editor.setValue(text);
      this.status.textContent = "changed on disk, and read again";
      this.picture?.draw(true);
      return;
    }
    clearTimeout(this.typing);
    this.conflict = {version, text};
    const theirs = make("button", {type: "button", textContent: "take the file's"}), mine = make("button", {type: "button", textContent: "write mine"});
    const settle = own => {
      this.conflict = null;
      this.bar.remove();
      this.version = version;
      this.saved = text;
      if (own) this.save();
      else this.editor.setValue(text);
      this.picture?.draw(true);
    };
    theirs.onclick = () => settle(false);
    mine.onclick = () => settle(true);
    this.bar?.remove();
    this.bar = make("div", {className: "live-conflict"}, `${this.file} was changed on disk while you typed; nothing was overwritten. `, theirs, " ", mine);
    this.place.before(this.bar);
  }

  // "shaders/…/pcf.glsl:12: message" at its line.
  mark_errors(errors) {
    this.editor.clearGutter("live-gutter");
    for (const mark of this.marks ?? []) mark.clear();
    this.marks = [];
    const said = new Set();
    for (const error of errors)
      for (const [whole, file, line, words] of error.matchAll(/([\w/.]+):(\d+):(?:\d+:)?\s*(.*)/g)) {
        if (!file.endsWith(this.file.split("/").pop()) || said.has(whole)) continue; // each pass that includes the file says it
        said.add(whole);
        const at = Math.min(Math.max(line - 1, 0), this.editor.lastLine());
        this.editor.setGutterMarker(at, "live-gutter", make("span", {className: "live-mark", textContent: "●", title: words}));
        this.marks.push(this.editor.addLineWidget(at, make("div", {className: "live-message", textContent: words})));
      }
    if (this.marks.length && this.picture) this.picture.note.textContent = ""; // the line says it
  }

  // Leads to the lesson's next exercise, and opens it; null behind the last one.
  next_button() {
    const anchors = [...document.querySelectorAll("a.exercise")], next = anchors[anchors.findIndex(one => one.id === this.id) + 1];
    if (!next) return null;
    const button = make("button", {type: "button", className: "live-next", textContent: `next exercise: ${next.id}`});
    button.onclick = () => {
      document.querySelector(`.live-open[data-exercise="${next.id}"]`)?.click();
      next.scrollIntoView({behavior: "smooth"});
    };
    return button;
  }

  show_verdict(result) {
    this.status.textContent = this.file;
    const counted = `${result.passed} of ${result.passed + result.failed} checks`;
    const words = [make("b", {textContent: result.ok ? `solved: ${counted}` : `open: ${counted}`})];
    if (!result.ok && result.first_failure) words.push(make("p", {textContent: result.first_failure}));
    if (result.note) words.push(make("p", {textContent: result.note}));
    if (!result.ok && result.hint) words.push(make("details", {className: "live-fold"}, make("summary", {textContent: "hint"}), make("p", {textContent: result.hint})));
    if (result.ok) words.push(this.next_button());
    this.verdict.replaceChildren(...words.filter(Boolean));
    this.verdict.className = `live-verdict ${result.ok ? "ok" : "open"}`;
    this.verdict.scrollIntoView({block: "nearest"});
    if (this.is_cpp || !this.picture) this.mark_errors([result.first_failure ?? ""]);
  }
}
