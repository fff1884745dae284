"use strict";

// An exercise whose file the server keeps and checks, and its picture.
class FileExercise extends Exercise {
  buttons() {
    return [this.button("Save", () => this.save(), "Ctrl+S; it is saved as you type, too"), this.version_choice()];
  }

  async open() {
    const {text, version, file, chapter} = await Live.get(`exercise/${this.id}`);
    Object.assign(this, {version, file, chapter, saved: text, is_cpp: file.endsWith(".cpp")});
    await this.edit(text, {"Ctrl-S": () => this.save(), "Cmd-S": () => this.save()});
    addEventListener("beforeunload", event => { if (this.editor.getValue() !== this.saved) event.preventDefault(); });
    Live.send({do: "watch", exercise: this.id});
    Live.on("connected", () => Live.send({do: "watch", exercise: this.id}));
    for (const [event, act] of [["disk", one => this.changed_on_disk(one)], ["working", one => { this.status.textContent = one.words; }],
                                ["checked", one => this.show_verdict(one.result)], ["built", one => this.built(one)]])
      Live.on(event, one => { if ((one.exercise ?? one.result?.exercise) === this.id) act(one); });
    this.show_picture();
  }

  changed(text) {
    clearTimeout(this.typing);
    if (!this.conflict) this.typing = setTimeout(() => this.save(), 900);
    if (text !== this.saved) this.status.textContent = "edited";
  }

  // Mine, the reference, or both under a slider.
  version_choice() {
    const choice = make("span", {className: "run-versions"});
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
    if (!shot) return this.head.querySelector(".run-versions").remove();
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
    this.bar = make("div", {className: "run-conflict"}, `${this.file} was changed on disk while you typed; nothing was overwritten. `, theirs, " ", mine);
    this.place.before(this.bar);
  }

  // "shaders/…/pcf.glsl:12: message" at its line. Each pass that includes the file says it.
  mark_errors(errors) {
    const found = errors.flatMap(error => [...error.matchAll(/([\w/.]+):(\d+):(?:\d+:)?\s*(.*)/g)]).filter(one => one[1].endsWith(this.file.split("/").pop()));
    const once = new Map(found.map(([whole, , line, words]) => [whole, {line, words}]));
    Editor.mark(this.editor, [...once.values()]);
    if (once.size && this.picture) this.picture.note.textContent = ""; // the line says it
  }

  // Leads to the lesson's next exercise, and opens it.
  next_step() {
    const anchors = [...document.querySelectorAll("a.exercise")], next = anchors[anchors.findIndex(one => one.id === this.id) + 1];
    return next && Object.assign(this.button(`next exercise: ${next.id}`, () => {
      document.querySelector(`.run-open[data-exercise="${next.id}"]`)?.click();
      next.scrollIntoView({behavior: "smooth"});
    }), {className: "run-next"});
  }

  show_verdict(result) {
    super.show_verdict(result);
    if (this.is_cpp || !this.picture) this.mark_errors([result.first_failure ?? ""]);
  }
}
