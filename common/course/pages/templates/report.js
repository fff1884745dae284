for (const image of document.querySelectorAll("img[data-same]"))
  image.src = document.getElementById(image.dataset.same).src;
for (const slide of document.querySelectorAll(".slide")) {
  const range = slide.querySelector("input");
  const move = () => slide.style.setProperty("--at", range.value + "%");
  range.addEventListener("input", move);
  move();
}
