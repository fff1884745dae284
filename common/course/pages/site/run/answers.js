"use strict";

// The reader's answers: kept by the browser, edited and checked in the page, taken along as files.
const Answers = {
  list: [], // of list.js: the exercises that the page can check
  base: new URL(".", document.currentScript.src),

  async load(id) {
    await Promise.all([id, "undefined"].map(name => Editor.script(new URL(`../tables/${name}.js`, Answers.base))));
    return Tables.known.get(id);
  },

  kept(key, value) {
    try {
      if (value === undefined) return localStorage.getItem(`lightwalk.${key}`);
      if (value === null) localStorage.removeItem(`lightwalk.${key}`);
      else localStorage.setItem(`lightwalk.${key}`, value);
    } catch { /* a browser that keeps nothing */ }
    return null;
  },

  text(id) {
    return Answers.kept(id) ?? Tables.known.get(id)?.starter ?? "";
  },

  solved() {
    return Answers.list.filter(id => Answers.kept(`${id}.solved`));
  },

  // The next exercise that is not solved: on this page, in a later chapter, then any; undefined where all are.
  after(id) {
    const here = [...document.querySelectorAll("a.exercise")].map(one => one.id).filter(one => Answers.list.includes(one));
    return [...here.slice(here.indexOf(id) + 1), ...here, ...Answers.list.filter(one => one > id), ...Answers.list]
      .find(one => one !== id && !Answers.kept(`${one}.solved`));
  },

  // A button at each exercise of the page.
  offer() {
    for (const anchor of document.querySelectorAll("a.exercise"))
      Exercise.offer(anchor, KeptExercise, Answers.list.includes(anchor.id) ? null :
        make("p", {className: "run-elsewhere"}, "This exercise needs the course on your machine: ", make("code", {textContent: `./course check ${anchor.id}`})));
    Answers.show_progress();
  },

  show_progress() {
    if (!Answers.list.length) return;
    const solved = Answers.solved();
    let place = document.querySelector(".run-progress");
    if (!place) {
      place = make("button", {type: "button", className: "run-progress", title: "your answers as files"});
      place.onclick = () => Answers.show_files();
      document.querySelector(".md-header__inner")?.append(place);
    }
    place.textContent = `${solved.length} of ${Answers.list.length} solved`;
    for (const anchor of document.querySelectorAll("a.exercise")) Exercise.section(anchor)[0]?.classList.toggle("run-solved", solved.includes(anchor.id));
  },

  // The answers as an archive that is unpacked in the course's folder, and back from it or from single files.
  show_files() {
    const dialog = make("dialog", {className: "run-files"}), said = make("p", {className: "run-said"});
    const chosen = make("input", {type: "file", multiple: true, accept: ".glsl,.tar"});
    chosen.setAttribute("aria-label", "files to import");
    chosen.onchange = async () => { said.textContent = await Answers.import_files([...chosen.files]); };
    dialog.append(make("h2", {textContent: "Your answers"}),
      make("p", {}, "This browser keeps them. As files they are checked by ", make("code", {textContent: "./course check"}), ": unpack the archive in the course's folder, ",
        make("code", {textContent: "tar xf answers.tar"}), "."),
      make("p", {}, make("button", {type: "button", textContent: "Export answers.tar", onclick: async () => Answers.save("answers.tar", await Answers.archive())})),
      make("p", {}, "Import an archive, or .glsl files: ", chosen), said, make("button", {type: "button", textContent: "Close", onclick: () => dialog.remove()}));
    document.body.append(dialog);
    dialog.showModal();
  },

  save(name, data) {
    const link = make("a", {download: name, href: URL.createObjectURL(new Blob([data]))});
    link.click();
    setTimeout(() => URL.revokeObjectURL(link.href), 1000);
  },

  // POSIX ustar: a block of 512 bytes for each file's head, then its bytes.
  async archive() {
    const encoder = new TextEncoder(), parts = [];
    for (const id of Answers.list.filter(one => Answers.kept(one) !== null)) {
      const {file} = await Answers.load(id), data = encoder.encode(Answers.text(id)), head = new Uint8Array(512);
      const write = (at, words) => head.set(encoder.encode(words), at), octal = (value, digits) => `${value.toString(8).padStart(digits - 1, "0")}\0`;
      write(0, file);
      for (const [at, words] of [[100, octal(0o644, 8)], [108, octal(0, 8)], [116, octal(0, 8)], [124, octal(data.length, 12)], [136, octal(0, 12)], [148, "        "], [156, "0"], [257, "ustar\x0000"]]) write(at, words);
      write(148, `${octal(head.reduce((sum, byte) => sum + byte, 0), 7)} `);
      parts.push(head, data, new Uint8Array(-data.length & 511));
    }
    return new Blob([...parts, new Uint8Array(1024)]);
  },

  unpacked(bytes) {
    const found = [], decoder = new TextDecoder(), words = (at, length) => decoder.decode(bytes.subarray(at, at + length)).replace(/\0.*$/s, "");
    for (let at = 0; at + 512 <= bytes.length && bytes[at];) {
      const size = parseInt(words(at + 124, 12), 8) || 0;
      found.push([words(at, 100), decoder.decode(bytes.subarray(at + 512, at + 512 + size))]);
      at += 512 + 512 * Math.ceil(size / 512);
    }
    return found;
  },

  // Returns what was taken, in words. A file is known by its path, or by its name where that is one exercise's alone.
  async import_files(files) {
    const taken = [], left = [];
    for (const file of files) {
      const named = file.name.endsWith(".tar") ? Answers.unpacked(new Uint8Array(await file.arrayBuffer())) : [[file.name, await file.text()]];
      for (const [path, text] of named) {
        const name = path.split("/").pop().replace(/\.glsl$/, ""), chapter = path.match(/(?:^|\/)(\d\d)_\w+\/exercise\//)?.[1];
        const meant = Answers.list.filter(id => id.slice(3) === name && (!chapter || id.startsWith(chapter)));
        if (meant.length !== 1 || !path.endsWith(".glsl")) {
          left.push(path);
          continue;
        }
        Answers.kept(meant[0], text);
        Exercise.all.get(meant[0])?.editor?.setValue(text);
        taken.push(meant[0]);
      }
    }
    return `${taken.length ? `imported ${taken.join(", ")}` : "nothing imported"}${left.length ? `; no exercise of these pages: ${left.join(", ")}` : ""}`;
  },
};

// An exercise whose answer the browser keeps and checks.
class KeptExercise extends Exercise {
  buttons() {
    return [this.button("Reset", () => this.reset()), this.button("Save as a file", () => Answers.save(`${this.id.slice(3)}.glsl`, Answers.text(this.id)))];
  }

  async open() {
    this.table = await Answers.load(this.id);
    this.file = this.table.file;
    await this.edit(Answers.text(this.id));
    this.show_picture();
    this.element.scrollIntoView({block: "nearest"});
  }

  changed(text) {
    Answers.kept(this.id, text === this.table.starter ? null : text);
    Answers.kept(`${this.id}.solved`, null);
    Answers.show_progress();
    clearTimeout(this.typing);
    this.typing = setTimeout(() => Program.refresh(this.id), 400);
  }

  reset() {
    this.editor.setValue(this.table.starter);
    this.verdict.replaceChildren();
  }

  check() {
    this.status.textContent = "checking";
    setTimeout(() => this.show_verdict(Tables.check(this.table, this.editor.getValue())), 20);
  }

  show_verdict(result) {
    super.show_verdict(result);
    const line = result.first_failure?.match(/^it does not compile: line (\d+): (.*)/s);
    Editor.mark(this.editor, line ? [{line: Number(line[1]), words: line[2]}] : []);
    Answers.kept(`${this.id}.solved`, result.ok ? "1" : null);
    Answers.show_progress();
  }

  next_step() {
    const next = Answers.after(this.id);
    return next && make("p", {}, "Next: ", make("a", {className: "run-next", href: new URL(`../../open/${next}.html`, Answers.base), textContent: next}));
  }

  // A picture of the answer, where the lesson's program has the exercise's function in it.
  show_picture() {
    const program = Program.all.find(one => one.scene.mine?.[this.id]);
    if (!program) return;
    const box = [...program.element.querySelectorAll(".run-mine input")].find(one => one.parentElement.textContent.includes(this.id));
    this.status.before(this.button("See it in the picture", async () => {
      program.start();
      box.checked = true;
      await program.show_mine(this.id, true);
      program.element.scrollIntoView({block: "center"});
      program.canvas.focus();
    }));
  }
}

addEventListener("DOMContentLoaded", () => {
  for (const title of document.querySelectorAll(".highlight span.filename")) {
    const name = title.textContent.match(/^docs\/minimal\/(\w+)\./)?.[1], listing = title.parentElement;
    if (name in Program.scenes) new Program(name, listing, listing.querySelector("code").textContent);
  }
  for (const place of document.querySelectorAll("[data-program]"))
    new Program(place.dataset.program, place, Program.scenes[place.dataset.program].text);
  Answers.offer();
});
