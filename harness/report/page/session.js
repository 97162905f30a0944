// The page around the diagrams: which scenarios are shown, day or night, printing.

function themeOf() {
  const chosen = document.documentElement.dataset.theme;
  if (chosen) return chosen;
  return matchMedia("(prefers-color-scheme: dark)").matches ? "dark" : "light";
}

function start() {
  const diagrams = new Map();
  const scenarios = [...document.querySelectorAll("details.scenario")];
  const recolour = () => diagrams.forEach((diagram) => diagram.recolour());

  const open = (scenario) => {
    const host = scenario.querySelector(".diagram");
    if (!scenario.open || host === null || diagrams.has(scenario)) return;
    const data = JSON.parse(document.getElementById(host.dataset.trace).textContent);
    diagrams.set(scenario, new Diagram(host, new Trace(data)));
  };
  for (const scenario of scenarios) scenario.addEventListener("toggle", () => open(scenario));

  const asked = scenarios.find((scenario) => scenario.id === location.hash.slice(1));
  const first = asked || document.querySelector("details.scenario.failed") || (scenarios.length === 1 ? scenarios[0] : null);
  if (first) {
    first.open = true;
    open(first);
    if (asked) first.scrollIntoView();
  }

  const filter = document.getElementById("scenario-filter");
  const failed = document.getElementById("only-failed");
  const none = document.getElementById("no-scenario");
  const choose = () => {
    const words = filter.value.toLowerCase().split(/\s+/).filter(Boolean);
    for (const scenario of scenarios) {
      const text = scenario.querySelector("summary").textContent.toLowerCase();
      const fits = words.every((word) => text.includes(word));
      scenario.hidden = !fits || (failed.checked && !scenario.classList.contains("failed"));
    }
    none.hidden = scenarios.some((scenario) => !scenario.hidden);
  };
  filter.addEventListener("input", choose);
  failed.addEventListener("change", choose);

  const theme = document.getElementById("theme");
  theme.addEventListener("click", () => {
    document.documentElement.dataset.theme = themeOf() === "dark" ? "light" : "dark";
    recolour();
  });

  for (const button of document.querySelectorAll("button.copy")) {
    button.addEventListener("click", async () => {
      const text = document.getElementById(button.dataset.copies).textContent;
      try {
        await navigator.clipboard.writeText(text);
        button.textContent = "Copied";
      } catch {
        getSelection().selectAllChildren(document.getElementById(button.dataset.copies));
      }
    });
  }

  // Paper is white: what is dark on the screen is drawn anew for it.
  let before;
  addEventListener("beforeprint", () => {
    before = document.documentElement.dataset.theme;
    document.documentElement.dataset.theme = "light";
    diagrams.forEach((diagram) => diagram.setOnPaper(true));
  });
  addEventListener("afterprint", () => {
    if (before) document.documentElement.dataset.theme = before;
    else delete document.documentElement.dataset.theme;
    diagrams.forEach((diagram) => diagram.setOnPaper(false));
  });
}

document.addEventListener("DOMContentLoaded", start);
