(() => {
  const steps = document.getElementById("steps");
  const parts = () => steps.querySelectorAll("details");
  const bar = document.createElement("div");
  bar.className = "folding";
  for (const [text, open] of [[steps.dataset.open, true], [steps.dataset.close, false]]) {
    const button = document.createElement("button");
    button.type = "button";
    button.textContent = text;
    button.addEventListener("click", () => parts().forEach((part) => { part.open = open; }));
    bar.append(button);
  }
  steps.previousElementSibling.before(bar);
  // A link leads into parts that are closed, too.
  const reveal = () => {
    const target = document.getElementById(location.hash.slice(1));
    if (!target) return;
    for (let part = target.closest("details"); part; part = part.parentElement.closest("details")) part.open = true;
    target.scrollIntoView({ block: "center" });
  };
  addEventListener("hashchange", reveal);
  reveal();
  // Wherever the value under the pointer stands.
  const mark = (event, on) => {
    const link = event.target.closest("a[href^='#e']");
    if (!link) return;
    document.querySelectorAll(`a[href="${link.getAttribute("href")}"]`).forEach((other) => other.classList.toggle("same", on));
  };
  document.addEventListener("mouseover", (event) => mark(event, true));
  document.addEventListener("mouseout", (event) => mark(event, false));
})();
