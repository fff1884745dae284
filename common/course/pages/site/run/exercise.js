"use strict";

// An element: make("div", {className: "x"}, children...).
function make(kind, properties = {}, ...children) {
  const element = Object.assign(document.createElement(kind), properties);
  element.append(...children);
  return element;
}

// The packaged editor; its styles and scripts come with the first one.
class Editor {
  static base = new URL("../cm/", document.currentScript.src);
  static loading = new Map();

  // A script, once.
  static script(address) {
    if (!Editor.loading.has(String(address)))
      Editor.loading.set(String(address), new Promise((done, failed) => {
        document.head.append(make("script", {src: address, onload: done, onerror: () => failed(new Error(`${address} is not there`))}));
      }));
    return Editor.loading.get(String(address));
  }

  static async on(place, text, {changed, keys = {}, mode = "x-shader/x-fragment"}) {
    const at = name => new URL(name, Editor.base);
    if (!document.querySelector("link.run-style")) document.head.append(make("link", {rel: "stylesheet", className: "run-style", href: at("codemirror.css")}));
    await Editor.script(at("codemirror.js"));
    await Promise.all(["clike.js", "matchbrackets.js", "closebrackets.js", "comment.js"].map(name => Editor.script(at(name))));
    const editor = CodeMirror(place, {value: text, mode, lineNumbers: true, indentUnit: 4, lineWrapping: true, matchBrackets: true, autoCloseBrackets: true,
      viewportMargin: Infinity, gutters: ["CodeMirror-linenumbers", "run-gutter"], extraKeys: {"Ctrl-/": "toggleComment",
        Tab: one => one.somethingSelected() ? one.indentSelection("add") : one.replaceSelection("    "), Esc: one => one.getInputField().blur(), ...keys}});
    editor.getInputField().setAttribute("aria-label", "code; Escape leaves the editor");
    editor.on("change", () => changed(editor.getValue()));
    return editor;
  }

  // Errors at their lines: [{line, words}].
  static mark(editor, errors) {
    editor.clearGutter("run-gutter");
    for (const mark of editor.marks ?? []) mark.clear();
    editor.marks = errors.map(({line, words}) => {
      const at = Math.min(Math.max(line - 1, 0), editor.lastLine());
      editor.setGutterMarker(at, "run-gutter", make("span", {className: "run-mark", textContent: "●", title: words}));
      return editor.addLineWidget(at, make("div", {className: "run-message", textContent: words}));
    });
  }
}

// An exercise in the page: its text in an editor, and what the check says. A page's own class keeps the text and has it checked:
// the browser does (answers.js), or the server (live/site/exercise.js).
class Exercise {
  static all = new Map();

  // What follows an exercise's anchor, its heading first, until the next heading.
  static section(anchor) {
    const found = [];
    for (let at = (anchor.parentElement.tagName === "P" ? anchor.parentElement : anchor).nextElementSibling; at; at = at.nextElementSibling) {
      if (found.length && (/^H[123]$/.test(at.tagName) || at.matches("a.exercise") || at.querySelector("a.exercise"))) break;
      found.push(at);
    }
    return found;
  }

  // A button behind what the lesson says of the exercise, or another element there.
  static offer(anchor, kind, other = null) {
    const section = Exercise.section(anchor);
    if (!section.length) return;
    const offer = other ?? make("button", {type: "button", className: "run-open md-button", textContent: "Solve it here"});
    if (!other) offer.onclick = () => new kind(anchor.id, section, offer);
    offer.dataset.exercise = anchor.id;
    section.at(-1).after(offer);
  }

  constructor(id, section, place) {
    Object.assign(this, {id, section});
    Exercise.all.set(id, this);
    this.place = make("div", {className: "run-editor"});
    this.verdict = make("div", {className: "run-verdict"});
    this.verdict.setAttribute("role", "status");
    this.status = make("span", {className: "run-said", textContent: "reading"});
    this.head = make("div", {className: "run-buttons"}, this.button("Check", () => this.check(), "Ctrl+Enter"), ...this.buttons(), this.status);
    this.element = make("div", {className: "run-exercise"}, this.head, this.place, this.verdict);
    this.element.exercise = this;
    place.replaceWith(this.element);
    this.open().catch(error => { this.status.textContent = error.message; });
  }

  button(words, act, title = "") {
    return make("button", {type: "button", textContent: words, onclick: act, title});
  }

  async edit(text, keys = {}) {
    this.editor = await Editor.on(this.place, text, {changed: now => this.changed(now), keys: {"Ctrl-Enter": () => this.check(), ...keys},
      mode: this.file.endsWith(".cpp") ? "text/x-c++src" : "x-shader/x-fragment"});
    this.status.textContent = this.file;
  }

  // {ok, passed, failed, first_failure, hint, note}, as ./course check says it.
  show_verdict(result) {
    this.status.textContent = this.file;
    const counted = `${result.passed} of ${result.passed + result.failed} checks`, paragraph = textContent => make("p", {textContent});
    const invalid = result.first_failure?.startsWith("it does not compile");
    const words = [make("b", {textContent: invalid ? "does not compile" : `${result.ok ? "solved" : "open"}: ${counted}`})];
    if (!result.ok && result.first_failure) words.push(paragraph(result.first_failure));
    if (result.note) words.push(paragraph(result.note));
    if (!result.ok && result.hint) words.push(make("details", {}, make("summary", {textContent: "hint"}), paragraph(result.hint)));
    if (result.ok) words.push(this.next_step());
    this.verdict.replaceChildren(...words.filter(Boolean));
    this.verdict.className = `run-verdict ${result.ok ? "ok" : "open"}`;
    this.verdict.scrollIntoView({block: "nearest"});
  }
}
