// Search in the index, buttons that copy commands, and sliders for joints. Without this script, all
// cards and all pictures are shown.
(function () {
  "use strict";

  // Shows the cards that have all words of the field, as `mjforge catalogue WORD...` does.
  function addSearch(form) {
    const text = document.getElementById("filter-text");
    const count = document.getElementById("filter-count");
    const nothing = document.getElementById("nothing-found");
    const cards = Array.from(document.querySelectorAll(".card"));
    const words = cards.map((card) => card.dataset.words.toLowerCase());

    function filter() {
      const wanted = text.value.toLowerCase().split(/\s+/).filter(Boolean);
      let shown = 0;
      cards.forEach((card, i) => {
        card.hidden = !wanted.every((word) => words[i].includes(word));
        if (!card.hidden) ++shown;
      });
      for (const kind of document.querySelectorAll(".kind"))
        kind.hidden = !kind.querySelector(".card:not([hidden])");
      nothing.hidden = shown > 0;
      count.textContent = shown + " of " + cards.length;
    }

    form.hidden = false;
    form.addEventListener("submit", (event) => event.preventDefault());
    form.addEventListener("input", filter);
    filter();
  }

  function addCopy(item) {
    const code = item.querySelector("code");
    const button = document.createElement("button");
    button.type = "button";
    button.textContent = "Copy";
    button.setAttribute("aria-label", "Copy: " + code.textContent);
    button.addEventListener("click", () => {
      getSelection().selectAllChildren(code);
      const copied = navigator.clipboard ? navigator.clipboard.writeText(code.textContent)
                                         : Promise.reject(new Error("no clipboard"));
      copied.catch(() => document.execCommand("copy")).then(() => { button.textContent = "Copied"; });
    });
    item.append(button);
  }

  // Shows one picture of a joint at a time.
  function addSlider(film) {
    const frames = Array.from(film.querySelectorAll("ol.frames > li"));
    const label = document.createElement("label");
    const slider = document.createElement("input");
    slider.type = "range";
    slider.max = String(frames.length - 1);
    slider.value = slider.max;
    label.append("Position of " + film.getAttribute("aria-label"), slider);

    function show() {
      frames.forEach((frame, i) => { frame.hidden = i !== Number(slider.value); });
      const shown = frames[Number(slider.value)];
      slider.setAttribute("aria-valuetext", shown.querySelector("figcaption").textContent);
    }

    slider.addEventListener("input", show);
    film.append(label);
    show();
  }

  document.documentElement.classList.add("scripted");
  const form = document.getElementById("filter");
  if (form) addSearch(form);
  document.querySelectorAll(".commands li").forEach(addCopy);
  document.querySelectorAll("section.film").forEach(addSlider);
})();
