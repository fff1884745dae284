"use strict";

// What of a page becomes live.
const Lesson = {
  chapter: null,
  knobs: [],
  named: [],
  current: null,

  async start() {
    Live.course = await Live.get("course");
    Lesson.show_progress(Live.course.progress);
    const page = decodeURIComponent(location.pathname.split("/").pop()).replace(/\.html$/, "");
    Lesson.chapter = Live.course.chapters[page] ? page : null;
    Live.connect();
    Live.on("chosen", picture => Lesson.choose(picture));
    Live.on("clicked", picture => Lesson.enlarge(picture));
    Live.on("lost", () => document.body.classList.add("live-lost"));
    Live.on("connected", () => document.body.classList.remove("live-lost"));
    Live.on("checked", event => Lesson.show_progress(event.progress));
    Lesson.find_pictures();
    if (!Lesson.chapter) return;
    for (const one of document.querySelectorAll("a.exercise")) Exercise.offer(one);
    Chart.start?.();
    try {
      Lesson.knobs = await Knobs.of(Lesson.chapter);
    } catch (error) {
      Lesson.complain(error.message);
      return;
    }
    Lesson.named = Knobs.link_text(document.querySelector("article"), Lesson.knobs, Lesson.turn);
    Lesson.link_commands();
    document.body.classList.add("live-ready");
  },

  complain(words) {
    document.querySelector("article h1")?.after(make("p", {className: "live-complaint", textContent: words}));
  },

  // A picture of a shot is its golden: tree/tests/NN_name/golden/SHOT.png.
  find_pictures() {
    for (const image of document.querySelectorAll("article img")) {
      const found = decodeURIComponent(new URL(image.src).pathname).match(/\/tree\/tests\/(\d\d_\w+)\/golden\/(\w+)\.png$/);
      if (!found || !Live.course.chapters[found[1]]?.shots[found[2]] || image.closest("a, .hero, .slide")) continue;
      const frame = make("span");
      image.replaceWith(frame);
      frame.append(image);
      image.classList.remove("zooms");
      const picture = new Picture(frame, found[1], [{image, shot: found[2]}]);
      frame.closest("table")?.classList.add("live-table");
      picture.block = frame.closest(".md-typeset__scrollwrap, p, figure") ?? frame.closest("table") ?? frame;
    }
  },

  async choose(picture) {
    if (Lesson.current === picture && picture.panel?.element.isConnected) return;
    Lesson.current?.frame.classList.remove("live-chosen");
    Lesson.current = picture;
    picture.frame.classList.add("live-chosen");
    if (picture.fixed) return;
    await Lesson.open(picture);
  },

  // One of a row of pictures moves into its panel, where it is as wide as the page; a still one keeps its place.
  async enlarge(picture) {
    if (picture.fixed || picture.dock || picture.still) return;
    await Lesson.open(picture);
    picture.still = picture.sides[0].image.cloneNode();
    if (picture.frame.offsetWidth < 0.7 * picture.block.offsetWidth) {
      picture.frame.replaceWith(picture.still);
      picture.panel.element.prepend(picture.frame);
      picture.draw(true);
    }
  },

  close(panel) {
    const {picture} = panel;
    if (picture.still?.isConnected) picture.still.replaceWith(picture.frame);
    picture.still = null;
    panel.element.remove();
  },

  // The panel below the picture's table or paragraph.
  async open(picture) {
    const knobs = await Knobs.of(picture.chapter);
    if (!picture.panel) {
      const shot = picture.sides[0].shot, set = Live.course.chapters[picture.chapter].shots[shot]?.set ?? {};
      const first = [Knobs.find(knobs, "method"), ...Object.keys(set).map(name => Knobs.find(knobs, name)),
                     ...(picture.chapter === Lesson.chapter ? Lesson.named : [])].filter(Boolean);
      new Panel(picture, knobs, [...new Set(first)], shot);
    }
    if (picture.dock) return;
    for (const other of document.querySelectorAll("article .live-panel"))
      if (other.panel && !other.panel.picture.fixed && !other.panel.picture.dock && other.panel !== picture.panel) Lesson.close(other.panel);
    if (!picture.panel.element.isConnected) picture.block.after(picture.panel.element);
  },

  // The picture that a link turns: the one chosen last, else the one above the link, else the page's first.
  near(element) {
    const own = Picture.all.filter(one => one.chapter === Lesson.chapter && one.frame.isConnected && one.frame.offsetParent);
    if (Lesson.current && own.includes(Lesson.current)) return Lesson.current;
    return own.filter(one => one.frame.compareDocumentPosition(element) & Node.DOCUMENT_POSITION_FOLLOWING).pop() ?? own[0];
  },

  async turn(knob, value, link) {
    let picture = Lesson.near(link);
    if (!picture || !Lesson.in_view(picture.frame)) picture = Lesson.dock(picture?.sides[0].shot, picture?.state);
    await Lesson.choose(picture);
    await Lesson.open(picture);
    picture.panel.turn(knob, value)?.scrollIntoView({block: "nearest"});
  },

  in_view(element) {
    const box = element.getBoundingClientRect();
    return box.bottom > 80 && box.top < innerHeight - 80;
  },

  // A picture in the corner of the window, for text far from its picture.
  dock(shot, state, use) {
    shot ??= Object.keys(Live.course.chapters[Lesson.chapter].shots)[0];
    let picture = Lesson.docked;
    if (picture?.sides[0].shot !== shot) {
      picture?.holder.remove();
      const image = make("img", {alt: shot}), frame = make("span", {}, image);
      image.src = new URL(`golden/${Lesson.chapter}/${shot}`, Live.base);
      const close = make("button", {type: "button", className: "live-close", textContent: "×", title: "close"});
      const holder = make("aside", {className: "live-dock"}, close, frame);
      document.body.append(holder);
      picture = Lesson.docked = new Picture(frame, Lesson.chapter, [{image, shot}]);
      Object.assign(picture, {dock: true, holder});
      close.onclick = () => { holder.hidden = true; };
      Lesson.open(picture).then(() => holder.append(picture.panel.element));
    }
    picture.holder.hidden = false;
    if (state || use) picture.change({...structuredClone(state ?? Picture.fresh()), ...(use ? {use} : {})});
    return picture;
  },

  // A command in the text that draws a shot of this chapter: a click draws it here.
  link_commands() {
    for (const code of document.querySelectorAll("article :is(p, li) code")) {
      const words = code.textContent.trim().split(/\s+/), after = word => words[words.indexOf(word) + 1];
      if (words[0] !== "./course" || words[1] !== "run" || words[2] !== Lesson.chapter.slice(0, 2) || !words.includes("--shot")) continue;
      const shot = after("--shot");
      if (!Live.course.chapters[Lesson.chapter].shots[shot]) continue;
      const set = {};
      words.forEach((word, i) => {
        const found = word.match(/^--([\w.]+)$/), given = word === "--set" ? words[i + 1]?.split("=") : found && !["shot", "use", "set", "size", "look"].includes(found[1]) ? [found[1], words[i + 1]] : null;
        const knob = given && Knobs.find(Lesson.knobs, given[0]);
        if (knob && given[1]) set[knob.name] = given[1];
      });
      code.classList.add("live-link");
      code.tabIndex = 0;
      code.title = "draw it here";
      code.onclick = () => {
        const picture = Lesson.dock(shot, {...Picture.fresh(), set, look: words.includes("--look") ? after("--look") : "",
          use: words.includes("--use") ? after("--use") : "solution"});
        Lesson.choose(picture);
      };
    }
  },

  show_progress(progress) {
    Live.progress = progress;
    const all = Object.values(progress), solved = all.reduce((sum, one) => sum + one.solved.length, 0);
    const total = all.reduce((sum, one) => sum + one.exercises, 0);
    let place = document.querySelector(".live-progress");
    if (!place) {
      place = make("span", {className: "live-progress"});
      document.querySelector(".md-header__inner")?.append(place);
    }
    place.textContent = `${solved} of ${total} exercises solved`;
    place.title = Object.entries(progress).map(([name, one]) => `${name}: ${one.solved.length} of ${one.exercises}`).join("\n");
    for (const mark of document.querySelectorAll("a.exercise"))
      mark.nextElementSibling?.classList.toggle("live-solved", all.some(one => one.solved.includes(mark.id)));
  },
};
Lesson.start().catch(error => Lesson.complain(error.message));
