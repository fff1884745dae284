"use strict";

// Formulas: their TeX stands in the page (arithmatex) between \( \) or \[ \].
for (const place of document.querySelectorAll(".arithmatex")) {
  const text = place.textContent.trim();
  katex.render(text.slice(2, -2), place, {displayMode: text.startsWith("\\["), throwOnError: false, strict: "error"});
}

// Two pictures under one slider.
for (const slide of document.querySelectorAll(".slide")) {
  const range = slide.querySelector("input");
  const move = () => slide.style.setProperty("--at", range.value + "%");
  range.addEventListener("input", move);
  move();
}

// The film of the start page: a click stops it, and it does not start for those who want no motion.
const film = document.querySelector(".hero video");
if (film && matchMedia("(prefers-reduced-motion: reduce)").matches) {
  film.autoplay = false;
  film.pause();
}
film?.parentElement.addEventListener("click", event => { if (!event.target.closest("a")) film.paused ? film.play() : film.pause(); });

// How far the reader is.
const read = document.createElement("div");
read.id = "read";
document.body.append(read);
const follow = () => {
  const page = document.documentElement, far = page.scrollTop / Math.max(1, page.scrollHeight - innerHeight);
  read.style.transform = `scaleX(${Math.min(1, far)})`;
};
addEventListener("scroll", follow, {passive: true});
addEventListener("resize", follow);
follow();

// A click on a picture shows it as large as the window.
const large = document.createElement("dialog");
large.className = "large";
large.addEventListener("click", event => { if (event.target.matches("dialog, img")) large.close(); });
document.body.append(large);
for (const image of document.querySelectorAll("article img")) {
  if (image.closest("a, .slide")) continue;
  image.classList.add("zooms");
  image.addEventListener("click", () => {
    const copy = image.cloneNode();
    large.replaceChildren(copy);
    image.dispatchEvent(new CustomEvent("enlarged", {detail: copy, bubbles: true}));
    large.showModal();
  });
}
