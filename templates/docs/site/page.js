/* Day and night, the menu on a narrow screen, and the tools of this page. */
const TOOLS = { decoder, converter };

function theme() {
  const root = document.documentElement;
  const stored = (() => { try { return localStorage.getItem("theme"); } catch { return null; } })();
  if (stored) root.dataset.theme = stored;
  document.getElementById("theme").addEventListener("click", () => {
    const dark = root.dataset.theme ? root.dataset.theme === "dark" : matchMedia("(prefers-color-scheme: dark)").matches;
    root.dataset.theme = dark ? "light" : "dark";
    try { localStorage.setItem("theme", root.dataset.theme); } catch { /* a browser that keeps nothing */ }
  });
}

function menu() {
  const button = document.getElementById("menu-button");
  const nav = document.getElementById("menu");
  button.addEventListener("click", () => {
    button.setAttribute("aria-expanded", nav.classList.toggle("shown") ? "true" : "false");
  });
  document.querySelector("nav [aria-current]")?.scrollIntoView({ block: "nearest" });
}

theme();
menu();
search();
for (const place of document.querySelectorAll("[data-tool]")) {
  const data = JSON.parse(place.querySelector("script").textContent);
  TOOLS[place.dataset.tool](place, data);
}
