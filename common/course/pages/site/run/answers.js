"use strict";

function make(tag, properties = {}, ...children) {
  const element = Object.assign(document.createElement(tag), properties);
  element.append(...children);
  return element;
}

// The reader's answers: kept by the browser, edited and checked in the page, taken along as files.
const Answers = {
  list: [], // of list.js: the exercises that the page can check
  base: new URL(".", document.currentScript.src),
  loading: new Map(),

  // A script of this site, once.
  script(name) {
    if (!Answers.loading.has(name))
      Answers.loading.set(name, new Promise((done, failed) => {
        document.head.append(make("script", {src: new URL(name, Answers.base), onload: done, onerror: () => failed(new Error(`${name} is not there`))}));
      }));
    return Answers.loading.get(name);
  },

  async load(id) {
    await Promise.all([Answers.script(`../tables/${id}.js`), Answers.script("../tables/undefined.js")]);
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

  // The packaged editor on a text; its styles and scripts come with the first one.
  async editor(place, text, changed) {
    if (!document.querySelector("link.run-style"))
      document.head.append(make("link", {rel: "stylesheet", className: "run-style", href: new URL("../cm/codemirror.css", Answers.base)}));
    await Answers.script("../cm/codemirror.js");
    await Promise.all(["clike.js", "matchbrackets.js", "closebrackets.js", "comment.js"].map(name => Answers.script(`../cm/${name}`)));
    const editor = CodeMirror(place, {value: text, mode: "x-shader/x-fragment", lineNumbers: true, indentUnit: 4, lineWrapping: true,
      matchBrackets: true, autoCloseBrackets: true, viewportMargin: Infinity, extraKeys: {"Ctrl-/": "toggleComment",
        Tab: one => one.somethingSelected() ? one.indentSelection("add") : one.replaceSelection("    "), Esc: one => one.getInputField().blur()}});
    editor.getInputField().setAttribute("aria-label", "GLSL; Escape leaves the editor");
    editor.on("change", () => changed(editor.getValue()));
    return editor;
  },

  // Errors at their lines: [{line, words}].
  mark(editor, errors) {
    for (const mark of editor.marks ?? []) mark.clear();
    editor.marks = errors.map(({line, words}) => editor.addLineWidget(Math.min(Math.max(line - 1, 0), editor.lastLine()),
      make("div", {className: "run-message", textContent: words})));
  },

  // A button at each exercise of the page.
  offer() {
    for (const anchor of document.querySelectorAll("a.exercise")) {
      const section = Answers.section(anchor);
      if (!section.length) continue;
      const fits = Answers.list.includes(anchor.id);
      const offer = fits ? make("button", {type: "button", className: "run-open md-button", textContent: "Solve it in this page"}) :
        make("p", {className: "run-elsewhere"}, "This exercise needs the course on your machine: ", make("code", {textContent: `./course check ${anchor.id}`}));
      offer.dataset.exercise = anchor.id;
      if (fits) offer.onclick = () => new Exercise(anchor.id, offer);
      section.at(-1).after(offer);
    }
    Answers.show_progress();
  },

  // What follows an exercise's anchor, its heading first, until the next heading.
  section(anchor) {
    const found = [];
    for (let at = (anchor.parentElement.tagName === "P" ? anchor.parentElement : anchor).nextElementSibling; at; at = at.nextElementSibling) {
      if (found.length && (/^H[123]$/.test(at.tagName) || at.matches("a.exercise") || at.querySelector("a.exercise"))) break;
      found.push(at);
    }
    return found;
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
    for (const anchor of document.querySelectorAll("a.exercise")) Answers.section(anchor)[0]?.classList.toggle("run-solved", solved.includes(anchor.id));
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

// An exercise in the page: its file in an editor, and what the check says.
class Exercise {
  static all = new Map();

  constructor(id, place) {
    Object.assign(this, {id});
    Exercise.all.set(id, this);
    const button = (words, act, title = "") => make("button", {type: "button", textContent: words, onclick: act, title});
    this.place = make("div", {className: "run-editor"});
    this.verdict = make("div", {className: "run-verdict"});
    this.verdict.setAttribute("role", "status");
    this.status = make("span", {className: "run-said", textContent: "reading"});
    this.element = make("div", {className: "run-exercise"}, make("div", {className: "run-buttons"}, button("Check", () => this.check(), "Ctrl+Enter"),
      button("Reset", () => this.reset()), button("Save as a file", () => Answers.save(`${this.id.slice(3)}.glsl`, Answers.text(this.id))), this.status), this.place, this.verdict);
    place.replaceWith(this.element);
    this.open().catch(error => { this.status.textContent = error.message; });
  }

  async open() {
    this.table = await Answers.load(this.id);
    this.editor = await Answers.editor(this.place, Answers.text(this.id), text => this.changed(text));
    this.editor.addKeyMap({"Ctrl-Enter": () => this.check()});
    this.status.textContent = this.table.file;
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
    setTimeout(() => this.show(Tables.check(this.table, this.editor.getValue())), 20);
  }

  show(result) {
    this.status.textContent = this.table.file;
    const counted = `${result.passed} of ${result.passed + result.failed} checks`;
    const words = [make("b", {textContent: result.ok ? `solved: ${counted}` : `open: ${counted}`})];
    if (!result.ok) words.push(make("p", {textContent: result.first_failure}));
    if (result.note) words.push(make("p", {textContent: result.note}));
    if (!result.ok && result.hint) words.push(make("details", {}, make("summary", {textContent: "hint"}), make("p", {textContent: result.hint})));
    const next = result.ok && Answers.after(this.id);
    if (next) words.push(make("p", {}, "Next: ", make("a", {className: "run-next", href: new URL(`../../open/${next}.html`, Answers.base), textContent: next})));
    this.verdict.replaceChildren(...words);
    this.verdict.className = `run-verdict ${result.ok ? "ok" : "open"}`;
    this.verdict.scrollIntoView({block: "nearest"});
    const line = result.first_failure?.match(/^it does not compile: line (\d+): (.*)/s);
    Answers.mark(this.editor, line ? [{line: Number(line[1]), words: line[2]}] : []);
    Answers.kept(`${this.id}.solved`, result.ok ? "1" : null);
    Answers.show_progress();
  }

  // A picture of the answer, where the lesson's program has the exercise's function in it.
  show_picture() {
    const program = Program.all.find(one => one.scene.mine?.[this.id]);
    if (!program) return;
    const box = [...program.element.querySelectorAll(".run-mine input")].find(one => one.parentElement.textContent.includes(this.id));
    this.element.querySelector(".run-said").before(make("button", {type: "button", textContent: "See it in the picture", onclick: async () => {
      program.start();
      box.checked = true;
      await program.show_mine(this.id, true);
      program.element.scrollIntoView({block: "center"});
      program.canvas.focus();
    }}));
  }
}

// Not beside ./course serve, whose own scripts edit files and draw with the chapters.
addEventListener("DOMContentLoaded", () => {
  if (typeof Live !== "undefined") return;
  for (const title of document.querySelectorAll(".highlight span.filename")) {
    const name = title.textContent.match(/^docs\/minimal\/(\w+)\./)?.[1], listing = title.parentElement;
    if (!name) continue;
    let after = listing;
    for (const scene of Object.keys(Program.scenes).filter(one => one === name || one.slice(0, 2) === name.slice(0, 2)).sort((a, b) => (b === name) - (a === name)))
      after = new Program(scene, after, Program.scenes[scene].text ?? listing.querySelector("code").textContent).element;
  }
  for (const place of document.querySelectorAll("[data-program]"))
    new Program(place.dataset.program, place, Program.scenes[place.dataset.program].text);
  Answers.offer();
});
